// How well the silhouettes of rigid parts agree at given poses: the distance by which the rays of
// each contour miss the part's visual hull, and its derivatives.
//
// For a contour point of part j in frame A, let y(λ) run along its ray in part space. The residuals
// are max(0, sd_v(π_v(y(λ*)))) over all other frames v, with sd_v the signed distance to the part's
// contour there and λ* the depth that makes their squares' sum least. λ is projected out of the
// derivatives (variable projection, Golub and Pereyra 1973).
#pragma once

#include <vector>

#include "model/pose_parameters.h"

namespace artisketch {

struct RayOptions {
  int rays_per_contour = 32;
  double pixel = 1;           // what counts as a pixel of the drawing, in pixels
};

// Robust kernels for a ray's residual (Geman and McClure 1987): ρ(e) = c²e / (c² + e) of the squared
// distance e; c = +infinity is least squares.
struct RayLoss {
  double reach = 0;           // c in pixels; 0: plain squares
  double landmark = 0;        // weight of the landmark term: parts' centroids agree between frames
  bool rays = true;
  double bone = 0;  // pull of the landmark to the bone's middle
};

struct RayEnergy {
  double total = 0;
  std::vector<double> rms;    // per view in order of views(), pixels
};

class RayResiduals {
 public:
  RayResiduals(const Document& document, const RayOptions& options);

  struct View {
    int part = 0, frame = 0;
    SampledDistance outline;
    std::vector<Vec2> points;  // where rays start, pixels
    double weight = 1;         // of each ray
    Vec2 centroid = Vec2::Zero();
    double size = 1;           // pixels, root of the area
  };
  struct Part {
    int joint = 0;
    std::vector<View> views;
    Vec3 bone = Vec3::Zero();
  bool has_bone = false;
  Vec3 landmark = Vec3::Zero();  // from the joint, in the joint's axes: the parts' middle
    double radius = 1;             // units about the landmark that hold the part
  };
  const std::vector<Part>& parts() const { return parts_; }

  // Energy at the change, and, where asked for, its systems in the parts' motions.
  double evaluate(const PoseChange& change, const RayLoss& loss,
                  std::vector<std::pair<int, MotionSystem>>* systems) const;

  int frames() const { return int(document_.frames.size()); }
  double evaluations = 0;

 private:
  const Document& document_;
  RayOptions options_;
  std::vector<Part> parts_;
};

}  // namespace artisketch
