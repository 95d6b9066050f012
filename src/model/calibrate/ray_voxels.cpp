#include "model/calibrate/ray_voxels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "base/ensure.h"
#include "base/within.h"

namespace artisketch {
namespace {

using Place = std::array<int, 3>;  // of a voxel in its cube

Place place_of(int voxel, int side) {
  const int row = voxel / side;
  return {voxel - row * side, row % side, row / side};
}

}  // namespace

std::vector<int> voxels_along(const VoxelCube& cube, const Ray& ray, bool whole_line) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  double enter = whole_line ? -kFar : 0, leave = kFar;
  const double size = cube.cell * cube.side;
  for (int a = 0; a < 3; ++a) {
    const double o = ray.origin[a] - cube.origin[a], d = ray.direction[a];
    if (std::abs(d) < 1e-12) {
      if (o < 0 || o > size) return {};
      continue;
    }
    enter = std::max(enter, std::min(-o / d, (size - o) / d));
    leave = std::min(leave, std::max(-o / d, (size - o) / d));
  }
  if (enter >= leave) return {};
  const Vec3 start = (ray.at(enter) - cube.origin) / cube.cell;
  std::array<int, 3> at, step;
  std::array<double, 3> next, delta;  // depth (in cells) to the next face, and from face to face
  for (int a = 0; a < 3; ++a) {
    at[a] = int(within(start[a], 0, cube.side - 1));
    const double d = ray.direction[a];
    step[a] = d > 0 ? 1 : -1;
    delta[a] = std::abs(d) < 1e-12 ? kFar : 1 / std::abs(d);
    next[a] = std::abs(d) < 1e-12 ? kFar : (at[a] + (d > 0) - start[a]) / d;
  }
  std::vector<int> voxels;
  const double end = (leave - enter) / cube.cell;
  while (true) {
    voxels.push_back(at[0] + cube.side * (at[1] + cube.side * at[2]));
    const int a = int(std::min_element(next.begin(), next.end()) - next.begin());
    if (next[a] > end) break;
    at[a] += step[a];
    if (at[a] < 0 || at[a] >= cube.side) break;
    next[a] += delta[a];
  }
  return voxels;
}

// Some voxels of a cube in blocks of 4³, with how far from any of them each block is at least:
// where that is far, no search is needed. Made anew whenever poses change, so being made must be
// cheap: a k-d tree, as in the paper, took longer to build than all searches in it.
class HitVoxels::Blocks {
 public:
  Blocks(const std::vector<int>& voxels, int side);

  // No voxel's centre is nearer to another voxel's, in voxels, than this.
  double free_about(const Place& at) const { return least_[block(at)]; }

  struct Nearest {
    int voxel = -1;       // −1: none within the bound
    double distance = 0;  // in voxels; the bound where there's none
  };
  // line: the ray, whole numbers at the voxels' centres.
  Nearest nearest(const Place& at, const Ray& line, double bound) const;

 private:
  static constexpr int kBlock = 4;
  static constexpr int kFarthest = 4;  // blocks apart that are told from those still farther

  // Between the nearest voxels of blocks so far apart along an axis.
  static int gap(int blocks_apart) {
    return blocks_apart == 0 ? 0 : kBlock * (blocks_apart - 1) + 1;
  }
  int block(const Place& at) const {
    return at[0] / kBlock + blocks_ * (at[1] / kBlock + blocks_ * (at[2] / kBlock));
  }
  void sort_in(const std::vector<int>& voxels, int side);
  void spread_distances();
  std::uint64_t within_bits(int first, int last) const {
    first = std::max(first, 0), last = std::min(last, blocks_ - 1);
    if (first > last) return 0;
    return (~std::uint64_t(0) >> (63 - last)) & (~std::uint64_t(0) << first);
  }
  static int lowest_bit(std::uint64_t bits) { return __builtin_ctzll(bits); }
  void look_in(int block, const Place& at, const Ray& line, int& least, int& found) const;

  int blocks_ = 0;                     // along an edge
  std::vector<std::uint64_t> filled_;  // per row of blocks, those with voxels
  std::vector<int> begin_;             // per block, its first voxel; one more for the end
  std::vector<int> voxels_;            // by block
  std::vector<Place> places_;          // of the same
  std::vector<float> least_;           // per block
};

