#include "model/part_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/block_grid.h"

namespace artisketch {
namespace {

// The diameter of the largest ball inside. A part's distances end some cells from its surface: from
// there on by chamfer steps (Borgefors 1986) over every third sample.
double width_of(const Grid3<float>& g, float least) {
  constexpr int kStride = 3;
  const Index3 size = (g.size.array() + (kStride - 1)) / kStride;
  const std::ptrdiff_t sy = size.x(), sz = sy * size.y();
  std::vector<float> depth(std::size_t(sz) * size.z());
  std::size_t at = 0;
  for (int k = 0; k < size.z(); ++k)
    for (int j = 0; j < size.y(); ++j)
      for (int i = 0; i < size.x(); ++i, ++at) {
        const float d = -g(kStride * i, kStride * j, kStride * k);
        depth[at] = d < -0.99f * least ? std::max(d, 0.0f) : BlockGrid::kOutside;
      }
  struct Step {
    int x, y, z;
    std::ptrdiff_t to;
    float way;
  };
  std::vector<Step> steps;  // to the 13 neighbours that come earlier
  for (int z = -1; z <= 0; ++z)
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x)
        if (const std::ptrdiff_t to = x + sy * y + sz * z; z < 0 || y < 0 || (y == 0 && x < 0))
          steps.push_back({x, y, z, to, float(kStride * g.cell * Vec3(x, y, z).norm())});
  float deepest = -least;
  for (const int way : {1, -1})
    for (int k = 0; k < size.z(); ++k)
      for (int j = 0; j < size.y(); ++j)
        for (int i = 0; i < size.x(); ++i) {
          const Index3 p = way > 0 ? Index3(i, j, k) : Index3(size - Index3(i + 1, j + 1, k + 1));
          float& here = depth[p.x() + sy * p.y() + sz * p.z()];
          if (here == 0) continue;
          for (const Step& step : steps) {
            const Index3 q = p + way * Index3(step.x, step.y, step.z);
            // Beyond the grid is outside.
            const bool in = (q.array() >= 0).all() && (q.array() < size.array()).all();
            here = std::min(here, (in ? (&here)[way * step.to] : 0) + step.way);
          }
          if (way < 0) deepest = std::max(deepest, here);
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
      int in_row = 0;
      double sum_x = 0;
      for (int i = 0; i < g.size.x(); ++i) {
        const bool in = row[i] < 0;
        in_row += in;
        sum_x += in ? i : 0;
        if (row[i] < least) least = row[i], deepest = at + i;
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
  tree.meets.assign(n * n, 0);
  tree.steps.assign(n * n, -1);
  for (int i = 0; i < n; ++i)
    if (const int p = tree.nodes[i].parent; p >= 0)
      tree.meets[i * n + p] = tree.meets[p * n + i] = 1;
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
