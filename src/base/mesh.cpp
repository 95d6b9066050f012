#include "base/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>

namespace artisketch {
namespace {

Vec3 row(const Points3& V, int i) {
  return V.row(i).transpose();
}

// Union-find over vertices.
class Sets {
 public:
  explicit Sets(int n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(int a, int b) { parent_[find(a)] = find(b); }

 private:
  std::vector<int> parent_;
};

struct HalfEdge {
  std::uint64_t edge;  // the two vertices, lower first
  int corner;          // 3 · face + index of its first vertex in the face
  bool forward;        // runs from the lower vertex to the higher
};

std::vector<HalfEdge> sorted_half_edges(const Triangles& F) {
  std::vector<HalfEdge> edges;
  edges.reserve(3 * F.rows());
  for (int f = 0; f < F.rows(); ++f)
    for (int c = 0; c < 3; ++c) {
      const auto a = std::uint32_t(F(f, c)), b = std::uint32_t(F(f, (c + 1) % 3));
      edges.push_back({std::uint64_t(std::min(a, b)) << 32 | std::max(a, b), 3 * f + c, a < b});
    }
  std::sort(edges.begin(), edges.end(), [](const HalfEdge& a, const HalfEdge& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.corner < b.corner;
  });
  return edges;
}

}  // namespace

Topology topology(const Mesh& mesh) {
  const Triangles& F = mesh.F;
  Topology t;
  for (int f = 0; f < F.rows(); ++f)
    t.degenerate_faces += F(f, 0) == F(f, 1) || F(f, 1) == F(f, 2) || F(f, 2) == F(f, 0);
  const std::vector<HalfEdge> edges = sorted_half_edges(F);
  // Corners of one vertex that share an edge belong to one fan.
  Sets fans(int(3 * F.rows()));
  const auto next = [](int corner) { return corner - corner % 3 + (corner + 1) % 3; };
  int edge_count = 0;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i;
    int forward = 0;
    while (end < edges.size() && edges[end].edge == edges[i].edge) forward += edges[end++].forward;
    const int n = int(end - i);
    ++edge_count;
    t.boundary_edges += n == 1;
    t.nonmanifold_edges += n > 2;
    t.misoriented_edges += n == 2 && forward != 1;
    if (n == 2) {
      const int a = edges[i].corner, b = edges[i + 1].corner;
      const bool opposite = forward == 1;
      fans.join(a, opposite ? next(b) : b);
      fans.join(next(a), opposite ? b : next(b));
    }
    i = end;
  }
  std::vector<char> used(mesh.V.rows(), 0);
  Sets pieces(int(mesh.V.rows()));
  for (int f = 0; f < F.rows(); ++f)
    for (int c = 0; c < 3; ++c) {
      used[F(f, c)] = 1;
      pieces.join(F(f, c), F(f, (c + 1) % 3));
    }
  int fan_count = 0, vertex_count = 0;
  for (int corner = 0; corner < 3 * F.rows(); ++corner) fan_count += fans.find(corner) == corner;
  for (int v = 0; v < mesh.V.rows(); ++v) {
    vertex_count += used[v];
    t.components += used[v] && pieces.find(v) == v;
  }
  t.pinched_vertices = fan_count - vertex_count;
  t.euler = vertex_count - edge_count + int(F.rows());
  return t;
}

Points3 vertex_normals(const Mesh& mesh) {
  Points3 N = Points3::Zero(mesh.V.rows(), 3);
  for (int f = 0; f < mesh.F.rows(); ++f) {
    std::array<Vec3, 3> p;
    for (int c = 0; c < 3; ++c) p[c] = row(mesh.V, mesh.F(f, c));
    const Vec3 n = (p[1] - p[0]).cross(p[2] - p[0]);
    const double length = n.norm();
    if (length == 0) continue;
    for (int c = 0; c < 3; ++c) {
      const Vec3 a = p[(c + 1) % 3] - p[c], b = p[(c + 2) % 3] - p[c];
      const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
      N.row(mesh.F(f, c)) += (angle / length) * n.transpose();
    }
  }
  for (int v = 0; v < N.rows(); ++v) {
    const double length = N.row(v).norm();
    if (length > 1e-12)
      N.row(v) /= length;
    else
      N.row(v) << 0, 1, 0;
  }
  return N;
}

double signed_volume(const Mesh& mesh) {
  double six = 0;
  for (int f = 0; f < mesh.F.rows(); ++f)
    six +=
        row(mesh.V, mesh.F(f, 0)).dot(row(mesh.V, mesh.F(f, 1)).cross(row(mesh.V, mesh.F(f, 2))));
  return six / 6;
}

double surface_area(const Mesh& mesh) {
  double twice = 0;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    const Vec3 a = row(mesh.V, mesh.F(f, 0));
    twice += (row(mesh.V, mesh.F(f, 1)) - a).cross(row(mesh.V, mesh.F(f, 2)) - a).norm();
  }
  return twice / 2;
}

