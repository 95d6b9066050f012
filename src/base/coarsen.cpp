#include "base/coarsen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace artisketch {
namespace {

constexpr double kMostTurn = 0.5;  // cosine: no face turns by more than 60° in one collapse

class Collapser {
 public:
  explicit Collapser(const Mesh& mesh)
      : V_(mesh.V.rows()), F_(mesh.F.rows()), faces_(mesh.V.rows()), left_(int(mesh.V.rows())) {
    for (int v = 0; v < left_; ++v) V_[v] = mesh.V.row(v).transpose();
    for (int f = 0; f < int(F_.size()); ++f) {
      F_[f] = {mesh.F(f, 0), mesh.F(f, 1), mesh.F(f, 2)};
      for (const int v : F_[f]) faces_[v].push_back(f);
    }
  }

  // Every edge shorter than `longest`, shortest first; around each collapse the mesh rests until
  // the next pass, so that the edges stay alike. Returns how many went.
  int pass(double longest, int wanted) {
    struct Edge {
      double length2;
      int a, b;
    };
    std::vector<Edge> edges;
    for (int f = 0; f < int(F_.size()); ++f)
      for (int c = 0; c < 3 && F_[f][0] >= 0; ++c) {
        const int a = F_[f][c], b = F_[f][(c + 1) % 3];
        const double length2 = (V_[a] - V_[b]).squaredNorm();
        if (a < b && length2 < longest * longest) edges.push_back({length2, a, b});
      }
    std::sort(edges.begin(), edges.end(), [](const Edge& p, const Edge& q) {
      return p.length2 != q.length2 ? p.length2 < q.length2
                                    : std::pair(p.a, p.b) < std::pair(q.a, q.b);
    });
    resting_.assign(V_.size(), 0);
    int gone = 0;
    for (const Edge& e : edges) {
      if (left_ <= wanted) break;
      if (!resting_[e.a] && !resting_[e.b] && collapse(e.a, e.b)) ++gone;
    }
    return gone;
  }

  int left() const { return left_; }

  Mesh mesh() const {
    Mesh out{Points3(V_.size(), 3), Triangles(F_.size(), 3)};
    for (std::size_t v = 0; v < V_.size(); ++v) out.V.row(v) = V_[v].transpose();
    int n = 0;
    for (const auto& f : F_)
      if (f[0] >= 0) out.F.row(n++) << f[0], f[1], f[2];
    out.F.conservativeResize(n, 3);
    return without_unused_vertices(out);
  }

 private:
  void neighbours_of(int v, std::vector<int>& out) const {
    out.clear();
    for (const int f : faces_[v])
      for (const int w : F_[f])
        if (w != v) out.push_back(w);
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
  }

  // Whether some face of v, none of b's, would turn too far if v went to p.
  bool turns(int v, int b, const Vec3& p) const {
    for (const int f : faces_[v]) {
      const auto& t = F_[f];
      if (t[0] == b || t[1] == b || t[2] == b) continue;
      const int c = t[0] == v ? 0 : t[1] == v ? 1 : 2;
      const Vec3 &q = V_[t[(c + 1) % 3]], &r = V_[t[(c + 2) % 3]];
      const Vec3 before = (q - V_[v]).cross(r - V_[v]), after = (q - p).cross(r - p);
      if (after.dot(before) < kMostTurn * after.norm() * before.norm() || after.isZero(0))
        return true;
    }
    return false;
  }

  bool collapse(int a, int b) {
    // Link condition (Dey et al. 1999): the ends share just the two vertices opposite the edge, and
    // those keep three faces or more.
    neighbours_of(a, near_a_);
    neighbours_of(b, near_b_);
    shared_.clear();
    std::set_intersection(near_a_.begin(), near_a_.end(), near_b_.begin(), near_b_.end(),
                          std::back_inserter(shared_));
    if (shared_.size() != 2 || near_a_.size() + near_b_.size() < 4 + 4) return false;
    for (const int s : shared_)
      if (faces_[s].size() < 4) return false;
    const Vec3 middle = (V_[a] + V_[b]) / 2;
    if (turns(a, b, middle) || turns(b, a, middle)) return false;
    for (const int f : faces_[b]) {
      auto& t = F_[f];
      if (t[0] == a || t[1] == a || t[2] == a) {
        for (const int v : t)
          if (v != b) faces_[v].erase(std::find(faces_[v].begin(), faces_[v].end(), f));
        t = {-1, -1, -1};
      } else {
        *std::find(t.begin(), t.end(), b) = a;
        faces_[a].push_back(f);
      }
    }
    faces_[b].clear();
    V_[a] = middle;
    --left_;
    resting_[a] = 1;
    for (const int v : near_a_) resting_[v] = 1;
    for (const int v : near_b_) resting_[v] = 1;
    return true;
  }

  std::vector<Vec3> V_;
  std::vector<std::array<int, 3>> F_;    // −1 where gone
  std::vector<std::vector<int>> faces_;  // round each vertex
  int left_;
  std::vector<char> resting_;
  std::vector<int> near_a_, near_b_, shared_;
};

}  // namespace

Mesh coarsened(const Mesh& mesh, int vertices) {
  if (mesh.V.rows() <= vertices) return mesh;
  Collapser collapser(mesh);
  // An even mesh of n vertices has edges of this length: two triangles a vertex, each √3/4 edge².
  const double goal = std::sqrt(surface_area(mesh) * 2 / std::sqrt(3.0) / vertices);
  // The shortest edges first; in the end longer ones too, as some short ones can't go.
  for (double longest = goal / 4; collapser.left() > vertices && longest < 4 * goal;)
    if (collapser.pass(longest, vertices) <= collapser.left() / 50) longest *= 1.25;
  return collapser.mesh();
}

}  // namespace artisketch
