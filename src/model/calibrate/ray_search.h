// Where along a ray a part must lie, by what the other frames' silhouettes say.
#pragma once

#include <vector>

#include "base/distance_field.h"
#include "document/camera.h"

namespace artisketch {

// A ray as another frame's camera sees it: at depth t its pixel is
// principal point + (a + t b) / (w + t c).
class SeenRay {
 public:
  // origin and direction in the world of that frame.
  SeenRay(const FrameCamera& camera, const Vec3& origin, const Vec3& direction);

  bool in_front(double t) const { return w_ + t * c_ > 1e-9; }
  Vec2 pixel(double t) const { return principal_point_ + (a_ + t * b_) / (w_ + t * c_); }
  // The most pixels that it moves by per unit of t, for t within ±reach; +infinity if it gets
  // behind the camera there.
  double fastest(double reach) const;
  // `along` is the pixel's derivative by t.
  Vec2 pixel(double t, Vec2& along) const {
    const double k = 1 / (w_ + t * c_);
    const Vec2 p = (a_ + t * b_) * k;
    along = (b_ - c_ * p) * k;
    return principal_point_ + p;
  }

 private:
  Vec2 a_, b_, principal_point_;
  double w_ = 1, c_ = 0;
};

// One ray against all other silhouettes of its part.
struct RaySearch {
  std::vector<SeenRay> rays;
  std::vector<const SampledDistance*> outlines;  // of the same views

  // The depth within ±reach at which the squared distances outside the silhouettes add up to least,
  // and that sum in pixels²: 0 where the ray meets the hull, +infinity where no depth lies in front
  // of every camera.
  double best_depth(double reach, double& least) const;

 private:
  struct Sum {
    double value = 0, half_slope = 0, half_bend = 0;  // the bend where distances are linear
  };
  Sum sum(double t) const;
  // At least `enough` where it's more than that; then `view` is one that makes it so, by
  // `distance`.
  double sum_up_to(double enough, double t, std::size_t& view, double& distance) const;
};

}  // namespace artisketch
