#include "document/region_outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/oklab.h"
#include "base/srgb.h"
#include "document/line_fit.h"

namespace artisketch {
namespace {

using Tone = SegmentedImage::Tone;
using Bits = std::vector<std::uint8_t>;

// ---------------------------------------------------------------- how pixels look

// Shading changes lightness before anything else: less of it counts. Transparency differs from
// any colour by at least so much.
constexpr float kLightness = 0.6f, kTransparency = 0.6f;

}  // namespace

float unlikeness(const Tone& x, const Tone& y) {
  const float l = x.l - y.l, a = x.a - y.a, b = x.b - y.b, t = x.alpha - y.alpha;
  return std::sqrt(l * l + a * a + b * b + t * t);
}

namespace {

// How dark a pixel looks on white paper: OKLab's lightness.
float lightness(const Tone& t) {
  return t.l / kLightness + 1 - t.alpha / kTransparency;
}

void read_tones(const Image& drawing, SegmentedImage& image) {
  float curve[256];
  for (int v = 0; v < 256; ++v) curve[v] = to_linear(float(v) / 255);
  const int k = image.pixels;
  image.tones.resize(std::size_t(image.width) * image.height);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      float sum[4] = {0, 0, 0, 0};
      for (int j = 0; j < k; ++j)
        for (int i = 0; i < k; ++i) {
          const std::uint8_t* p = drawing.at(x * k + i, y * k + j);
          const float alpha = float(p[3]) / 255;
          for (int c = 0; c < 3; ++c) sum[c] += alpha * curve[p[c]];
          sum[3] += alpha;
        }
      Tone& tone = image.tones[std::size_t(y) * image.width + x];
      if (sum[3] <= 0) continue;
      const float alpha = sum[3] / float(k * k);
      const Eigen::Vector3f lab = oklab(sum[0] / sum[3], sum[1] / sum[3], sum[2] / sum[3]);
      tone = {lab[0], lab[1], lab[2], 1};
      tone = {kLightness * alpha * tone.l, alpha * tone.a, alpha * tone.b, kTransparency * alpha};
    }
}

// ---------------------------------------------------------------- masks

// Calls f(neighbour) for the four or eight neighbours of pixel i.
template <class F>
void neighbours(int i, int w, int h, bool eight, const F& f) {
  const int x = i % w, y = i / w;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx)
      if ((dx || dy) && (eight || !dx || !dy) && x + dx >= 0 && y + dy >= 0 && x + dx < w &&
          y + dy < h)
        f(i + dy * w + dx);
}

Bits grown(const Bits& mask, int w, int h) {
  Bits result = mask;
  for (int i = 0; i < w * h; ++i)
    if (mask[i]) neighbours(i, w, h, true, [&](int n) { result[n] = 1; });
  return result;
}

// The pixels whose neighbours all belong; what lies beyond the image belongs.
Bits shrunk(const Bits& mask, int w, int h) {
  Bits result = mask;
  for (int i = 0; i < w * h; ++i)
    if (!mask[i]) neighbours(i, w, h, true, [&](int n) { result[n] = 0; });
  return result;
}

// The pixels of `mask` that hang together with the seeds, which need not belong themselves.
Bits connected(const Bits& mask, std::vector<int> seeds, int w, int h, bool eight = false) {
  Bits result(mask.size(), 0);
  std::vector<int>& open = seeds;
  open.erase(std::remove_if(open.begin(), open.end(), [&](int i) { return !mask[i]; }), open.end());
  for (int i : open) result[i] = 1;
  while (!open.empty()) {
    const int i = open.back();
    open.pop_back();
    neighbours(i, w, h, eight, [&](int n) {
      if (!mask[n] || result[n]) return;
      result[n] = 1;
      open.push_back(n);
    });
  }
  return result;
}

std::vector<int> border(int w, int h) {
  std::vector<int> pixels;
  for (int x = 0; x < w; ++x) pixels.push_back(x), pixels.push_back((h - 1) * w + x);
  for (int y = 0; y < h; ++y) pixels.push_back(y * w), pixels.push_back(y * w + w - 1);
  return pixels;
}

