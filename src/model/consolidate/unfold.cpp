#include "model/consolidate/unfold.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace artisketch {
namespace {

constexpr double kFolded = 0;  // cosine between the normals of neighbours: over 90°
constexpr int kRounds = 30;
constexpr int kWidest = 3;  // rings round a fold that are smoothed, where it takes that much
constexpr double kInward = 0.6, kOutward = -0.3;  // of the way to the mean of those round a vertex
constexpr double kGain = 1e-3;                    // in cosine, that turning an edge has to bring

class Unfolder {
 public:
  explicit Unfolder(Mesh& mesh)
      : mesh_(mesh),
        beside_(face_neighbours(mesh.F)),
        normals_(mesh.F.rows()),
        a_face_(mesh.V.rows(), -1) {
    for (int f = 0; f < mesh.F.rows(); ++f) {
      normals_[f] = normal(f);
      for (int k = 0; k < 3; ++k) a_face_[mesh.F(f, k)] = f;
    }
  }

  int run() {
    std::vector<int> all(mesh_.F.rows());
    std::iota(all.begin(), all.end(), 0);
    std::vector<Edge> folds = folds_of(all), best_folds = folds;
    if (folds.empty()) return 0;
    std::vector<int> often(mesh_.V.rows(), 0);  // how often a vertex was at a fold
    Mesh best = mesh_;
    double least = sharpness(folds);
    for (int round = 0; round < kRounds && !folds.empty(); ++round) {
      touched_.clear();
      for (const Edge& e : folds) {
        touched_.insert(touched_.end(), {e.face, beside_[e.face][e.corner]});
        if (folded(e.face, e.corner)) turn_best(e.face);
      }
      std::vector<int> moving;
      for (const Edge& e : folds) {
        if (!folded(e.face, e.corner)) continue;
        for (const int f : {e.face, beside_[e.face][e.corner]})
          for (int c = 0; c < 3; ++c) moving.push_back(mesh_.F(f, c));
      }
      smooth(std::move(moving), often);
      folds = folds_of(touched_);
      if (const double now = sharpness(folds); now < least) {
        least = now;
        best = mesh_;
        best_folds = folds;
      }
    }
    mesh_ = std::move(best);
    return int(best_folds.size());
  }

 private:
  struct Edge {
    int face, corner;
    bool operator<(const Edge& o) const {
      return std::pair(face, corner) < std::pair(o.face, o.corner);
    }
    bool operator==(const Edge&) const = default;
  };

