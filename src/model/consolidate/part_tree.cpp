#include "model/consolidate/part_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/block_grid.h"

namespace artisketch {
namespace {

// The diameter of the largest ball inside. A part's distances end some cells from its surface: from
// there on by chamfer steps (Borgefors 1986) over every fourth sample.
double width_of(const Grid3<float>& g, float least) {
  constexpr int kStride = 4;
  // One more all round, which is outside.
  const Index3 size = (g.size.array() + (kStride - 1)) / kStride + 2;
  const std::ptrdiff_t sy = size.x(), sz = sy * size.y();
  std::vector<float> depth(std::size_t(sz) * size.z(), 0.0f);
  for (int k = 0; k < size.z() - 2; ++k)
    for (int j = 0; j < size.y() - 2; ++j)
      for (int i = 0; i < size.x() - 2; ++i) {
        const float d = -g(kStride * i, kStride * j, kStride * k);
        depth[i + 1 + sy * (j + 1) + sz * (k + 1)] = d < -0.99f * least ? d : BlockGrid::kOutside;
      }
  std::array<std::ptrdiff_t, 13> to;  // the neighbours that come earlier
  std::array<float, 13> way;
  for (int n = 0; n < 13; ++n) {
    const Index3 step(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
    to[n] = step.x() + sy * step.y() + sz * step.z();
    way[n] = float(kStride * g.cell * step.cast<double>().norm());
  }
  float deepest = -least;
  const std::ptrdiff_t first = 1 + sy + sz, last = std::ptrdiff_t(depth.size()) - 1 - first;
  for (std::ptrdiff_t at = first; at <= last; ++at)
    for (int n = 0; n < 13 && depth[at] > 0; ++n)
      depth[at] = std::min(depth[at], depth[at + to[n]] + way[n]);
  for (std::ptrdiff_t at = last; at >= first; --at) {
    for (int n = 0; n < 13 && depth[at] > 0; ++n)
      depth[at] = std::min(depth[at], depth[at - to[n]] + way[n]);
    deepest = std::max(deepest, depth[at]);
  }
  return 2 * double(deepest);
}

// What one pass over a part's samples tells.
void measure(const Grid3<float>& g, PartTree::Node& node, Vec3& centroid) {
  float least = 0;
  std::size_t deepest = 0, inside = 0, crossings = 0;
  const std::ptrdiff_t stride_y = g.stride_y(), stride_z = g.stride_z();
  Vec3 sum = Vec3::Zero();
  std::size_t at = 0;
  for (int k = 0; k < g.size.z(); ++k)
    for (int j = 0; j < g.size.y(); ++j) {
      const float* row = &g.values[at];
      int in_row = 0, sum_x = 0;
      float least_in_row = 0;
      for (int i = 0; i < g.size.x(); ++i) {
        const bool in = row[i] < 0;
        in_row += in;
        sum_x += in ? i : 0;
        least_in_row = std::min(least_in_row, row[i]);
      }
      if (least_in_row < least) {
        least = least_in_row;
        deepest = at + std::size_t(std::find(row, row + g.size.x(), least) - row);
      }
      for (int i = 1; i < g.size.x(); ++i) crossings += (row[i] < 0) != (row[i - 1] < 0);
      for (int i = 0; i < g.size.x() && j > 0; ++i)
        crossings += (row[i] < 0) != (row[i - stride_y] < 0);
      for (int i = 0; i < g.size.x() && k > 0; ++i)
        crossings += (row[i] < 0) != (row[i - stride_z] < 0);
      inside += in_row;
      sum += Vec3(sum_x, double(in_row) * j, double(in_row) * k);
      at += g.size.x();
    }
  node.solid = inside > 0;
  if (!node.solid) return;
  const auto x = deepest % g.size.x(), yz = deepest / g.size.x();
  node.deepest = g.position(int(x), int(yz % g.size.y()), int(yz / g.size.y()));
  node.thickness = -2 * double(least);
  node.width = width_of(g, least);
  // The lines along the axes cross a surface |nx| + |ny| + |nz| times per cell²: 1.5 on average.
  node.area = double(crossings) * g.cell * g.cell / 1.5;
  centroid = g.origin + g.cell * (sum / double(inside));
}

// A part without a bone lies from its joint through its centroid to its far end, less what its
// thickness rounds off.
Segment axis_of_leaf(const PartTree::Node& node, const Grid3<float>& g, const Vec3& centroid) {
  const Vec3 along = centroid - node.joint;
  const double length = along.norm();
  if (length < node.thickness / 4) return {node.joint, node.joint};
  const Vec3 direction = along / length;
  Vec3 end = centroid;
  for (double reach = length; g.box().contains(node.joint + reach * direction); reach += g.cell) {
    const Vec3 p = node.joint + reach * direction;
    if (sample(g, p) < -node.thickness / 4) end = p;
  }
  return {node.joint, end};
}

}  // namespace

PartTree part_tree(const Document& document, std::span<const PartSurface> parts) {
  const Skeleton& skeleton = document.skeleton;
  const std::vector<Vec3> rest = rest_positions(skeleton);
  const std::vector<Bone> all_bones = bones(skeleton);
  const int n = int(parts.size());
  PartTree tree;
  tree.nodes.resize(n);
  std::vector<int> part_of(skeleton.size(), -1);  // joint → part
  for (int i = 0; i < n; ++i) {
    PartTree::Node& node = tree.nodes[i];
    node.joint = rest[parts[i].joint];
    const Grid3<float>& g = parts[i].distance;
    if (g.empty() || g.size.minCoeff() < 2) continue;
    Vec3 centroid;
    measure(g, node, centroid);
    if (!node.solid) continue;
    part_of[parts[i].joint] = i;
    for (const Bone& bone : all_bones)
      if (bone.joint == parts[i].joint) node.axes.push_back({bone.a, bone.b});
    if (node.axes.empty()) node.axes.push_back(axis_of_leaf(node, g, centroid));
  }
  // The nearest part at or above each joint; joints without contours that lie together under no
  // part are one hub, named by −1.
  std::vector<int> above(skeleton.size(), -1);
  int first_at_hub = -1;
  for (int j = 0; j < skeleton.size(); ++j) {
    const int parent = skeleton.joints[j].parent;
    const int over = parent < 0 ? -1 : above[parent];
    above[j] = part_of[j] >= 0 ? part_of[j] : over;
    if (part_of[j] < 0) continue;
    if (over < 0 && first_at_hub < 0)
      first_at_hub = part_of[j];
    else
      tree.nodes[part_of[j]].parent = over >= 0 ? over : first_at_hub;
  }
  tree.adjacent_pairs.assign(n * n, 0);
  tree.steps.assign(n * n, -1);
  for (int i = 0; i < n; ++i)
    if (const int p = tree.nodes[i].parent; p >= 0)
      tree.adjacent_pairs[i * n + p] = tree.adjacent_pairs[p * n + i] = 1;
  // Ways through the tree: from each part the way up, then down.
  const auto line_up = [&](int i) {
    std::vector<int> line{i};
    while (tree.nodes[line.back()].parent >= 0) line.push_back(tree.nodes[line.back()].parent);
    return line;
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      if (i == j || !tree.nodes[i].solid || !tree.nodes[j].solid) continue;
      const std::vector<int> up = line_up(j);
      const auto found = std::find(up.begin(), up.end(), i);
      tree.steps[i * n + j] = found == up.end() ? tree.nodes[i].parent : *(found - 1);
    }
  return tree;
}

}  // namespace artisketch
