#include "model/ray_search.h"

#include <algorithm>
#include <limits>

namespace artisketch {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr int kSamples = 13;  // along the reach: a part's silhouettes are rarely finer than that
constexpr int kRefinements = 7;

}  // namespace

SeenRay::SeenRay(const FrameCamera& camera, const Vec3& origin, const Vec3& direction)
    : principal_point_(camera.principal_point) {
  double s = camera.pixels_per_unit(0);
  if (camera.camera.type == Camera::Type::perspective) {
    s = camera.camera.focal_length;
    w_ = camera.camera.distance - origin.z();
    c_ = -direction.z();
  }
  a_ = Vec2(s * origin.x(), -s * origin.y());
  b_ = Vec2(s * direction.x(), -s * direction.y());
}

double RaySearch::sum_up_to(double enough, double t) const {
  double total = 0;
  for (std::size_t v = 0; v < rays.size() && total < enough; ++v) {
    if (!rays[v].in_front(t)) return kNever;
    const double sd = outlines[v]->distance(rays[v].pixel(t));
    if (sd > 0) total += sd * sd;
  }
  return total;
}

double RaySearch::sum(double t, double& half_slope) const {
  double total = 0;
  half_slope = 0;
  for (std::size_t v = 0; v < rays.size(); ++v) {
    if (!rays[v].in_front(t)) return kNever;
    Vec2 along, gradient;
    const double sd = outlines[v]->distance(rays[v].pixel(t, along), gradient);
    if (sd <= 0) continue;
    total += sd * sd;
    half_slope += sd * gradient.dot(along);
  }
  return total;
}

double RaySearch::best_depth(double reach, double& least) const {
  const double step = 2 * reach / (kSamples - 1);
  double at = 0;
  least = kNever;
  // From the middle outward: most rays find their part there.
  for (int i = 0; i < kSamples && least > 0; ++i) {
    const double t = step * ((i + 1) / 2) * (i % 2 ? 1 : -1);
    const double value = sum_up_to(least, t);
    if (value < least) {
      least = value;
      at = t;
    }
  }
  if (least == 0 || least == kNever) return at;
  // The zero of the slope beside the best sample: by false position kept off the ends, halving
  // until there is a slope on both sides.
  double low = at - step, high = at + step, low_slope = 0, high_slope = 0, t = at;
  for (int i = 0; i < kRefinements; ++i) {
    double slope;
    const double value = sum(t, slope);
    if (value < least) {
      least = value;
      at = t;
    }
    if (least == 0 || slope == 0) break;
    (slope > 0 ? high : low) = t;
    (slope > 0 ? high_slope : low_slope) = slope;
    const bool both = low_slope < 0 && high_slope > 0;
    const double w = both ? std::clamp(low_slope / (low_slope - high_slope), 0.1, 0.9) : 0.5;
    t = low + w * (high - low);
  }
  return at;
}

}  // namespace artisketch
