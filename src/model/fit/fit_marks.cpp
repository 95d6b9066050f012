#include "model/fit/fit_marks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/raster.h"

namespace artisketch {
namespace {

constexpr double kStep = 2;          // pixels between the edge's points
constexpr double kMargin = 3;        // pixels round the model
constexpr double kLargest = 4096;    // pixels; what is projected larger is seen too near to judge
constexpr std::size_t kFewest = 12;  // edge steps; smaller loops are crumbs of the raster
constexpr int kSmooth = 2;           // neighbours on each side that take out the raster's stairs

struct Raster {
  Vec2 origin = Vec2::Zero();
  Mask mask;
};

Raster raster_of(const Mesh& mesh, const Transform& to_world, const FrameCamera& camera) {
  std::vector<Vec2> pixels(std::size_t(mesh.V.rows()));
  Box2 box;
  for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
    const Vec3 X = to_world * Vec3(mesh.V.row(v).transpose());
    if (!camera.in_front(X)) return {};
    pixels[std::size_t(v)] = camera.project(X);
    box.extend(pixels[std::size_t(v)]);
  }
  if (box.isEmpty() || !(box.sizes().maxCoeff() < kLargest)) return {};
  Raster raster;
  raster.origin = (box.min() - Vec2::Constant(kMargin)).array().floor();
  const Vec2 size = box.max() + Vec2::Constant(kMargin) - raster.origin;
  raster.mask = Mask(int(std::ceil(size.x())), int(std::ceil(size.y())));
  for (Vec2& p : pixels) p -= raster.origin;
  add_triangles(pixels, mesh.F, raster.mask);
  return raster;
}

// The mask's borders as closed loops along its pixels' edges, the inside to the right (y down).
std::vector<std::vector<Vec2>> borders(const Mask& mask) {
  constexpr int kDx[] = {1, 0, -1, 0}, kDy[] = {0, 1, 0, -1};
  const auto in = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < mask.width && y < mask.height && mask.at(x, y);
  };
  // Whether the step from corner (x, y) in a direction runs along a border, inside to its right.
  const auto runs = [&](int x, int y, int d) {
    switch (d) {
      case 0:
        return in(x, y) && !in(x, y - 1);
      case 1:
        return in(x - 1, y) && !in(x, y);
      case 2:
        return in(x - 1, y - 1) && !in(x - 1, y);
      default:
        return in(x, y - 1) && !in(x - 1, y - 1);
    }
  };
  std::vector<char> walked(std::size_t(mask.width + 1) * (mask.height + 1), 0);
  const auto seen = [&](int x, int y) -> char& {
    return walked[std::size_t(y) * (mask.width + 1) + x];
  };
  std::vector<std::vector<Vec2>> loops;
  for (int y = 0; y < mask.height; ++y)
    for (int x = 0; x < mask.width; ++x) {
      if (!runs(x, y, 0) || seen(x, y)) continue;
      std::vector<Vec2> loop;
      int at_x = x, at_y = y, d = 0;
      do {
        if (d == 0) seen(at_x, at_y) = 1;
        loop.emplace_back(at_x, at_y);
        at_x += kDx[d];
        at_y += kDy[d];
        // Right turns first: pixels that touch at a corner stay apart.
        for (const int turn : {1, 0, 3})
          if (runs(at_x, at_y, (d + turn) % 4)) {
            d = (d + turn) % 4;
            break;
          }
      } while (at_x != x || at_y != y || d != 0);
      if (loop.size() >= kFewest) loops.push_back(std::move(loop));
    }
  return loops;
}

std::vector<Vec2> smoothed(const std::vector<Vec2>& loop) {
  const int n = int(loop.size());
  std::vector<Vec2> smooth(loop.size());
  for (int i = 0; i < n; ++i) {
    Vec2 sum = Vec2::Zero();
    for (int k = -kSmooth; k <= kSmooth; ++k) sum += loop[std::size_t((i + k + n) % n)];
    smooth[std::size_t(i)] = sum / (2 * kSmooth + 1);
  }
  return smooth;
}

Vec2 nearest_of(const std::vector<const Polyline*>& lines, const Vec2& p) {
  Vec2 best = p;
  double least = std::numeric_limits<double>::infinity();
  for (const Polyline* line : lines)
    for (std::size_t s = 0; s < line->segments(); ++s) {
      const Vec2& a = line->points[s];
      const Vec2 d = line->end_of(s) - a;
      const double square = d.squaredNorm();
      const Vec2 q = square > 0 ? Vec2(a + std::clamp((p - a).dot(d) / square, 0.0, 1.0) * d) : a;
      if (const double distance = (p - q).squaredNorm(); distance < least)
        least = distance, best = q;
    }
  return best;
}

double step_after(const std::vector<EdgePoint>& loop, std::size_t i) {
  return (loop[(i + 1) % loop.size()].at - loop[i].at).norm();
}

// The longest run of points over the limit, round the loop.
void find_stretch(const std::vector<EdgePoint>& loop, double limit, FitMarks& marks) {
  const std::size_t n = loop.size();
  std::size_t first = 0;  // a point where no run goes on
  while (first < n && loop[first].off() > limit) ++first;
  if (first == n) first = 0;
  double length = 0;
  std::size_t start = first;
  for (std::size_t k = 0; k <= n; ++k) {
    const std::size_t i = (first + k) % n;
    if (k < n && loop[i].off() > limit) {
      if (length == 0) start = i;
      length += step_after(loop, i);
      continue;
    }
    if (length > marks.stretch) {
      marks.stretch = length;
      double half = 0;
      std::size_t m = start;
      while (half + step_after(loop, m) < length / 2) half += step_after(loop, m), m = (m + 1) % n;
      marks.middle = loop[m];
      const Vec2 along = loop[(m + 1) % n].at - loop[(m + n - 1) % n].at;
      marks.outward = Vec2(along.y(), -along.x()).normalized();
    }
    length = 0;
  }
}

}  // namespace

FitMarks fit_marks(const Mesh& mesh, const Transform& to_world, const FrameCamera& camera,
                   const Frame& frame, int joint, double limit) {
  FitMarks marks;
  std::vector<const Polyline*> lines;
  for (const Contour& contour : frame.contours)
    if (contour.joint == joint && contour.line.closed) lines.push_back(&contour.line);
  if (lines.empty()) return marks;
  const Raster raster = raster_of(mesh, to_world, camera);
  double sum = 0;
  std::size_t count = 0;
  for (const std::vector<Vec2>& loop : borders(raster.mask)) {
    std::vector<EdgePoint> edge;
    Polyline line{smoothed(loop), true};
    for (const Vec2& p : resampled(line, kStep).points) {
      const Vec2 at = raster.origin + p;
      edge.push_back({at, nearest_of(lines, at)});
      sum += edge.back().off();
      ++count;
    }
    find_stretch(edge, limit, marks);
    marks.edge.push_back(std::move(edge));
  }
  if (count > 0) marks.off = sum / double(count);
  return marks;
}

}  // namespace artisketch
