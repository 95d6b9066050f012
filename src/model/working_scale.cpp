#include "model/working_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

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

// A row of blocks, side pixels high but at the bottom, of width pixels.
struct BlockRow {
  const std::uint8_t* rgba;
  int width, height;
};

// Down each column, of each channel.
void add_up(const BlockRow& rows, std::vector<std::uint16_t>& sums) {
  static_assert(kMostShrunk * kMostShrunk * 255 <= 0xFFFF);  // a whole block's, too
  const std::size_t stride = 4 * std::size_t(rows.width);
  sums.assign(stride, 0);
  std::uint16_t* const to = sums.data();
  for (int v = 0; v < rows.height; ++v) {
    const std::uint8_t* const row = rows.rgba + stride * v;
    for (std::size_t i = 0; i < stride; ++i) to[i] = std::uint16_t(to[i] + row[i]);
  }
}

// The mean of a block's pixels, of columns [left, right): of their colours by how much they cover.
void covered_mean(const BlockRow& rows, int left, int right, std::uint8_t* to) {
  std::array<unsigned, 3> sum = {};
  unsigned alpha = 0;
  for (int v = 0; v < rows.height; ++v)
    for (int u = left; u < right; ++u) {
      const std::uint8_t* p = rows.rgba + 4 * (std::size_t(v) * rows.width + u);
      for (int c = 0; c < 3; ++c) sum[c] += unsigned(p[c]) * p[3];
      alpha += p[3];
    }
  const unsigned pixels = unsigned((right - left) * rows.height);
  for (int c = 0; c < 3; ++c) to[c] = std::uint8_t((sum[c] + alpha / 2) / alpha);
  to[3] = std::uint8_t((alpha + pixels / 2) / pixels);
}

// The means of all blocks; most are wholly opaque or wholly clear.
//   sums  of their columns
void means(const BlockRow& rows, int side, const std::vector<std::uint16_t>& sums,
           std::uint8_t* to) {
  for (int left = 0; left < rows.width; left += side, to += 4) {
    const int right = std::min(left + side, rows.width);
    const unsigned pixels = unsigned((right - left) * rows.height);
    std::uint64_t four = 0;  // channels, none of which runs over into the next
    for (int u = left; u < right; ++u) {
      std::uint64_t column;
      std::memcpy(&column, &sums[4 * std::size_t(u)], sizeof column);
      four += column;
    }
    std::array<std::uint16_t, 4> sum;
    std::memcpy(sum.data(), &four, sizeof four);
    if (sum[3] == 255 * pixels)
      for (int c = 0; c < 4; ++c) to[c] = std::uint8_t((sum[c] + pixels / 2) / pixels);
    else if (sum[3] == 0)
      std::fill_n(to, 4, std::uint8_t(0));
    else
      covered_mean(rows, left, right, to);
  }
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
                   : mean_of_blocks(picture.rgba.data(), picture.width, picture.height,
                                    int(std::lround(1 / times)));
}

Image mean_of_blocks(const std::uint8_t* rgba, int width, int height, int side) {
  Image out((width + side - 1) / side, (height + side - 1) / side);
  std::vector<std::uint16_t> sums;
  for (int y = 0; y < out.height; ++y) {
    const BlockRow rows{rgba + 4 * std::size_t(width) * y * side, width,
                        std::min(side, height - y * side)};
    add_up(rows, sums);
    means(rows, side, sums, out.at(0, y));
  }
  return out;
}

}  // namespace artisketch
