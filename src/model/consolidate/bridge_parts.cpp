#include "model/consolidate/bridge_parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace artisketch {
namespace {

// The point of the part nearest to `p` that lies at least `depth` inside.
Vec3 anchor(const Grid3<float>& g, double depth, const Vec3& p) {
  Vec3 best = p;
  double least = BlockGrid::kOutside;
  for (int k = 0; k < g.size.z(); ++k)
    for (int j = 0; j < g.size.y(); ++j)
      for (int i = 0; i < g.size.x(); ++i) {
        if (g(i, j, k) > -depth) continue;
        const double d = (g.position(i, j, k) - p).squaredNorm();
        if (d < least) least = d, best = g.position(i, j, k);
      }
  return best;
}

Capsule bridge_between(const PartSurface& part, const PartSurface& other,
                       const PartTree::Node& node, const PartTree::Node& other_node, double limb,
                       double cell) {
  const double depth = 0.7 * std::min({limb, node.thickness / 2, other_node.thickness / 2});
  Capsule capsule;
  capsule.axis = {anchor(part.distance, depth, node.joint),
                  anchor(other.distance, depth, node.joint)};
  const double gap = std::max((capsule.axis.b - capsule.axis.a).norm() - 2 * depth, 0.0);
  // Parts that nearly meet are joined about as thick as they are; far ones by something thin.
  const double share = std::clamp(limb / std::max(gap, 1e-300), 0.4, 1.0);
  capsule.radius = std::max(share * depth, 2 * cell);
  return capsule;
}

}  // namespace

std::vector<Capsule> bridge_parts(const Document& document, std::span<const PartSurface> parts,
                                  const PartTree& tree, std::span<const JointSphere> spheres,
                                  std::span<const int> piece_of, double cell,
                                  std::vector<std::string>& warnings) {
  const int pieces = *std::max_element(piece_of.begin(), piece_of.end()) + 1;
  std::vector<int> joined(pieces);  // piece → the lowest piece that it is one with
  std::iota(joined.begin(), joined.end(), 0);
  std::vector<Capsule> capsules;
  for (int i = 0; i < int(parts.size()); ++i) {
    int over = tree.nodes[i].parent;
    while (over >= 0 && piece_of[over] < 0) over = tree.nodes[over].parent;
    if (over < 0 || piece_of[i] < 0) continue;
    const int a = joined[piece_of[i]], b = joined[piece_of[over]];
    if (a == b) continue;
    for (int& piece : joined)
      if (piece == a) piece = b;
    double limb = tree.nodes[i].thickness / 2;
    for (const JointSphere& sphere : spheres)
      if (sphere.joint == parts[i].joint) limb = std::min(limb, sphere.radius / 1.2);
    capsules.push_back(
        bridge_between(parts[i], parts[over], tree.nodes[i], tree.nodes[over], limb, cell));
    const auto name = [&](int part) {
      return "'" + document.skeleton.joints[parts[part].joint].name + "'";
    };
    warnings.push_back(
        name(i) + " does not touch " + name(over) +
        " in the rest pose: a round bridge along the bone joins them. Draw their contours "
        "so that they overlap at the joint, or what lies between them");
  }
  return capsules;
}

}  // namespace artisketch
