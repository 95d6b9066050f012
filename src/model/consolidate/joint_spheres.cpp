// The spheres in whose volume parts are stitched together (the paper's section 5).
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/trigonometry.h"
#include "model/consolidate/part_tree.h"

namespace artisketch {
namespace {

constexpr double kShareOfDiameter = 0.6;  // the paper's

// Median distance from the axis to the part's surface, over the half of the axis from `near` on.
// Nothing where that half lies outside the part.
std::optional<double> radius_about(const Grid3<float>& g, const Segment& axis, bool near_a) {
  const Vec3 along = axis.b - axis.a;
  const Vec3 direction = along.norm() > 0 ? along.normalized() : Vec3::UnitX().eval();
  const Vec3 u = direction.unitOrthogonal(), w = direction.cross(u);
  constexpr int kStations = 8, kRays = 12;
  std::vector<double> radii;
  for (int s = 0; s < kStations; ++s) {
    const double t = 0.5 * (s + 0.5) / kStations;
    const Vec3 from = axis.at(near_a ? t : 1 - t);
    if (!g.box().contains(from) || sample(g, from) >= 0) continue;
    for (int r = 0; r < kRays; ++r) {
      const double angle = 2 * kPi * r / kRays;
      const Vec3 out = cosine(angle) * u + sine(angle) * w;
      // Steps of the sampled distance itself, at least half a cell.
      double reach = 0;
      while (g.box().contains(from + reach * out)) {
        const double d = sample(g, from + reach * out);
        if (d >= 0) break;
        reach += std::max(-d, g.cell / 2);
      }
      radii.push_back(reach);
    }
  }
  if (radii.empty()) return {};
  std::nth_element(radii.begin(), radii.begin() + radii.size() / 2, radii.end());
  return radii[radii.size() / 2];
}

}  // namespace

// We take the thinner of the two parts that meet: a head's own diameter would swallow the
// shoulders.
std::vector<JointSphere> joint_spheres(const Document& document,
                                       std::span<const PartSurface> parts) {
  return joint_spheres(document, parts, part_tree(document, parts));
}

std::vector<JointSphere> joint_spheres(const Document& document, std::span<const PartSurface> parts,
                                       const PartTree& tree) {
  std::vector<JointSphere> spheres;
  for (int i = 0; i < int(parts.size()); ++i) {
    const PartTree::Node& node = tree.nodes[i];
    if (!node.solid || node.parent < 0) continue;
    double radius = node.thickness / 2;
    if (const auto own = radius_about(parts[i].distance, node.axes[0], true)) radius = *own;
    // The parent's bone that leads here: the one that ends nearest.
    const PartTree::Node& parent = tree.nodes[node.parent];
    const Segment* bone = nullptr;
    for (const Segment& axis : parent.axes)
      if (!bone || (axis.b - node.joint).norm() < (bone->b - node.joint).norm()) bone = &axis;
    if (const auto other = radius_about(parts[node.parent].distance, *bone, false))
      radius = std::min(radius, *other);
    JointSphere sphere{parts[i].joint, node.joint, kShareOfDiameter * 2 * radius};
    if (const auto it = document.spheres.find(sphere.joint); it != document.spheres.end()) {
      sphere.centre += it->second.offset;
      sphere.radius = it->second.radius.value_or(sphere.radius);
    }
    spheres.push_back(sphere);
  }
  return spheres;
}

}  // namespace artisketch
