#include "base/well_composed.h"

#include <array>

namespace artisketch {
namespace {

// The four corners round each face, in order.
constexpr int kFaces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                              {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};

constexpr std::array<bool, 256> critical_corners() {
  std::array<bool, 256> critical{};
  for (int m = 0; m < 256; ++m) {
    for (const auto& f : kFaces) {
      const bool a = m >> f[0] & 1, b = m >> f[1] & 1, c = m >> f[2] & 1, d = m >> f[3] & 1;
      critical[m] |= a == c && b == d && a != b;
    }
    for (int corner = 0; corner < 4; ++corner) {
      const int pair = 1 << corner | 1 << (7 - corner);
      critical[m] |= m == pair || m == (255 ^ pair);
    }
  }
  return critical;
}

constexpr std::array<bool, 256> kCritical = critical_corners();

unsigned corners_of(const BlockGrid& grid, int i, int j, int k) {
  unsigned mask = 0;
  for (int c = 0; c < 8; ++c)
    mask |= unsigned(grid.inside(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2))) << c;
  return mask;
}

// The outside corner nearest to the surface.
std::ptrdiff_t nearest_outside(const BlockGrid& grid, const Index3& cell) {
  std::ptrdiff_t nearest = -1;
  for (int c = 0; c < 8; ++c) {
    const std::ptrdiff_t s =
        grid.find(cell.x() + (c & 1), cell.y() + (c >> 1 & 1), cell.z() + (c >> 2));
    if (s < 0 || grid.values[s] < 0) continue;
    if (nearest < 0 || grid.values[s] < grid.values[nearest]) nearest = s;
  }
  return nearest;
}

}  // namespace

bool is_critical(unsigned corners) {
  return kCritical[corners];
}

namespace {

std::vector<Index3> critical_cells_of(const BlockGrid& grid) {
  constexpr int n = BlockGrid::kSide;
  std::vector<Index3> cells;
  BlockGrid::Window window;
  for (int b = 0; b < int(grid.at.size()); ++b) {
    const int count = grid.inside_window(b, window);
    if (count == 0 || count == int(window.size())) continue;
    const Index3 first = grid.first_sample(b);
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i)
          if (kCritical[BlockGrid::corners(window, i, j, k)])
            cells.push_back(first + Index3(i, j, k));
  }
  return cells;
}

}  // namespace

std::vector<Turned> make_well_composed(BlockGrid& grid) {
  std::vector<Turned> turned;
  // A sample turned on the border of what is stored asks for more to be stored, and for another
  // look there.
  do {
    grid.close();
    std::vector<Index3> work = critical_cells_of(grid);
    while (!work.empty()) {
      const Index3 cell = work.back();
      work.pop_back();
      if (!kCritical[corners_of(grid, cell.x(), cell.y(), cell.z())]) continue;
      const std::ptrdiff_t s = nearest_outside(grid, cell);
      if (s < 0) continue;  // not stored yet: the next round's
      turned.push_back({s, grid.values[s]});
      grid.values[s] = float(-1e-3 * grid.cell);
      const Index3 at = grid.sample_of(s);
      for (int c = 0; c < 8; ++c) work.push_back(at - Index3(c & 1, c >> 1 & 1, c >> 2));
    }
  } while (!grid.is_closed());
  return turned;
}

}  // namespace artisketch
