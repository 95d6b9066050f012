#include "document/document.h"

#include <set>

namespace artisketch {

FrameCamera frame_camera(const Document& document, int frame) {
  const Frame& f = document.frames[frame];
  return {document.camera, f.principal_point.value_or(Vec2(f.width, f.height) / 2),
          document.camera.type == Camera::Type::orthographic ? f.scale : 1};
}

std::vector<Polyline> contours_of(const Frame& frame, int joint) {
  std::vector<Polyline> lines;
  for (const Contour& contour : frame.contours)
    if (contour.joint == joint) lines.push_back(contour.line);
  return lines;
}

std::vector<int> drawn_joints(const Document& document) {
  std::set<int> joints;
  for (const Frame& frame : document.frames)
    for (const Contour& contour : frame.contours) joints.insert(contour.joint);
  return {joints.begin(), joints.end()};
}

}  // namespace artisketch
