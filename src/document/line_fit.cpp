#include "document/line_fit.h"

#include <algorithm>
#include <cmath>

namespace artisketch {
namespace {

// Marks the points that matter between two that are kept.
void keep_between(std::span<const Vec2> points, std::size_t first, std::size_t last, double error,
                  std::vector<bool>& kept) {
  std::vector<std::pair<std::size_t, std::size_t>> spans = {{first, last}};
  while (!spans.empty()) {
    const auto [a, b] = spans.back();
    spans.pop_back();
    const Vec2 d = points[b] - points[a];
    double farthest = error;
    std::size_t at = a;
    for (std::size_t i = a + 1; i < b; ++i) {
      const double t =
          std::clamp((points[i] - points[a]).dot(d) / std::max(d.squaredNorm(), 1e-12), 0.0, 1.0);
      const double distance = (points[i] - points[a] - t * d).norm();
      if (distance > farthest) {
        farthest = distance;
        at = i;
      }
    }
    if (at == a) continue;
    kept[at] = true;
    spans.push_back({a, at});
    spans.push_back({at, b});
  }
}

}  // namespace

std::vector<Vec2> simplified(std::span<const Vec2> points, bool closed, double error) {
  if (points.size() < 4) return {points.begin(), points.end()};
  std::vector<bool> kept(points.size(), false);
  kept.front() = kept.back() = true;
  if (closed) {
    // Two far points split the loop into lines.
    std::size_t far = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
      if ((points[i] - points[0]).norm() > (points[far] - points[0]).norm()) far = i;
    kept[far] = true;
    keep_between(points, 0, far, error, kept);
    keep_between(points, far, points.size() - 1, error, kept);
  } else {
    keep_between(points, 0, points.size() - 1, error, kept);
  }
  std::vector<Vec2> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (kept[i]) result.push_back(points[i]);
  if (closed && result.size() > 3 && (result.front() - result.back()).norm() < error)
    result.pop_back();
  return result;
}

std::vector<Vec2> smoothed(std::span<const Vec2> points, bool closed, double radius, double step) {
  const int n = int(points.size()), reach = int(std::ceil(2 * radius / step));
  if (radius <= 0 || n < 3) return {points.begin(), points.end()};
  std::vector<Vec2> result(points.begin(), points.end());
  for (int i = 0; i < n; ++i) {
    const int here = closed ? std::min(reach, n / 4) : std::min({reach, i, n - 1 - i});
    Vec2 sum = Vec2::Zero();
    double weights = 0;
    for (int k = -here; k <= here; ++k) {
      const double weight = std::exp(-0.5 * std::pow(k * step / radius, 2));
      sum += weight * points[(i + k + n) % n];
      weights += weight;
    }
    result[i] = sum / weights;
  }
  return result;
}

namespace {

// A cell between four samples: its corners clockwise from the top left, its edges clockwise from
// the top. Per case of corners that are inside, the edges that the line enters and leaves by, what
// is inside at its right hand.
constexpr int kNone = -1, kTop = 0, kRight = 1, kBottom = 2, kLeft = 3;
constexpr int kTurns[16][4] = {
    {kNone, kNone, kNone, kNone},  {kTop, kLeft, kNone, kNone},     {kRight, kTop, kNone, kNone},
    {kRight, kLeft, kNone, kNone}, {kBottom, kRight, kNone, kNone}, {kTop, kLeft, kBottom, kRight},
    {kBottom, kTop, kNone, kNone}, {kBottom, kLeft, kNone, kNone},  {kLeft, kBottom, kNone, kNone},
    {kTop, kBottom, kNone, kNone}, {kRight, kTop, kLeft, kBottom},  {kRight, kBottom, kNone, kNone},
    {kLeft, kRight, kNone, kNone}, {kTop, kRight, kNone, kNone},    {kLeft, kTop, kNone, kNone},
    {kNone, kNone, kNone, kNone}};

}  // namespace

std::vector<Polyline> iso_lines(std::span<const float> field, int w, int h) {
  constexpr float kHalf = 0.5f;
  // Samples with a border of zeros about them; cell (x, y) has sample (x, y) at its top left.
  const int W = w + 2, H = h + 2;
  const auto at = [&](int x, int y) {
    return x < 1 || y < 1 || x > w || y > h ? 0.0f : field[std::size_t(y - 1) * w + (x - 1)];
  };
  // An edge by the sample that it starts at: 2 · index, plus 1 where it runs down.
  const auto edge = [&](int x, int y, int side) {
    if (side == kRight) ++x;
    if (side == kBottom) ++y;
    return 2 * (y * W + x) + (side == kLeft || side == kRight);
  };
  std::vector<int> next(2 * std::size_t(W) * H, -1);
  for (int y = 0; y + 1 < H; ++y)
    for (int x = 0; x + 1 < W; ++x) {
      const int inside = (at(x, y) >= kHalf) | (at(x + 1, y) >= kHalf) << 1 |
                         (at(x + 1, y + 1) >= kHalf) << 2 | (at(x, y + 1) >= kHalf) << 3;
      for (int k = 0; k < 4 && kTurns[inside][k] != kNone; k += 2)
        next[std::size_t(edge(x, y, kTurns[inside][k]))] = edge(x, y, kTurns[inside][k + 1]);
    }
  const auto crossing = [&](int e) {
    const int x = e / 2 % W, y = e / 2 / W, down = e % 2;
    const double a = at(x, y), b = at(x + !down, y + down);
    const double t = (kHalf - a) / (b - a);
    return Vec2(x - 0.5 + (down ? 0 : t), y - 0.5 + (down ? t : 0));
  };
  std::vector<Polyline> lines;
  for (int first = 0; first < int(next.size()); ++first) {
    if (next[std::size_t(first)] < 0) continue;
    Polyline& line = lines.emplace_back();
    for (int e = first; next[std::size_t(e)] >= 0;) {
      line.points.push_back(crossing(e));
      const int following = next[std::size_t(e)];
      next[std::size_t(e)] = -1;
      e = following;
    }
  }
  return lines;
}

}  // namespace artisketch
