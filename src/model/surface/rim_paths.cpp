// Section 4: on each view's outline the surface has a rim, a closed curve on which the view's rays
// touch it. The hull leaves the rim open: its surface follows each contour ray for a stretch, and
// any point of the stretch explains the contour. A closed path of mesh vertices is chosen by
// dynamic programming along the contour. How we read the five costs, for a vertex v at a sample c
// of the contour, in squares of mesh edges where they are lengths:
//
//   silhouette  the view sees v edge-on: (n_v · r)², r the ray
//   proximity   the pixel of v lies at c
//   normal      v's normal, as the view sees it, is the contour's: 1 − n_v · N_c
//   barycentre  v lies at the middle, in depth, of all the vertices that the sample could take
//   geodesic    from one sample's vertex to the next the way over the mesh is short
//
// The chosen vertices are joined by the shortest ways over the mesh. Where a part is thinner than
// the mesh's edges, a rim may run through a vertex twice.
#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

#include "model/stages.h"

namespace artisketch {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

// In mesh edges.
constexpr double kReach = 2;         // from a sample to what may stand for it: rounding is an edge
constexpr double kFarthestStep = 3;  // from one sample's vertex to the next one's, without a leap

constexpr double kLeastAgreement = 0.3;  // cosine between contour and surface normal
constexpr double kEdgeOn = 0.35;         // cosine between ray and surface normal: 20°

struct CostWeights {
  double silhouette = 2, proximity = 1, normal = 2, barycentre = 4, geodesic = 0.5;
};

// What one view sees of the mesh.
struct SeenVertices {
  std::vector<Vec2> pixels;
  std::vector<double> depths;   // units along the view, larger is nearer
  std::vector<double> edge_on;  // n · r
  std::vector<Vec2> normals;  // n in the image's axes, shorter than 1 where it leans to the viewer
};

SeenVertices seen_by(const PartView& view, const Mesh& mesh, const Points3& normals) {
  SeenVertices seen;
  const int n = int(mesh.V.rows());
  for (int v = 0; v < n; ++v) {
    const Vec3 X = view.to_world * Vec3(mesh.V.row(v).transpose());
    const Vec3 normal = view.to_world.linear() * normals.row(v).transpose();
    const bool ortho = view.camera.camera.type == Camera::Type::orthographic;
    const Vec3 ray =
        ortho ? Vec3(0, 0, -1) : (X - Vec3(0, 0, view.camera.camera.distance)).normalized();
    seen.pixels.push_back(view.camera.project(X));
    seen.depths.push_back(X.z());
    seen.edge_on.push_back(normal.dot(ray));
    const Vec3 across = normal - normal.dot(ray) * ray;
    seen.normals.emplace_back(across.x(), -across.y());
  }
  return seen;
}

// Vertices by the pixel bucket they project to.
class PixelBuckets {
 public:
  PixelBuckets(const std::vector<Vec2>& pixels, double size) : size_(size) {
    for (const Vec2& p : pixels) box_.extend(p);
    // No more than a few million buckets, whatever lies far out.
    size_ = std::max(size_, box_.sizes().maxCoeff() / 2000);
    nx_ = int(box_.sizes().x() / size_) + 1;
    ny_ = int(box_.sizes().y() / size_) + 1;
    start_.assign(std::size_t(nx_) * ny_ + 1, 0);
    for (const Vec2& p : pixels) ++start_[bucket(p) + 1];
    for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
    items_.resize(pixels.size());
    std::vector<int> fill(start_.begin(), start_.end() - 1);
    for (int v = 0; v < int(pixels.size()); ++v) items_[fill[bucket(pixels[v])]++] = v;
  }

  template <class Visit>
  void near(const Vec2& p, double radius, const Visit& visit) const {
    const Vec2 low = (p - box_.min()).array() - radius, high = (p - box_.min()).array() + radius;
    const int x1 = std::min(int(std::floor(high.x() / size_)), nx_ - 1);
    const int y1 = std::min(int(std::floor(high.y() / size_)), ny_ - 1);
    for (int y = std::max(int(std::floor(low.y() / size_)), 0); y <= y1; ++y)
      for (int x = std::max(int(std::floor(low.x() / size_)), 0); x <= x1; ++x) {
        const std::size_t b = std::size_t(y) * nx_ + x;
        for (int i = start_[b]; i < start_[b + 1]; ++i) visit(items_[i]);
      }
  }

 private:
  std::size_t bucket(const Vec2& p) const {
    const Vec2 at = (p - box_.min()) / size_;
    return std::size_t(int(at.y())) * nx_ + int(at.x());
  }
  double size_;
  Box2 box_;
  int nx_ = 0, ny_ = 0;
  std::vector<int> start_, items_;
};

// Shortest ways along the edges of a mesh.
class Ways {
 public:
  struct Reached {
    int vertex;
    double distance;
  };

