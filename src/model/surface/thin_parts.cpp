#include "model/surface/thin_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace artisketch {
namespace {

constexpr double kNear = 0.87;   // cells: a sample this near may share a cell with the surface
constexpr double kDeep = 0.75;   // cells
constexpr int kReach = 2;        // samples between the two, over a right-angled edge too
constexpr double kShare = 0.02;  // of the samples near the surface

constexpr double kStep = 0.125, kMostGiven = 1.5;  // cells by which a field is widened

// Marks what has a marked sample within `reach` along an axis.
void dilate(const Index3& size, int axis, int reach, std::vector<std::uint8_t>& marks) {
  const std::ptrdiff_t strides[3] = {1, size.x(), std::ptrdiff_t(size.x()) * size.y()};
  const std::ptrdiff_t step = strides[axis];
  const int b = (axis + 1) % 3, c = (axis + 2) % 3, n = size[axis];
  std::vector<std::uint8_t> line(n);
  for (int v = 0; v < size[c]; ++v)
    for (int u = 0; u < size[b]; ++u) {
      std::uint8_t* first = &marks[u * strides[b] + v * strides[c]];
      int last = -n - reach;  // marked sample
      for (int i = 0; i < n; ++i) {
        if (first[i * step]) last = i;
        line[i] = i - last <= reach;
      }
      last = 2 * n + reach;
      for (int i = n; i-- > 0;) {
        if (first[i * step]) last = i;
        line[i] |= last - i <= reach;
      }
      for (int i = 0; i < n; ++i) first[i * step] = line[i];
    }
}

}  // namespace

bool alike(const Mesh& mesh, const Result<Mesh>& other, double cell) {
  if (!other) return false;
  const Box3 a = bounds(mesh.V), b = bounds(other->V);
  return topology(mesh).genus() == topology(*other).genus() &&
         (a.min() - b.min()).cwiseAbs().maxCoeff() < 2 * cell &&
         (a.max() - b.max()).cwiseAbs().maxCoeff() < 2 * cell;
}

bool is_thin(const Grid3<float>& field) {
  std::vector<std::uint8_t> deep(field.values.size());
  for (std::size_t i = 0; i < deep.size(); ++i) deep[i] = field.values[i] < -kDeep * field.cell;
  for (int axis = 0; axis < 3; ++axis) dilate(field.size, axis, kReach, deep);
  int near = 0, alone = 0;
  for (std::size_t i = 0; i < deep.size(); ++i) {
    if (!(field.values[i] < kNear * field.cell)) continue;
    ++near;
    alone += !deep[i];
  }
  return alone > kShare * near;
}

int finer_cells(const Grid3<float>& field, int cells) {
  const double room = std::cbrt(kMostSamples / std::max<double>(double(field.values.size()), 1));
  return int(cells * std::clamp(room, 1.0, kMostFiner));
}

void hold_together(const Mesh& mesh, Grid3<float>& field) {
  for (int step = 0; step * kStep < kMostGiven; ++step) {
    if (alike(mesh, isosurface(field), field.cell)) return;
    for (float& v : field.values) v -= float(kStep * field.cell);
  }
}

}  // namespace artisketch