// The lightest (or darkest) within `radius` along rows and columns, a square about each pixel.
std::vector<float> extreme(std::vector<float> values, int w, int h, int radius, bool most) {
  std::vector<float> line;
  const auto sweep = [&](int lines, int count, int along, int across) {
    for (int l = 0; l < lines; ++l) {
      line.resize(std::size_t(count));
      for (int i = 0; i < count; ++i) line[i] = values[l * across + i * along];
      // The best so far, kept until it is out of reach.
      int best = -1;
      for (int i = 0; i < count; ++i) {
        const int from = std::max(0, i - radius), to = std::min(count - 1, i + radius);
        const auto better = [&](int a, int b) {
          return most ? line[a] >= line[b] : line[a] <= line[b];
        };
        if (best < from) {
          best = from;
          for (int k = from + 1; k <= to; ++k)
            if (better(k, best)) best = k;
        } else if (better(to, best)) {
          best = to;
        }
        values[l * across + i * along] = line[best];
      }
    }
  };
  sweep(h, w, 1, w);
  sweep(w, h, w, 1);
  return values;
}

// ---------------------------------------------------------------- paper and ink

Bits paper_of(const SegmentedImage& image) {
  const int w = image.width, h = image.height, n = w * h;
  Bits paper(std::size_t(n), 0);
  constexpr double kSheer = 0.01;  // an image this much of which is transparent is a cut-out
  int clear = 0;
  for (int i = 0; i < n; ++i) clear += paper[i] = image.tones[i].alpha < kTransparency / 2;
  if (clear >= kSheer * n && clear > 0) return paper;
  // The border's usual colour, where it has one.
  const std::vector<int> rim = border(w, h);
  const auto middle = [&](float Tone::*part) {
    std::vector<float> values;
    for (int i : rim) values.push_back(image.tones[i].*part);
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
  };
  const Tone usual{middle(&Tone::l), middle(&Tone::a), middle(&Tone::b), middle(&Tone::alpha)};
  constexpr float kAlike = 0.06f;  // scans are uneven
  int alike = 0;
  for (int i : rim) alike += unlikeness(image.tones[i], usual) < kAlike;
  Bits like(std::size_t(n), 0);
  if (alike * 5 < int(rim.size()) * 3) return like;
  for (int i = 0; i < n; ++i) like[i] = unlikeness(image.tones[i], usual) < kAlike;
  // A gap of two pixels in an ink line lets nothing through.
  const Bits open = connected(shrunk(like, w, h), rim, w, h);
  const Bits near = grown(open, w, h);
  for (int i = 0; i < n; ++i) paper[i] = near[i] && like[i];
  return paper;
}

// Lines at most two reaches wide that are darker than both sides: what a morphological closing of
// the lightness fills.
Bits ink_of(const SegmentedImage& image) {
  const int w = image.width, h = image.height;
  std::vector<float> light(image.tones.size());
  for (std::size_t i = 0; i < light.size(); ++i) light[i] = lightness(image.tones[i]);
  const int reach = std::clamp(int(std::lround(0.008 * std::min(w, h))), 2, 8);
  const std::vector<float> closed = extreme(extreme(light, w, h, reach, true), w, h, reach, false);
  constexpr float kDarker = 0.12f;
  Bits ink(light.size(), 0);
  for (std::size_t i = 0; i < light.size(); ++i) ink[i] = closed[i] - light[i] > kDarker;
  return ink;
}

int pixel_at(const SegmentedImage& image, const Vec2& at) {
  const auto along = [&](double v, int size) {
    return int(std::clamp(std::floor(v / image.pixels), 0.0, double(size - 1)));
  };
  return along(at.y(), image.height) * image.width + along(at.x(), image.width);
}

}  // namespace

SegmentedImage segmented(const Image& drawing) {
  constexpr double kMost = 2e6;
  SegmentedImage image;
  while (double(drawing.width / image.pixels) * (drawing.height / image.pixels) > kMost)
    image.pixels *= 2;
  image.width = drawing.width / image.pixels;
  image.height = drawing.height / image.pixels;
  if (image.width < 1 || image.height < 1) return {};
  read_tones(drawing, image);
  image.paper = paper_of(image);
  image.ink = ink_of(image);
  return image;
}

