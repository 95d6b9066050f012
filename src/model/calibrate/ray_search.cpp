#include "model/calibrate/ray_search.h"

#include <cmath>
#include <limits>

namespace artisketch {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr int kSamples = 13;  // along the reach: a part's silhouettes are rarely finer than that
constexpr int kRefinements = 10;
constexpr double kSettled = 1e-3;  // of the step between samples
constexpr double kSteepest = 1.1;  // slope of a distance that is bilinear between its samples

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

double SeenRay::fastest(double reach) const {
  const double w = w_ - std::abs(c_) * reach;
  return w > 1e-9 ? (w_ * b_ - c_ * a_).norm() / (w * w) : kNever;
}

double RaySearch::sum_up_to(double enough, double t, std::size_t& view, double& distance) const {
  double total = 0;
  for (view = 0; view < rays.size(); ++view) {
    if (!rays[view].in_front(t)) {
      distance = 0;
      return kNever;
    }
    distance = outlines[view]->distance(rays[view].pixel(t));
    if (distance > 0) total += distance * distance;
    if (total >= enough) break;
  }
  return total;
}

RaySearch::Sum RaySearch::sum(double t) const {
  Sum sum;
  for (std::size_t v = 0; v < rays.size(); ++v) {
    if (!rays[v].in_front(t)) return {kNever, 0, 0};
    Vec2 along, gradient;
    const double sd = outlines[v]->distance(rays[v].pixel(t, along), gradient);
    if (sd <= 0) continue;
    const double by_depth = gradient.dot(along);
    sum.value += sd * sd;
    sum.half_slope += sd * by_depth;
    sum.half_bend += by_depth * by_depth;
  }
  return sum;
}

double RaySearch::best_depth(double reach, double& least) const {
  const double step = 2 * reach / (kSamples - 1);
  double at = 0;
  least = kNever;
  // From the middle outward: most rays find their part there. Depths at which one silhouette alone
  // is too far off yet, however fast the ray comes nearer to it, are left out on either side.
  double too_far[2] = {0, 0};
  for (int i = 0; i < kSamples && least > 0; ++i) {
    const int side = i % 2;
    const double depth = step * ((i + 1) / 2), t = side ? depth : -depth;
    if (depth < too_far[side]) continue;
    std::size_t view;
    double distance;
    const double value = sum_up_to(least, t, view, distance);
    if (value < least) {
      least = value;
      at = t;
    } else if (distance * distance > least) {
      too_far[side] =
          depth + (distance - std::sqrt(least)) / (kSteepest * rays[view].fastest(reach));
    }
  }
  if (least == 0 || least == kNever) return at;
  // The zero of the slope beside the best sample: Gauss–Newton, kept between slopes of both signs.
  double low = at - step, high = at + step, t = at;
  for (int i = 0; i < kRefinements; ++i) {
    const Sum here = sum(t);
    if (here.value < least) {
      least = here.value;
      at = t;
    }
    if (least == 0 || here.half_slope == 0) break;
    (here.half_slope > 0 ? high : low) = t;
    double next = t - here.half_slope / here.half_bend;
    if (!(next > low && next < high)) next = (low + high) / 2;
    if (std::abs(next - t) < kSettled * step) break;
    t = next;
  }
  return at;
}

}  // namespace artisketch
