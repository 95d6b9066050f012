#include "base/self_intersection.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace artisketch {
namespace {

// Six times the volume of the tetrahedron a, b, c, d.
double volume(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

// Whether the segment p q passes through the inside of a triangle; volumes up to eps are flat.
bool passes(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& t, double eps) {
  const double vp = volume(t[0], t[1], t[2], p), vq = volume(t[0], t[1], t[2], q);
  if (!(vp > eps && vq < -eps) && !(vp < -eps && vq > eps)) return false;
  const double a = volume(p, q, t[0], t[1]), b = volume(p, q, t[1], t[2]),
               c = volume(p, q, t[2], t[0]);
  return (a > eps && b > eps && c > eps) || (a < -eps && b < -eps && c < -eps);
}

// Whether an edge of s passes through t. Most triangles lie on one side of their neighbours'
// planes.
bool edges_pass(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t, double eps) {
  const Vec3 v(volume(t[0], t[1], t[2], s[0]), volume(t[0], t[1], t[2], s[1]),
               volume(t[0], t[1], t[2], s[2]));
  if (!(v.maxCoeff() > eps && v.minCoeff() < -eps)) return false;
  for (int e = 0; e < 3; ++e)
    if (passes(s[e], s[(e + 1) % 3], t, eps)) return true;
  return false;
}

bool triangles_cross(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t, double eps) {
  return edges_pass(s, t, eps) || edges_pass(t, s, eps);
}

}  // namespace

// Each triangle goes into the cells of a lattice that its box touches, coarse enough to be few.
std::vector<std::pair<int, int>> self_intersections(const Mesh& mesh) {
  const int faces = int(mesh.F.rows());
  std::vector<std::pair<int, int>> pairs;
  if (faces == 0) return pairs;
  std::vector<std::array<Vec3, 3>> corners(faces);
  std::vector<Box3> boxes(faces);
  double extent = 0;
  Box3 all;
  for (int f = 0; f < faces; ++f) {
    for (int c = 0; c < 3; ++c) {
      corners[f][c] = mesh.V.row(mesh.F(f, c)).transpose();
      boxes[f].extend(corners[f][c]);
    }
    extent += boxes[f].sizes().maxCoeff();
    all.extend(boxes[f]);
  }
  // Neighbours in one plane differ from it by rounding alone.
  const double eps = 1e-9 * std::pow(extent / faces, 3);
  // At most 200 cells along a side.
  const double cell = std::max(
      {1.5 * extent / faces, all.sizes().maxCoeff() / 200, 1e-12 * all.max().norm(), 1e-300});
  const Index3 size = (all.sizes() / cell).cast<int>() + Index3::Ones();
  struct Cells {
    Index3 low, high;
  };
  std::vector<Cells> touched(faces);
  for (int f = 0; f < faces; ++f)
    touched[f] = {((boxes[f].min() - all.min()) / cell).cast<int>(),
                  ((boxes[f].max() - all.min()) / cell).cast<int>()};
  const auto cells_of = [&](int f, auto&& visit) {
    const auto& [low, high] = touched[f];
    for (int z = low.z(); z <= high.z(); ++z)
      for (int y = low.y(); y <= high.y(); ++y)
        for (int x = low.x(); x <= high.x(); ++x) visit(x + size.x() * (y + size.y() * z));
  };
  std::vector<int> start(std::size_t(size.prod()) + 1, 0);
  for (int f = 0; f < faces; ++f) cells_of(f, [&](int c) { ++start[c + 1]; });
  for (std::size_t c = 1; c < start.size(); ++c) start[c] += start[c - 1];
  std::vector<int> list(start.back()), next(start.begin(), start.end() - 1);
  for (int f = 0; f < faces; ++f) cells_of(f, [&](int c) { list[next[c]++] = f; });
  for (std::size_t c = 0; c + 1 < start.size(); ++c)
    for (int i = start[c]; i < start[c + 1]; ++i)
      for (int j = i + 1; j < start[c + 1]; ++j) {
        const int f = list[i], g = list[j];
        if (!boxes[f].intersects(boxes[g])) continue;
        // Once only: in the first cell that both touch.
        const Index3 first = touched[f].low.cwiseMax(touched[g].low);
        if (first.x() + size.x() * (first.y() + size.y() * first.z()) != int(c)) continue;
        bool shared = false;
        for (int a = 0; a < 3; ++a)
          for (int b = 0; b < 3; ++b) shared |= mesh.F(f, a) == mesh.F(g, b);
        if (!shared && triangles_cross(corners[f], corners[g], eps)) pairs.emplace_back(f, g);
      }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace artisketch