HitVoxels::Blocks::Blocks(const std::vector<int>& voxels, int side)
    : blocks_((side + kBlock - 1) / kBlock) {
  ensure(blocks_ <= 64, "a row of blocks is one word");
  sort_in(voxels, side);
  spread_distances();
}

void HitVoxels::Blocks::sort_in(const std::vector<int>& voxels, int side) {
  std::vector<Place> places(voxels.size());
  begin_.assign(std::size_t(blocks_) * blocks_ * blocks_ + 1, 0);
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    places[i] = place_of(voxels[i], side);
    ++begin_[block(places[i]) + 1];
  }
  filled_.assign(std::size_t(blocks_) * blocks_, 0);
  for (std::size_t b = 0; b + 1 < begin_.size(); ++b)
    if (begin_[b + 1] > 0) filled_[b / blocks_] |= std::uint64_t(1) << (b % blocks_);
  for (std::size_t b = 1; b < begin_.size(); ++b) begin_[b] += begin_[b - 1];
  std::vector<int> next(begin_.begin(), begin_.end() - 1);
  voxels_.resize(voxels.size());
  places_.resize(voxels.size());
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const int to = next[block(places[i])]++;
    voxels_[to] = voxels[i];
    places_[to] = places[i];
  }
}

// Of squares first, axis by axis.
void HitVoxels::Blocks::spread_distances() {
  const auto squared = [](int apart) { return float(gap(apart) * gap(apart)); };
  least_.assign(begin_.size() - 1, squared(kFarthest + 1));
  for (std::size_t b = 0; b < least_.size(); ++b)
    if (begin_[b] < begin_[b + 1]) least_[b] = 0;
  std::vector<float> before;
  for (int axis = 0, stride = 1; axis < 3; ++axis, stride *= blocks_) {
    before = least_;
    const std::size_t line = std::size_t(stride) * blocks_;
    for (int apart = 1; apart <= std::min(kFarthest, blocks_ - 1); ++apart) {
      const std::size_t shift = std::size_t(stride) * apart;
      for (std::size_t start = 0; start < least_.size(); start += line)
        for (std::size_t i = start; i + shift < start + line; ++i) {
          least_[i] = std::min(least_[i], before[i + shift] + squared(apart));
          least_[i + shift] = std::min(least_[i + shift], before[i] + squared(apart));
        }
    }
  }
  for (float& v : least_) v = std::sqrt(v);
}

void HitVoxels::Blocks::look_in(int block, const Place& at, const Ray& line, int& least,
                                int& found) const {
  const auto to_line = [&](int i) {
    const Vec3 d = Vec3(places_[i][0], places_[i][1], places_[i][2]) - line.origin;
    return d.cross(line.direction).squaredNorm();
  };
  for (int i = begin_[block]; i < begin_[block + 1]; ++i) {
    const int x = places_[i][0] - at[0], y = places_[i][1] - at[1], z = places_[i][2] - at[2];
    const int squared = x * x + y * y + z * z;
    if (squared < least || (squared == least && (found < 0 || to_line(i) < to_line(found))))
      least = squared, found = i;
  }
}

// In shells of blocks about the one that `at` lies in. Of voxels equally near, the one
// that the ray itself comes nearest to.
HitVoxels::Blocks::Nearest HitVoxels::Blocks::nearest(const Place& at, const Ray& line,
                                                      double bound) const {
  int least = int(std::ceil(bound * bound)), found = -1;  // squares of whole numbers are whole
  const int bx = at[0] / kBlock, by = at[1] / kBlock, bz = at[2] / kBlock;
  const auto squared_to = [](int at, int block) {
    const int d = std::max({0, kBlock * block - at, at - (kBlock * block + kBlock - 1)});
    return d * d;
  };
  for (int r = 0; r < blocks_ && gap(r) * gap(r) <= least; ++r) {
    const std::uint64_t middle = within_bits(bx - r, bx + r);
    const std::uint64_t ends = middle & ~within_bits(bx - r + 1, bx + r - 1);
    for (int z = std::max(bz - r, 0); z <= std::min(bz + r, blocks_ - 1); ++z)
      for (int y = std::max(by - r, 0); y <= std::min(by + r, blocks_ - 1); ++y) {
        const bool whole = std::max(std::abs(z - bz), std::abs(y - by)) == r;
        std::uint64_t filled = filled_[y + blocks_ * z] & (whole ? middle : ends);
        if (!filled) continue;
        const int off_row = squared_to(at[1], y) + squared_to(at[2], z);
        for (; filled; filled &= filled - 1) {
          const int x = lowest_bit(filled);
          if (off_row + squared_to(at[0], x) <= least)
            look_in(x + blocks_ * (y + blocks_ * z), at, line, least, found);
        }
      }
  }
  if (found < 0) return {-1, bound};
  return {voxels_[found], std::sqrt(double(least))};
}

