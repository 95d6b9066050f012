// A part's virtual cameras (the paper's section 2.1).
#include <algorithm>
#include <cmath>
#include <map>

#include "model/one_order.h"
#include "model/specks.h"
#include "model/stages.h"

namespace artisketch {
namespace {

double closed_area(const Polyline& line) {
  return line.closed ? std::abs(signed_area(line)) : 0;
}

}  // namespace

Document without_specks(Document document) {
  constexpr double kSpeck = 4;           // pixels²
  constexpr double kBesideWhole = 0.01;  // of the part's largest contour there
  for (Frame& frame : document.frames) {
    std::map<int, double> largest;  // by joint
    for (const Contour& contour : frame.contours)
      largest[contour.joint] = std::max(largest[contour.joint], closed_area(contour.line));
    std::erase_if(frame.contours, [&](const Contour& contour) {
      return contour.line.closed &&
             closed_area(contour.line) < std::min(kSpeck, kBesideWhole * largest[contour.joint]);
    });
  }
  return document;
}

Ray PartView::ray(const Vec2& pixel) const {
  const Ray world = camera.ray(pixel);
  const Transform to_rest = to_world.inverse();
  return {to_rest * world.origin, to_rest.linear() * world.direction};
}

PolygonDistance outline_of(const std::vector<Polyline>& contours) {
  return PolygonDistance(closed_polygons(contours));
}

std::vector<Part> parts_of(const Document& given) {
  const Document document = without_specks(given);
  const std::vector<Vec3> rest = rest_positions(document.skeleton);
  std::vector<std::vector<Transform>> to_world;
  for (const Frame& frame : document.frames)
    to_world.push_back(skinning_transforms(document.skeleton, frame.pose));
  std::vector<Part> parts;
  for (const int joint : drawn_joints(document)) {
    Part part;
    part.joint = joint;
    part.name = document.skeleton.joints[joint].name;
    part.origin = rest[joint];
    if (const auto it = document.parts.find(joint); it != document.parts.end())
      part.fatness = it->second.fatness;
    for (const int end : document.skeleton.children(joint))
      if (role_of(document, end) == Role::body)  // no bone leads to a thing
        part.bones.push_back({joint, end, rest[joint], rest[end]});
    for (int f = 0; f < int(document.frames.size()); ++f) {
      PartView view;
      view.contours = in_one_order(contours_of(document.frames[f], joint));
      if (view.contours.empty()) continue;
      view.frame = f;
      view.camera = frame_camera(document, f);
      view.to_world = to_world[f][joint];
      view.outline = outline_of(view.contours);
      part.views.push_back(std::move(view));
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

Document with_poses(const Document& document, const Calibration& calibration) {
  Document moved = document;
  for (std::size_t f = 0; f < moved.frames.size(); ++f) {
    moved.frames[f].pose = calibration.poses[f];
    moved.frames[f].scale = calibration.scales[f];
  }
  return moved;
}

}  // namespace artisketch
