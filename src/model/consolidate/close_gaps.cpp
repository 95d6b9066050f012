#include "model/consolidate/close_gaps.h"

#include <algorithm>
#include <array>
#include <queue>
#include <utility>
#include <vector>

#include "base/well_composed.h"

namespace artisketch {
namespace {

// The 27 samples round one, bit x + 3 y + 9 z for offsets x − 1, y − 1, z − 1.
using Around = std::uint32_t;
constexpr int kCentre = 13;

struct Neighbourhoods {
  Around ring6 = 0, ring18 = 0, ring26 = 0, all = (Around(1) << 27) - 1;
  Around low[3] = {}, high[3] = {};  // those that have no neighbour before them, or after, per axis
  float step[27] = {};               // from the centre
};

constexpr Neighbourhoods neighbourhoods() {
  Neighbourhoods n;
  for (int b = 0; b < 27; ++b) {
    const Around bit = Around(1) << b;
    int off = 0;  // axes along which it lies aside of the centre
    for (int axis = 0, unit = 1; axis < 3; ++axis, unit *= 3) {
      const int at = b / unit % 3;
      off += at != 1;
      if (at == 0) n.low[axis] |= bit;
      if (at == 2) n.high[axis] |= bit;
    }
    if (off == 0) continue;
    n.step[b] = off == 1 ? 1 : off == 2 ? 1.41421356f : 1.73205081f;
    n.ring26 |= bit;
    if (off <= 2) n.ring18 |= bit;
    if (off == 1) n.ring6 |= bit;
  }
  return n;
}
constexpr Neighbourhoods kNear = neighbourhoods();

// What lies at or beside the members of a set along one axis.
Around spread(Around set, int axis) {
  constexpr int kUnit[3] = {1, 3, 9};
  return set | (set & ~kNear.high[axis]) << kUnit[axis] | (set & ~kNear.low[axis]) >> kUnit[axis];
}
Around spread6(Around set) {
  return spread(set, 0) | spread(set, 1) | spread(set, 2);
}
Around spread26(Around set) {
  return spread(spread(spread(set, 0), 1), 2);
}

// How many connected pieces `set` has that hold one of `touching`.
int pieces(Around set, Around (*beside)(Around), Around touching) {
  int count = 0;
  while (const Around seeds = set & touching) {
    Around piece = seeds & -seeds, before = 0;
    while (piece != before) {
      before = piece;
      piece = beside(piece) & set;
    }
    set &= ~piece;
    ++count;
  }
  return count;
}

bool stays_well_composed(Around inside) {
  for (int c = 0; c < 8; ++c) {
    const int low = (c & 1) + 3 * (c >> 1 & 1) + 9 * (c >> 2);
    unsigned corners = 0;
    for (int v = 0; v < 8; ++v)
      corners |= (inside >> (low + (v & 1) + 3 * (v >> 1 & 1) + 9 * (v >> 2)) & 1) << v;
    if (is_critical(corners)) return false;
  }
  return true;
}

// Whether the centre can join the solid without joining two places of it: it may end a tunnel,
// never begin one.
bool addable(Around inside) {
  return pieces(inside & kNear.ring18, spread6, kNear.ring6) == 1 &&
         stays_well_composed(inside | Around(1) << kCentre);
}

// Whether the centre can leave the solid without changing its topology (a simple point: Bertrand
// and Malandain 1994, 6-connected inside, 26-connected outside). It may let the air into a bubble.
bool removable(Around inside, Around bubble) {
  const Around outside = ~inside & kNear.ring26;
  if (pieces(inside & kNear.ring18, spread6, kNear.ring6) != 1) return false;
  const int open = pieces(outside & ~bubble, spread26, kNear.ring26);
  const int closed = pieces(outside & bubble, spread26, kNear.ring26);
  if (open > 1 || closed > 1 || open + closed == 0) return false;
  return stays_well_composed(inside & ~(Around(1) << kCentre));
}

// The samples round one, as indices into the grid's values; −1 where one isn't stored.
struct Places {
  std::ptrdiff_t at[27];
};
Places places_round(const BlockGrid& grid, std::ptrdiff_t sample) {
  constexpr int n = BlockGrid::kSide;
  Places places;
  const int in_block = int(sample % BlockGrid::kSize);
  const int x = in_block % n, y = in_block / n % n, z = in_block / (n * n);
  const auto within = [](int i) { return i > 0 && i < n - 1; };
  if (within(x) && within(y) && within(z)) {
    for (int b = 0; b < 27; ++b)
      places.at[b] = sample + (b % 3 - 1) + n * (b / 3 % 3 - 1) + n * n * (b / 9 - 1);
    return places;
  }
  const Index3 s = grid.sample_of(sample);
  for (int b = 0; b < 27; ++b)
    places.at[b] = grid.find(s.x() + b % 3 - 1, s.y() + b / 3 % 3 - 1, s.z() + b / 9 - 1);
  return places;
}

// Marks as open every outside sample that hangs together with those in `front`.
void flood(const BlockGrid& grid, std::vector<std::ptrdiff_t>& front, std::vector<char>& open) {
  constexpr int n = BlockGrid::kSide;
  constexpr int kStep[3] = {1, n, n * n};
  while (!front.empty()) {
    const std::ptrdiff_t s = front.back();
    front.pop_back();
    const int in_block = int(s % BlockGrid::kSize);
    for (int axis = 0; axis < 3; ++axis)
      for (const int way : {-1, 1}) {
        const int along = in_block / kStep[axis] % n + way;
        std::ptrdiff_t next = s + way * kStep[axis];
        if (along < 0 || along >= n) {
          Index3 p = grid.sample_of(s);
          p[axis] += way;
          next = grid.find(p.x(), p.y(), p.z());
        }
        if (next < 0 || open[next] || grid.values[next] < 0) continue;
        open[next] = 1;
        front.push_back(next);
      }
  }
}

// The outside samples that hang together with the border of what is stored. Blocks that hold
// nothing solid, which most do, open as a whole.
std::vector<char> open_samples(const BlockGrid& grid) {
  constexpr int n = BlockGrid::kSide, kSize = BlockGrid::kSize;
  std::vector<char> open(grid.values.size(), 0), empty(grid.at.size());
  for (std::size_t b = 0; b < grid.at.size(); ++b) {
    const float* values = &grid.values[b * kSize];
    empty[b] = std::none_of(values, values + kSize, [](float v) { return v < 0; });
  }
  std::vector<int> front;  // empty blocks
  std::vector<std::ptrdiff_t> samples;
  const auto open_block = [&](int b) {
    char* first = &open[std::size_t(b) * kSize];
    if (*first) return;
    std::fill(first, first + kSize, char(1));
    front.push_back(b);
  };
  const auto open_sample = [&](std::ptrdiff_t s) {
    if (grid.values[s] < 0 || open[s]) return;
    open[s] = 1;
    samples.push_back(s);
  };
  const auto slot_beside = [&](const Index3& at, int axis, int way) {
    Index3 beside = at;
    beside[axis] += way;
    return grid.has_block(beside.x(), beside.y(), beside.z())
               ? grid.slot[grid.block_index(beside.x(), beside.y(), beside.z())]
               : -1;
  };
  for (int b = 0; b < int(grid.at.size()); ++b)
    for (int axis = 0; axis < 3; ++axis)
      for (const int way : {-1, 1}) {
        if (slot_beside(grid.at[b], axis, way) >= 0) continue;
        if (empty[b]) {
          open_block(b);
          continue;
        }
        // The middle of the face is outside: parts keep a margin from the blocks' border.
        Index3 middle = Index3::Constant(n / 2);
        middle[axis] += way < 0 ? -n / 2 : n / 2 - 1;
        open_sample(std::ptrdiff_t(b) * kSize +
                    BlockGrid::within(middle.x(), middle.y(), middle.z()));
      }
  while (!front.empty()) {
    const int b = front.back();
    front.pop_back();
    for (int axis = 0; axis < 3; ++axis)
      for (const int way : {-1, 1}) {
        const int beside = slot_beside(grid.at[b], axis, way);
        if (beside < 0) continue;
        if (empty[beside]) {
          open_block(beside);
          continue;
        }
        Index3 p;
        p[axis] = way < 0 ? n - 1 : 0;
        for (int v = 0; v < n; ++v)
          for (int u = 0; u < n; ++u) {
            p[(axis + 1) % 3] = u;
            p[(axis + 2) % 3] = v;
            open_sample(std::ptrdiff_t(beside) * kSize + BlockGrid::within(p.x(), p.y(), p.z()));
          }
      }
  }
  // Through what is left; a pocket of empty blocks behind a neck is reached sample by sample.
  flood(grid, samples, open);
  return open;
}

struct Fill {
  std::ptrdiff_t index;
  float was;  // its value
  float seam;
  Around inside = 0;  // of the 27 samples round it
  float way = 1e30f;  // to the nearest open sample, in cells, along the lattice
  bool in = false;    // filled
  bool keep = false;  // filled for good
  bool queued = false;
};

using Queue = std::priority_queue<std::pair<float, int>, std::vector<std::pair<float, int>>,
                                  std::greater<std::pair<float, int>>>;  // rank, index of a Fill

void push_once(Queue& queue, std::vector<Fill>& all, int f, float rank) {
  if (!std::exchange(all[f].queued, true)) queue.push({rank, f});
}
int take(Queue& queue, std::vector<Fill>& all) {
  const int f = queue.top().second;
  queue.pop();
  all[f].queued = false;
  return f;
}

// The places that may be filled.
struct Fills {
  BlockGrid& grid;
  std::vector<Fill> all;
  std::vector<std::array<int, 27>> beside;  // per place those round it that may be filled too, −1
  std::vector<char> open;                   // per sample of the grid: outside, and not in a bubble

