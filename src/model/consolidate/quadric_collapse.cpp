#include "model/consolidate/quadric_collapse.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace artisketch {
namespace {

// What a collapse must leave as it is, unless the place was as bad before. Where too few can go
// that way, thin threads above all, the next lot is tried.
struct Fairness {
  double turn;     // cosine: how far a face may turn
  double fold;     // cosine: how far neighbours may fold,
  double quality;  // and how thin a triangle may be (1: equilateral)
};
constexpr std::array<Fairness, 3> kFairness = {{{0.4, 0.34, 0.1}, {0.2, 0.17, 0.02}, {0.1, 0, 0}}};
// Where all is flat and no place better than another, edges stay alike: the shorter goes first …
constexpr double kShortFirst = 1e-3;  // of its squared length, beside the error
// … and to its middle: what no plane holds is held by this share of all of them.
constexpr double kMiddle = 1e-3;

// Σ weight · (squared distance from a plane), over the planes of a vertex' triangles.
struct Quadric {
  double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0, x = 0, y = 0, z = 0, c = 0;
  double weight = 0;  // area

  void add_plane(const Vec3& n, const Vec3& p, double w) {
    const double d = -n.dot(p);
    xx += w * n.x() * n.x(), xy += w * n.x() * n.y(), xz += w * n.x() * n.z();
    yy += w * n.y() * n.y(), yz += w * n.y() * n.z(), zz += w * n.z() * n.z();
    x += w * n.x() * d, y += w * n.y() * d, z += w * n.z() * d, c += w * d * d;
    weight += w;
  }
  Quadric operator+(const Quadric& o) const {
    return {xx + o.xx, xy + o.xy, xz + o.xz, yy + o.yy, yz + o.yz,        zz + o.zz,
            x + o.x,   y + o.y,   z + o.z,   c + o.c,   weight + o.weight};
  }
  double at(const Vec3& p) const {
    const double ax = xx * p.x() + xy * p.y() + xz * p.z() + 2 * x,
                 ay = xy * p.x() + yy * p.y() + yz * p.z() + 2 * y,
                 az = xz * p.x() + yz * p.y() + zz * p.z() + 2 * z;
    return std::max(0.0, ax * p.x() + ay * p.y() + az * p.z() + c);
  }
  // Where it is least, near `middle` along what the planes leave open.
  Vec3 best(const Vec3& middle) const {
    const double hold = kMiddle * (xx + yy + zz);
    const double a = xx + hold, d = yy + hold, f = zz + hold;
    const double i = d * f - yz * yz, j = xz * yz - xy * f, k = xy * yz - xz * d;
    const double determinant = a * i + xy * j + xz * k;
    if (!(determinant > 0)) return middle;
    const double u = hold * middle.x() - x, v = hold * middle.y() - y, w = hold * middle.z() - z;
    const double l = a * f - xz * xz, m = xy * xz - a * yz, n = a * d - xy * xy;
    return Vec3(i * u + j * v + k * w, j * u + l * v + m * w, k * u + m * v + n * w) / determinant;
  }
};

class Collapser {
 public:
  Collapser(const Mesh& mesh, double error)
      : most_(error * error), V_(mesh.V.rows()), F_(mesh.F.rows()), quadrics_(mesh.V.rows()) {
    // About the middle, so that no digits go to where the figure stands.
    middle_ = bounds(mesh.V).center();
    for (std::size_t v = 0; v < V_.size(); ++v)
      V_[v] = mesh.V.row(Eigen::Index(v)).transpose() - middle_;
    for (std::size_t f = 0; f < F_.size(); ++f) {
      for (int c = 0; c < 3; ++c) F_[f][c] = mesh.F(Eigen::Index(f), c);
      const auto& [a, b, c] = F_[f];
      const Vec3 n = (V_[b] - V_[a]).cross(V_[c] - V_[a]);
      const double area = n.norm();
      if (area > 0)
        for (const int v : F_[f]) quadrics_[v].add_plane(n / area, V_[v], area);
    }
  }

  int triangles() const { return int(F_.size()); }

