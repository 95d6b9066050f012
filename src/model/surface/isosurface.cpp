// Marching cubes (Lorensen and Cline 1987) with a table that is worked out here from one rule,
// instead of written down.
//
// The rule: on a cube's face, crossings are joined so that negative corners stay connected. It
// looks at the face alone, so the two cubes beside it agree, and every grid edge that changes sign
// carries one vertex with exactly one polygon in each of its four cubes: the polygons make a closed
// 2-manifold. It stays one in triangles as long as no diagonal lies in a cube's face, where the
// cube next door could draw the same; every polygon of the 256 cubes has such a triangulation.
// Connecting the negative corners keeps thin parts in one piece.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

#include "model/stages.h"

namespace artisketch {
namespace {

// Vertices keep this share of an edge from its ends, so that no two coincide, not in single
// precision either, and the triangles keep some area. It moves the surface by less than that.
constexpr double kFromCorner = 0.01;

// Corner c of a cube stands at its bits: x + 2y + 4z. Edge 4·axis + u + 2v runs along axis from the
// corner whose next two coordinates (in cyclic order) are u and v.
constexpr int edge_start(int edge) {
  const int axis = edge / 4, u = edge & 1, v = edge >> 1 & 1;
  return u << (axis + 1) % 3 | v << (axis + 2) % 3;
}
constexpr int edge_end(int edge) {
  return edge_start(edge) | 1 << edge / 4;
}
constexpr int edge_between(int a, int b) {
  const int axis = (a ^ b) == 1 ? 0 : (a ^ b) == 2 ? 1 : 2;
  return 4 * axis + (a >> (axis + 1) % 3 & 1) + 2 * (a >> (axis + 2) % 3 & 1);
}

// Face 2·axis + side: its corners counter-clockwise seen from outside the cube.
constexpr std::array<int, 4> face_corners(int face) {
  const int axis = face / 2, side = face % 2;
  const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, base = side << axis;
  if (side) return {base, base + u, base + u + v, base + v};
  return {base, base + v, base + u + v, base + u};
}

// Two edges lie in one face where some coordinate is the same all along both.
constexpr bool share_a_face(int e, int f) {
  const int either = edge_start(e) | edge_end(e) | edge_start(f) | edge_end(f);
  const int both = edge_start(e) & edge_end(e) & edge_start(f) & edge_end(f);
  return either != 7 || both != 0;
}

struct Case {
  std::vector<std::array<std::uint8_t, 4>> quads;  // either diagonal will do
  std::vector<std::array<std::uint8_t, 3>> triangles;
};

using Loop = std::vector<std::uint8_t>;  // edges of a cube, in the order a polygon visits them

// The polygons of a cube whose corners in `negative` (a bit each) are.
std::vector<Loop> loops_of(int negative) {
  const auto in = [&](int corner) { return negative >> corner & 1; };
  // On each face, each run of positive corners is cut off by one segment; seen from outside the
  // cube with the corners counter-clockwise, it goes from the run's end to its start.
  std::array<int, 12> next;
  next.fill(-1);
  for (int face = 0; face < 6; ++face) {
    const std::array<int, 4> corner = face_corners(face);
    for (int i = 0; i < 4; ++i) {
      if (!in(corner[i]) || in(corner[(i + 1) % 4])) continue;
      int j = (i + 1) % 4;
      while (!in(corner[(j + 1) % 4])) j = (j + 1) % 4;
      next[edge_between(corner[j], corner[(j + 1) % 4])] =
          edge_between(corner[i], corner[(i + 1) % 4]);
    }
  }
  std::vector<Loop> loops;
  for (int start = 0; start < 12; ++start) {
    if (next[start] < 0) continue;
    Loop loop;
    for (int e = start; next[e] >= 0;) {
      loop.push_back(std::uint8_t(e));
      const int after = next[e];
      next[e] = -1;
      e = after;
    }
    loops.push_back(loop);
  }
  return loops;
}

double middle_distance(int e, int f) {
  double sum = 0;
  for (int a = 0; a < 3; ++a) {
    const int d = (edge_start(e) >> a & 1) + (edge_end(e) >> a & 1) - (edge_start(f) >> a & 1) -
                  (edge_end(f) >> a & 1);
    sum += d * d;
  }
  return std::sqrt(sum);
}

// The triangulation of loop[first … last] with the shortest diagonals, none in a face. Returns
// their length, infinite where there is none.
double triangulate(const Loop& loop, int first, int last,
                   std::vector<std::array<std::uint8_t, 3>>& out) {
  out.clear();
  if (last - first < 2) return 0;
  double best = std::numeric_limits<double>::infinity();
  for (int middle = first + 1; middle < last; ++middle) {
    double cost = 0;
    for (const auto& [a, b] : {std::pair(first, middle), std::pair(middle, last)}) {
      if (b - a < 2) continue;
      cost += share_a_face(loop[a], loop[b]) ? std::numeric_limits<double>::infinity()
                                             : middle_distance(loop[a], loop[b]);
    }
    std::vector<std::array<std::uint8_t, 3>> left, right;
    cost += triangulate(loop, first, middle, left) + triangulate(loop, middle, last, right);
    if (cost >= best) continue;
    best = cost;
    out = left;
    out.insert(out.end(), right.begin(), right.end());
    out.push_back({loop[first], loop[middle], loop[last]});
  }
  return best;
}

std::vector<Case> all_cases() {
  std::vector<Case> cases(256);
  for (int negative = 0; negative < 256; ++negative)
    for (const Loop& loop : loops_of(negative)) {
      Case& c = cases[negative];
      std::vector<std::array<std::uint8_t, 3>> triangles;
      if (loop.size() == 4 && !share_a_face(loop[0], loop[2]) && !share_a_face(loop[1], loop[3]))
        c.quads.push_back({loop[0], loop[1], loop[2], loop[3]});
      else
        triangulate(loop, 0, int(loop.size()) - 1, triangles);
      c.triangles.insert(c.triangles.end(), triangles.begin(), triangles.end());
    }
  return cases;
}

// The field with a layer of outside round it, where it is negative on its border.
Grid3<float> padded(const Grid3<float>& field) {
  Grid3<float> wider(field.origin - Vec3::Constant(field.cell), field.cell,
                     field.size + Index3::Constant(2), float(field.cell));
  for (int k = 0; k < field.size.z(); ++k)
    for (int j = 0; j < field.size.y(); ++j)
      std::copy_n(&field.values[field.index(0, j, k)], field.size.x(),
                  &wider.values[wider.index(1, j + 1, k + 1)]);
  return wider;
}

bool negative_on_border(const Grid3<float>& g) {
  for (int k = 0; k < g.size.z(); ++k)
    for (int j = 0; j < g.size.y(); ++j) {
      const bool side = k == 0 || j == 0 || k == g.size.z() - 1 || j == g.size.y() - 1;
      for (int i = 0; i < g.size.x(); i += side ? 1 : std::max(g.size.x() - 1, 1))
        if (g(i, j, k) < 0) return true;
    }
  return false;
}

// Marching through a grid whose border is outside.
class March {
 public:
  explicit March(const Grid3<float>& g) : g_(g) {
    const std::size_t layer = std::size_t(g.size.x()) * g.size.y();
    for (std::vector<int>& edges : edges_) edges.assign(2 * layer, -1);
    signs_.assign(2 * layer, 0);
  }

