#include "base/dual_surface.h"

#include <algorithm>
#include <cmath>

#include "base/ensure.h"

namespace artisketch {
namespace {

constexpr int n = BlockGrid::kSide;

// Mean of the zero crossings on a cell's edges, relative to its lowest corner, in cells.
Vec3 mean_crossing(const BlockGrid& grid, const Index3& cell) {
  double v[8];
  for (int c = 0; c < 8; ++c)
    v[c] = grid.value(cell.x() + (c & 1), cell.y() + (c >> 1 & 1), cell.z() + (c >> 2));
  Vec3 sum = Vec3::Zero();
  int crossings = 0;
  for (int axis = 0; axis < 3; ++axis)
    for (int c = 0; c < 8; ++c) {
      if (c >> axis & 1) continue;
      const double a = v[c], b = v[c | 1 << axis];
      if ((a < 0) == (b < 0)) continue;
      Vec3 p(c & 1, c >> 1 & 1, c >> 2);
      p[axis] = std::clamp(a / (a - b), 0.0, 1.0);
      sum += p;
      ++crossings;
    }
  return sum / crossings;
}

}  // namespace

QuadMesh dual_surface(const BlockGrid& given) {
  // Cells are visited by their lowest corner: those beside what is stored must be stored, too.
  BlockGrid closed;
  const bool whole = given.is_closed();
  if (!whole) {
    closed = given;
    closed.close();
  }
  const BlockGrid& grid = whole ? given : closed;
  std::vector<int> vertex_of(grid.values.size(), -1);  // by the cell's lowest corner
  std::vector<Vec3> V;
  std::vector<std::array<int, 4>> Q;
  // A crossing edge along an axis from its lower end: the end, the axis, whether it leaves the
  // solid.
  struct Crossing {
    Index3 from;
    int axis;
    bool leaves;
  };
  std::vector<Crossing> crossings;
  BlockGrid::Window window;
  for (int b = 0; b < int(grid.at.size()); ++b) {
    const int count = grid.inside_window(b, window);
    if (count == 0 || count == int(window.size())) continue;
    const Index3 first = grid.first_sample(b);
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
          const unsigned m = BlockGrid::corners(window, i, j, k);
          if (m == 0 || m == 255) continue;
          const Index3 cell = first + Index3(i, j, k);
          vertex_of[std::size_t(b) * BlockGrid::kSize + BlockGrid::within(i, j, k)] = int(V.size());
          V.push_back(grid.origin + grid.cell * (cell.cast<double>() + mean_crossing(grid, cell)));
          for (int axis = 0; axis < 3; ++axis)
            if ((m & 1) != (m >> (1 << axis) & 1)) crossings.push_back({cell, axis, (m & 1) != 0});
        }
  }
  Q.reserve(crossings.size());
  for (const Crossing& c : crossings) {
    const int u = (c.axis + 1) % 3, w = (c.axis + 2) % 3;
    std::array<int, 4> quad;
    // Round the edge counter-clockwise seen against the axis' direction.
    constexpr int kRound[4][2] = {{-1, -1}, {0, -1}, {0, 0}, {-1, 0}};
    for (int corner = 0; corner < 4; ++corner) {
      Index3 cell = c.from;
      cell[u] += kRound[corner][0];
      cell[w] += kRound[corner][1];
      const std::ptrdiff_t at = grid.find(cell.x(), cell.y(), cell.z());
      quad[corner] = at < 0 ? -1 : vertex_of[at];
    }
    if (!c.leaves) std::swap(quad[1], quad[3]);
    ensure(std::find(quad.begin(), quad.end(), -1) == quad.end(),
           "each crossing edge has four cells round it");
    Q.push_back(quad);
  }
  QuadMesh mesh{Points3(V.size(), 3), Quads(Q.size(), 4)};
  for (std::size_t v = 0; v < V.size(); ++v) mesh.V.row(v) = V[v].transpose();
  for (std::size_t q = 0; q < Q.size(); ++q)
    for (int c = 0; c < 4; ++c) mesh.Q(q, c) = Q[q][c];
  return mesh;
}

Triangles split_quads(const Points3& V, const Quads& Q) {
  Triangles F(2 * Q.rows(), 3);
  const auto normal = [&](int a, int b, int c) {
    const Vec3 p = V.row(a), q = V.row(b), r = V.row(c);
    return (q - p).cross(r - p).normalized().eval();
  };
  for (Eigen::Index q = 0; q < Q.rows(); ++q) {
    const int a = Q(q, 0), b = Q(q, 1), c = Q(q, 2), d = Q(q, 3);
    const double along_ac = normal(a, b, c).dot(normal(a, c, d));
    const double along_bd = normal(b, c, d).dot(normal(b, d, a));
    const double ac = (V.row(a) - V.row(c)).squaredNorm(), bd = (V.row(b) - V.row(d)).squaredNorm();
    // Where both bend alike, the shorter diagonal makes the better shaped triangles.
    const bool use_ac = std::abs(along_ac - along_bd) > 0.02 ? along_ac > along_bd : ac < bd;
    if (use_ac) {
      F.row(2 * q) << a, b, c;
      F.row(2 * q + 1) << a, c, d;
    } else {
      F.row(2 * q) << b, c, d;
      F.row(2 * q + 1) << b, d, a;
    }
  }
  return F;
}

Adjacency quad_adjacency(const QuadMesh& mesh) {
  // Every edge belongs to two quads that run through it in opposite ways: each vertex gets the one
  // it leads to from either.
  Adjacency adjacency;
  adjacency.offsets.assign(mesh.V.rows() + 1, 0);
  for (Eigen::Index q = 0; q < mesh.Q.rows(); ++q)
    for (int c = 0; c < 4; ++c) ++adjacency.offsets[mesh.Q(q, c) + 1];
  for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) adjacency.offsets[v + 1] += adjacency.offsets[v];
  adjacency.neighbours.resize(adjacency.offsets.back());
  std::vector<int> next(adjacency.offsets.begin(), adjacency.offsets.end() - 1);
  for (Eigen::Index q = 0; q < mesh.Q.rows(); ++q)
    for (int c = 0; c < 4; ++c) adjacency.neighbours[next[mesh.Q(q, c)]++] = mesh.Q(q, (c + 1) % 4);
  return adjacency;
}

}  // namespace artisketch
