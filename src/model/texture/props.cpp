#include "model/texture/props.h"

#include <algorithm>

#include "base/raster.h"

namespace artisketch {
namespace {

// Per pixel, the joint of that role whose outline lies there with none of another joint's before
// it; −1: none. Empty where no joint of the role is outlined.
std::vector<int> seen_of(const Document& document, int frame, Role role) {
  const Frame& drawn = document.frames[frame];
  std::vector<int> order;  // joints by their last closed outline, from behind
  bool any = false;
  for (const Contour& contour : drawn.contours) {
    if (!contour.line.closed) continue;
    std::erase(order, contour.joint);
    order.push_back(contour.joint);
    any = any || role_of(document, contour.joint) == role;
  }
  if (!any) return {};
  std::vector<int> seen(std::size_t(drawn.width) * drawn.height, -1);
  for (const int joint : order) {
    Mask part(drawn.width, drawn.height);
    add_polygons(closed_contours(drawn, joint), part);
    const int there = role_of(document, joint) == role ? joint : -1;
    for (std::size_t p = 0; p < seen.size(); ++p)
      if (part.in[p]) seen[p] = there;
  }
  return seen;
}

}  // namespace

std::vector<int> held_things(const Document& document, int frame) {
  return seen_of(document, frame, Role::held);
}

Image without_things_apart(const Document& document, int frame, const Image& picture) {
  const Frame& drawn = document.frames[frame];
  if (picture.width != drawn.width || picture.height != drawn.height) return {};
  const std::vector<int> seen = seen_of(document, frame, Role::apart);
  if (seen.empty()) return {};
  Image out = picture;
  for (std::size_t p = 0; p < seen.size(); ++p)
    if (seen[p] >= 0) std::fill_n(&out.rgba[4 * p], 4, std::uint8_t(0));
  return out;
}

}  // namespace artisketch
