#include "model/texture/atlas.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace {

// In place of qsort, which orders what is alike differently from one system's library to another's:
// the same document is to give the same model everywhere.
template <class T>
void sort_stably(T* all, int count, std::size_t, int (*compare)(const void*, const void*)) {
  std::stable_sort(all, all + count, [=](const T& a, const T& b) { return compare(&a, &b) < 0; });
}

}  // namespace

#define STB_RECT_PACK_IMPLEMENTATION
#define STBRP_STATIC
#define STBRP_SORT sort_stably
#include <stb/stb_rect_pack.h>

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

// Places every chart; the picture's height. Source: the skyline heuristic of Jylänki 2010.
int pack(std::vector<Chart>& charts, int width) {
  std::vector<stbrp_rect> rects;
  double highest = 0;
  for (std::size_t c = 0; c < charts.size(); ++c) {
    const Vec2 size = charts[c].box.sizes() + Vec2::Constant(2 * kGutter);
    rects.push_back({int(c), int(size.x()), int(size.y()), 0, 0, 0});
    highest = std::max(highest, size.y());
  }
  // All in one column would fit into so much.
  stbrp_context context;
  std::vector<stbrp_node> nodes(width);
  const double enough = std::min(1e9, highest * double(charts.size()) + 1);
  stbrp_init_target(&context, width, int(enough), nodes.data(), width);
  stbrp_pack_rects(&context, rects.data(), int(rects.size()));
  int height = 0;
  for (const stbrp_rect& rect : rects) {
    charts[rect.id].corner = Vec2(rect.x + kGutter, rect.y + kGutter);
    height = std::max(height, rect.y + rect.h);
  }
  return height;
}

int power_of_two(int least) {
  int n = 1;
  while (n < least) n *= 2;
  return n;
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
  double widest = 0;
  for (Chart& chart : charts) {
    // A view's pixels stay whole texels where nothing shrinks.
    const Vec2 low = (shrink * chart.box.min()).array().floor(),
               high = (shrink * chart.box.max()).array().ceil();
    chart.box = Box2(low, high);
    widest = std::max(widest, chart.box.sizes().x());
    for (const int i : chart.corners) atlas.texels[i] *= shrink;
  }
  // Powers of two, as validators and old graphics cards want them: the pair that wastes least, the
  // squarest of those.
  atlas.width = 0;
  for (int width = power_of_two(int(widest) + 2 * kGutter), i = 0; i < 4; ++i, width *= 2) {
    const int height = power_of_two(pack(charts, width));
    const auto waste = [](int w, int h) { return std::pair(double(w) * h, std::max(w, h)); };
    if (atlas.width == 0 || waste(width, height) < waste(atlas.width, atlas.height)) {
      atlas.width = width;
      atlas.height = height;
    }
  }
  pack(charts, atlas.width);
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
