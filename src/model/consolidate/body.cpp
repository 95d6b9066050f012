#include "model/consolidate/body.h"

#include <algorithm>
#include <cmath>

#include "base/within.h"

namespace artisketch {
namespace {

double smoothstep(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

bool inside_on_border(const Grid3<float>& g) {
  for (int k = 0; k < g.size.z(); ++k)
    for (int j = 0; j < g.size.y(); ++j) {
      const bool face = k == 0 || j == 0 || k == g.size.z() - 1 || j == g.size.y() - 1;
      const int step = face ? 1 : std::max(g.size.x() - 1, 1);
      for (int i = 0; i < g.size.x(); i += step)
        if (g(i, j, k) < 0) return true;
    }
  return false;
}

// The samples with a wall half a cell within the grid's border.
Grid3<float> cut_at_border(Grid3<float> g) {
  for (int k = 0; k < g.size.z(); ++k)
    for (int j = 0; j < g.size.y(); ++j)
      for (int i = 0; i < g.size.x(); ++i) {
        const Index3 at(i, j, k);
        const int deep = std::min(at.minCoeff(), (g.size - Index3::Ones() - at).minCoeff());
        g(i, j, k) = std::max(g(i, j, k), float((0.5 - deep) * g.cell));
      }
  return g;
}

}  // namespace

Body::Body(std::span<const PartSurface> parts, const PartTree& tree,
           std::span<const JointSphere> spheres, double gap)
    : tree_(tree),
      gap_(gap),
      sphere_of_(parts.size(), -1),
      spheres_(spheres.begin(), spheres.end()) {
  for (int i = 0; i < int(parts.size()); ++i) {
    // Views from nearly one side leave a part's depth open, and its grid cuts it off. Beyond the
    // grid nothing may be inside: nobody would look for it there.
    const bool cut = tree.nodes[i].solid && inside_on_border(parts[i].distance);
    if (cut) cut_.push_back(std::make_unique<Grid3<float>>(cut_at_border(parts[i].distance)));
    const Grid3<float>& g = cut ? *cut_.back() : parts[i].distance;
    fields_.push_back(
        {g.values.data(), g.origin, g.cell, g.size, g.stride_y(), g.stride_z(), Box3()});
    if (tree.nodes[i].solid) fields_.back().box = g.box();
    for (int s = 0; s < int(spheres_.size()); ++s)
      if (spheres_[s].joint == parts[i].joint) sphere_of_[i] = s;
  }
}

// The cell of a part's samples that holds a point, or the nearest one: its values, interpolated
// along x at its edges, then along y at its sides.
struct Body::Cell {
  const float* v;
  double w[3];
  Vec3 beyond = Vec3::Zero();  // from the samples to the point
  double x00, x10, x01, x11, y0, y1;

