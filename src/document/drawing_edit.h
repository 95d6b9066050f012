// What is done to a drawing as a whole: its outlines and its skeleton go with its picture.
#pragma once

#include "base/image.h"
#include "document/document.h"
#include "document/sprite_sheet.h"

namespace artisketch {

// A quarter turn clockwise, so many times; counterclockwise below 0.
Image turned(const Image& picture, int quarters);
Document with_drawing_turned(Document document, int frame, int quarters);

// Left for right. The outlines are then those of the other side's parts, and the pose is the mirror
// image's; what has no other side stays its own.
Image flipped(const Image& picture);
Document with_drawing_flipped(Document document, int frame);

// What of it lies in a box. Outlines may run beyond, and are kept.
//   box  within the picture
Image cropped(const Image& picture, const PixelBox& box);
Document with_drawing_cropped(Document document, int frame, const PixelBox& box);

// The same drawing in more pixels or fewer, of the same proportions: orthographic cameras only,
// since others have no scale for one frame.
Document with_drawing_resized(Document document, int frame, int width, int height);

}  // namespace artisketch
