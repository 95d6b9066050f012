#include "base/block_grid.h"

namespace artisketch {
namespace {

constexpr int n = BlockGrid::kSide;

// Whether a block has an inside sample on the face, the edge or the corner towards a neighbour.
bool inside_towards(const float* block, const Index3& way) {
  Index3 from, to;
  for (int a = 0; a < 3; ++a) {
    from[a] = way[a] > 0 ? n - 1 : 0;
    to[a] = way[a] < 0 ? 1 : n;
  }
  for (int k = from.z(); k < to.z(); ++k)
    for (int j = from.y(); j < to.y(); ++j)
      for (int i = from.x(); i < to.x(); ++i)
        if (block[BlockGrid::within(i, j, k)] < 0) return true;
  return false;
}

// The blocks that are missing beside inside samples.
std::vector<Index3> missing_blocks(const BlockGrid& grid) {
  std::vector<Index3> missing;
  for (std::size_t b = 0; b < grid.at.size(); ++b)
    for (int w = 0; w < 27; ++w) {
      const Index3 way(w % 3 - 1, w / 3 % 3 - 1, w / 9 - 1), beside = grid.at[b] + way;
      const bool stored = grid.has_block(beside.x(), beside.y(), beside.z()) &&
                          grid.slot[grid.block_index(beside.x(), beside.y(), beside.z())] >= 0;
      if (!stored && inside_towards(&grid.values[b * BlockGrid::kSize], way))
        missing.push_back(beside);
    }
  return missing;
}

// One more block at every side of the lattice.
void add_margin(BlockGrid& grid) {
  grid.origin -= Vec3::Constant(n * grid.cell);
  grid.blocks += Index3::Constant(2);
  grid.slot.assign(std::size_t(grid.blocks.cast<std::ptrdiff_t>().prod()), -1);
  for (std::size_t b = 0; b < grid.at.size(); ++b) {
    Index3& at = grid.at[b];
    at += Index3::Ones();
    grid.slot[grid.block_index(at.x(), at.y(), at.z())] = int(b);
  }
}

}  // namespace

bool BlockGrid::is_closed() const {
  return missing_blocks(*this).empty();
}

int BlockGrid::close() {
  std::vector<Index3> missing = missing_blocks(*this);
  bool room = true;
  for (const Index3& b : missing) room = room && has_block(b.x(), b.y(), b.z());
  if (!room) {
    add_margin(*this);
    for (Index3& b : missing) b += Index3::Ones();
  }
  int added = 0;
  for (const Index3& b : missing) {
    int& place = slot[block_index(b.x(), b.y(), b.z())];
    if (place >= 0) continue;  // missed by several
    place = int(at.size());
    at.push_back(b);
    ++added;
  }
  values.resize(at.size() * kSize, kOutside);
  return added;
}

}  // namespace artisketch