Box2 figure_box(const SegmentedImage& image) {
  Box2 box;
  for (int i = 0; i < int(image.paper.size()); ++i) {
    if (image.paper[i]) continue;
    const Vec2 corner(i % image.width, i / image.width);
    box.extend(Vec2(image.pixels * corner));
    box.extend(Vec2(image.pixels * (corner + Vec2(1, 1))));
  }
  return box;
}

bool is_paper(const SegmentedImage& image, const Vec2& at) {
  const Vec2 size = image.pixels * Vec2(image.width, image.height);
  return image.tones.empty() || at.minCoeff() < 0 || at.x() >= size.x() || at.y() >= size.y() ||
         image.paper[pixel_at(image, at)];
}

// Pixels are reached in the order of how unlike they are, so each gets the least that a way to it
// demands. Source: the watershed by flooding, Meyer 1991.
FloodLevels flood_levels(const SegmentedImage& image, const Vec2& at) {
  FloodLevels levels;
  if (image.tones.empty()) return levels;
  const int w = image.width, h = image.height;
  levels.seed = pixel_at(image, at);
  // The clicked colour, from the like of it next to it: drawings are noisy.
  Tone mean = image.tones[levels.seed];
  const Tone seed = mean;
  float count = 1;
  neighbours(levels.seed, w, h, true, [&](int n) {
    const Tone& t = image.tones[n];
    if (unlikeness(t, seed) > 0.05f) return;
    mean = {mean.l + t.l, mean.a + t.a, mean.b + t.b, mean.alpha + t.alpha};
    ++count;
  });
  mean = {mean.l / count, mean.a / count, mean.b / count, mean.alpha / count};
  constexpr int kSteps = 1024;
  std::vector<std::vector<int>> waiting(kSteps);
  levels.level.assign(image.tones.size(), std::numeric_limits<float>::infinity());
  const bool on_paper = image.paper[levels.seed];
  const auto reach = [&](int i, float level) {
    levels.level[i] = level;
    waiting[std::size_t(level / kMostUnlike * (kSteps - 1))].push_back(i);
  };
  reach(levels.seed, 0);
  for (int step = 0; step < kSteps; ++step)
    while (!waiting[step].empty()) {
      const int i = waiting[step].back();
      waiting[step].pop_back();
      neighbours(i, w, h, false, [&](int n) {
        if (levels.level[n] <= kMostUnlike || (image.paper[n] && !on_paper)) return;
        reach(n,
              std::min(kMostUnlike, std::max(levels.level[i], unlikeness(image.tones[n], mean))));
      });
    }
  return levels;
}

