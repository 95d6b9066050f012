// Exact distances come from scan conversion (Mauch 2000, "A fast algorithm for computing the
// closest point and distance transform"): the point of a mesh nearest to a sample lies inside a
// face, an edge or at a vertex, and then the sample lies in that feature's own region: the prism
// over the face, the wedge between the normals of the edge's faces, the cone at the vertex. Only
// the samples inside a region are asked for their distance to it. The regions need nothing of the
// mesh but its faces: where it cuts itself the least distance still wins.
//
// The sign comes from winding numbers counted along the rows of samples, with ties decided the same
// way for both faces of an edge: what enters a closed mesh leaves it again, whatever the rounding.
#include "base/mesh_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/within.h"

namespace artisketch {
namespace {

// Regions are this much wider than they are, in cells, so that rounding leaves no gap between them.
constexpr double kSlack = 1e-5;

// The samples x with normal · x + offset ≥ 0, all in cells.
struct HalfSpace {
  Vec3 normal;
  double offset;
  HalfSpace(const Vec3& normal, const Vec3& on, double slack)
      : normal(normal), offset(slack - normal.dot(on)) {}
};

// Calls visit(index, sample) for the samples of the grid inside the box and all half-spaces: row by
// row, each row clipped at once.
template <class Visit>
void for_samples(const Grid3<float>& g, const Box3& box, std::span<const HalfSpace> inside,
                 const Visit& visit) {
  int low[3], high[3];
  for (int a = 0; a < 3; ++a) {
    low[a] = int(std::ceil(within(box.min()[a], 0, g.size[a])));
    high[a] = int(std::floor(within(box.max()[a], -1, g.size[a] - 1)));
  }
  for (int k = low[2]; k <= high[2]; ++k)
    for (int j = low[1]; j <= high[1]; ++j) {
      double from = low[0], to = high[0];
      for (const HalfSpace& h : inside) {
        const double at_zero = h.normal.y() * j + h.normal.z() * k + h.offset;
        if (h.normal.x() > 1e-12)
          from = std::max(from, -at_zero / h.normal.x());
        else if (h.normal.x() < -1e-12)
          to = std::min(to, -at_zero / h.normal.x());
        else if (at_zero < 0)
          to = -1;
        if (from > to) break;
      }
      if (from > to) continue;
      const std::size_t row = g.index(0, j, k);
      for (int i = int(std::ceil(from)); i <= int(to); ++i) visit(row + i, Vec3(i, j, k));
    }
}

class ScanConversion {
 public:
  ScanConversion(const Mesh& mesh, double band, Grid3<float>& field)
      : F_(mesh.F), band_(band), field_(field), V_(mesh.V.rows()), normals_(mesh.F.rows()) {
    for (int v = 0; v < mesh.V.rows(); ++v)
      V_[v] = (mesh.V.row(v).transpose() - field.origin) / field.cell;
    for (int f = 0; f < F_.rows(); ++f) normals_[f] = unit_normal(f);
    find_neighbours();
  }

  // Lowers the field to the distance in cells wherever that is less than the band.
  void run() {
    for (int f = 0; f < F_.rows(); ++f) {
      face(f);
      for (int c = 0; c < 3; ++c) edge(3 * f + c);
    }
    for (int v = 0; v < int(V_.size()); ++v) vertex(v);
  }

 private:
  // Zero for a triangle without area: its edges then stand for it.
  Vec3 unit_normal(int f) const {
    const Vec3 u = V_[F_(f, 1)] - V_[F_(f, 0)], v = V_[F_(f, 2)] - V_[F_(f, 0)];
    const Vec3 n = u.cross(v);
    const double length = n.norm();
    const double longest2 = std::max({u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()});
    return length > 1e-9 * longest2 ? Vec3(n / length) : Vec3(Vec3::Zero());
  }