Box3 bounds(const Points3& points) {
  Box3 box;
  for (int i = 0; i < points.rows(); ++i) box.extend(row(points, i));
  return box;
}

double position_step(const Points3& points) {
  constexpr int kBits = 16;
  int exponent = 0;
  std::frexp(bounds(points).sizes().maxCoeff(), &exponent);
  return std::ldexp(1, exponent - kBits);
}

Adjacency vertex_adjacency(const Mesh& mesh) {
  // Every edge from both its triangles first, each vertex' in a row; then what is double goes.
  std::vector<int> next(mesh.V.rows() + 1, 0);
  for (int f = 0; f < mesh.F.rows(); ++f)
    for (int c = 0; c < 3; ++c) next[mesh.F(f, c) + 1] += 2;
  std::partial_sum(next.begin(), next.end(), next.begin());
  const std::vector<int> begin = next;
  std::vector<int> twice(next.back());
  for (int f = 0; f < mesh.F.rows(); ++f)
    for (int c = 0; c < 3; ++c) {
      const int a = mesh.F(f, c), b = mesh.F(f, (c + 1) % 3);
      twice[next[a]++] = b;
      twice[next[b]++] = a;
    }
  Adjacency adjacency;
  adjacency.offsets.reserve(begin.size());
  adjacency.offsets.push_back(0);
  adjacency.neighbours.reserve(twice.size() / 2);
  for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
    const auto first = twice.begin() + begin[v], last = twice.begin() + begin[v + 1];
    std::sort(first, last);
    adjacency.neighbours.insert(adjacency.neighbours.end(), first, std::unique(first, last));
    adjacency.offsets.push_back(int(adjacency.neighbours.size()));
  }
  return adjacency;
}

std::vector<int> vertex_components(const Mesh& mesh, int* count) {
  Sets pieces(int(mesh.V.rows()));
  for (int f = 0; f < mesh.F.rows(); ++f) {
    pieces.join(mesh.F(f, 0), mesh.F(f, 1));
    pieces.join(mesh.F(f, 1), mesh.F(f, 2));
  }
  std::vector<int> label(mesh.V.rows(), -1), component(mesh.V.rows());
  int n = 0;
  for (int v = 0; v < mesh.V.rows(); ++v) {
    int& l = label[pieces.find(v)];
    if (l < 0) l = n++;
    component[v] = l;
  }
  if (count) *count = n;
  return component;
}

Mesh largest_component(const Mesh& mesh) {
  int count = 0;
  const std::vector<int> component = vertex_components(mesh, &count);
  if (count <= 1) return mesh;
  std::vector<double> six(count, 0.0);
  for (int f = 0; f < mesh.F.rows(); ++f)
    six[component[mesh.F(f, 0)]] +=
        row(mesh.V, mesh.F(f, 0)).dot(row(mesh.V, mesh.F(f, 1)).cross(row(mesh.V, mesh.F(f, 2))));
  const auto larger = [](double a, double b) { return std::abs(a) < std::abs(b); };
  const int best = int(std::max_element(six.begin(), six.end(), larger) - six.begin());
  Mesh kept{mesh.V, Triangles(mesh.F.rows(), 3)};
  int n = 0;
  for (int f = 0; f < mesh.F.rows(); ++f)
    if (component[mesh.F(f, 0)] == best) kept.F.row(n++) = mesh.F.row(f);
  kept.F.conservativeResize(n, 3);
  return without_unused_vertices(kept);
}