namespace {

// ---------------------------------------------------------------- the region

// A piece of the image about the region, with masks of its own.
struct Window {
  int x = 0, y = 0, w = 0, h = 0;
  Bits region, paper, ink;
  std::vector<Tone> tones;
};

Window window_about(const SegmentedImage& image, const Bits& region) {
  const int w = image.width;
  int low_x = w, low_y = image.height, high_x = -1, high_y = -1;
  for (int i = 0; i < int(region.size()); ++i)
    if (region[i]) {
      low_x = std::min(low_x, i % w), high_x = std::max(high_x, i % w);
      low_y = std::min(low_y, i / w), high_y = std::max(high_y, i / w);
    }
  constexpr int kMargin = 20;  // more than any ink line's width
  Window window;
  window.x = std::max(0, low_x - kMargin), window.y = std::max(0, low_y - kMargin);
  window.w = std::min(w, high_x + kMargin + 1) - window.x;
  window.h = std::min(image.height, high_y + kMargin + 1) - window.y;
  for (int y = 0; y < window.h; ++y)
    for (int x = 0; x < window.w; ++x) {
      const int i = (y + window.y) * w + x + window.x;
      window.region.push_back(region[i]);
      window.paper.push_back(image.paper[i]);
      window.ink.push_back(image.ink[i]);
      window.tones.push_back(image.tones[i]);
    }
  return window;
}

// What leaked through a gap of a pixel or two is let go.
void cut_leaks(Window& v, int seed) {
  const Bits core = shrunk(v.region, v.w, v.h);
  std::vector<int> seeds = {seed};
  neighbours(seed, v.w, v.h, true, [&](int n) { seeds.push_back(n); });
  const Bits own = connected(core, seeds, v.w, v.h);
  if (std::find(own.begin(), own.end(), 1) == own.end()) return;  // a thin line, as a whole
  const Bits near = grown(grown(own, v.w, v.h), v.w, v.h);
  for (std::size_t i = 0; i < near.size(); ++i) v.region[i] = v.region[i] && near[i];
}

// Holes are filled, but for large ones through which paper shows.
void fill_holes(Window& v) {
  constexpr double kLarge = 0.1;  // of the region
  const int n = v.w * v.h;
  Bits rest(v.region.size());
  int area = 0;
  for (int i = 0; i < n; ++i) area += v.region[i], rest[i] = !v.region[i];
  // The region is connected by edges, so what surrounds it is by corners as well.
  Bits known = v.region;
  const auto learn = [&](const Bits& piece) {
    for (int i = 0; i < n; ++i) known[i] = known[i] || piece[i];
  };
  // Beyond the window lies the outside.
  std::vector<int> outside;
  for (int i : border(v.w, v.h))
    if (rest[i]) outside.push_back(i);
  learn(connected(rest, outside, v.w, v.h, true));
  for (int i = 0; i < n; ++i) {
    if (known[i]) continue;
    std::vector<int> hole, open = {i};
    int paper = 0;
    known[i] = 1;
    while (!open.empty()) {
      const int p = open.back();
      open.pop_back();
      hole.push_back(p);
      paper += v.paper[p];
      neighbours(p, v.w, v.h, true, [&](int q) {
        if (!known[q]) known[q] = 1, open.push_back(q);
      });
    }
    if (paper * 2 > int(hole.size()) && double(hole.size()) >= kLarge * area) continue;
    for (int p : hole) v.region[p] = 1;
  }
}

// Steps from the nearest pixel of the mask, diagonal ones as long as they are.
std::vector<float> steps_from(const Bits& mask, int w, int h) {
  constexpr float kFar = 1e6f, kDiagonal = 1.41421356f;
  std::vector<float> steps(mask.size());
  for (std::size_t i = 0; i < mask.size(); ++i) steps[i] = mask[i] ? 0 : kFar;
  const auto relax = [&](int i) {
    neighbours(i, w, h, true, [&](int n) {
      const bool straight = n == i - 1 || n == i + 1 || n == i - w || n == i + w;
      steps[i] = std::min(steps[i], steps[n] + (straight ? 1 : kDiagonal));
    });
  };
  for (int i = 0; i < w * h; ++i) relax(i);
  for (int i = w * h - 1; i >= 0; --i) relax(i);
  return steps;
}

// How much of a boundary pixel is the region's: where its tone lies between those of the two
// sides close by.
float covered(const Window& v, const Bits& core, const Bits& far, int i) {
  Tone in, out;
  int ins = 0, outs = 0;
  const auto add = [](Tone& sum, const Tone& t) {
    sum = {sum.l + t.l, sum.a + t.a, sum.b + t.b, sum.alpha + t.alpha};
  };
  const int x = i % v.w, y = i / v.w;
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx) {
      if (x + dx < 0 || y + dy < 0 || x + dx >= v.w || y + dy >= v.h) continue;
      const int n = i + dy * v.w + dx;
      if (core[n]) add(in, v.tones[n]), ++ins;
      if (far[n]) add(out, v.tones[n]), ++outs;
    }
  if (!ins || !outs) return v.region[i];
  const auto part = [&](float Tone::*c) {
    const float a = in.*c / float(ins), b = out.*c / float(outs);
    return std::pair{a - b, v.tones[i].*c - b};
  };
  float dot = 0, square = 0;
  for (float Tone::*c : {&Tone::l, &Tone::a, &Tone::b, &Tone::alpha}) {
    const auto [side, own] = part(c);
    dot += side * own;
    square += side * side;
  }
  return square < 1e-6f ? float(v.region[i]) : std::clamp(dot / square, 0.0f, 1.0f);
}

// How many of the pixels close by are the region's, as a share.
float share_about(const Window& v, int i) {
  const int x = i % v.w, y = i / v.w;
  float in = 0, all = 0;
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx) {
      if (x + dx < 0 || y + dy < 0 || x + dx >= v.w || y + dy >= v.h) continue;
      in += v.region[i + dy * v.w + dx];
      ++all;
    }
  return in / all;
}

