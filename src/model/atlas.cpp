#include "model/atlas.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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
  return (b - a).cross(c - a).normalized();
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

// Shelves, highest charts first. Places every chart; the picture's height.
int pack(std::vector<Chart>& charts, int width) {
  std::vector<int> order(charts.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
    return charts[a].box.sizes().y() > charts[b].box.sizes().y();
  });
  int x = 0, y = 0, shelf = 0;
  for (const int c : order) {
    const Vec2 size = charts[c].box.sizes() + Vec2::Constant(2 * kGutter);
    if (x > 0 && x + size.x() > width) {
      x = 0;
      y += shelf;
      shelf = 0;
    }
    charts[c].corner = Vec2(x + kGutter, y + kGutter);
    x += int(size.x());
    shelf = std::max(shelf, int(size.y()));
  }
  return y + shelf;
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

void fill_gutters(std::vector<Rgb>& texels, std::vector<std::uint8_t>& painted, int width) {
  const int height = int(texels.size()) / width;
  std::vector<std::size_t> queue;
  for (std::size_t i = 0; i < texels.size(); ++i)
    if (painted[i]) queue.push_back(i);
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const std::size_t p = queue[head];
    const int x = int(p % std::size_t(width)), y = int(p / std::size_t(width));
    const auto spread = [&](std::size_t q) {
      if (painted[q]) return;
      painted[q] = 1;
      texels[q] = texels[p];
      queue.push_back(q);
    };
    if (x > 0) spread(p - 1);
    if (x + 1 < width) spread(p + 1);
    if (y > 0) spread(p - std::size_t(width));
    if (y + 1 < height) spread(p + std::size_t(width));
  }
}

}  // namespace artisketch
