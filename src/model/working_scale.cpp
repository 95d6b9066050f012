#include "model/working_scale.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace artisketch {
namespace {

// Every pixel `times` by `times`.
Image repeated(const Image& picture, int times) {
  Image out(picture.width * times, picture.height * times);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x)
      std::copy_n(picture.at(x / times, y / times), 4, out.at(x, y));
  return out;
}

// The mean of every `side` by `side` pixels: of their colours by how much they cover.
Image mean_of_blocks(const Image& picture, int side) {
  Image out((picture.width + side - 1) / side, (picture.height + side - 1) / side);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const int right = std::min((x + 1) * side, picture.width),
                bottom = std::min((y + 1) * side, picture.height);
      std::array<unsigned, 3> sum = {};
      unsigned alpha = 0, pixels = 0;
      for (int v = y * side; v < bottom; ++v)
        for (int u = x * side; u < right; ++u, ++pixels) {
          const std::uint8_t* p = picture.at(u, v);
          for (int c = 0; c < 3; ++c) sum[c] += unsigned(p[c]) * p[3];
          alpha += p[3];
        }
      std::uint8_t* mean = out.at(x, y);
      for (int c = 0; c < 3; ++c) mean[c] = std::uint8_t(alpha ? (sum[c] + alpha / 2) / alpha : 0);
      mean[3] = std::uint8_t((alpha + pixels / 2) / pixels);
    }
  return out;
}

}  // namespace

namespace {

// Pixels, of the largest figure by its outlines.
double largest_figure(const Document& document) {
  double largest = 0;
  for (const Frame& frame : document.frames) {
    Box2 box;
    for (const Contour& contour : frame.contours)
      for (const Vec2& p : contour.line.points) box.extend(p);
    if (!box.isEmpty()) largest = std::max(largest, box.sizes().maxCoeff());
  }
  return largest;
}

}  // namespace

double working_scale(const Document& document) {
  const double largest = largest_figure(document);
  double pixels = 0;
  for (const Frame& frame : document.frames)
    for (const Contour& contour : frame.contours)
      if (contour.line.closed) pixels += std::abs(signed_area(contour.line));
  double times = 1;
  while (largest > 0 && times < kMostEnlarged && times * largest < kWorkingSize) times *= 2;
  while (times * kMostShrunk > 1 && times * times / 4 * pixels >= kEnoughPixels) times /= 2;
  return times;
}

double shape_scale(const Document& document) {
  constexpr double kMost = 1 << 20;
  const double largest = largest_figure(document);
  double times = 1;
  while (largest > 0 && times < kMost && times * largest < kShapeSize) times *= 2;
  while (times > 1 / kMost && times * largest >= 2 * kShapeSize) times /= 2;
  return times;
}

Document scaled(Document document, double times) {
  if (times == 1) return document;
  document.camera.pixels_per_unit *= times;
  document.camera.focal_length *= times;
  for (Frame& frame : document.frames) {
    // The middle of a picture isn't that of one shrunk to whole pixels.
    if (!frame.principal_point) frame.principal_point = Vec2(frame.width, frame.height) / 2;
    *frame.principal_point *= times;
    frame.width = int(std::ceil(frame.width * times));
    frame.height = int(std::ceil(frame.height * times));
    for (Contour& contour : frame.contours)
      for (Vec2& p : contour.line.points) p *= times;
  }
  return document;
}

Image scaled(const Image& picture, double times) {
  if (times == 1) return picture;
  return times > 1 ? repeated(picture, int(std::lround(times)))
                   : mean_of_blocks(picture, int(std::lround(1 / times)));
}

}  // namespace artisketch
