// A joint's bone as a line in a drawing.
#pragma once

#include "document/document.h"

namespace artisketch {

// Where it starts, its direction, its length in pixels. A leaf has the direction of the bone before
// it, and with it its length; a joint alone points down.
struct BoneAxis {
  Vec2 start = Vec2::Zero(), along = Vec2(0, 1);
  double length = 0;
};
BoneAxis bone_axis(const Document& document, int frame, int joint);

}  // namespace artisketch
