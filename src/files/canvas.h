// Drawing on an image: anti-aliased lines, discs, fills, pictures and words. Coordinates are pixels
// from the image's top-left corner, as in FORMAT.md; what lies outside the image is cut off.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/types.h"
#include "files/image_file.h"

namespace artisketch {

struct Colour {
  float r = 0, g = 0, b = 0;  // sRGB, 0 … 1
  float a = 1;                // opacity
};
Colour colour(unsigned rrggbb, double opacity = 1);

// Lays a colour over one pixel, as much of it as `coverage` (0 … 1) says.
void blend(Image& image, int x, int y, const Colour& colour, double coverage);

// Every pixel becomes the colour, its opacity included.
void fill(Image& image, const Colour& colour);

// radius: of the corners.
void draw_rectangle(Image& image, const Box2& box, double radius, double width,
                    const Colour& colour);

// By the even-odd rule.
void fill_polygons(Image& image, std::span<const std::vector<Vec2>> polygons, const Colour& colour);

void fill_disc(Image& image, const Vec2& centre, double radius, const Colour& colour);

// Round ends and corners; one even coat, however often the line crosses itself.
void draw_line(Image& image, std::span<const Vec2> points, bool closed, double width,
               const Colour& colour);

// Discs of diameter `width` at even steps of about `step`, the ends among them.
void draw_dots(Image& image, const Vec2& from, const Vec2& to, double width, double step,
               const Colour& colour);

// `picture` with its top-left corner at (x, y), the corners rounded by `radius`.
void draw_image(Image& image, const Image& picture, int x, int y, double opacity = 1,
                double radius = 0);

// Every pixel is the mean of what it covers where the image shrinks, bilinear where it grows.
Image resized(const Image& image, int width, int height);

struct Lettering {
  double size = 13;  // pixels from baseline to baseline of set type; capitals are 0.72 as high
  bool bold = false;
};

// The width in pixels that a UTF-8 text takes, set in Inter: Latin, Greek and Cyrillic. Characters
// that it lacks show as boxes.
double text_width(std::string_view text, const Lettering& lettering);

// Draws a text from its baseline's left end; returns where it ends.
double draw_text(Image& image, const Vec2& baseline, std::string_view text,
                 const Lettering& lettering, const Colour& colour);

// The text, its end replaced by an ellipsis where it is wider than `width` pixels.
std::string shortened(std::string_view text, const Lettering& lettering, double width);

}  // namespace artisketch
