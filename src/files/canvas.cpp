#include "files/canvas.h"

#include <algorithm>
#include <cmath>
#include <new>

#define STB_IMAGE_RESIZE_IMPLEMENTATION
#define STB_IMAGE_RESIZE_STATIC
#include <stb/stb_image_resize.h>

#include "base/raster.h"

namespace artisketch {
namespace {

// Pixels x0 ≤ x < x1, y0 ≤ y < y1 of an image.
struct Pixels {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  int width() const { return std::max(x1 - x0, 0); }
  int height() const { return std::max(y1 - y0, 0); }
};

Pixels touched(const Image& image, const Box2& box, double margin) {
  const auto at = [](double v, int n) { return int(std::clamp(v, 0.0, double(n))); };
  return {at(std::floor(box.min().x() - margin), image.width),
          at(std::floor(box.min().y() - margin), image.height),
          at(std::ceil(box.max().x() + margin), image.width),
          at(std::ceil(box.max().y() + margin), image.height)};
}

// How much of a pixel lies within a shape whose edge is `distance` away, negative inside.
double coverage(double distance) {
  return std::clamp(0.5 - distance, 0.0, 1.0);
}

double rounded_box_distance(const Box2& box, double radius, const Vec2& p) {
  const Vec2 q = (p - box.center()).cwiseAbs() - box.sizes() / 2 + Vec2::Constant(radius);
  return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0) - radius;
}

double segment_distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double dd = d.squaredNorm();
  const double t = dd > 0 ? std::clamp((p - a).dot(d) / dd, 0.0, 1.0) : 0.0;
  return (p - a - t * d).norm();
}

bool finite(const Vec2& p) {
  return std::abs(p.x()) < kFarthestPixel && std::abs(p.y()) < kFarthestPixel;
}

}  // namespace

Colour colour(unsigned rrggbb, double opacity) {
  const auto part = [&](int shift) { return float(rrggbb >> shift & 255) / 255; };
  return {part(16), part(8), part(0), float(opacity)};
}

void blend(Image& image, int x, int y, const Colour& colour, double coverage) {
  const double a = colour.a * coverage;
  if (a <= 0) return;
  std::uint8_t* p = image.at(x, y);
  const double under = p[3] / 255.0 * (1 - a), all = a + under;
  const float c[3] = {colour.r, colour.g, colour.b};
  for (int k = 0; k < 3; ++k)
    p[k] = std::uint8_t(std::clamp((255.0 * c[k] * a + p[k] * under) / all + 0.5, 0.0, 255.0));
  p[3] = std::uint8_t(255 * all + 0.5);
}

void fill(Image& image, const Colour& colour) {
  const float c[4] = {colour.r, colour.g, colour.b, colour.a};
  for (std::size_t i = 0; i < image.rgba.size(); ++i)
    image.rgba[i] = std::uint8_t(255 * c[i % 4] + 0.5f);
}

void draw_rectangle(Image& image, const Box2& box, double radius, double width,
                    const Colour& colour) {
  const Pixels area = touched(image, box, width + 1);
  const double border = radius + width + 1;
  for (int y = area.y0; y < area.y1; ++y)
    for (int x = area.x0; x < area.x1; ++x) {
      const Vec2 in = (box.sizes() / 2 - (Vec2(x + 0.5, y + 0.5) - box.center()).cwiseAbs());
      if (in.minCoeff() > border) {  // on to the other side
        x = std::max(x, int(box.max().x() - border) - 1);
        continue;
      }
      const double edge = std::abs(rounded_box_distance(box, radius, {x + 0.5, y + 0.5}));
      blend(image, x, y, colour, coverage(edge - width / 2));
    }
}

void fill_polygons(Image& image, std::span<const std::vector<Vec2>> polygons,
                   const Colour& colour) {
  constexpr int kSamples = 4;  // per pixel, along x and y
  Box2 box;
  for (const std::vector<Vec2>& polygon : polygons)
    for (const Vec2& p : polygon)
      if (finite(p)) box.extend(p);
  if (box.isEmpty()) return;
  const Pixels area = touched(image, box, 0);
  Mask mask(area.width() * kSamples, area.height() * kSamples);
  std::vector<std::vector<Vec2>> scaled(polygons.begin(), polygons.end());
  for (std::vector<Vec2>& polygon : scaled)
    for (Vec2& p : polygon) p = (p - Vec2(area.x0, area.y0)) * kSamples;
  add_polygons(scaled, mask);
  for (int y = area.y0; y < area.y1; ++y)
    for (int x = area.x0; x < area.x1; ++x) {
      int in = 0;
      for (int s = 0; s < kSamples * kSamples; ++s)
        in += mask.at((x - area.x0) * kSamples + s % kSamples,
                      (y - area.y0) * kSamples + s / kSamples);
      blend(image, x, y, colour, in / double(kSamples * kSamples));
    }
}

