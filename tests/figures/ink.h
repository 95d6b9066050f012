// Drawings of a figure: flat colours, a shadow tone, outlines of changing width, as a hand would
// draw it in ink and colour; the same as pixel art, or in pencil. What the examples show.
#pragma once

#include "figures.h"
#include "files/image_file.h"

namespace artisketch::figures {

struct InkStyle {
  double line = 3.2;           // mean width of the outline, pixels
  double detail = 1.6;         // mean width of lines between colours, pixels
  double wobble = 0.5;         // how far the hand strays, pixels
  unsigned ink = 0x33262b;     // 0xRRGGBB
  unsigned shadow = 0xd0b4c4;  // multiplies what the light does not reach
  std::uint64_t seed = 1;
  // pixels: each pixel takes one of the colours whole. pencil: tones only, on a sheet of paper that
  // shows through them.
  enum class Medium { ink, pixels, pencil };
  Medium medium = Medium::ink;
};

// The figure in a pose, on a transparent sheet where it isn't paper.
Image ink_drawing(const Figure& figure, const Pose& pose, const FrameCamera& camera, int width,
                  int height, const InkStyle& style = {});

}  // namespace artisketch::figures
