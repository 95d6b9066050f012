// What is drawn over sketches and models: contours and skeletons in their joints' colours, as the
// editor shows them (EDITOR.md).
#pragma once

#include <span>
#include <vector>

#include "document/document.h"
#include "files/canvas.h"

namespace artisketch {

// The palette's colour of a joint (EDITOR.md), 0xRRGGBB.
unsigned joint_colour(int joint);

// A frame's contours, `scale` pixels of the image per pixel of the sketch: a coloured line in a
// white casing. fill: opacity of the parts' insides.
void draw_contours(Image& image, const Frame& frame, double scale, double line_width, double fill);

// Where a pose's joints show in a picture; joints behind the camera have no finite place.
std::vector<Vec2> joint_pixels(const Skeleton& skeleton, const Pose& pose, const Transform& view,
                               const FrameCamera& camera);

// Bones as lines and joints as rings in their colours.
void draw_skeleton(Image& image, const Skeleton& skeleton, std::span<const Vec2> pixels);
// As grey dots: the pose that another one replaced.
void draw_former_skeleton(Image& image, const Skeleton& skeleton, std::span<const Vec2> pixels);

}  // namespace artisketch
