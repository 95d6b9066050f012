// A large lattice of samples of which only some blocks are stored.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/types.h"

namespace artisketch {

// Sample (i, j, k) stands at origin + cell · (i, j, k). Blocks of 8³ samples are stored where
// something is; every other sample reads `kOutside`.
struct BlockGrid {
  static constexpr int kSide = 8;
  static constexpr int kSize = kSide * kSide * kSide;
  static constexpr float kOutside = 1e30f;

  Vec3 origin = Vec3::Zero();
  double cell = 1;                 // units
  Index3 blocks = Index3::Zero();  // along x, y, z
  std::vector<int> slot;           // per block: its place in `at` and `values`, −1: not stored
  std::vector<Index3> at;          // per stored block: its block coordinates
  std::vector<float> values;       // kSize per stored block, x fastest

  BlockGrid() = default;
  BlockGrid(const Vec3& origin, double cell, const Index3& blocks)
      : origin(origin), cell(cell), blocks(blocks), slot(std::size_t(blocks.prod()), -1) {}

  int block_index(int x, int y, int z) const { return x + blocks.x() * (y + blocks.y() * z); }
  bool has_block(int x, int y, int z) const {
    return x >= 0 && y >= 0 && z >= 0 && x < blocks.x() && y < blocks.y() && z < blocks.z();
  }
  Vec3 position(int i, int j, int k) const { return origin + cell * Vec3(i, j, k); }
  Index3 first_sample(int stored) const { return kSide * at[stored]; }
  static int within(int i, int j, int k) { return (i & 7) + kSide * ((j & 7) + kSide * (k & 7)); }

  // Index of a sample in `values`; −1 where it isn't stored.
  std::ptrdiff_t find(int i, int j, int k) const {
    if (!has_block(i >> 3, j >> 3, k >> 3)) return -1;
    const int s = slot[block_index(i >> 3, j >> 3, k >> 3)];
    return s < 0 ? -1 : std::ptrdiff_t(s) * kSize + within(i, j, k);
  }
  float value(int i, int j, int k) const {
    const std::ptrdiff_t at_value = find(i, j, k);
    return at_value < 0 ? kOutside : values[at_value];
  }
  bool inside(int i, int j, int k) const { return value(i, j, k) < 0; }
  // The lattice coordinates of an index into `values`.
  Index3 sample_of(std::ptrdiff_t index) const {
    const int in_block = int(index % kSize);
    return first_sample(int(index / kSize)) +
           Index3(in_block & 7, (in_block >> 3) & 7, in_block >> 6);
  }
  // Whether each of the 9³ samples from a stored block's first one on is inside (its cells'
  // corners), x fastest. Returns how many are.
  static constexpr int kWindow = kSide + 1;
  using Window = std::array<std::uint8_t, kWindow * kWindow * kWindow>;
  int inside_window(int stored, Window& window) const {
    int count = 0;
    const Index3& b = at[stored];
    for (int z = 0; z < 2; ++z)
      for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 2; ++x) {
          const int s = !(x | y | z) ? stored
                        : has_block(b.x() + x, b.y() + y, b.z() + z)
                            ? slot[block_index(b.x() + x, b.y() + y, b.z() + z)]
                            : -1;
          const float* v = s < 0 ? nullptr : &values[std::size_t(s) * kSize];
          for (int k = 0; k < (z ? 1 : kSide); ++k)
            for (int j = 0; j < (y ? 1 : kSide); ++j)
              for (int i = 0; i < (x ? 1 : kSide); ++i) {
                const bool in = v && v[i + kSide * (j + kSide * k)] < 0;
                count += in;
                window[i + kSide * x + kWindow * (j + kSide * y + kWindow * (k + kSide * z))] = in;
              }
        }
    return count;
  }
  // Of a window: the mask of the cell whose lowest corner is sample (i, j, k) of the block. Bit
  // x + 2 y + 4 z is set where that corner is inside.
  static unsigned corners(const Window& w, int i, int j, int k) {
    constexpr int n = kWindow;
    const std::uint8_t* v = &w[i + n * (j + n * k)];
    return v[0] | v[1] << 1 | v[n] << 2 | v[n + 1] << 3 | v[n * n] << 4 | v[n * n + 1] << 5 |
           v[n * n + n] << 6 | v[n * n + n + 1] << 7;
  }
  // Stores every block marked in `wanted` (one flag per block), filled with kOutside.
  void store(const std::vector<char>& wanted) {
    at.clear();
    for (int z = 0; z < blocks.z(); ++z)
      for (int y = 0; y < blocks.y(); ++y)
        for (int x = 0; x < blocks.x(); ++x) {
          const int b = block_index(x, y, z);
          slot[b] = wanted[b] ? int(at.size()) : -1;
          if (wanted[b]) at.emplace_back(x, y, z);
        }
    values.assign(at.size() * kSize, kOutside);
  }
  // Stores blocks of kOutside beside each inside sample that stands on the border of what is
  // stored, and makes the lattice larger where there is no room for them: every cell that has a
  // corner inside then has all its corners stored. What was stored keeps its place in `at` and
  // `values`. Returns how many blocks were added.
  int close();
  bool is_closed() const;  // close() would add nothing
};

}  // namespace artisketch