  explicit Ways(const Mesh& mesh)
      : V_(mesh.V),
        adjacency_(vertex_adjacency(mesh)),
        distance_(mesh.V.rows(), kInfinite),
        from_(mesh.V.rows(), -1) {}

  const Adjacency& adjacency() const { return adjacency_; }

  // All vertices within `radius` of start.
  std::vector<Reached> near(int start, double radius) {
    search(start, radius, -1);
    std::vector<Reached> reached;
    for (const int v : touched_)
      if (distance_[v] <= radius) reached.push_back({v, distance_[v]});
    return reached;
  }

  // The vertices after `start` up to and with `end`; empty where there is no way, or none to go.
  std::vector<int> between(int start, int end) {
    std::vector<int> way;
    if (start == end || !search(start, kInfinite, end)) return way;
    for (int v = end; v != start; v = from_[v]) way.push_back(v);
    std::reverse(way.begin(), way.end());
    return way;
  }

 private:
  bool search(int start, double radius, int end) {
    for (const int v : touched_) distance_[v] = kInfinite;
    touched_.assign(1, start);
    distance_[start] = 0;
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    queue.emplace(0, start);
    while (!queue.empty()) {
      const auto [d, v] = queue.top();
      queue.pop();
      if (d > distance_[v]) continue;
      if (v == end) return true;
      if (d > radius) break;
      for (const int w : adjacency_.of(v)) {
        const double further = d + (V_.row(v) - V_.row(w)).norm();
        if (further >= distance_[w]) continue;
        if (distance_[w] == kInfinite) touched_.push_back(w);
        distance_[w] = further;
        from_[w] = v;
        queue.emplace(further, w);
      }
    }
    return false;
  }

  const Points3& V_;
  Adjacency adjacency_;
  std::vector<double> distance_;
  std::vector<int> from_, touched_;
};

struct Candidate {
  int vertex;
  double cost;
};
using Stage = std::vector<Candidate>;  // what could stand for one sample

// Whether the contour's tangent, turned a quarter turn from +x to −y, points out of the part.
bool outside_on_the_left(const PartView& view, const Polyline& contour) {
  constexpr double kAside = 1e-3;  // pixels
  double votes = 0;
  for (std::size_t s = 0; s < contour.segments(); ++s) {
    const Vec2 along = contour.end_of(s) - contour.points[s];
    const double length = along.norm();
    if (length == 0) continue;
    const Vec2 middle = contour.points[s] + along / 2;
    const Vec2 left = Vec2(along.y(), -along.x()) * (kAside / length);
    votes += length *
             (int(view.outline.inside(middle - left)) - int(view.outline.inside(middle + left)));
  }
  return votes >= 0;
}

// What could stand for each sample of a contour, leaving out those that nothing could.
// edge: a mesh edge in pixels.
std::vector<Stage> stages_along(const PartView& view, const Polyline& contour,
                                const Polyline& samples, const SeenVertices& seen,
                                const PixelBuckets& buckets, double edge, double edge_units) {
  const CostWeights weights;
  const double reach = kReach * edge;
  const double turn = outside_on_the_left(view, contour) ? 1 : -1;
  std::vector<Stage> stages;
  const int n = int(samples.points.size());
  for (int s = 0; s < n; ++s) {
    const Vec2 c = samples.points[s];
    const Vec2 tangent = samples.points[(s + 1) % n] - samples.points[(s + n - 1) % n];
    const double length = tangent.norm();
    if (length == 0) continue;
    const Vec2 normal = Vec2(tangent.y(), -tangent.x()) * (turn / length);
    Stage stage;
    double low = kInfinite, high = -kInfinite;
    buckets.near(c, reach, [&](int v) {
      const double away = (seen.pixels[v] - c).norm();
      const double agreement = seen.normals[v].dot(normal);
      if (away > reach || agreement < kLeastAgreement) return;
      stage.push_back({v, weights.proximity * std::pow(away / edge, 2) +
                              weights.silhouette * std::pow(seen.edge_on[v], 2) +
                              weights.normal * (1 - agreement)});
      // The middle is that of what the rays touch, not of what leans away from them.
      if (std::abs(seen.edge_on[v]) > kEdgeOn) return;
      low = std::min(low, seen.depths[v]);
      high = std::max(high, seen.depths[v]);
    });
    if (stage.empty()) continue;
    if (low <= high) {
      const double half = (high - low) / 2 + edge_units;
      for (Candidate& c : stage)
        c.cost +=
            weights.barycentre * std::pow((seen.depths[c.vertex] - (low + high) / 2) / half, 2);
    }
    stages.push_back(std::move(stage));
  }
  return stages;
}

// The cheapest choice of one vertex for each stage.
class Choice {
 public:
  Choice(Ways& ways, double edge_units, int vertices)
      : ways_(ways), edge_(edge_units), at_(vertices, -1), near_at_(vertices, -1) {}

