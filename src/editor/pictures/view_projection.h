// How a 3D view looks at the world: round a model, or as a frame's camera does.
#pragma once

#include "document/camera.h"
#include "editor/ui/rect.h"

namespace artisketch {

// From the world to the picture of one rectangle of the window.
struct ViewProjection {
  Eigen::Matrix4d clip;  // world → clip space of the rectangle
  Mat3 turn;             // world → view directions: x right, y up, z toward the viewer
  Rect place;            // points

  // Where a world point stands in the window; points.
  ImVec2 project(const Vec3& X) const {
    const Eigen::Vector4d c = clip * X.homogeneous();
    return {place.x + place.w * float(0.5 + 0.5 * c.x() / c.w()),
            place.y + place.h * float(0.5 - 0.5 * c.y() / c.w())};
  }
};

// Turning round a target.
struct Orbit {
  double yaw = 0.5, pitch = 0.12;  // radians
  double distance = 4;             // units
  Vec3 target = Vec3(0, 0.5, 0);

  Mat3 turn() const {
    return (Eigen::AngleAxisd(pitch, Vec3::UnitX()) * Eigen::AngleAxisd(-yaw, Vec3::UnitY()))
        .toRotationMatrix();
  }
};
ViewProjection orbit_projection(const Orbit& orbit, const Rect& place);

// As a frame's camera, with the sketch's pixel (x, y) at origin + zoom·(x, y) in the window.
ViewProjection sketch_projection(const FrameCamera& camera, ImVec2 origin, float zoom,
                                 const Rect& place);

}  // namespace artisketch
