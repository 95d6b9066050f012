#include "model/texture/atlas.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

namespace artisketch {
namespace {

constexpr double kMostTexels = 4e6;
constexpr double kFlat = 0.4;  // cosine between the normals of an unpainted chart and its first

struct Chart {
  int view = -1;
  Vec3 across, up;  // where no view paints it: the axes that it is laid along
  std::vector<int> faces;
  std::vector<int> corners;  // indices into the atlas' lists
  Box2 box;
  Vec2 corner = Vec2::Zero();  // in the atlas
};

Vec3 normal_of(const Mesh& mesh, int f) {
  const Vec3 a = mesh.V.row(mesh.F(f, 0)).transpose(), b = mesh.V.row(mesh.F(f, 1)).transpose(),
             c = mesh.V.row(mesh.F(f, 2)).transpose();
  const Vec3 normal = (b - a).cross(c - a);
  return normal.norm() > 0 ? normal.normalized() : Vec3::UnitZ();  // one without area lies anyhow
}

std::vector<Chart> charts_of(const Mesh& mesh, const FaceNeighbours& neighbours,
                             const std::vector<int>& views, std::vector<int>& chart) {
  std::vector<Chart> charts;
  chart.assign(mesh.F.rows(), -1);
  for (int seed = 0; seed < mesh.F.rows(); ++seed) {
    if (chart[seed] >= 0) continue;
    Chart& one = charts.emplace_back();
    one.view = views[seed];
    const Vec3 normal = normal_of(mesh, seed);
    one.across = normal.unitOrthogonal();
    one.up = normal.cross(one.across);
    one.faces = {seed};
    chart[seed] = int(charts.size()) - 1;
    for (std::size_t head = 0; head < one.faces.size(); ++head)
      for (const int g : neighbours[one.faces[head]]) {
        if (g < 0 || chart[g] >= 0 || views[g] != one.view) continue;
        if (one.view < 0 && normal_of(mesh, g).dot(normal) < kFlat) continue;
        chart[g] = chart[seed];
        one.faces.push_back(g);
      }
  }
  return charts;
}

// A chart's shape, in columns of kCell texels: where each begins and ends, gutter and all.
struct Shape {
  int chart = 0, height = 0;  // cells
  std::vector<int> low, high;
};

// Charts lie in cells: finer ones would waste less and take longer.
constexpr int kCell = 2;  // texels

Shape shape_of(int index, const Chart& chart, const Atlas& atlas) {
  Shape shape;
  shape.chart = index;
  const Vec2 size = chart.box.sizes() + Vec2::Constant(2 * kGutter);
  const int columns = int(std::ceil(size.x() / kCell));
  std::vector<double> low(columns, std::numeric_limits<double>::max()), high(columns, 0.0);
  const Vec2 origin = chart.box.min() - Vec2::Constant(kGutter);
  for (const int f : chart.faces)
    for (int k = 0; k < 3; ++k) {
      Vec2 a = atlas.texels[atlas.corners(f, k)] - origin,
           b = atlas.texels[atlas.corners(f, (k + 1) % 3)] - origin;
      if (a.x() > b.x()) std::swap(a, b);
      const double slope = b.x() > a.x() ? (b.y() - a.y()) / (b.x() - a.x()) : 0;
      const int first = std::max(int((a.x() - kGutter) / kCell), 0),
                last = std::min(int((b.x() + kGutter) / kCell), columns - 1);
      for (int c = first; c <= last; ++c)
        for (const double x : {double(c * kCell - kGutter), double((c + 1) * kCell + kGutter)}) {
          const double y = x <= a.x() ? a.y() : x >= b.x() ? b.y() : a.y() + slope * (x - a.x());
          low[c] = std::min(low[c], y - kGutter);
          high[c] = std::max(high[c], y + kGutter);
        }
    }
  for (int c = 0; c < columns; ++c) {
    shape.low.push_back(int(std::clamp(low[c], 0.0, size.y()) / kCell));
    shape.high.push_back(int(std::ceil(high[c] / kCell)));
    shape.height = std::max(shape.height, shape.high.back());
  }
  return shape;
}

int even(int cells) {
  return cells + cells % 2;
}

// Places every chart, the highest first, each where it leaves the least room unused below it, as in
// the game of falling pieces; the picture's height in cells. Source: Lévy et al. 2002, section 4.
int pack(const std::vector<Shape>& shapes, int width, std::vector<Chart>& charts) {
  std::vector<int> top(width, 0);
  for (const Shape& shape : shapes) {
    const int columns = int(shape.low.size());
    int best = 0, best_y = 0;
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (int x = 0; x + columns <= width; ++x) {
      int y = 0;
      for (int c = 0; c < columns; ++c) y = std::max(y, top[x + c] - shape.low[c]);
      std::int64_t cost = std::int64_t(y + shape.height) * columns;
      for (int c = 0; c < columns && cost < least; ++c) cost += y + shape.low[c] - top[x + c];
      if (cost >= least) continue;
      least = cost;
      best = x;
      best_y = y;
    }
    for (int c = 0; c < columns; ++c) top[best + c] = best_y + shape.high[c];
    charts[shape.chart].corner = kCell * Vec2(best, best_y) + Vec2::Constant(kGutter);
  }
  return *std::max_element(top.begin(), top.end());
}

}  // namespace

Atlas make_atlas(const Mesh& mesh, const FaceNeighbours& neighbours, const std::vector<int>& views,
                 const DrawnSurface& surface, double scale) {
  Atlas atlas;
  std::vector<Chart> charts = charts_of(mesh, neighbours, views, atlas.chart);
  atlas.corners.resize(mesh.F.rows(), 3);
  std::vector<int> here(mesh.V.rows(), -1), of_chart(mesh.V.rows(), -1);
  double area = 0;
  for (std::size_t c = 0; c < charts.size(); ++c) {
    Chart& chart = charts[c];
    for (const int f : chart.faces)
      for (int k = 0; k < 3; ++k) {
        const int v = mesh.F(f, k);
        if (of_chart[v] != int(c)) {
          of_chart[v] = int(c);
          here[v] = int(atlas.vertex.size());
          const Vec3 p = mesh.V.row(v).transpose();
          chart.corners.push_back(here[v]);
          atlas.vertex.push_back(v);
          atlas.texels.push_back(chart.view >= 0
                                     ? surface.views[chart.view].pixels[v]
                                     : Vec2(scale * Vec2(p.dot(chart.across), -p.dot(chart.up))));
          chart.box.extend(atlas.texels.back());
        }
        atlas.corners(f, k) = here[v];
      }
    const Vec2 size = chart.box.sizes() + Vec2::Constant(2 * kGutter + 1);
    area += size.prod();
  }
  const double shrink = std::min(1.0, std::sqrt(kMostTexels / area));
  for (Chart& chart : charts) {
    // A view's pixels stay whole texels where nothing shrinks.
    const Vec2 low = (shrink * chart.box.min()).array().floor(),
               high = (shrink * chart.box.max()).array().ceil();
    chart.box = Box2(low, high);
    for (const int i : chart.corners) atlas.texels[i] *= shrink;
  }
  std::vector<Shape> shapes;
  double cells = 0;
  int widest_shape = 1;
  for (std::size_t c = 0; c < charts.size(); ++c) {
    shapes.push_back(shape_of(int(c), charts[c], atlas));
    const Shape& shape = shapes.back();
    for (std::size_t i = 0; i < shape.low.size(); ++i) cells += shape.high[i] - shape.low[i];
    widest_shape = std::max(widest_shape, int(shape.low.size()));
  }
  std::stable_sort(shapes.begin(), shapes.end(),
                   [](const Shape& a, const Shape& b) { return a.height > b.height; });
  // The width that wastes least, of a few that make the picture about square.
  int best = 0;
  double least = std::numeric_limits<double>::max();
  for (const double wide : {0.9, 1.0, 1.1, 1.2, 1.3, 1.4}) {
    const int width = even(std::max(widest_shape, int(wide * std::sqrt(cells))));
    const double area = double(width) * even(pack(shapes, width, charts));
    if (area >= least) continue;
    least = area;
    best = width;
  }
  atlas.width = kCell * best;
  atlas.height = kCell * even(pack(shapes, best, charts));
  for (const Chart& chart : charts)
    for (const int i : chart.corners) atlas.texels[i] += chart.corner - chart.box.min();
  return atlas;
}

void fill_gutters(Image& picture) {
  const std::size_t width = std::size_t(picture.width), texels = width * picture.height;
  std::vector<int> steps(texels);
  for (std::size_t i = 0; i < texels; ++i)
    steps[i] = picture.rgba[4 * i + 3] ? 0 : std::numeric_limits<int>::max() - 1;
  // Two sweeps find all ways along rows and columns (Rosenfeld and Pfaltz 1966).
  const auto take = [&](std::size_t i, std::size_t from) {
    if (steps[from] + 1 >= steps[i]) return;
    steps[i] = steps[from] + 1;
    std::memcpy(&picture.rgba[4 * i], &picture.rgba[4 * from], 4);
  };
  for (std::size_t i = 0; i < texels; ++i) {
    if (i % width > 0) take(i, i - 1);
    if (i >= width) take(i, i - width);
  }
  for (std::size_t i = texels; i-- > 0;) {
    if (i % width + 1 < width) take(i, i + 1);
    if (i + width < texels) take(i, i + width);
  }
}

}  // namespace artisketch
