// How well the silhouettes of rigid parts agree at given poses, and what moving the parts does to
// that: how far the rays of every contour miss the part's visual hull.
//
// For a contour point of a part in frame A, let y(t) run along its ray in part space. The residuals
// are max(0, sd_v(π_v(y(t*)))) over all other frames v, where sd_v is the signed distance to the
// part's contour there and t* the depth at which their squares add up to least. All views of a ray
// together say far more than pairs of views do, which only meet in epipolar tangents.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "model/calibrate/calibrate.h"
#include "model/calibrate/pose_system.h"

namespace artisketch {

// Where every joint stands in every frame, and how each frame's camera sees it.
struct Placement {
  std::vector<std::vector<Transform>> posed;  // [frame][joint]: joint's axes → world
  std::vector<FrameCamera> cameras;           // [frame]
};
Placement placed(const Document& document, std::span<const Pose> poses,
                 std::span<const double> scales);

class RayResiduals {
 public:
  struct View {
    int frame = 0;
    std::shared_ptr<const SampledDistance> outline;
    std::vector<Vec2> points;  // where rays start, pixels
    double weight = 1;         // of each ray: the stretch of contour it stands for
    Vec2 centroid = Vec2::Zero();
    double size = 1;  // pixels: root of the outline's area
  };
  // A part that at least two frames show by a closed contour.
  struct Part {
    int joint = 0;
    std::vector<View> views;   // of frames that do
    Vec3 bone = Vec3::Zero();  // middle of the joint's bones, in its axes
    double radius = 1;         // units: the part lies within it of its middle
    // The point nearest to the views' rays through their centroids, in the joint's axes: rays look
    // for the part about it. Views from one direction leave its depth to the bone.
    Vec3 middle(const Placement& placement) const;
  };

  // step: pixels between rays; most: rays a part and frame.
  RayResiduals(const Document& document, double step, int most);

  const std::vector<Part>& parts() const { return parts_; }
  // The same with fewer rays a contour where more frames show a part, at most `most` times a frame
  // that they are held against: cost would grow with the square of the frames, and what rays say
  // does not.
  RayResiduals thinned(int most = 96) const;
  // The same for the parts of some joints alone (per joint: whether it's wanted).
  RayResiduals of(const std::vector<char>& joints) const;
  // The drawing's own pixel: what counts as one in a figure drawn some 500 pixels large. Energies
  // are in its squares, and times the length of contour that they stand for.
  double unit() const { return unit_; }
  double contour_length() const;  // in unit()

  // Sum over rays of ρ(e) = c²e / (c² + e) (Geman and McClure 1987), e the sum of a ray's squared
  // residuals, and c = reach, in unit() (0: plain squares), times `weight`. systems: where not
  // null, each part's linear system in its motions is added there.
  double evaluate(const Placement& placement, double reach, double weight,
                  MotionSystems* systems) const;
  // A system for each part, as parts() are ordered, to be added to.
  void clear(MotionSystems& systems, int frames) const;

  // The sum over a part's rays of their squared misses, each times its weight; where that is more
  // than `enough`, anything above it.
  double cost(const Part& part, const Placement& placement, double enough) const;

  // Pixels² by which each ray of a part misses the hull, view by view, point by point.
  std::vector<std::vector<double>> misses(const Part& part, const Placement& placement) const;

 private:
  // Until visit returns false.
  template <class Visit>
  void each_ray(const Part& part, const Placement& placement, const Visit& visit) const;

  double unit_ = 1;
  std::vector<Part> parts_;
};

// As many rays as tell how well drawings agree: a pixel apart, no more than a close look takes.
RayResiduals rays_to_compare(const Document& document);

// The way that a view's camera looks at a part, in the joint's axes.
Vec3 line_of_sight(const RayResiduals::Part& part, const RayResiduals::View& view,
                   const Placement& placement);
// From where to where a view's outline reaches along an axis in the joint's axes; units, in the
// plane at the depth of `middle`, a place in the joint's axes.
Vec2 reach_along(const RayResiduals::Part& part, const RayResiduals::View& view,
                 const Placement& placement, const Vec3& middle, const Vec3& axis);

}  // namespace artisketch
