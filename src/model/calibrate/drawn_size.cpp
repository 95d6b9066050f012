// Logarithms of the frames' sizes by least squares over all pairs of views of all parts, reweighted
// so that parts which differ for another reason (a bend, a wrong pose) count ever less.
#include "model/calibrate/drawn_size.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <Eigen/Dense>

#include "document/place_words.h"
#include "model/calibrate/calibration_words.h"
#include "model/working_scale.h"

namespace artisketch {
namespace {

constexpr double kAside = 0.35;     // sine of 20°: nearer views have no axis across both to trust
constexpr double kOtherSize = 0.1;  // of the size: pairs farther off than this count ever less
constexpr double kSizePrior = 0.3;  // standard deviation of a drawing's log size
constexpr int kReweightings = 20;
// What is told: so large a difference, so many standard errors, of so many parts.
constexpr double kToldSize = 0.1, kCertainSize = 4;
constexpr int kFewParts = 3;

// What a pair of views of one part says: log size of one frame less that of another.
struct SizeRatio {
  int frame = 0, other = 0;
  double log = 0;
};

// Units that a view's outline takes along an axis in the joint's axes.
double extent_along(const RayResiduals::Part& part, const RayResiduals::View& view,
                    const Placement& placement, const Vec3& middle, const Vec3& axis) {
  const Vec2 reach = reach_along(part, view, placement, middle, axis);
  return reach.y() - reach.x();
}

std::vector<SizeRatio> size_ratios(const RayResiduals& rays, const Placement& placement) {
  constexpr double kNothing = 1e-9;  // units
  std::vector<SizeRatio> all;
  for (const RayResiduals::Part& part : rays.parts()) {
    const Vec3 middle = part.middle(placement);
    const auto across = [&](const RayResiduals::View& view) {  // from about the same side
      const double z = (placement.posed[view.frame][part.joint] * middle).z();
      return view.size / placement.cameras[view.frame].pixels_per_unit(z);
    };
    for (std::size_t v = 0; v < part.views.size(); ++v)
      for (std::size_t w = 0; w < v; ++w) {
        const RayResiduals::View &one = part.views[v], &other = part.views[w];
        const Vec3 axis =
            line_of_sight(part, one, placement).cross(line_of_sight(part, other, placement));
        const bool aside = axis.norm() >= kAside;
        const Vec3 along = aside ? Vec3(axis.normalized()) : Vec3(Vec3::Zero());
        const double a = aside ? extent_along(part, one, placement, middle, along) : across(one);
        const double b =
            aside ? extent_along(part, other, placement, middle, along) : across(other);
        if (a > kNothing && b > kNothing) all.push_back({one.frame, other.frame, std::log(a / b)});
      }
  }
  return all;
}

}  // namespace

bool DrawnSize::differs() const {
  const double log = std::log(factor);
  return parts >= kFewParts && std::abs(log) > kToldSize && std::abs(log) > kCertainSize * error;
}

std::vector<DrawnSize> drawn_sizes(const RayResiduals& rays, const Placement& placement) {
  const int frames = int(placement.cameras.size());
  std::vector<DrawnSize> sizes(frames);
  const std::vector<SizeRatio> all = size_ratios(rays, placement);
  if (frames < 2 || all.empty()) return sizes;
  Eigen::VectorXd log = Eigen::VectorXd::Zero(frames);
  Eigen::MatrixXd A;
  double squares = 0, weights = 0;
  for (int round = 0; round < kReweightings; ++round) {
    A = Eigen::MatrixXd::Identity(frames, frames) *
        (kOtherSize * kOtherSize / (kSizePrior * kSizePrior));
    Eigen::VectorXd b = Eigen::VectorXd::Zero(frames);
    squares = weights = 0;
    for (const SizeRatio& r : all) {
      const double off = r.log - log[r.frame] + log[r.other];
      const double c2 = kOtherSize * kOtherSize, share = c2 / (c2 + off * off), w = share * share;
      A(r.frame, r.frame) += w;
      A(r.other, r.other) += w;
      A(r.frame, r.other) -= w;
      A(r.other, r.frame) -= w;
      b[r.frame] += w * r.log;
      b[r.other] -= w * r.log;
      squares += w * off * off;
      weights += w;
    }
    // The first frame is what the others are measured against.
    A.row(0).setZero();
    A.col(0).setZero();
    A(0, 0) = 1;
    b[0] = 0;
    log = A.ldlt().solve(b);
  }
  const Eigen::MatrixXd inverse = A.ldlt().solve(Eigen::MatrixXd::Identity(frames, frames));
  const double variance = squares / std::max(weights - (frames - 1), 1.0);
  for (int f = 0; f < frames; ++f) {
    sizes[f].factor = std::exp(log[f]);
    sizes[f].error = f == 0 ? 0 : std::sqrt(variance * inverse(f, f));
    for (const RayResiduals::Part& part : rays.parts())
      sizes[f].parts += std::any_of(part.views.begin(), part.views.end(),
                                    [&](const RayResiduals::View& v) { return v.frame == f; });
  }
  return sizes;
}

std::vector<std::string> drawn_size_words(const Document& document,
                                          const std::vector<DrawnSize>& sizes,
                                          const std::vector<double>& scales) {
  std::vector<std::string> lines;
  if (document.camera.type != Camera::Type::orthographic) return lines;  // its depth would tell
  for (int f = 1; f < int(sizes.size()); ++f) {
    if (!sizes[f].differs()) continue;
    const double factor = sizes[f].factor;
    char scale[32];
    std::snprintf(scale, sizeof scale, "%.2f", scales[f] * factor);
    lines.push_back(frame_words(document, f) + " seems drawn " +
                    std::to_string(std::lround(100 * std::abs(factor - 1))) + " % " +
                    (factor > 1 ? "larger" : "smaller") + " than " + frame_words(document, 0) +
                    ": with frames[" + std::to_string(f) + "].scale at " + scale +
                    " its parts would be as large");
  }
  return lines;
}

std::vector<double> offered_scales(const Document& whole) {
  Document document = with_shaping_contours(whole);
  document = scaled(document, calibration_scale(document));
  std::vector<double> scales;
  std::vector<Pose> poses;
  for (const Frame& frame : document.frames) {
    scales.push_back(frame.scale);
    poses.push_back(frame.pose);
  }
  if (document.camera.type != Camera::Type::orthographic || scales.size() < 2) return scales;
  const std::vector<DrawnSize> sizes =
      drawn_sizes(rays_to_compare(document), placed(document, poses, scales));
  for (std::size_t f = 1; f < sizes.size(); ++f)
    if (sizes[f].differs()) scales[f] *= sizes[f].factor;
  return scales;
}

}  // namespace artisketch