bool paper_about(const Window& v, int i) {
  const int x = i % v.w, y = i / v.w;
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx)
      if (x + dx >= 0 && y + dy >= 0 && x + dx < v.w && y + dy < v.h && v.paper[i + dy * v.w + dx])
        return true;
  return false;
}

// 1 inside, 0 outside, between them how much of a pixel belongs.
//   drawn  all of the region's edge follows what is drawn; else only where it borders on paper
std::vector<float> field_of(const Window& v, bool drawn) {
  const int n = v.w * v.h;
  // The edges of ink are mixed with what it borders on: they are ink as well.
  const Bits ink = grown(v.ink, v.w, v.h);
  Bits inside(v.region.size()), outside(v.region.size()), rest(v.region.size());
  for (int i = 0; i < n; ++i) {
    inside[i] = v.region[i] && !ink[i];
    outside[i] = !v.region[i] && !ink[i];
    rest[i] = !v.region[i];
  }
  const std::vector<float> in = steps_from(inside, v.w, v.h), out = steps_from(outside, v.w, v.h);
  const Bits core = shrunk(v.region, v.w, v.h), far = shrunk(rest, v.w, v.h);
  constexpr float kReach = 18;  // an ink line between the two sides is no wider
  std::vector<float> field(v.region.size());
  for (int i = 0; i < n; ++i) {
    const bool both = in[i] + out[i] <= kReach;
    if (!drawn && !paper_about(v, i)) {
      field[i] = share_about(v, i);
    } else if (ink[i] && both) {
      field[i] = std::clamp(0.5f + (out[i] - in[i]) / 2, 0.0f, 1.0f);
    } else if ((v.region[i] && core[i]) || (!v.region[i] && far[i])) {
      field[i] = v.region[i];
    } else {
      field[i] = covered(v, core, far, i);
    }
  }
  return field;
}

Polyline fitted(const Polyline& raw) {
  constexpr double kStep = 1, kSmooth = 0.8, kError = 0.3;
  for (const double strength : {1.0, 0.4}) {
    Polyline line = resampled(raw, kStep);
    line.points =
        simplified(smoothed(line.points, true, strength * kSmooth, kStep), true, strength * kError);
    if (line.points.size() >= 3 && std::abs(signed_area(line)) > 0.6 * std::abs(signed_area(raw)) &&
        !self_crossing(line))
      return line;
  }
  return raw;
}

std::optional<RegionOutline> outline_in(const SegmentedImage& image, Window window, bool drawn) {
  fill_holes(window);
  std::vector<Polyline> lines = iso_lines(field_of(window, drawn), window.w, window.h);
  const auto area = [](const Polyline& a, const Polyline& b) {
    return signed_area(a) < signed_area(b);
  };
  const auto largest = std::max_element(lines.begin(), lines.end(), area);
  if (largest == lines.end() || signed_area(*largest) <= 0) return std::nullopt;
  constexpr double kHole = 0.05;  // of the outline: less is a speck
  RegionOutline result;
  const auto placed = [&](const Polyline& line) {
    Polyline fit = fitted(line);
    for (Vec2& p : fit.points) p = image.pixels * (p + Vec2(window.x, window.y));
    return fit;
  };
  result.outline = placed(*largest);
  for (const Polyline& line : lines)
    if (-signed_area(line) > kHole * signed_area(*largest)) result.holes.push_back(placed(line));
  return result;
}

}  // namespace

std::optional<RegionOutline> region_outline(const SegmentedImage& image, const FloodLevels& levels,
                                            double tolerance) {
  if (image.tones.empty() || image.paper[levels.seed]) return std::nullopt;
  const bool all = tolerance >= 1;
  const float most = all ? kMostUnlike : float(std::max(0.0, tolerance));
  Bits region;
  for (const float level : levels.level) region.push_back(level <= most);
  Window window = window_about(image, region);
  const int w = image.width;
  if (!all) cut_leaks(window, (levels.seed / w - window.y) * window.w + levels.seed % w - window.x);
  return outline_in(image, std::move(window), true);
}

std::optional<RegionOutline> outline_of_pixels(const SegmentedImage& image,
                                               const std::vector<std::uint8_t>& pixels) {
  if (std::find(pixels.begin(), pixels.end(), 1) == pixels.end()) return std::nullopt;
  return outline_in(image, window_about(image, pixels), false);
}

}  // namespace artisketch