  std::vector<int> cheapest(std::span<const Stage> stages) {
    std::vector<std::vector<int>> from(stages.size());
    std::vector<double> value, next;
    for (const Candidate& c : stages[0]) value.push_back(c.cost);
    for (std::size_t s = 1; s < stages.size(); ++s) {
      const Stage &before = stages[s - 1], &stage = stages[s];
      const int best = int(std::min_element(value.begin(), value.end()) - value.begin());
      // A leap over the mesh is always possible, and always dear.
      next.assign(stage.size(), value[best] + geodesic(2 * kFarthestStep * edge_));
      from[s].assign(stage.size(), best);
      for (int c = 0; c < int(stage.size()); ++c) at_[stage[c].vertex] = c;
      for (int b = 0; b < int(before.size()); ++b) {
        if (value[b] >= value[best] + geodesic(2 * kFarthestStep * edge_)) continue;
        for (const Ways::Reached& r : near(before[b].vertex)) {
          const int c = at_[r.vertex];
          if (c < 0 || value[b] + geodesic(r.distance) >= next[c]) continue;
          next[c] = value[b] + geodesic(r.distance);
          from[s][c] = b;
        }
      }
      for (int c = 0; c < int(stage.size()); ++c) {
        at_[stage[c].vertex] = -1;
        next[c] += stage[c].cost;
      }
      value.swap(next);
    }
    std::vector<int> chosen(stages.size());
    int c = int(std::min_element(value.begin(), value.end()) - value.begin());
    for (std::size_t s = stages.size(); s-- > 0;) {
      chosen[s] = stages[s][c].vertex;
      if (s > 0) c = from[s][c];
    }
    return chosen;
  }

  // The same, round and round: first with open ends, which the middle of the contour hardly feels,
  // then from what was chosen there back to it.
  std::vector<int> cheapest_round(std::vector<Stage> stages) {
    const std::size_t middle = stages.size() / 2;
    const int fixed = cheapest(stages)[middle];
    std::rotate(stages.begin(), stages.begin() + std::ptrdiff_t(middle), stages.end());
    stages[0] = {{fixed, 0}};
    stages.push_back(stages[0]);
    std::vector<int> chosen = cheapest(stages);
    chosen.pop_back();
    return chosen;
  }

 private:
  double geodesic(double distance) const {
    return CostWeights().geodesic * std::pow(distance / edge_, 2);
  }

  // Many samples share candidates: each is searched from once.
  const std::vector<Ways::Reached>& near(int v) {
    if (near_at_[v] < 0) {
      near_at_[v] = int(near_.size());
      near_.push_back(ways_.near(v, kFarthestStep * edge_));
    }
    return near_[near_at_[v]];
  }

  Ways& ways_;
  double edge_;
  std::vector<int> at_, near_at_;
  std::vector<std::vector<Ways::Reached>> near_;
};

double mean_edge(const Mesh& mesh, const Adjacency& adjacency) {
  double sum = 0;
  for (int v = 0; v < mesh.V.rows(); ++v)
    for (const int w : adjacency.of(v)) sum += (mesh.V.row(v) - mesh.V.row(w)).norm();
  return sum / double(std::max<std::size_t>(adjacency.neighbours.size(), 1));
}

}  // namespace

Result<std::vector<Rim>> rim_paths(const Part& part, const Mesh& mesh, Run& run) {
  std::vector<Rim> rims;
  if (mesh.V.rows() == 0) return rims;
  const Points3 normals = vertex_normals(mesh);
  Ways ways(mesh);
  const double edge_units = mean_edge(mesh, ways.adjacency());
  Choice choice(ways, edge_units, int(mesh.V.rows()));
  const Vec3 centre = bounds(mesh.V).center();
  for (std::size_t p = 0; p < part.views.size(); ++p) {
    const PartView& view = part.views[p];
    if (!view.seen() || view.mirrored) continue;
    const double edge = edge_units * view.pixels_per_unit(centre);
    const SeenVertices seen = seen_by(view, mesh, normals);
    const PixelBuckets buckets(seen.pixels, edge);
    for (const Polyline& contour : view.contours) {
      if (run.cancelled()) return cancelled();
      if (!contour.closed) continue;
      const Polyline samples = resampled(contour, edge);
      const std::vector<Stage> stages =
          stages_along(view, contour, samples, seen, buckets, edge, edge_units);
      // A contour that the surface doesn't reach (of a smaller piece, of a closed hole) has none.
      if (stages.size() < 3 || 2 * stages.size() < samples.points.size()) continue;
      const std::vector<int> chosen = choice.cheapest_round(stages);
      Rim rim{view.frame, {}};
      for (std::size_t i = 0; i < chosen.size(); ++i) {
        const std::vector<int> way = ways.between(chosen[i], chosen[(i + 1) % chosen.size()]);
        rim.vertices.insert(rim.vertices.end(), way.begin(), way.end());
      }
      if (rim.vertices.size() >= 3) rims.push_back(std::move(rim));
    }
    run.report((p + 1.0) / double(part.views.size()));
  }
  return rims;
}

}  // namespace artisketch