  Mesh run() {
    static const std::vector<Case> cases = all_cases();
    enter_layer(0);
    for (int k = 0; k + 1 < g_.size.z(); ++k) {
      enter_layer(k + 1);
      for (int j = 0; j + 1 < g_.size.y(); ++j) {
        const std::uint8_t* rows[4] = {&signs_[slot(0, j, k)], &signs_[slot(0, j + 1, k)],
                                       &signs_[slot(0, j, k + 1)], &signs_[slot(0, j + 1, k + 1)]};
        int negative = 0;
        for (int i = 0; i < g_.size.x(); ++i) {
          // Where all four rows go on as the last corners are there is nothing to see.
          while (i > 0 && i + kAtOnce <= g_.size.x() && (negative == 0 || negative == 255) &&
                 std::all_of(rows, rows + 4, [&](const std::uint8_t* row) {
                   return go_on(row + i, negative ? 1 : 0);
                 }))
            i += kAtOnce;
          if (i == g_.size.x()) break;
          // The four corners at i become those at the cube's start, and i + 1 brings its end.
          const int column = rows[0][i] << 1 | rows[1][i] << 3 | rows[2][i] << 5 | rows[3][i] << 7;
          negative = (negative >> 1 & 0x55) | column;
          if (i > 0 && negative != 0 && negative != 255) cube(cases[negative], i - 1, j, k);
        }
      }
    }
    Mesh mesh{Points3(V_.size(), 3), Triangles(F_.size(), 3)};
    for (std::size_t v = 0; v < V_.size(); ++v) mesh.V.row(v) = V_[v].transpose();
    for (std::size_t f = 0; f < F_.size(); ++f) mesh.F.row(f) = F_[f].transpose();
    return mesh;
  }