  Fills(Body::Sampled& sampled, double reach) : grid(sampled.grid) {
    std::vector<int> at(grid.values.size(), -1);
    for (std::ptrdiff_t s = 0; s < std::ptrdiff_t(grid.values.size()); ++s) {
      if (sampled.seam[s] > reach || grid.values[s] < 0) continue;
      at[s] = int(all.size());
      all.push_back({s, grid.values[s], sampled.seam[s]});
    }
    beside.resize(all.size());
    for (std::size_t f = 0; f < all.size(); ++f) {
      const Places places = places_round(grid, all[f].index);
      for (int b = 0; b < 27; ++b) {
        const std::ptrdiff_t n = places.at[b];
        beside[f][b] = n < 0 ? -1 : at[n];
        all[f].inside |= Around(n >= 0 && grid.values[n] < 0) << b;
      }
    }
  }

  // The samples round a place that are outside in a bubble.
  Around bubble_of(int f) const {
    const Places places = places_round(grid, all[f].index);
    Around set = 0;
    for (int b = 0; b < 27; ++b) {
      const std::ptrdiff_t n = places.at[b];
      set |= Around(n >= 0 && grid.values[n] >= 0 && !open[n]) << b;
    }
    return set;
  }
  // What becomes air where the place is opened: itself, and a bubble beside it.
  void let_air_in(int f) {
    std::vector<std::ptrdiff_t> front{all[f].index};
    open[all[f].index] = 1;
    flood(grid, front, open);
  }
  void set(int f, bool in) {
    all[f].in = in;
    for (int b = 0; b < 27; ++b)
      if (const int g = beside[f][b]; g >= 0) {
        const Around bit = Around(1) << (26 - b);  // the place as its neighbour sees it
        all[g].inside = in ? all[g].inside | bit : all[g].inside & ~bit;
      }
    grid.values[all[f].index] = in ? float(-1e-3 * grid.cell) : all[f].was;
  }
  // visit(index into all or −1, whether inside, length of the step in cells)
  template <class Visit>
  void neighbours(int f, const Visit& visit) const {
    for (int b = 0; b < 27; ++b)
      if (b != kCentre) visit(beside[f][b], (all[f].inside >> b & 1) != 0, kNear.step[b]);
  }
};

// From the parts outward, everything that joins nothing.
void grow(Fills& fills) {
  Queue queue;
  const auto push = [&](int f) {
    if (!fills.all[f].in) push_once(queue, fills.all, f, fills.all[f].seam);
  };
  // What has nothing solid beside it waits until it has.
  for (int f = 0; f < int(fills.all.size()); ++f)
    if (fills.all[f].inside & kNear.ring6) push(f);
  while (!queue.empty()) {
    const int f = take(queue, fills.all);
    if (!addable(fills.all[f].inside)) continue;
    fills.set(f, true);
    fills.neighbours(f, [&](int g, bool, float) {
      if (g >= 0) push(g);
    });
  }
}

void measure_ways(Fills& fills) {
  Queue queue;
  const auto relax = [&](int f, float way) {
    if (way >= fills.all[f].way) return;
    fills.all[f].way = way;
    queue.push({way, f});
  };
  for (int f = 0; f < int(fills.all.size()); ++f)
    if (fills.all[f].in)
      fills.neighbours(f, [&](int, bool inside, float step) {
        if (!inside) relax(f, step);
      });
  while (!queue.empty()) {
    const auto [way, f] = queue.top();
    queue.pop();
    if (way > fills.all[f].way) continue;
    fills.neighbours(f, [&, from = way](int g, bool, float step) {
      if (g >= 0 && fills.all[g].in) relax(g, from + step);
    });
  }
}

// Opens again what the topology doesn't need, from outside in.
void thin(Fills& fills) {
  Queue queue;
  const auto push = [&](int f) {
    if (fills.all[f].in && !fills.all[f].keep) push_once(queue, fills.all, f, fills.all[f].way);
  };
  for (int f = 0; f < int(fills.all.size()); ++f) push(f);
  while (!queue.empty()) {
    const int f = take(queue, fills.all);
    const Around inside = fills.all[f].inside;
    if ((inside | Around(1) << kCentre) == kNear.all) continue;  // buried, for now
    if (!removable(inside, fills.bubble_of(f))) continue;
    fills.set(f, false);
    fills.let_air_in(f);
    fills.neighbours(f, [&](int g, bool, float) {
      if (g >= 0) push(g);
    });
  }
}

}  // namespace

void close_gaps(Body::Sampled& sampled, const Body& body, double reach,
                std::span<const JointSphere> spheres) {
  BlockGrid& grid = sampled.grid;
  Fills fills(sampled, reach);
  grow(fills);
  fills.open = open_samples(grid);
  measure_ways(fills);
  for (Fill& f : fills.all) {
    if (!f.in || f.way * grid.cell <= reach) continue;
    const Index3 s = grid.sample_of(f.index);
    const Vec3 p = grid.position(s.x(), s.y(), s.z());
    for (const JointSphere& sphere : spheres)
      f.keep |= (p - sphere.centre).squaredNorm() < sphere.radius * sphere.radius;
    f.keep = f.keep && !body.crowded(p, sampled.near[f.index / BlockGrid::kSize]);
  }
  thin(fills);
  sampled.close();
}

}  // namespace artisketch
