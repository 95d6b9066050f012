// A box of samples at equal steps along the axes.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

#include "base/types.h"
#include "base/within.h"

namespace artisketch {

// Sample (i, j, k) stands at origin + cell · (i, j, k); x runs fastest in memory.
template <class T>
struct Grid3 {
  Vec3 origin = Vec3::Zero();
  double cell = 1;               // step between neighbouring samples, in units
  Index3 size = Index3::Zero();  // samples along x, y, z
  std::vector<T> values;

  Grid3() = default;
  Grid3(const Vec3& origin, double cell, const Index3& size, T fill = T())
      : origin(origin),
        cell(cell),
        size(size),
        values(std::size_t(size.x()) * size.y() * size.z(), fill) {
    assert(size.minCoeff() >= 0 && cell > 0);
  }

  bool empty() const { return values.empty(); }
  std::ptrdiff_t stride_y() const { return size.x(); }
  std::ptrdiff_t stride_z() const { return std::ptrdiff_t(size.x()) * size.y(); }
  std::size_t index(int i, int j, int k) const {
    return std::size_t(i) + std::size_t(size.x()) * (j + std::size_t(size.y()) * k);
  }
  T& operator()(int i, int j, int k) { return values[index(i, j, k)]; }
  const T& operator()(int i, int j, int k) const { return values[index(i, j, k)]; }
  bool contains(int i, int j, int k) const {
    return i >= 0 && j >= 0 && k >= 0 && i < size.x() && j < size.y() && k < size.z();
  }
  Vec3 position(int i, int j, int k) const { return origin + cell * Vec3(i, j, k); }
  Vec3 last() const { return position(size.x() - 1, size.y() - 1, size.z() - 1); }
  Box3 box() const { return {origin, last()}; }
};

// Trilinear value of g at p (units). Outside the grid the value at the nearest border point, so
// that a signed distance stays outside; where p is no number, that of the grid's first samples
// along that axis. g holds at least two samples along each axis.
template <class T>
double sample(const Grid3<T>& g, const Vec3& p) {
  int at[3];
  double w[3];
  for (int a = 0; a < 3; ++a) {
    const double x = within((p[a] - g.origin[a]) / g.cell, 0, g.size[a] - 1);
    at[a] = std::min(int(x), g.size[a] - 2);
    w[a] = x - at[a];
  }
  const T* v = &g.values[g.index(at[0], at[1], at[2])];
  const auto sy = g.stride_y(), sz = g.stride_z();
  const auto along_x = [&](std::ptrdiff_t s) { return (1 - w[0]) * v[s] + w[0] * v[s + 1]; };
  const double low = (1 - w[1]) * along_x(0) + w[1] * along_x(sy);
  const double high = (1 - w[1]) * along_x(sz) + w[1] * along_x(sz + sy);
  return (1 - w[2]) * low + w[2] * high;
}

}  // namespace artisketch