  // One sweep over the edges, best first, toward `wanted` triangles; around each collapse the mesh
  // rests until the next. Returns how many went.
  int sweep(int wanted, const Fairness& fairness) {
    fairness_ = fairness;
    index();
    std::vector<Edge> edges = candidates();
    const std::size_t goal = std::min<std::size_t>(std::size_t(triangles() - wanted + 1) / 2,
                                                   edges.size() / kShareOfEdges + 1);
    if (edges.empty()) return 0;
    if (goal < edges.size()) {
      // What is much worse than the goal's may wait for a better neighbour.
      constexpr double kWorse = 1.5;
      const auto nth = edges.begin() + std::ptrdiff_t(goal);
      std::nth_element(edges.begin(), nth, edges.end());
      const double limit = kWorse * nth->cost;
      edges.erase(std::partition(nth, edges.end(), [&](const Edge& e) { return e.cost <= limit; }),
                  edges.end());
    }
    std::sort(edges.begin(), edges.end());
    int gone = 0;
    for (const Edge& e : edges) {
      if (triangles() - 2 * gone <= wanted) break;
      if (!resting_[e.a] && !resting_[e.b] && collapse(e.a, e.b)) ++gone;
    }
    std::erase_if(F_, [](const Face& f) { return f[0] < 0; });
    return gone;
  }

  Mesh mesh() const {
    Mesh out{Points3(V_.size(), 3), Triangles(F_.size(), 3)};
    for (std::size_t v = 0; v < V_.size(); ++v)
      out.V.row(Eigen::Index(v)) = (V_[v] + middle_).transpose();
    for (std::size_t f = 0; f < F_.size(); ++f)
      out.F.row(Eigen::Index(f)) << F_[f][0], F_[f][1], F_[f][2];
    return without_unused_vertices(out);
  }

 private:
  using Face = std::array<int, 3>;
  static constexpr std::size_t kShareOfEdges = 6;
  struct Edge {
    double cost;
    int a, b;
    bool operator<(const Edge& o) const {
      return cost != o.cost ? cost < o.cost : std::pair(a, b) < std::pair(o.a, o.b);
    }
  };

  std::span<const int> faces_of(int v) const {
    return {of_vertex_.data() + first_[v], std::size_t(first_[v + 1] - first_[v])};
  }

  void index() {
    first_.assign(V_.size() + 1, 0);
    for (const Face& f : F_)
      for (const int v : f) ++first_[v + 1];
    degree_.assign(first_.begin() + 1, first_.end());
    for (std::size_t v = 0; v < V_.size(); ++v) first_[v + 1] += first_[v];
    of_vertex_.resize(3 * F_.size());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    normals_.resize(F_.size());
    for (std::size_t f = 0; f < F_.size(); ++f) {
      for (const int v : F_[f]) of_vertex_[next[v]++] = int(f);
      normals_[f] = normal(V_[F_[f][0]], V_[F_[f][1]], V_[F_[f][2]]);
    }
    resting_.assign(V_.size(), 0);
  }