 private:
  // Whether the next kAtOnce signs are all like one.
  static constexpr int kAtOnce = 8;
  static bool go_on(const std::uint8_t* signs, std::uint8_t one) {
    std::uint64_t eight;
    std::memcpy(&eight, signs, kAtOnce);
    return eight == one * 0x0101010101010101ull;
  }
  // Where the data of (i, j) in layer k stands while two layers are kept.
  std::size_t slot(int i, int j, int k) const {
    return std::size_t(i) + std::size_t(g_.size.x()) * (j + std::size_t(g_.size.y()) * (k & 1));
  }

  // Reads the signs of layer k, and puts a vertex on each of its edges, and on those down to layer
  // k − 1, that change sign.
  void enter_layer(int k) {
    for (int j = 0; j < g_.size.y(); ++j) {
      const float* row = &g_.values[g_.index(0, j, k)];
      std::uint8_t* sign = &signs_[slot(0, j, k)];
      const std::uint8_t *before = j > 0 ? sign - g_.stride_y() : sign,
                         *below = k > 0 ? &signs_[slot(0, j, k - 1)] : sign;
      const int n = g_.size.x();
      for (int i = 0; i < n; ++i) sign[i] = row[i] < 0;
      for (int i = 1; i < n; ++i) {
        while (i + kAtOnce <= n && go_on(sign + i, sign[i - 1]) && go_on(before + i, sign[i - 1]) &&
               go_on(below + i, sign[i - 1]))
          i += kAtOnce;
        if (i == n) break;
        if (sign[i] != sign[i - 1]) add_vertex(0, {i - 1, j, k}, slot(i - 1, j, k));
        if (sign[i] != before[i]) add_vertex(1, {i, j - 1, k}, slot(i, j - 1, k));
        if (sign[i] != below[i]) add_vertex(2, {i, j, k - 1}, slot(i, j, k - 1));
      }
    }
  }

  void add_vertex(int axis, const Index3& from, std::size_t at) {
    const std::ptrdiff_t strides[3] = {1, g_.stride_y(), g_.stride_z()};
    const std::size_t a = g_.index(from.x(), from.y(), from.z());
    const double v0 = g_.values[a], v1 = g_.values[a + strides[axis]];
    const double t = v0 / (v0 - v1);
    Vec3 p = from.cast<double>();
    p[axis] += std::isfinite(t) ? std::clamp(t, kFromCorner, 1 - kFromCorner) : 0.5;
    edges_[axis][at] = int(V_.size());
    V_.push_back(g_.origin + g_.cell * p);
  }

  void cube(const Case& c, int i, int j, int k) {
    const auto vertex = [&](int edge) {
      const int start = edge_start(edge);
      return edges_[edge / 4][slot(i + (start & 1), j + (start >> 1 & 1), k + (start >> 2))];
    };
    for (const auto& t : c.triangles) F_.emplace_back(vertex(t[0]), vertex(t[1]), vertex(t[2]));
    for (const auto& q : c.quads) {
      const int v[4] = {vertex(q[0]), vertex(q[1]), vertex(q[2]), vertex(q[3])};
      const bool other = (V_[v[1]] - V_[v[3]]).squaredNorm() < (V_[v[0]] - V_[v[2]]).squaredNorm();
      F_.emplace_back(v[0], v[1], v[other ? 3 : 2]);
      F_.emplace_back(v[other ? 1 : 0], v[2], v[3]);
    }
  }

  const Grid3<float>& g_;
  std::array<std::vector<int>, 3> edges_;  // by axis: the vertex on the edge that starts at a slot
  std::vector<std::uint8_t> signs_;        // by slot: 1 where negative
  std::vector<Vec3> V_;
  std::vector<Index3> F_;
};

}  // namespace

Result<Mesh> isosurface(const Grid3<float>& field) {
  const Mesh mesh = negative_on_border(field) ? March(padded(field)).run() : March(field).run();
  if (mesh.F.rows() == 0) return bad_input("the surface is empty: nothing lies inside it");
  return largest_component(mesh);
}

}  // namespace artisketch
