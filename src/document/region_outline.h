// From a click on a drawing to the outline of the region about it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/image.h"
#include "document/contour.h"

namespace artisketch {

// A drawing made ready: how its pixels look, what is paper, what is ink. Images of more than two
// million pixels are halved until they aren't.
struct SegmentedImage {
  struct Tone {
    float l = 0, a = 0, b = 0, alpha = 0;  // OKLab times alpha, weighted for comparison
  };
  int width = 0, height = 0;
  int pixels = 1;  // of the drawing, along each side of one of these
  std::vector<Tone> tones;
  std::vector<std::uint8_t>
      paper;                      // what lies about the figure: transparent, or the border's colour
  std::vector<std::uint8_t> ink;  // dark lines, thin, between what is lighter on both sides
};
SegmentedImage segmented(const Image& drawing);

// Where the figure stands: all that isn't paper, in the drawing's pixels. Empty where all is.
Box2 figure_box(const SegmentedImage& image);

// The level at which flooding from the clicked place reaches each pixel: the least tolerance at
// which it belongs to the region. Paper is never reached, unless it was clicked.
struct FloodLevels {
  std::vector<float> level;  // per pixel, 0 … kMostUnlike; infinite where it is never reached
  int seed = 0;              // index of the clicked pixel
};
inline constexpr float kMostUnlike = 1.5f;
bool is_paper(const SegmentedImage& image, const Vec2& at);
FloodLevels flood_levels(const SegmentedImage& image,
                         const Vec2& at);  // `at` in the drawing's pixels

// The region's outline, and its holes: what is paper within it and a tenth of it or more. A
// boundary along an ink line stands on the line's middle, one between two colours where each
// covers half a pixel. Smoothed and simplified to within 0.35 pixels; never crosses itself.
//   tolerance  0 … 1: from the clicked colour alone to all that hangs together and isn't paper
// Nothing where the image has no pixels or paper was clicked.
struct RegionOutline {
  Polyline outline;
  std::vector<Polyline> holes;
};
std::optional<RegionOutline> region_outline(const SegmentedImage& image, const FloodLevels& levels,
                                            double tolerance);
inline constexpr double kUsualTolerance = 0.1;

// The same about chosen pixels of the image: its largest piece. Nothing where none is chosen.
//   pixels  1 where it belongs, else 0; as many as the image has
std::optional<RegionOutline> outline_of_pixels(const SegmentedImage& image,
                                               const std::vector<std::uint8_t>& pixels);

// How unlike two tones look: their distance in OKLab, where lightness counts less; at least 0.6
// from nothing to an opaque colour.
float unlikeness(const SegmentedImage::Tone& a, const SegmentedImage::Tone& b);

}  // namespace artisketch
