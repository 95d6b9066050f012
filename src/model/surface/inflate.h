// The depth of a part that its views leave open: one drawing, or several from nearly one direction.
#pragma once

#include "model/surface/carving.h"

namespace artisketch {

// World depth as a function of a view's pixel: the sheet about which a part without a depth of its
// own lies, z = at + slope · (pixel − centre).
struct MiddleSheet {
  Vec2 centre = Vec2::Zero();
  Vec2 slope = Vec2::Zero();  // units per pixel
  double at = 0;
  double depth(const Vec2& pixel) const { return at + slope.dot(pixel - centre); }
};

// The plane nearest to the bones through a point (of rest space), upright against the view where
// they don't say otherwise. bones may be empty.
MiddleSheet middle_sheet(const PartView& view, std::span<const Bone> bones, const Vec3& through);

// Raises `field` to the plump body that an outline alone suggests: half as thick at a pixel as √u,
// where Δu is constant inside the outline and u nothing on it, so that a disc becomes a ball and a
// strip a round rod; as thick at its thickest as it is wide there, times `fatness`. It lies about
// the view's middle sheet through a point.
void inflate(const Silhouette& outline, std::span<const Bone> bones, const Vec3& through,
             double fatness, Grid3<float>& field);

}  // namespace artisketch
