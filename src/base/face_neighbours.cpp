#include "base/face_neighbours.h"

#include <algorithm>

namespace artisketch {

FaceNeighbours face_neighbours(const Triangles& F) {
  // The sides in a list for each vertex that is the lower end of some.
  const int vertices = F.rows() > 0 ? F.maxCoeff() + 1 : 0;
  struct Side {
    int high, face, corner;
  };
  std::vector<int> first(vertices + 1, 0);
  const auto each = [&](const auto& visit) {
    for (int f = 0; f < F.rows(); ++f)
      for (int k = 0; k < 3; ++k) {
        const int a = F(f, k), b = F(f, (k + 1) % 3);
        visit(std::min(a, b), Side{std::max(a, b), f, k});
      }
  };
  each([&](int low, const Side&) { ++first[low + 1]; });
  for (int v = 0; v < vertices; ++v) first[v + 1] += first[v];
  std::vector<Side> sides(std::size_t(F.size()));
  std::vector<int> next(first.begin(), first.end() - 1);
  each([&](int low, const Side& side) { sides[next[low]++] = side; });
  FaceNeighbours neighbours(F.rows(), {-1, -1, -1});
  for (int v = 0; v < vertices; ++v) {
    const auto from = sides.begin() + first[v], to = sides.begin() + first[v + 1];
    // In the order of the faces where ends are the same.
    std::stable_sort(from, to, [](const Side& a, const Side& b) { return a.high < b.high; });
    for (auto a = from; a != to && a + 1 != to; ++a) {
      const auto b = a + 1;
      if (a->high != b->high || a->face == b->face) continue;
      neighbours[a->face][a->corner] = b->face;
      neighbours[b->face][b->corner] = a->face;
      ++a;
    }
  }
  return neighbours;
}

}  // namespace artisketch