  // Half-edges c → c + 1 sorted by their vertices: the two of an edge side by side, and all that
  // leave a vertex in a row.
  void find_neighbours() {
    std::vector<std::pair<std::uint64_t, int>> edges;
    edges.reserve(3 * F_.rows());
    for (int f = 0; f < F_.rows(); ++f)
      for (int c = 0; c < 3; ++c) {
        const auto a = std::uint32_t(F_(f, c)), b = std::uint32_t(F_(f, (c + 1) % 3));
        edges.emplace_back(std::uint64_t(std::min(a, b)) << 32 | std::max(a, b), 3 * f + c);
      }
    std::sort(edges.begin(), edges.end());
    twin_.assign(edges.size(), -1);
    for (std::size_t i = 0; i + 1 < edges.size(); ++i)
      if (edges[i].first == edges[i + 1].first) {
        twin_[edges[i].second] = edges[i + 1].second;
        twin_[edges[i + 1].second] = edges[i].second;
      }
    start_.assign(V_.size() + 1, 0);
    for (int f = 0; f < F_.rows(); ++f)
      for (int c = 0; c < 3; ++c) ++start_[F_(f, c) + 1];
    for (std::size_t v = 0; v < V_.size(); ++v) start_[v + 1] += start_[v];
    next_.resize(edges.size());
    std::vector<int> fill(start_.begin(), start_.end() - 1);
    for (int f = 0; f < F_.rows(); ++f)
      for (int c = 0; c < 3; ++c) next_[fill[F_(f, c)]++] = F_(f, (c + 1) % 3);
  }

  void lower(std::size_t sample, double distance) {
    float& value = field_.values[sample];
    value = std::min(value, float(distance));
  }

  void face(int f) {
    const Vec3& n = normals_[f];
    if (n.isZero()) return;
    const Vec3 &a = V_[F_(f, 0)], &b = V_[F_(f, 1)], &c = V_[F_(f, 2)];
    Box3 box;
    for (const Vec3* p : {&a, &b, &c}) {
      box.extend(*p + band_ * n);
      box.extend(*p - band_ * n);
    }
    const HalfSpace sides[5] = {{n.cross(b - a).normalized(), a, kSlack},
                                {n.cross(c - b).normalized(), b, kSlack},
                                {n.cross(a - c).normalized(), c, kSlack},
                                {n, a, band_},
                                {-n, a, band_}};
    for_samples(field_, widened(box), sides,
                [&](std::size_t s, const Vec3& x) { lower(s, std::abs(n.dot(x - a))); });
  }

  void edge(int half_edge) {
    const int f = half_edge / 3, c = half_edge % 3, twin = twin_[half_edge];
    if (twin > half_edge) return;  // the other one does it
    const Vec3 &a = V_[F_(f, c)], &b = V_[F_(f, (c + 1) % 3)];
    const double length = (b - a).norm();
    if (length == 0) return;
    const Vec3 along = (b - a) / length;
    const Vec3 n1 = normals_[f], n2 = twin >= 0 ? normals_[twin / 3] : Vec3::Zero();
    Box3 box(a, a);
    box.extend(b);
    std::array<HalfSpace, 4> sides = {
        {{along, a, kSlack}, {-along, b, kSlack}, {along, a, kSlack}, {along, a, kSlack}}};
    if (!n1.isZero()) sides[2] = {-n1.cross(along), a, kSlack};
    if (!n2.isZero()) sides[3] = {n2.cross(along), a, kSlack};
    if (!n1.isZero() && !n2.isZero()) {
      // The wedge spans the directions between the two normals, or between their opposites.
      const double bend = n1.cross(n2).dot(along), cosine = n1.dot(n2);
      if (cosine > 0 && std::abs(bend) * band_ < kSlack)
        return;  // flat: the faces' slack covers it
      if (cosine > -0.5) {
        const double outward = bend > 0 ? band_ : -band_;
        const Vec3 tip = outward / (1 + cosine) * (n1 + n2);  // the arc's tangents meet here
        const Box3 edge_box = box;
        for (const Vec3& d : {Vec3(outward * n1), Vec3(outward * n2), tip})
          box.extend(edge_box.translated(d));
      } else {
        box = Box3(box.min().array() - band_, box.max().array() + band_);
      }
    } else {
      box = Box3(box.min().array() - band_, box.max().array() + band_);
    }
    for_samples(field_, widened(box), sides, [&](std::size_t s, const Vec3& x) {
      const double t = std::clamp((x - a).dot(along), 0.0, length);
      lower(s, (x - a - t * along).norm());
    });
  }

