#include "editor/pictures/view_projection.h"

namespace artisketch {
namespace {

// Depths from `near` to `far` along the view onto clip space's −w … w.
void set_depth(Eigen::Matrix4d& clip, const Eigen::RowVector4d& depth, double near, double far) {
  clip.row(2) = depth * (far + near) / (far - near);
  clip(2, 3) -= 2 * far * near / (far - near);
  clip.row(3) = depth;
}

}  // namespace

ViewProjection orbit_projection(const Orbit& orbit, const Rect& place) {
  constexpr double kFocal = 2.4;  // half heights: a lens that flatters, 45°
  const Mat3 R = orbit.turn();
  const Vec3 t = -R * orbit.target - Vec3(0, 0, orbit.distance);
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  view.topLeftCorner<3, 3>() = R;
  view.topRightCorner<3, 1>() = t;
  ViewProjection projection;
  projection.turn = R;
  projection.place = place;
  // A tall place keeps the width in sight.
  const double focal = kFocal * std::min(1.0, double(place.w / std::max(1.0f, place.h)) * 1.15);
  projection.clip.row(0) = view.row(0) * focal * place.h / std::max(1.0f, place.w);
  projection.clip.row(1) = view.row(1) * focal;
  set_depth(projection.clip, -view.row(2), orbit.distance * 0.05, orbit.distance * 20);
  return projection;
}

ViewProjection sketch_projection(const FrameCamera& frame, ImVec2 origin, float zoom,
                                 const Rect& place) {
  const Camera& camera = frame.camera;
  const bool flat = camera.type == Camera::Type::orthographic;
  const double cx = (origin.x + zoom * frame.principal_point.x() - place.x) * 2 / place.w - 1,
               cy = 1 - (origin.y + zoom * frame.principal_point.y() - place.y) * 2 / place.h;
  const double s = zoom * (flat ? camera.pixels_per_unit * frame.scale : camera.focal_length);
  Eigen::RowVector4d w = Eigen::RowVector4d::Zero();
  if (flat)
    w(3) = 1;
  else
    w << 0, 0, -1, camera.distance;
  ViewProjection projection;
  projection.turn = Mat3::Identity();
  projection.place = place;
  projection.clip.row(0) = w * cx;
  projection.clip.row(1) = w * cy;
  projection.clip(0, 0) += 2 * s / place.w;
  projection.clip(1, 1) += 2 * s / place.h;
  if (flat) {
    // A thousand widths of the picture deep.
    const double depth = 1000 * place.w / s;
    projection.clip.row(2) << 0, 0, -1 / depth, 0;
    projection.clip.row(3) = w;
  } else {
    set_depth(projection.clip, w, camera.distance * 0.05, camera.distance * 20);
  }
  return projection;
}

}  // namespace artisketch
