#include "document/document.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace artisketch {

FrameCamera frame_camera(const Document& document, int frame) {
  const Frame& f = document.frames[frame];
  return {document.camera, f.principal_point.value_or(Vec2(f.width, f.height) / 2),
          document.camera.type == Camera::Type::orthographic ? f.scale : 1};
}

double pixel_size(const Document& document) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < document.frames.size(); ++f) {
    const FrameCamera camera = frame_camera(document, int(f));
    const Vec3& root = document.frames[f].pose.root_position;
    if (camera.in_front(root)) least = std::min(least, 1 / camera.pixels_per_unit(root.z()));
  }
  return std::isfinite(least) ? least : 0;
}

std::vector<Polyline> contours_of(const Frame& frame, int joint) {
  std::vector<Polyline> lines;
  for (const Contour& contour : frame.contours)
    if (contour.joint == joint) lines.push_back(contour.line);
  return lines;
}

bool is_hidden(const Frame& frame, int joint) {
  const auto outlines = [joint](const Contour& contour) { return contour.joint == joint; };
  return std::find(frame.hidden.begin(), frame.hidden.end(), joint) != frame.hidden.end() &&
         std::none_of(frame.contours.begin(), frame.contours.end(), outlines);
}

std::vector<std::vector<Vec2>> closed_contours(const Frame& frame, int joint) {
  return closed_polygons(contours_of(frame, joint));
}

bool is_posed(const Document& document, int frame) {
  return frame == 0 || document.frames[frame].posed;
}

Role role_of(const Document& document, int joint) {
  const auto found = document.parts.find(joint);
  return found == document.parts.end() ? Role::body : found->second.role;
}

namespace {

std::set<int> joints_with_closed_contours(const Document& document) {
  std::set<int> joints;
  for (const Frame& frame : document.frames)
    for (const Contour& contour : frame.contours)
      if (contour.line.closed) joints.insert(contour.joint);
  return joints;
}

// A part that has open contours alone is drawn with them all the same: each that goes round an
// area, from its end straight to its beginning, is closed so. Where none does, the part has no
// body.
void close_lone_strokes(Document& document) {
  constexpr double kLeastArea = 0.01;  // pixels²
  const std::set<int> whole = joints_with_closed_contours(document);
  for (Frame& frame : document.frames)
    for (Contour& contour : frame.contours) {
      if (whole.contains(contour.joint) || contour.line.points.size() < 3) continue;
      Polyline round = contour.line;
      round.closed = true;
      if (std::abs(signed_area(round)) > kLeastArea && !self_crossing(round)) contour.line = round;
    }
  const std::set<int> bodies = joints_with_closed_contours(document);
  for (Frame& frame : document.frames)
    std::erase_if(frame.contours,
                  [&](const Contour& contour) { return !bodies.contains(contour.joint); });
}

}  // namespace

Document with_shaping_contours(Document document) {
  for (Frame& frame : document.frames)
    std::erase_if(frame.contours, [&](const Contour& contour) {
      return role_of(document, contour.joint) == Role::apart;
    });
  const auto tells = [&](int f) {
    return is_posed(document, f) && !document.frames[f].contours.empty();
  };
  bool any = false;
  for (int f = 0; f < int(document.frames.size()); ++f) any = any || tells(f);
  for (int f = 0; any && f < int(document.frames.size()); ++f)
    if (!is_posed(document, f)) document.frames[f].contours.clear();
  close_lone_strokes(document);
  return document;
}

std::vector<int> drawn_joints(const Document& document) {
  std::set<int> joints;
  for (const Frame& frame : document.frames)
    for (const Contour& contour : frame.contours) joints.insert(contour.joint);
  return {joints.begin(), joints.end()};
}

}  // namespace artisketch