Mesh without_unused_vertices(const Mesh& mesh) {
  std::vector<int> index(mesh.V.rows(), -1);
  for (int f = 0; f < mesh.F.rows(); ++f)
    for (int c = 0; c < 3; ++c) index[mesh.F(f, c)] = 0;
  Mesh kept{Points3(mesh.V.rows(), 3), mesh.F};
  int n = 0;
  for (int v = 0; v < mesh.V.rows(); ++v)
    if (index[v] == 0) {
      kept.V.row(n) = mesh.V.row(v);
      index[v] = n++;
    }
  kept.V.conservativeResize(n, 3);
  for (int f = 0; f < kept.F.rows(); ++f)
    for (int c = 0; c < 3; ++c) kept.F(f, c) = index[kept.F(f, c)];
  return kept;
}

std::vector<int> first_at_place(const Mesh& mesh) {
  std::vector<int> order(mesh.V.rows()), first(mesh.V.rows());
  std::iota(order.begin(), order.end(), 0);
  const auto place = [&](int v) {
    return std::array<double, 3>{mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)};
  };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return place(a) < place(b); });
  for (std::size_t i = 0; i < order.size(); ++i)
    first[order[i]] =
        i > 0 && place(order[i]) == place(order[i - 1]) ? first[order[i - 1]] : order[i];
  return first;
}

namespace {

Mesh with_joined_faces(Mesh mesh, const std::vector<int>& first) {
  for (Eigen::Index i = 0; i < mesh.F.size(); ++i) mesh.F.data()[i] = first[mesh.F.data()[i]];
  return mesh;
}

}  // namespace

Mesh welded(const Mesh& mesh) {
  return without_unused_vertices(with_joined_faces(mesh, first_at_place(mesh)));
}

Points3 seamless_normals(const Mesh& mesh) {
  const std::vector<int> first = first_at_place(mesh);
  const Points3 joined = vertex_normals(with_joined_faces(mesh, first));
  Points3 normals(joined.rows(), 3);
  for (int v = 0; v < normals.rows(); ++v) normals.row(v) = joined.row(first[v]);
  return normals;
}

Mesh icosphere(const Vec3& centre, double radius, int subdivisions) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  std::vector<Vec3> V = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                         {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  std::vector<Index3> F = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                           {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                           {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                           {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
  for (int s = 0; s < subdivisions; ++s) {
    std::map<std::pair<int, int>, int> middle;
    const auto midpoint = [&](int a, int b) {
      const auto [it, added] = middle.try_emplace(std::minmax(a, b), int(V.size()));
      if (added) V.push_back((V[a] + V[b]).normalized());
      return it->second;
    };
    for (Vec3& v : V) v.normalize();
    std::vector<Index3> finer;
    for (const Index3& f : F) {
      const int a = midpoint(f[0], f[1]), b = midpoint(f[1], f[2]), c = midpoint(f[2], f[0]);
      finer.insert(finer.end(), {{f[0], a, c}, {f[1], b, a}, {f[2], c, b}, {a, b, c}});
    }
    F = std::move(finer);
  }
  Mesh mesh{Points3(V.size(), 3), Triangles(F.size(), 3)};
  for (std::size_t i = 0; i < V.size(); ++i)
    mesh.V.row(i) = (centre + radius * V[i].normalized()).transpose();
  for (std::size_t i = 0; i < F.size(); ++i) mesh.F.row(i) = F[i].transpose();
  return mesh;
}

}  // namespace artisketch
