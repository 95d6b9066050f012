#include "model/rig/own_skeleton.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/rotation.h"
#include "model/rig/body_plan.h"

namespace artisketch {
namespace {

// Where the joints of the standing figure are, y up.
std::vector<Vec3> standing(const Motion& motion) {
  constexpr double kUpright = 0.8;  // cosine
  const auto turned = [](std::vector<Vec3> at) {
    for (Vec3& p : at) p = about_x(-90) * p;
    return at;
  };
  std::vector<std::vector<Vec3>> choices{rest_positions(motion.skeleton)};
  if (!motion.poses.empty()) choices.push_back(places_of(posed_joints(motion, 0)));
  for (const std::vector<Vec3>& at : choices) {
    const std::optional<Vec3> up = standing_direction(body_plan_of(motion.skeleton, at, false), at);
    if (up && up->y() > kUpright) return at;
    if (up && up->z() > kUpright) return turned(at);
  }
  return choices[0];
}

void name_all(std::vector<Joint>& joints) {
  std::set<std::string> taken;
  for (Joint& joint : joints) {
    if (joint.name.empty())
      joint.name = joint.parent < 0 ? "root" : joints[std::size_t(joint.parent)].name + "_end";
    const std::string wanted = joint.name;
    for (int n = 2; !taken.insert(joint.name).second; ++n)
      joint.name = wanted + "_" + std::to_string(n);
  }
}

// Pairs that are each other's nearest across the plane; a joint on it is its own.
void pair_mirrors(const std::vector<Vec3>& at, double tall, std::vector<Joint>& joints) {
  constexpr double kOff = 0.02;  // of the height: hands make skeletons
  const auto nearest = [&](std::size_t j) {
    Vec3 image = at[j];
    image.x() = 2 * at[0].x() - image.x();
    int best = -1;
    double off = kOff * tall;
    for (std::size_t other = 0; other < at.size(); ++other)
      if (const double d = (at[other] - image).norm();
          d < off && (joints[other].parent < 0) == (joints[j].parent < 0)) {
        off = d;
        best = int(other);
      }
    return best;
  };
  std::vector<int> found;
  for (std::size_t j = 0; j < at.size(); ++j) found.push_back(nearest(j));
  for (std::size_t j = 0; j < at.size(); ++j)
    if (found[j] >= 0 && found[std::size_t(found[j])] == int(j)) joints[j].mirror = found[j];
}

}  // namespace

Document document_with_skeleton(const Motion& motion) {
  Document document;
  document.name = motion.name;
  document.skeleton = motion.skeleton;
  std::vector<Joint>& joints = document.skeleton.joints;
  std::vector<Vec3> at = standing(motion);
  Box3 box;
  for (const Vec3& p : at) box.extend(p);
  constexpr double kNothing = 1e-9;
  const double tall = std::max(box.sizes().maxCoeff(), kNothing);
  if (motion.skeleton.joints[0].offset.norm() < kNothing * tall) {
    const Vec3 to_ground(-at[0].x(), -box.min().y(), -at[0].z());
    for (Vec3& p : at) p += to_ground;
  }
  // What single precision and turns leave behind the sixth digit is nobody's wish.
  const double step = std::pow(10.0, std::floor(std::log10(tall)) - 6);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const Vec3 offset =
        joints[j].parent < 0 ? at[j] : Vec3(at[j] - at[std::size_t(joints[j].parent)]);
    for (int c = 0; c < 3; ++c) joints[j].offset[c] = std::round(offset[c] / step) * step + 0.0;
  }
  name_all(joints);
  pair_mirrors(at, tall, joints);
  constexpr double kPixels = 500;
  document.camera.pixels_per_unit = kPixels / tall;
  return document;
}

}  // namespace artisketch