void fill_disc(Image& image, const Vec2& centre, double radius, const Colour& colour) {
  const Vec2 line[] = {centre};
  draw_line(image, line, false, 2 * radius, colour);
}

void draw_line(Image& image, std::span<const Vec2> points, bool closed, double width,
               const Colour& colour) {
  Box2 box;
  for (const Vec2& p : points)
    if (finite(p)) box.extend(p);
  if (box.isEmpty()) return;
  const double reach = width / 2 + 1;
  const Pixels area = touched(image, box, reach);
  // The nearest piece of the line decides how much of a pixel it covers.
  std::vector<float> covered(std::size_t(area.width()) * area.height(), 0.0f);
  const std::size_t n = points.size(), pieces = closed || n == 1 ? n : n - 1;
  for (std::size_t i = 0; i < pieces; ++i) {
    const Vec2 &a = points[i], &b = points[(i + 1) % n];
    if (!finite(a) || !finite(b)) continue;
    const Pixels near = touched(image, Box2(a.cwiseMin(b), a.cwiseMax(b)), reach);
    for (int y = near.y0; y < near.y1; ++y)
      for (int x = near.x0; x < near.x1; ++x) {
        float& c = covered[std::size_t(y - area.y0) * area.width() + (x - area.x0)];
        const double d = segment_distance({x + 0.5, y + 0.5}, a, b);
        c = std::max(c, float(coverage(d - width / 2)));
      }
  }
  for (int y = area.y0; y < area.y1; ++y)
    for (int x = area.x0; x < area.x1; ++x)
      blend(image, x, y, colour, covered[std::size_t(y - area.y0) * area.width() + (x - area.x0)]);
}

void draw_dots(Image& image, const Vec2& from, const Vec2& to, double width, double step,
               const Colour& colour) {
  if (!finite(from) || !finite(to)) return;
  // A dot per pixel of the image at most: the rest of a longer line lies outside.
  const double most = image.width + image.height;
  const int n = int(std::clamp(std::round((to - from).norm() / step), 1.0, most));
  for (int i = 0; i <= n; ++i) fill_disc(image, from + (to - from) * i / n, width / 2, colour);
}

void draw_image(Image& image, const Image& picture, int x, int y, double opacity, double radius) {
  const Box2 box(Vec2(x, y), Vec2(x + picture.width, y + picture.height));
  const Pixels area = touched(image, box, 0);
  for (int v = area.y0; v < area.y1; ++v)
    for (int u = area.x0; u < area.x1; ++u) {
      const std::uint8_t* p = picture.at(u - x, v - y);
      const bool corner = std::min(u - x, x + picture.width - 1 - u) < radius &&
                          std::min(v - y, y + picture.height - 1 - v) < radius;
      const double shown =
          corner ? coverage(rounded_box_distance(box, radius, {u + 0.5, v + 0.5})) : 1;
      blend(image, u, v, {p[0] / 255.0f, p[1] / 255.0f, p[2] / 255.0f, p[3] / 255.0f},
            opacity * shown);
    }
}

Image resized(const Image& image, int width, int height) {
  if (image.width <= 0 || image.height <= 0 || width <= 0 || height <= 0) return {};
  const auto filter = [](int from, int to) {
    return to < from ? STBIR_FILTER_BOX : STBIR_FILTER_TRIANGLE;
  };
  Image out(width, height);
  constexpr int kChannels = 4, kAlpha = 3, kPacked = 0, kStraightAlpha = 0;
  if (!stbir_resize(image.rgba.data(), image.width, image.height, kPacked, out.rgba.data(), width,
                    height, kPacked, STBIR_TYPE_UINT8, kChannels, kAlpha, kStraightAlpha,
                    STBIR_EDGE_CLAMP, STBIR_EDGE_CLAMP, filter(image.width, width),
                    filter(image.height, height), STBIR_COLORSPACE_LINEAR, nullptr))
    throw std::bad_alloc();  // its only failure
  return out;
}

}  // namespace artisketch