  Cell(const Field& f, const Vec3& p) {
    int at[3];
    for (int a = 0; a < 3; ++a) {
      const double x = (p[a] - f.origin[a]) / f.cell;
      const double c = within(x, 0, f.size[a] - 1);
      beyond[a] = (x - c) * f.cell;
      at[a] = std::min(int(c), f.size[a] - 2);
      w[a] = c - at[a];
    }
    v = f.values + at[0] + f.sy * at[1] + f.sz * at[2];
    x00 = v[0] + w[0] * (v[1] - v[0]);
    x10 = v[f.sy] + w[0] * (v[f.sy + 1] - v[f.sy]);
    x01 = v[f.sz] + w[0] * (v[f.sz + 1] - v[f.sz]);
    x11 = v[f.sz + f.sy] + w[0] * (v[f.sz + f.sy + 1] - v[f.sz + f.sy]);
    y0 = x00 + w[1] * (x10 - x00), y1 = x01 + w[1] * (x11 - x01);
  }
  double value() const { return y0 + w[2] * (y1 - y0); }
};

double Body::part_distance(int part, const Vec3& p) const {
  const Cell c(fields_[part], p);
  return c.value() + c.beyond.norm();
}

double Body::part_distance(int part, const Vec3& p, Vec3& gradient) const {
  const Field& f = fields_[part];
  const Cell c(f, p);
  if (const double away = c.beyond.norm(); away > 0) {
    gradient = c.beyond / away;
    return c.value() + away;
  }
  const auto dx = [&](std::ptrdiff_t s) { return c.v[s + 1] - c.v[s]; };
  const double dx0 = dx(0) + c.w[1] * (dx(f.sy) - dx(0));
  const double dx1 = dx(f.sz) + c.w[1] * (dx(f.sz + f.sy) - dx(f.sz));
  gradient.x() = (dx0 + c.w[2] * (dx1 - dx0)) / f.cell;
  gradient.y() = ((c.x10 - c.x00) + c.w[2] * ((c.x11 - c.x01) - (c.x10 - c.x00))) / f.cell;
  gradient.z() = (c.y1 - c.y0) / f.cell;
  return c.value();
}

// Non-adjacent parts that come close share the space between them: each keeps its side of the
// surface where both are equally deep, less half the gap. Not where the surfaces run side by side:
// neither could yield without a dent. And a part and its parent's parent (a thigh and the chest)
// not within the spheres of both joints, where all three belong together.
double Body::apart(int i, int j, double di, double dj, const Vec3& p) const {
  const auto outside_sphere = [&](int part) {
    const int s = sphere_of_[part];
    return s < 0 ? gap_ : (p - spheres_[s].centre).norm() - spheres_[s].radius;
  };
  double in_spheres = gap_;
  for (const auto& [low, high] : {std::pair(i, j), std::pair(j, i)})
    if (const int between = tree_.nodes[low].parent;
        between >= 0 && tree_.nodes[between].parent == high)
      in_spheres = std::max(outside_sphere(low), outside_sphere(between));
  const double active = smoothstep(1 + in_spheres / gap_);
  if (active == 0) return -BlockGrid::kOutside;
  // The surface of equal depth halves the angle between the two; across it the difference of the
  // depths grows by twice the sine of that.
  Vec3 ni, nj;
  part_distance(i, p, ni);
  part_distance(j, p, nj);
  const double slope = (ni.normalized() - nj.normalized()).norm();
  constexpr double kSideBySide = 0.5, kApart = 0.9;  // slopes
  const double yields = active * smoothstep((slope - kSideBySide) / (kApart - kSideBySide));
  if (yields == 0) return -BlockGrid::kOutside;
  const double across = (di - dj) / slope;
  return across + gap_ / 2 - (1 - yields) * (gap_ + std::abs(across));
}

Body::Reading Body::read(const Vec3& p, std::span<const int> near) const {
  Reading best;
  struct Close {
    int part;
    double distance;
    Vec3 gradient;
  };
  thread_local std::vector<Close> close;
  close.clear();
  for (const int i : near) {
    Vec3 gradient;
    const double d = part_distance(i, p, gradient);
    close.push_back({i, d, gradient});
  }
  for (const Close& c : close) {
    if (c.distance >= best.distance) continue;
    Reading own{c.distance, c.gradient, c.part};
    for (const Close& other : close) {
      if (c.distance > gap_ || other.distance > gap_ || other.part == c.part ||
          tree_.adjacent(c.part, other.part))
        continue;
      const double pushed = apart(c.part, other.part, c.distance, other.distance, p);
      if (pushed > own.distance) {
        own.distance = pushed;
        own.gradient = (c.gradient - other.gradient).normalized();
      }
    }
    if (own.distance < best.distance) best = own;
  }
  for (const Capsule& capsule : capsules) {
    const double d = capsule.distance(p);
    if (d < best.distance)
      best = {d, (p - capsule.axis.at(capsule.axis.nearest(p))).normalized(), -1};
  }
  return best;
}

bool Body::crowded(const Vec3& p, std::span<const int> near) const {
  int first = -1, second = -1;
  for (const int i : near)
    if (first < 0 || part_distance(i, p) < part_distance(first, p)) first = i;
  for (const int i : near)
    if (i != first && tree_.adjacent(i, first) &&
        (second < 0 || part_distance(i, p) < part_distance(second, p)))
      second = i;
  if (second < 0) return false;
  const double reach = part_distance(second, p) + gap_;
  return std::any_of(near.begin(), near.end(), [&](int i) {
    return i != first && i != second && !(tree_.adjacent(i, first) && tree_.adjacent(i, second)) &&
           part_distance(i, p) < reach;
  });
}

// The 8³ samples from `first` on.
void Body::fill_block(const Vec3& first, double cell, std::span<const int> near, float* values,
                      float* seam) const {
  constexpr int n = BlockGrid::kSide;
  thread_local std::vector<float> of_part;  // #near × 8³
  of_part.resize(near.size() * BlockGrid::kSize);
  for (std::size_t c = 0; c < near.size(); ++c) {
    const Field& f = fields_[near[c]];
    struct Axis {
      std::ptrdiff_t at[n];
      float w[n], beyond[n];
    } axes[3];
    const std::ptrdiff_t stride[3] = {1, f.sy, f.sz};
    for (int a = 0; a < 3; ++a)
      for (int s = 0; s < n; ++s) {
        const double x = (first[a] + cell * s - f.origin[a]) / f.cell;
        const double in = within(x, 0, f.size[a] - 1);
        const int at = std::min(int(in), f.size[a] - 2);
        axes[a].at[s] = at * stride[a];
        axes[a].w[s] = float(in - at);
        axes[a].beyond[s] = float((x - in) * f.cell);
      }
    float* out = &of_part[c * BlockGrid::kSize];
    const auto& [ax, ay, az] = axes;
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < n; ++j) {
        const float* row = f.values + ay.at[j] + az.at[k];
        const float wy = ay.w[j], wz = az.w[k];
        const float beyond_yz = ay.beyond[j] * ay.beyond[j] + az.beyond[k] * az.beyond[k];
        for (int i = 0; i < n; ++i, ++out) {
          const float* v = row + ax.at[i];
          const float wx = ax.w[i];
          const auto along_x = [&](std::ptrdiff_t s) { return v[s] + wx * (v[s + 1] - v[s]); };
          const float a = along_x(0), b = along_x(f.sy);
          const float c0 = along_x(f.sz), d = along_x(f.sz + f.sy);
          const float low = a + wy * (b - a), high = c0 + wy * (d - c0);
          const float beyond2 = beyond_yz + ax.beyond[i] * ax.beyond[i];
          *out = low + wz * (high - low) + (beyond2 > 0 ? std::sqrt(beyond2) : 0.0f);
        }
      }
  }
  std::fill(values, values + BlockGrid::kSize, BlockGrid::kOutside);
  std::fill(seam, seam + BlockGrid::kSize, BlockGrid::kOutside);
  for (std::size_t c = 0; c < near.size(); ++c)
    for (int s = 0; s < BlockGrid::kSize; ++s)
      values[s] = std::min(values[s], of_part[c * BlockGrid::kSize + s]);
  for (std::size_t c = 0; c < near.size(); ++c)
    for (std::size_t e = c + 1; e < near.size(); ++e) {
      const float* a = &of_part[c * BlockGrid::kSize];
      const float* b = &of_part[e * BlockGrid::kSize];
      if (tree_.adjacent(near[c], near[e])) {
        for (int s = 0; s < BlockGrid::kSize; ++s)
          seam[s] = std::min(seam[s], std::max(a[s], b[s]));
        continue;
      }
      for (int s = 0; s < BlockGrid::kSize; ++s) {
        if (a[s] > gap_ || b[s] > gap_) continue;
        // Non-adjacent parts come close here: read() keeps the gap between them.
        const Vec3 p = first + cell * Vec3(s & 7, (s >> 3) & 7, s >> 6);
        values[s] = float(read(p, near).distance);
      }
    }
  const Box3 block(first, first + Vec3::Constant(cell * n));
  for (const Capsule& capsule : capsules)
    for (int s = 0; s < BlockGrid::kSize && capsule.box().intersects(block); ++s) {
      const Vec3 p = first + cell * Vec3(s & 7, (s >> 3) & 7, s >> 6);
      values[s] = std::min(values[s], float(capsule.distance(p)));
    }
}

Body::Bounds Body::bounds_of(const Field& f) {
  constexpr int n = Bounds::kBounds;
  Bounds bounds;
  bounds.size = (f.size.array() - 1 + (n - 1)) / n;
  bounds.blocks.assign(std::size_t(bounds.size.prod()),
                       {BlockGrid::kOutside, -BlockGrid::kOutside});
  // A block's last samples are its neighbour's first.
  const auto first_block = [](int i) { return std::max(i - 1, 0) / n; };
  for (int k = 0; k < f.size.z(); ++k)
    for (int j = 0; j < f.size.y(); ++j)
      for (int x = 0; x < bounds.size.x(); ++x) {
        const float* v = f.values + f.sy * j + f.sz * k;
        const int end = std::min(n * (x + 1), f.size.x() - 1);
        float low = v[end], high = v[end];
        for (int i = n * x; i < end; ++i) {
          low = std::min(low, v[i]);
          high = std::max(high, v[i]);
        }
        for (int z = first_block(k); z <= std::min(k / n, bounds.size.z() - 1); ++z)
          for (int y = first_block(j); y <= std::min(j / n, bounds.size.y() - 1); ++y) {
            auto& block = bounds.blocks[x + bounds.size.x() * (y + bounds.size.y() * z)];
            block = {std::min(block[0], low), std::max(block[1], high)};
          }
      }
  return bounds;
}

std::array<float, 2> Body::range(const Field& f, const Bounds& bounds, const Box3& box) {
  const auto block_at = [&](const Vec3& p) {
    const Eigen::Array3d last = (f.size.array() - 1).cast<double>();
    const Index3 sample = ((p - f.origin).array() / f.cell).max(0.0).min(last).cast<int>();
    return Index3((sample.array() / Bounds::kBounds).min(bounds.size.array() - 1));
  };
  const Index3 from = block_at(box.min()), to = block_at(box.max());
  std::array<float, 2> found = {BlockGrid::kOutside, -BlockGrid::kOutside};
  for (int z = from.z(); z <= to.z(); ++z)
    for (int y = from.y(); y <= to.y(); ++y)
      for (int x = from.x(); x <= to.x(); ++x) {
        const auto& b = bounds.blocks[x + bounds.size.x() * (y + bounds.size.y() * z)];
        found = {std::min(found[0], b[0]), std::max(found[1], b[1])};
      }
  const double away = box.exteriorDistance(f.box);
  const double farthest =
      (f.box.min() - box.min()).cwiseMax(box.max() - f.box.max()).cwiseMax(0.0).norm();
  return {float(found[0] + away), float(found[1] + farthest)};
}

Result<Body::Sampled> Body::sample(double cell, double reach, Run& run) const {
  constexpr int n = BlockGrid::kSide;
  const double side = cell * n;
  std::vector<Box3> boxes;
  for (const Field& f : fields_)
    if (!f.box.isEmpty()) boxes.push_back(f.box);
  Box3 all;
  for (Box3& box : boxes) {
    box = Box3(box.min() - Vec3::Constant(reach), box.max() + Vec3::Constant(reach));
    all.extend(box);
  }
  for (const Capsule& capsule : capsules) {
    all.extend(capsule.box().min() - Vec3::Constant(reach));
    all.extend(capsule.box().max() + Vec3::Constant(reach));
  }
  Sampled sampled;
  BlockGrid& grid = sampled.grid;
  // One more cell all round: the border is outside.
  grid = BlockGrid(all.min() - Vec3::Constant(cell), cell,
                   ((all.sizes() / cell).array() + 3).ceil().cast<int>() / n + 1);
  std::vector<std::vector<int>> near_block(grid.slot.size());
  std::vector<char> wanted(grid.slot.size(), 0), full(grid.slot.size(), 0);
  for (int i = 0; i < size(); ++i) {
    const Field& f = fields_[i];
    if (f.box.isEmpty()) continue;
    const Bounds bounds = bounds_of(f);
    const Index3 from = ((f.box.min() - grid.origin).array() / side - reach / side).cast<int>();
    const Index3 to = ((f.box.max() - grid.origin).array() / side + reach / side).cast<int>();
    for (int z = from.z(); z <= to.z(); ++z)
      for (int y = from.y(); y <= to.y(); ++y)
        for (int x = from.x(); x <= to.x(); ++x) {
          const Vec3 first = grid.position(n * x, n * y, n * z);
          // A cell more all round: what borders on a block that isn't stored is outside.
          const Box3 box(first - Vec3::Constant(cell), first + Vec3::Constant(side));
          const auto [low, high] = range(f, bounds, box);
          if (low > reach) continue;
          const int b = grid.block_index(x, y, z);
          full[b] |= high < 0;
          wanted[b] |= low <= 0 || std::any_of(near_block[b].begin(), near_block[b].end(),
                                               [&](int j) { return tree_.adjacent(i, j); });
          near_block[b].push_back(i);
        }
  }
  // Along a capsule only what lies near its axis: its box may be large and empty.
  for (const Capsule& capsule : capsules) {
    const double around = capsule.radius + reach + side;
    const int steps = int((capsule.axis.b - capsule.axis.a).norm() / side) + 1;
    for (int step = 0; step <= steps; ++step) {
      const Vec3 p = capsule.axis.at(double(step) / steps) - grid.origin;
      const Index3 from = ((p.array() - around) / side).floor().cast<int>().max(0);
      const Index3 to =
          ((p.array() + around) / side).floor().cast<int>().min(grid.blocks.array() - 1);
      for (int z = from.z(); z <= to.z(); ++z)
        for (int y = from.y(); y <= to.y(); ++y)
          for (int x = from.x(); x <= to.x(); ++x) wanted[grid.block_index(x, y, z)] = 1;
    }
  }
  grid.store(wanted);
  sampled.seam.resize(grid.values.size());
  sampled.near.resize(grid.at.size());
  for (std::size_t b = 0; b < grid.at.size(); ++b) {
    if (b % 64 == 0 && run.cancelled()) return cancelled();
    const Index3 s = grid.first_sample(int(b));
    const Vec3 first = grid.position(s.x(), s.y(), s.z());
    const int block = grid.block_index(grid.at[b].x(), grid.at[b].y(), grid.at[b].z());
    sampled.near[b] = std::move(near_block[block]);
    const std::vector<int>& near = sampled.near[b];
    float *values = &grid.values[b * BlockGrid::kSize], *seam = &sampled.seam[b * BlockGrid::kSize];
    const bool any_apart = std::any_of(near.begin(), near.end(), [&](int i) {
      return std::any_of(near.begin(), near.end(),
                         [&](int j) { return i != j && !tree_.adjacent(i, j); });
    });
    if (full[block] && !any_apart) {
      std::fill(values, values + BlockGrid::kSize, -BlockGrid::kOutside);
      std::fill(seam, seam + BlockGrid::kSize, BlockGrid::kOutside);
    } else {
      fill_block(first, cell, near, values, seam);
    }
  }
  sampled.close();
  return sampled;
}

void Body::Sampled::close() {
  const int before = int(grid.at.size());
  grid.close();
  seam.resize(grid.values.size(), BlockGrid::kOutside);
  near.resize(grid.at.size());
  // Of a new block nothing is known but what its neighbours know.
  for (int b = before; b < int(near.size()); ++b) {
    for (int w = 0; w < 27; ++w) {
      const Index3 beside = grid.at[b] + Index3(w % 3 - 1, w / 3 % 3 - 1, w / 9 - 1);
      if (!grid.has_block(beside.x(), beside.y(), beside.z())) continue;
      const int stored = grid.slot[grid.block_index(beside.x(), beside.y(), beside.z())];
      if (stored >= 0 && stored < before)
        near[b].insert(near[b].end(), near[stored].begin(), near[stored].end());
    }
    std::sort(near[b].begin(), near[b].end());
    near[b].erase(std::unique(near[b].begin(), near[b].end()), near[b].end());
  }
}

std::span<const int> Body::Sampled::near_at(const Vec3& p) const {
  const Index3 b = ((p - grid.origin) / (grid.cell * BlockGrid::kSide)).array().floor().cast<int>();
  const int stored =
      grid.has_block(b.x(), b.y(), b.z()) ? grid.slot[grid.block_index(b.x(), b.y(), b.z())] : -1;
  return stored < 0 ? std::span<const int>() : std::span<const int>(near[stored]);
}

}  // namespace artisketch
