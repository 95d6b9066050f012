// What the model's stages mean in pixels they mean of figures drawn some hundred pixels high: a
// smaller one is worked on as if it had been drawn larger, and of one that has far more pixels than
// the model's texture can keep, no more are read than that.
#pragma once

#include "model/stages.h"

namespace artisketch {

// How many times as large a document's drawings are worked on, a power of two from 1 / kMostShrunk
// to kMostEnlarged: more than 1 until the largest figure, by its outlines, is kWorkingSize pixels
// wide or high; less than 1 while the outlines still hold kEnoughPixels in all. 1 where nothing is
// outlined.
double working_scale(const Document& document);
inline constexpr double kWorkingSize = 300;
inline constexpr double kEnoughPixels =
    2e6;  // half of the texels there may be: charts fill no more
inline constexpr int kMostEnlarged = 16, kMostShrunk = 16;

// How many times as large calibration and surfaces take the drawings, which know outlines alone: a
// power of two, so that the largest figure is kShapeSize to twice as many pixels wide or high. It
// costs no digit: drawings that differ in size by a power of two give the same poses and surfaces
// to the bit. 1 where nothing is outlined.
double shape_scale(const Document& document);
inline constexpr double kShapeSize = 375;

// The document or a picture, as if drawn `times` times as large: the same poses and units, more
// pixels or fewer. Pictures grow by repeating pixels, so that their edges stay as sharp
// as they are, and shrink to the mean of the pixels that become one.
Document scaled(Document document, double times);
Image scaled(const Image& picture, double times);  // times or 1 / times whole

// Every side by side pixels of width by height as one, their mean; fewer are one at the right and
// the bottom. Of their colours by how much they cover.
//   rgba  as an image has them
//   side  at most kMostShrunk
Image mean_of_blocks(const std::uint8_t* rgba, int width, int height, int side);

}  // namespace artisketch