  Vec3 at(int v) const { return mesh_.V.row(v).transpose(); }
  static Vec3 normal(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 n = (b - a).cross(c - a);
    const double length = n.norm();
    return length > 0 ? Vec3(n / length) : n;
  }
  Vec3 normal(int f) const {
    return normal(at(mesh_.F(f, 0)), at(mesh_.F(f, 1)), at(mesh_.F(f, 2)));
  }
  bool folded(int f, int k) const {
    const int g = beside_[f][k];
    return g >= 0 && normals_[f].dot(normals_[g]) < kFolded;
  }
  // The folds at the edges of some faces, each once.
  std::vector<Edge> folds_of(const std::vector<int>& faces) const {
    std::vector<Edge> folds;
    for (const int f : faces)
      for (int k = 0; k < 3; ++k) {
        if (!folded(f, k)) continue;
        const int g = beside_[f][k];
        folds.push_back(f < g ? Edge{f, k} : Edge{g, corner_beside(g, f)});
      }
    once(folds);
    return folds;
  }
  template <class T>
  static void once(std::vector<T>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  // visit(face, corner of v in it), round v.
  template <class Visit>
  void round(int v, const Visit& visit) const {
    int f = a_face_[v];
    do {
      int k = 0;
      while (mesh_.F(f, k) != v) ++k;
      visit(f, k);
      f = beside_[f][(k + 2) % 3];
    } while (f >= 0 && f != a_face_[v]);
  }
  // What is wrong in all: one for a right angle, two where a triangle lies flat on its neighbour.
  double sharpness(const std::vector<Edge>& folds) const {
    double sum = 0;
    for (const Edge& e : folds)
      sum += 1 - normals_[e.face].dot(normals_[beside_[e.face][e.corner]]);
    return sum;
  }
  int corner_beside(int g, int f) const {
    for (int k = 0; k < 3; ++k)
      if (beside_[g][k] == f) return k;
    return -1;
  }

  // A quad of two faces: the edge from a to b with c before and d beyond it.
  struct Quad {
    int f, g, k, l;  // faces, and the edge's corner in each
    int a, b, c, d;
  };
  bool quad_at(int f, int k, Quad& q) const {
    const int g = beside_[f][k];
    if (g < 0) return false;
    const int l = corner_beside(g, f);
    q = {f,
         g,
         k,
         l,
         mesh_.F(f, k),
         mesh_.F(f, (k + 1) % 3),
         mesh_.F(f, (k + 2) % 3),
         mesh_.F(g, (l + 2) % 3)};
    return q.c != q.d && !joined(q.c, q.d);
  }
  bool joined(int c, int d) const {
    bool found = false;
    round(c, [&](int f, int k) { found |= mesh_.F(f, (k + 1) % 3) == d; });
    return found;
  }

  // What the worst fold over the quad's five edges would gain if its edge went the other way.
  double gain(const Quad& q) const {
    double before = normals_[q.f].dot(normals_[q.g]);
    const Vec3 acd = normal(at(q.a), at(q.d), at(q.c)), bcd = normal(at(q.b), at(q.c), at(q.d));
    if (acd.isZero(0) || bcd.isZero(0)) return -1;
    double after = acd.dot(bcd);
    const auto rim = [&](int face, int corner, const Vec3& turned) {
      const int h = beside_[face][corner];
      if (h < 0) return;
      before = std::min(before, normals_[face].dot(normals_[h]));
      after = std::min(after, turned.dot(normals_[h]));
    };
    rim(q.f, (q.k + 1) % 3, bcd);  // b c
    rim(q.f, (q.k + 2) % 3, acd);  // c a
    rim(q.g, (q.l + 1) % 3, acd);  // a d
    rim(q.g, (q.l + 2) % 3, bcd);  // d b
    return after - before;
  }

  // Faces a b c and b a d become a d c and b c d.
  void turn(const Quad& q) {
    const int bc = beside_[q.f][(q.k + 1) % 3], ca = beside_[q.f][(q.k + 2) % 3],
              ad = beside_[q.g][(q.l + 1) % 3], db = beside_[q.g][(q.l + 2) % 3];
    const int bc_corner = corner_beside(bc, q.f), ad_corner = corner_beside(ad, q.g);
    mesh_.F.row(q.f) << q.a, q.d, q.c;
    mesh_.F.row(q.g) << q.b, q.c, q.d;
    beside_[q.f] = {ad, q.g, ca};
    beside_[q.g] = {bc, q.f, db};
    beside_[ad][ad_corner] = q.f;
    beside_[bc][bc_corner] = q.g;
    a_face_[q.a] = q.f;
    a_face_[q.b] = q.g;
    normals_[q.f] = normal(q.f);
    normals_[q.g] = normal(q.g);
    touched_.insert(touched_.end(), {q.f, q.g});
  }

  // Of the edges of a face, turns the one that mends most.
  void turn_best(int f) {
    Quad best{};
    double most = kGain;
    for (int k = 0; k < 3; ++k)
      if (Quad q; quad_at(f, k, q))
        if (const double g = gain(q); g > most) most = g, best = q;
    if (most > kGain) turn(best);
  }

  void smooth(std::vector<int> moving, std::vector<int>& often) {
    once(moving);
    int wide = 0;
    for (const int v : moving) wide = std::max(wide, ++often[v] / 4);
    for (int r = 0; r < std::min(wide, kWidest); ++r) {
      for (std::size_t i = 0, n = moving.size(); i < n; ++i)
        round(moving[i], [&](int f, int k) { moving.push_back(mesh_.F(f, (k + 1) % 3)); });
      once(moving);
    }
    // Inward and out again, so that what is thin doesn't shrink to a thread (Taubin 1995).
    Points3 next(moving.size(), 3);
    for (const double step : {kInward, kOutward}) {
      for (std::size_t i = 0; i < moving.size(); ++i) {
        Vec3 sum = Vec3::Zero();
        int count = 0;
        round(moving[i], [&](int f, int k) { sum += at(mesh_.F(f, (k + 1) % 3)), ++count; });
        next.row(Eigen::Index(i)) = (at(moving[i]) + step * (sum / count - at(moving[i])));
      }
      for (std::size_t i = 0; i < moving.size(); ++i)
        mesh_.V.row(moving[i]) = next.row(Eigen::Index(i));
    }
    for (const int v : moving)
      round(v, [&](int f, int) {
        normals_[f] = normal(f);
        touched_.push_back(f);
      });
  }

  Mesh& mesh_;
  FaceNeighbours beside_;
  std::vector<Vec3> normals_;
  std::vector<int> a_face_;   // at each vertex
  std::vector<int> touched_;  // faces that changed in this round, and those that were folded
};

}  // namespace

std::vector<std::pair<int, int>> folds(const Mesh& mesh, const FaceNeighbours& beside) {
  std::vector<Vec3> normals(mesh.F.rows());
  for (int f = 0; f < mesh.F.rows(); ++f) {
    const Vec3 a = mesh.V.row(mesh.F(f, 0)), b = mesh.V.row(mesh.F(f, 1)),
               c = mesh.V.row(mesh.F(f, 2));
    normals[f] = (b - a).cross(c - a);  // their lengths don't matter
  }
  std::vector<std::pair<int, int>> found;
  for (int f = 0; f < mesh.F.rows(); ++f)
    for (const int g : beside[f])
      if (f < g && normals[f].dot(normals[g]) < 0) found.emplace_back(f, g);
  return found;
}

int unfold(Mesh& mesh) {
  return Unfolder(mesh).run();
}

}  // namespace artisketch
