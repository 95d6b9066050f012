// Each view of a part is held out and predicted from the others:
// - two views share the axis across both directions, and each says from where to where the part
//   reaches along it (the epipolar tangents);
// - an outline lies within the hull of all other views.
#include "model/calibrate/unseen_sides.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "base/trigonometry.h"
#include "model/calibrate/calibrate.h"
#include "model/calibrate/ray_residuals.h"
#include "model/working_scale.h"

namespace artisketch {
namespace {

constexpr double kRayStep = 3;  // units of the drawing
constexpr int kMostRays = 32;   // of one outline
// Below kNarrow the depth is next to nothing but the prior's; from kWide on the views tell it.
constexpr double kNarrow = radians(25), kWide = radians(45);
constexpr double kAgrees = 0.1, kDisagrees = 0.35;  // in the part's sizes
// Of the drawn area: so much in parts of one kind makes the whole of that kind.
constexpr double kMostly = 0.6;

// Units: the root of the largest outline's area.
double size_of(const RayResiduals::Part& part, const Placement& placement, const Vec3& middle) {
  double size = 1e-9;
  for (const RayResiduals::View& view : part.views) {
    const double z = (placement.posed[view.frame][part.joint] * middle).z();
    size = std::max(size, view.size / placement.cameras[view.frame].pixels_per_unit(z));
  }
  return size;
}

PartTrust judged(const RayResiduals& rays, const RayResiduals::Part& part,
                 const Placement& placement) {
  PartTrust out;
  out.joint = part.joint;
  const Vec3 middle = part.middle(placement);
  const double size = size_of(part, placement, middle);
  double squares = 0;
  int pairs = 0;
  for (std::size_t v = 0; v < part.views.size(); ++v)
    for (std::size_t w = v + 1; w < part.views.size(); ++w) {
      const Vec3 a = line_of_sight(part, part.views[v], placement);
      const Vec3 b = line_of_sight(part, part.views[w], placement);
      const Vec3 axis = a.cross(b);
      out.spread = std::max(out.spread, arctangent(axis.norm(), std::abs(a.dot(b))));
      if (axis.norm() < sine(kNarrow)) continue;
      const Vec3 along = axis.normalized();
      squares += (reach_along(part, part.views[v], placement, middle, along) -
                  reach_along(part, part.views[w], placement, middle, along))
                     .squaredNorm() /
                 2;
      ++pairs;
    }
  if (pairs > 0) out.disagreement = std::sqrt(squares / pairs) / size;
  const auto misses = rays.misses(part, placement);
  for (std::size_t v = 0; v < misses.size(); ++v) {
    double mean = 0;
    for (const double squared : misses[v]) mean += squared / double(misses[v].size());
    out.disagreement = std::max(out.disagreement, std::sqrt(mean) / part.views[v].size);
  }
  out.trust = out.spread < kNarrow || out.disagreement > kDisagrees ? Trust::guess
              : out.spread >= kWide && out.disagreement <= kAgrees  ? Trust::good
                                                                    : Trust::doubtful;
  return out;
}

double drawn_area(const Document& document, int joint) {
  double most = 0;
  for (std::size_t f = 0; f < document.frames.size(); ++f) {
    double area = 0;
    for (const Contour& contour : document.frames[f].contours)
      if (contour.joint == joint && contour.line.closed)
        area += std::abs(signed_area(contour.line));
    const double scale = frame_camera(document, int(f)).scale;
    most = std::max(most, area / (scale * scale));
  }
  return most;
}

}  // namespace

const char* trust_word(Trust trust) {
  return trust == Trust::good ? "good" : trust == Trust::doubtful ? "doubtful" : "guess";
}

UnseenSides unseen_sides(const Document& given) {
  const Document document = scaled(given, calibration_scale(given));
  UnseenSides out;
  std::vector<Pose> poses;
  std::vector<double> scales;
  for (const Frame& frame : document.frames) {
    poses.push_back(frame.pose);
    scales.push_back(frame.scale);
  }
  const Placement placement = placed(document, poses, scales);
  const RayResiduals rays = RayResiduals(document, kRayStep, kMostRays).thinned();
  double area[3] = {0, 0, 0}, all = 0;
  for (const int joint : drawn_joints(document)) {
    PartTrust trust;
    trust.joint = joint;  // a part that one drawing shows is a guess
    for (const RayResiduals::Part& part : rays.parts())
      if (part.joint == joint) trust = judged(rays, part, placement);
    const double drawn = drawn_area(document, joint);
    area[int(trust.trust)] += drawn;
    all += drawn;
    out.parts.push_back(trust);
  }
  out.whole = area[int(Trust::good)] > kMostly * all     ? Trust::good
              : area[int(Trust::guess)] >= kMostly * all ? Trust::guess
                                                         : Trust::doubtful;
  return out;
}

std::string unseen_sides_words(const Document& document, const UnseenSides& sides) {
  std::string words = std::string("from sides not drawn: ") + trust_word(sides.whole), parts;
  for (const Trust trust : {Trust::good, Trust::doubtful, Trust::guess}) {
    std::string names;
    for (const PartTrust& part : sides.parts)
      if (part.trust == trust && trust != sides.whole)
        names += (names.empty() ? "" : ", ") + document.skeleton.joints[part.joint].name;
    if (!names.empty())
      parts += (parts.empty() ? "" : "; ") + std::string(trust_word(trust)) + ": " + names;
  }
  return parts.empty() ? words : words + " (" + parts + ")";
}

}  // namespace artisketch