  void vertex(int v) {
    const Vec3& p = V_[v];
    sides_.clear();
    for (int i = start_[v]; i < start_[v + 1]; ++i) {
      const Vec3 way = V_[next_[i]] - p;
      const double length = way.norm();
      if (length > 0) sides_.emplace_back(-way / length, p, kSlack);
    }
    if (start_[v] == start_[v + 1]) return;
    const Box3 box(p.array() - band_, p.array() + band_);
    for_samples(field_, box, sides_,
                [&](std::size_t s, const Vec3& x) { lower(s, (x - p).norm()); });
  }

  static Box3 widened(const Box3& box) {
    return {box.min().array() - kSlack, box.max().array() + kSlack};
  }

  const Triangles& F_;
  double band_;
  Grid3<float>& field_;
  std::vector<Vec3> V_;        // in cells
  std::vector<Vec3> normals_;  // of faces
  std::vector<int> twin_;      // of each half-edge 3 · face + corner
  std::vector<int> start_,
      next_;  // vertices at the far end of the half-edges that leave each vertex
  std::vector<HalfSpace> sides_;
};

// The samples i of n with low ≤ i < high, as [first, last).
std::pair<int, int> samples_between(double low, double high, int n) {
  return {int(std::ceil(within(low, 0, n))), int(std::ceil(within(high, 0, n)))};
}

// Winding number at every sample. Along a row of samples in x, a face that is met from outside adds
// one to all samples behind it, and one met from inside takes one away.
std::vector<std::int16_t> winding_numbers(const Mesh& mesh, const Grid3<float>& g) {
  std::vector<std::int16_t> winding(g.values.size(), 0);
  for (int f = 0; f < mesh.F.rows(); ++f) {
    std::array<Vec3, 3> p;
    for (int c = 0; c < 3; ++c) p[c] = (mesh.V.row(mesh.F(f, c)).transpose() - g.origin) / g.cell;
    const auto [low, high] = std::minmax({p[0].z(), p[1].z(), p[2].z()});
    const auto [k0, k1] = samples_between(low, high, g.size.z());
    for (int k = k0; k < k1; ++k) {
      // Where the plane z = k cuts the triangle's sides: one that rises through it, one that falls.
      Vec2 rise = Vec2::Zero(), fall = Vec2::Zero();
      int crossings = 0;
      for (int c = 0; c < 3; ++c) {
        const int d = (c + 1) % 3;
        const bool up = p[c].z() <= k && p[d].z() > k, down = p[d].z() <= k && p[c].z() > k;
        if (!up && !down) continue;
        // From the lower end, so that both faces of the edge find the very same point.
        const Vec3 &from = up ? p[c] : p[d], &to = up ? p[d] : p[c];
        const double t = (k - from.z()) / (to.z() - from.z());
        (up ? rise : fall) = from.head<2>() + t * (to.head<2>() - from.head<2>());
        ++crossings;
      }
      if (crossings != 2) continue;
      const int step = rise.y() > fall.y() ? -1 : 1;
      const Vec2 &left = step < 0 ? fall : rise, &right = step < 0 ? rise : fall;
      const auto [j0, j1] = samples_between(left.y(), right.y(), g.size.y());
      for (int j = j0; j < j1; ++j) {
        const double t = (j - left.y()) / (right.y() - left.y());
        const double x = left.x() + t * (right.x() - left.x());
        if (x < g.size.x() - 1)
          winding[g.index(x < 0 ? 0 : int(x) + 1, j, k)] += std::int16_t(step);
      }
    }
  }
  for (std::size_t row = 0; row < winding.size(); row += g.size.x())
    for (int i = 1; i < g.size.x(); ++i) winding[row + i] += winding[row + i - 1];
  return winding;
}

}  // namespace

void mesh_distance(const Mesh& mesh, double band, Grid3<float>& field) {
  field.values.assign(field.values.size(), float(band));
  ScanConversion(mesh, band, field).run();
  const std::vector<std::int16_t> winding = winding_numbers(mesh, field);
  for (std::size_t i = 0; i < winding.size(); ++i)
    field.values[i] *= float(winding[i] > 0 ? -field.cell : field.cell);
}

}  // namespace artisketch
