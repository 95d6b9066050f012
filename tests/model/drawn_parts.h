// Parts drawn from given sides by given outlines, and how well a mesh fits them.
#pragma once

#include <cmath>
#include <vector>

#include "base/raster.h"
#include "model/stages.h"

namespace artisketch::drawn {

// In units, +y up, about the part's origin.
using Outline = std::vector<Vec2>;

inline Outline ellipse(double rx, double ry, const Vec2& centre = Vec2::Zero(), int n = 180) {
  Outline points;
  for (int i = 0; i < n; ++i)
    points.push_back(centre + Vec2(rx * std::cos(2 * kPi * i / n), ry * std::sin(2 * kPi * i / n)));
  return points;
}
inline Outline rectangle(double rx, double ry) {
  return {{-rx, -ry}, {rx, -ry}, {rx, ry}, {-rx, ry}};
}

struct Side {
  Quat turn = Quat::Identity();  // of the part before the camera
  std::vector<Outline> outlines;
  std::vector<Outline> strokes;  // open
};
inline Quat from_front() {
  return Quat::Identity();
}
inline Quat from_right() {
  return Quat(Eigen::AngleAxisd(kPi / 2, Vec3::UnitY()));
}
inline Quat from_above() {
  return Quat(Eigen::AngleAxisd(kPi / 2, Vec3::UnitX()));
}

// One joint, one frame a side. Outlines are in units at the joint's depth.
inline Part part(const std::vector<Side>& sides, const Camera& camera) {
  constexpr int kMiddle = 300;
  Document document;
  document.camera = camera;
  const double pixels_per_unit = camera.type == Camera::Type::perspective
                                     ? camera.focal_length / camera.distance
                                     : camera.pixels_per_unit;
  document.skeleton.joints.push_back({"part", -1, Vec3::Zero(), -1, ""});
  for (const Side& side : sides) {
    Frame frame;
    frame.width = frame.height = 2 * kMiddle;
    frame.pose = rest_pose(document.skeleton);
    frame.pose.rotations[0] = side.turn;
    for (const bool closed : {true, false})
      for (const Outline& outline : closed ? side.outlines : side.strokes) {
        Contour contour;
        contour.line.closed = closed;
        for (const Vec2& p : outline)
          contour.line.points.emplace_back(kMiddle + pixels_per_unit * p.x(),
                                           kMiddle - pixels_per_unit * p.y());
        frame.contours.push_back(contour);
      }
    document.frames.push_back(frame);
  }
  return parts_of(document)[0];
}

inline Part part(const std::vector<Side>& sides, double pixels_per_unit = 100) {
  Camera camera;
  camera.pixels_per_unit = pixels_per_unit;
  return part(sides, camera);
}

// A ball of radius 1 drawn from so near that just a cap of it shows: what outlines it lies before
// its middle.
inline Part near_ball(double distance) {
  const double radius = distance / std::sqrt(distance * distance - 1);
  return part({{from_front(), {ellipse(radius, radius)}, {}},
               {from_right(), {ellipse(radius, radius)}, {}}},
              {Camera::Type::perspective, 0, 100 * distance, distance});
}

inline Part two_circles(double radius = 1) {
  return part({{from_front(), {ellipse(radius, radius)}, {}},
               {from_right(), {ellipse(radius, radius)}, {}}});
}
// A flat ring seen from its axis and from its edge.
inline Part ring() {
  return part({{from_front(), {ellipse(1, 1), ellipse(0.55, 0.55)}, {}},
               {from_right(), {ellipse(0.25, 1)}, {}}});
}

inline Grid3<float> hull_of(const Part& part, int cells) {
  Run run;
  std::vector<std::string> warnings;
  return *visual_hull(part, cells, warnings, run);
}

// Intersection over union of a mesh's silhouette and the drawn one, two samples a pixel.
inline double silhouette_fit(const PartView& view, const Mesh& mesh) {
  constexpr double kScale = 2;
  std::vector<Vec2> pixels;
  Box2 box = view.outline.box();
  for (int v = 0; v < mesh.V.rows(); ++v) {
    pixels.push_back(view.project(mesh.V.row(v).transpose()));
    box.extend(pixels.back());
  }
  const auto to_mask = [&](const Vec2& p) { return Vec2((p - box.min()) * kScale); };
  Mask drawn(int(box.sizes().x() * kScale) + 2, int(box.sizes().y() * kScale) + 2), seen = drawn;
  for (Vec2& p : pixels) p = to_mask(p);
  add_triangles(pixels, mesh.F, seen);
  std::vector<std::vector<Vec2>> polygons;
  for (const Polyline& line : view.contours)
    if (line.closed) {
      polygons.emplace_back();
      for (const Vec2& p : line.points) polygons.back().push_back(to_mask(p));
    }
  add_polygons(polygons, drawn);
  return intersection_over_union(drawn, seen);
}

}  // namespace artisketch::drawn
