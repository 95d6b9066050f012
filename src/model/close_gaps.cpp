#include "model/close_gaps.h"

#include <cmath>
#include <queue>

#include "base/well_composed.h"

namespace artisketch {
namespace {

// The 27 samples round one, bit x + 3 y + 9 z for offsets x − 1, y − 1, z − 1.
using Around = std::uint32_t;
constexpr int kCentre = 13;

struct Neighbourhoods {
  Around near6[27] = {}, near26[27] = {};  // the neighbours of each within the 27
  Around ring6 = 0, ring18 = 0, ring26 = 0;
};

constexpr Neighbourhoods neighbourhoods() {
  Neighbourhoods n;
  for (int a = 0; a < 27; ++a)
    for (int b = 0; b < 27; ++b) {
      const auto apart = [&](int unit) {
        const int d = a / unit % 3 - b / unit % 3;
        return d < 0 ? -d : d;
      };
      const int x = apart(1), y = apart(3), z = apart(9);
      if (a == b || x > 1 || y > 1 || z > 1) continue;
      n.near26[a] |= Around(1) << b;
      if (x + y + z == 1) n.near6[a] |= Around(1) << b;
      if (a != kCentre) continue;
      n.ring26 |= Around(1) << b;
      if (x + y + z <= 2) n.ring18 |= Around(1) << b;
      if (x + y + z == 1) n.ring6 |= Around(1) << b;
    }
  return n;
}
constexpr Neighbourhoods kNear = neighbourhoods();

int lowest_bit(Around set) {
  return __builtin_ctz(set);
}

// How many connected pieces `set` has that hold one of `touching`.
int pieces(Around set, const Around (&near)[27], Around touching) {
  int count = 0;
  while (Around seeds = set & touching) {
    Around piece = 0, front = seeds & -seeds;
    while (front) {
      piece |= front;
      const Around next = near[lowest_bit(front)] & set & ~piece;
      front = (front & (front - 1)) | next;
    }
    set &= ~piece;
    ++count;
  }
  return count;
}

// Whether the centre can leave the solid without changing its topology (a simple point: Bertrand
// and Malandain 1994, 6-connected inside, 26-connected outside) nor its being well-composed.
bool removable(Around inside) {
  if (pieces(inside & kNear.ring18, kNear.near6, kNear.ring6) != 1) return false;
  if (pieces(~inside & kNear.ring26, kNear.near26, kNear.ring26) != 1) return false;
  const Around without = inside & ~(Around(1) << kCentre);
  for (int c = 0; c < 8; ++c) {
    const int low = (c & 1) + 3 * (c >> 1 & 1) + 9 * (c >> 2);
    unsigned corners = 0;
    for (int v = 0; v < 8; ++v)
      corners |= (without >> (low + (v & 1) + 3 * (v >> 1 & 1) + 9 * (v >> 2)) & 1) << v;
    if (is_critical(corners)) return false;
  }
  return true;
}

Around around(const BlockGrid& grid, const Index3& s) {
  Around set = 0;
  for (int b = 0; b < 27; ++b)
    set |= Around(grid.inside(s.x() + b % 3 - 1, s.y() + b / 3 % 3 - 1, s.z() + b / 9 - 1)) << b;
  return set;
}

struct Filled {
  std::ptrdiff_t index;
  float was;          // its value
  float way = 1e30f;  // to the nearest open sample, in cells, along the lattice
  bool keep = false;  // wherever a ball doesn't reach
};

}  // namespace

void close_gaps(BlockGrid& grid, std::span<const float> seam, double reach,
                std::span<const JointSphere> spheres) {
  std::vector<Filled> filled;
  std::vector<int> filled_at(grid.values.size(), -1);
  const auto fill = [&](std::ptrdiff_t s, float was) {
    filled_at[s] = int(filled.size());
    filled.push_back({s, was});
    grid.values[s] = float(-1e-3 * grid.cell);
  };
  for (std::ptrdiff_t s = 0; s < std::ptrdiff_t(grid.values.size()); ++s)
    if (seam[s] <= reach && grid.values[s] >= 0) fill(s, grid.values[s]);
  for (const Turned& t : make_well_composed(grid)) fill(t.sample, t.was);

  // The way to the open, from outside in.
  using Item = std::pair<float, int>;  // way, index into filled
  std::priority_queue<Item, std::vector<Item>, std::greater<Item>> queue;
  const auto relax = [&](int to, float way) {
    if (way >= filled[to].way) return;
    filled[to].way = way;
    queue.push({way, to});
  };
  const auto for_neighbours = [&](int f, auto&& visit) {
    const Index3 s = grid.sample_of(filled[f].index);
    for (int b = 0; b < 27; ++b) {
      if (b == kCentre) continue;
      const Index3 d(b % 3 - 1, b / 3 % 3 - 1, b / 9 - 1);
      const Index3 p = s + d;
      visit(grid.find(p.x(), p.y(), p.z()), std::sqrt(float(d.squaredNorm())));
    }
  };
  for (int f = 0; f < int(filled.size()); ++f)
    for_neighbours(f, [&](std::ptrdiff_t s, float step) {
      if (s < 0 || grid.values[s] >= 0) relax(f, step);
    });
  while (!queue.empty()) {
    const float way = queue.top().first;
    const int f = queue.top().second;  // no structured binding: Clang 14 can't capture those
    queue.pop();
    if (way > filled[f].way) continue;
    for_neighbours(f, [&](std::ptrdiff_t s, float step) {
      if (s >= 0 && filled_at[s] >= 0) relax(filled_at[s], filled[f].way + step);
    });
  }
  for (Filled& f : filled) {
    if (f.way * grid.cell <= reach) continue;
    const Index3 s = grid.sample_of(f.index);
    const Vec3 p = grid.position(s.x(), s.y(), s.z());
    for (const JointSphere& sphere : spheres)
      f.keep |= (p - sphere.centre).squaredNorm() < sphere.radius * sphere.radius;
  }

  // Open again what the topology doesn't need, from outside in.
  for (int f = 0; f < int(filled.size()); ++f)
    if (!filled[f].keep) queue.push({filled[f].way, f});
  while (!queue.empty()) {
    const int f = queue.top().second;
    queue.pop();
    if (filled_at[filled[f].index] < 0) continue;
    if (!removable(around(grid, grid.sample_of(filled[f].index)))) continue;
    grid.values[filled[f].index] = filled[f].was;
    filled_at[filled[f].index] = -1;
    for_neighbours(f, [&](std::ptrdiff_t s, float) {
      if (s >= 0 && filled_at[s] >= 0 && !filled[filled_at[s]].keep)
        queue.push({filled[filled_at[s]].way, filled_at[s]});
    });
  }
}

}  // namespace artisketch
