#include "model/working_scale.h"

#include <algorithm>

namespace artisketch {

int working_scale(const Document& document) {
  double largest = 0;
  for (const Frame& frame : document.frames) {
    Box2 box;
    for (const Contour& contour : frame.contours)
      for (const Vec2& p : contour.line.points) box.extend(p);
    if (!box.isEmpty()) largest = std::max(largest, box.sizes().maxCoeff());
  }
  int times = 1;
  while (largest > 0 && times < kMostEnlarged && times * largest < kWorkingSize) times *= 2;
  return times;
}

Document enlarged(Document document, int times) {
  if (times == 1) return document;
  document.camera.pixels_per_unit *= times;
  document.camera.focal_length *= times;
  for (Frame& frame : document.frames) {
    frame.width *= times;
    frame.height *= times;
    if (frame.principal_point) *frame.principal_point *= times;
    for (Contour& contour : frame.contours)
      for (Vec2& p : contour.line.points) p *= times;
  }
  return document;
}

Part enlarged(Part part, int times) {
  if (times == 1) return part;
  for (PartView& view : part.views) {
    view.camera.camera.pixels_per_unit *= times;
    view.camera.camera.focal_length *= times;
    view.camera.principal_point *= times;
    for (Polyline& line : view.contours)
      for (Vec2& p : line.points) p *= times;
    view.outline = outline_of(view.contours);
  }
  return part;
}

Image enlarged(const Image& picture, int times) {
  Image out(picture.width * times, picture.height * times);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x)
      std::copy_n(picture.at(x / times, y / times), 4, out.at(x, y));
  return out;
}

}  // namespace artisketch