  static Vec3 normal(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 n = (b - a).cross(c - a);
    const double length = n.norm();
    return length > 0 ? Vec3(n / length) : n;
  }
  static double quality(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double sides = (b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm();
    return sides > 0 ? 2 * std::sqrt(3.0) * (b - a).cross(c - a).norm() / sides : 0;
  }

  std::vector<Edge> candidates() const {
    std::vector<Edge> edges;
    edges.reserve(3 * F_.size() / 2);
    for (const Face& f : F_)
      for (int c = 0; c < 3; ++c) {
        const int a = f[c], b = f[(c + 1) % 3];
        if (a > b) continue;  // its other face names it
        const Quadric q = quadrics_[a] + quadrics_[b];
        const double moved = q.at(q.best((V_[a] + V_[b]) / 2));
        if (moved > most_ * q.weight) continue;
        edges.push_back({moved + kShortFirst * q.weight * (V_[a] - V_[b]).squaredNorm(), a, b});
      }
    return edges;
  }

  // The vertices round v, each once.
  void ring_of(int v, std::vector<int>& out) const {
    out.clear();
    for (const int f : faces_of(v)) {
      const int c = F_[f][0] == v ? 0 : F_[f][1] == v ? 1 : 2;
      out.push_back(F_[f][(c + 1) % 3]);
    }
  }

  // The face across the edge that runs from a to b in face f.
  int across(int f, int a, int b) const {
    for (const int g : faces_of(a)) {
      if (g == f) continue;
      const Face& t = F_[g];
      for (int c = 0; c < 3; ++c)
        if (t[c] == b && t[(c + 1) % 3] == a) return g;
    }
    return -1;
  }

  // The worst fold over the edges of the faces round a and b, as a cosine; the thinnest of them.
  std::pair<double, double> worst_now(int a, int b) const {
    double fold = 1, thin = 1;
    for (const int v : {a, b})
      for (const int f : faces_of(v)) {
        const Face& t = F_[f];
        thin = std::min(thin, quality(V_[t[0]], V_[t[1]], V_[t[2]]));
        for (int c = 0; c < 3; ++c)
          if (const int g = across(f, t[c], t[(c + 1) % 3]); g >= 0)
            fold = std::min(fold, normals_[f].dot(normals_[g]));
      }
    return {fold, thin};
  }

  // Whether the surface stays fair where a and b become one at p. Fills changed_.
  bool stays_fair(int a, int b, const Vec3& p) {
    changed_.clear();
    double fold = 1, thin = 1;
    for (const int v : {a, b})
      for (const int f : faces_of(v)) {
        const Face& t = F_[f];
        const int c = t[0] == v ? 0 : t[1] == v ? 1 : 2;
        const int q = t[(c + 1) % 3], r = t[(c + 2) % 3];
        if (q == a || q == b || r == a || r == b) continue;
        const Vec3 now = normal(p, V_[q], V_[r]);
        if (!(now.dot(normals_[f]) > fairness_.turn) && !normals_[f].isZero(0)) return false;
        thin = std::min(thin, quality(p, V_[q], V_[r]));
        if (const int g = across(f, q, r); g >= 0) fold = std::min(fold, now.dot(normals_[g]));
        changed_.push_back({q, r, now});
      }
    for (const Changed& f : changed_)
      for (const Changed& g : changed_)
        if (f.to == g.from) fold = std::min(fold, f.normal.dot(g.normal));
    if (fold > fairness_.fold && thin > fairness_.quality) return true;
    const auto [fold_now, thin_now] = worst_now(a, b);
    return fold >= std::min(fairness_.fold, fold_now) &&
           thin >= std::min(fairness_.quality, thin_now);
  }

  bool collapse(int a, int b) {
    // Link condition (Dey et al. 1999): the ends share just the two vertices opposite the edge, and
    // those keep three faces or more.
    ring_of(a, ring_a_);
    ring_of(b, ring_b_);
    int shared = 0;
    std::array<int, 2> opposite = {-1, -1};
    for (const int v : ring_a_)
      if (std::find(ring_b_.begin(), ring_b_.end(), v) != ring_b_.end()) {
        if (shared == 2 || degree_[v] < 4) return false;
        opposite[shared++] = v;
      }
    if (shared != 2 || ring_a_.size() + ring_b_.size() < 4 + 4) return false;
    const Quadric q = quadrics_[a] + quadrics_[b];
    const Vec3 p = q.best((V_[a] + V_[b]) / 2);
    if (!stays_fair(a, b, p)) return false;
    V_[a] = p;
    quadrics_[a] = q;
    for (const int v : opposite) --degree_[v];
    for (const int f : faces_of(b)) {
      Face& t = F_[f];
      if (t[0] == a || t[1] == a || t[2] == a)
        t = {-1, -1, -1};
      else
        *std::find(t.begin(), t.end(), b) = a;
    }
    for (const int v : {a, b})
      for (const int f : faces_of(v))
        if (const Face& t = F_[f]; t[0] >= 0) normals_[f] = normal(V_[t[0]], V_[t[1]], V_[t[2]]);
    resting_[a] = resting_[b] = 1;
    for (const int v : ring_a_) resting_[v] = 1;
    for (const int v : ring_b_) resting_[v] = 1;
    return true;
  }

  struct Changed {
    int from, to;  // the corners that stay
    Vec3 normal;
  };

  double most_;  // units²
  Fairness fairness_ = kFairness[0];
  Vec3 middle_;
  std::vector<Vec3> V_;
  std::vector<Face> F_;  // −1 where gone in this sweep
  std::vector<Quadric> quadrics_;
  std::vector<int> first_, of_vertex_;  // as of a sweep's beginning: true still where nothing rests
  std::vector<Vec3> normals_;
  std::vector<int> degree_;  // faces round each vertex, kept up to date
  std::vector<char> resting_;
  std::vector<int> ring_a_, ring_b_;
  std::vector<Changed> changed_;
};

}  // namespace

Mesh collapsed(const Mesh& mesh, int triangles, double error) {
  if (mesh.F.rows() <= triangles) return mesh;
  Collapser collapser(mesh, error);
  for (const Fairness& fairness : kFairness)
    while (collapser.triangles() > triangles && collapser.sweep(triangles, fairness) > 0) {
    }
  return collapser.mesh();
}

}  // namespace artisketch
