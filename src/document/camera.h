// The real camera, one for all frames, and its image of a frame. Conventions: FORMAT.md.
#pragma once

#include "base/types.h"

namespace artisketch {

struct Camera {
  enum class Type { orthographic, perspective };
  Type type = Type::orthographic;
  double pixels_per_unit = 100;  // orthographic: pixels per unit, > 0
  double focal_length = 1000;    // perspective: pixels, > 0
  double distance = 5;           // perspective: the camera stands at (0, 0, distance), > 0
};

struct Ray {
  Vec3 origin;
  Vec3 direction;  // unit length, away from the camera
  Vec3 at(double depth) const { return origin + depth * direction; }
  double depth_at(double z) const { return (z - origin.z()) / direction.z(); }
  Vec3 at_z(double z) const { return at(depth_at(z)); }  // its point with that z in the world
};

// The point nearest to rays, as lines: where the sum of its squared distances from them, and of
// `weight` times that from `otherwise`, is least. `weight` > 0: parallel rays leave a depth open.
class NearestToRays {
 public:
  NearestToRays(const Vec3& otherwise, double weight)
      : A_(weight * Mat3::Identity()), b_(weight * otherwise) {}
  void add(const Ray& ray) {
    const Mat3 across = Mat3::Identity() - ray.direction * ray.direction.transpose();
    A_ += across;
    b_ += across * ray.origin;
  }
  Vec3 point() const { return A_.inverse() * b_; }

 private:
  Mat3 A_;
  Vec3 b_;
};

// The camera as one frame sees it: with the frame's principal point and, where orthographic, its
// scale (FORMAT.md, frames[].scale).
struct FrameCamera {
  Camera camera;
  Vec2 principal_point = Vec2::Zero();  // pixels
  double scale = 1;

  // Pixel of the world point X. In perspective X must lie before the camera: in_front(X).
  Vec2 project(const Vec3& X) const {
    const double s = pixels_per_unit(X.z());
    return {principal_point.x() + s * X.x(), principal_point.y() - s * X.y()};
  }
  bool in_front(const Vec3& X) const {
    return camera.type == Camera::Type::orthographic || X.z() < camera.distance;
  }
  // Pixels that one unit across the view takes at world depth z.
  double pixels_per_unit(double z) const {
    return camera.type == Camera::Type::orthographic ? camera.pixels_per_unit * scale
                                                     : camera.focal_length / (camera.distance - z);
  }
  // Derivative of project at X, 2×3.
  Eigen::Matrix<double, 2, 3> jacobian(const Vec3& X) const {
    const double s = pixels_per_unit(X.z());
    Eigen::Matrix<double, 2, 3> J;
    J << s, 0, 0, 0, -s, 0;
    if (camera.type == Camera::Type::perspective)
      J.col(2) = Vec2(X.x(), -X.y()) * (s / (camera.distance - X.z()));
    return J;
  }
  // World ray through a pixel. Orthographic rays start in the plane z = 0 (their depth may be
  // negative), perspective ones at the camera.
  Ray ray(const Vec2& pixel) const {
    const Vec2 d = pixel - principal_point;
    if (camera.type == Camera::Type::orthographic) {
      const double s = pixels_per_unit(0);
      return {{d.x() / s, -d.y() / s, 0}, {0, 0, -1}};
    }
    return {{0, 0, camera.distance}, Vec3(d.x(), -d.y(), -camera.focal_length).normalized()};
  }
};

}  // namespace artisketch