HitCount::HitCount(const VoxelCube& cube)
    : hits_(std::size_t(cube.side) * cube.side * cube.side, 0) {}

void HitCount::add(const VoxelRays& frame) {
  ++frames_;
  std::vector<char> counted(hits_.size(), 0);
  for (const std::vector<int>& ray : frame)
    for (const int voxel : ray)
      if (!counted[voxel] && hits_[voxel] < 255) counted[voxel] = 1, ++hits_[voxel];
}

HitVoxels::HitVoxels(const VoxelCube& cube, const VoxelRays& frame, const HitCount& all)
    : cube_(cube), all_(all), own_(std::size_t(cube.side) * cube.side * cube.side, 0) {
  std::vector<std::vector<int>> voxels(std::min(all.frames(), 255));
  for (const std::vector<int>& ray : frame)
    for (const int voxel : ray) {
      if (own_[voxel]) continue;
      own_[voxel] = 1;
      for (int h = 0; h < all.of(voxel); ++h) voxels[h].push_back(voxel);
    }
  for (std::vector<int>& list : voxels)
    if (!list.empty()) at_least_.push_back(std::make_unique<Blocks>(list, cube.side));
}

HitVoxels::~HitVoxels() = default;
HitVoxels::HitVoxels(HitVoxels&&) noexcept = default;

HitVoxels::Pair HitVoxels::best_pair(const std::vector<int>& ray, const Ray& through, double lambda,
                                     double reach) const {
  // Voxels beyond the bound that a search still tells how far off they are, so that as many along
  // the ray needn't be searched for. More makes each search dearer than what it saves.
  constexpr double kLookAhead = 2;
  Pair best;
  best.cost = std::numeric_limits<double>::infinity();
  const auto offer = [&](int on_ray, int hit, double distance) {
    const double cost = distance + lambda * (all_.frames() - all_.of(hit));
    if (cost < best.cost) best = {on_ray, hit, distance, cost};
  };
  std::vector<double> free;  // per voxel of the ray
  const Ray line{(through.origin - cube_.origin) / cube_.cell - Vec3::Constant(0.5),
                 through.direction};
  // Voxels that the ray shares with the frame come first: they cost no search, and bound it.
  for (const int voxel : ray)
    if (own_[voxel]) offer(voxel, voxel, 0);
  for (int h = int(at_least_.size()); h-- > 0;) {
    const double unseen = lambda * (all_.frames() - (h + 1));
    const Blocks& blocks = *at_least_[h];
    free.clear();
    for (const int voxel : ray) free.push_back(blocks.free_about(place_of(voxel, cube_.side)));
    // What is found where the ray seems nearest bounds all else. It isn't taken at once: of pairs
    // equally good, the first along the ray is.
    double within = reach / cube_.cell;
    const auto bound = [&] { return std::min(within, (best.cost - unseen) / cube_.cell); };
    if (!ray.empty()) {
      const std::size_t i = std::size_t(std::min_element(free.begin(), free.end()) - free.begin());
      constexpr double kJustBeyond = 1e-9;
      if (free[i] < bound())
        within =
            std::min(within, blocks.nearest(place_of(ray[i], cube_.side), line, bound()).distance +
                                 kJustBeyond);
    }
    for (std::size_t i = 0; i < ray.size() && bound() > 1e-9;) {
      double least = free[i];  // the next ones are no nearer than this, less a step of one each
      if (least < bound()) {
        const Blocks::Nearest nearest =
            blocks.nearest(place_of(ray[i], cube_.side), line, bound() + kLookAhead);
        least = nearest.distance;
        if (nearest.voxel >= 0 && least < bound()) offer(ray[i], nearest.voxel, least * cube_.cell);
      }
      i += std::size_t(std::max(1, int(std::ceil(least - std::max(bound(), 0.0)))));
    }
  }
  if (best.on_ray < 0) best.cost = best.distance = reach;
  return best;
}

}  // namespace artisketch
