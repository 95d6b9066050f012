#include "document/joint_limits.h"

#include <string_view>

namespace artisketch {
namespace {

struct Range {
  double least, most;  // degrees
};
struct Row {
  const char* name;  // without its side
  Range x, y, z;     // of the left one
};

// Ranges of motion as textbooks of anatomy give them for people, widened: a drawn figure is
// livelier than a measured one. Four-legged animals' after dogs'.
constexpr Row kRows[] = {
    {"chest", {-40, 70}, {-50, 50}, {-40, 40}},
    {"neck", {-70, 70}, {-60, 60}, {-45, 45}},
    {"head", {-60, 60}, {-80, 80}, {-45, 45}},
    {"forearm", {-90, 90}, {-155, 10}, {-60, 60}},
    {"hand", {-90, 90}, {-60, 60}, {-85, 85}},
    {"thigh", {-135, 50}, {-60, 60}, {-40, 90}},
    {"shin", {-5, 155}, {-35, 35}, {-20, 20}},
    {"foot", {-60, 60}, {-40, 40}, {-40, 40}},
    {"fore_thigh", {-90, 90}, {-40, 40}, {-40, 60}},
    {"fore_shin", {-140, 60}, {-25, 25}, {-25, 25}},
    {"fore_paw", {-60, 110}, {-35, 35}, {-35, 35}},
    {"hind_thigh", {-90, 90}, {-40, 40}, {-40, 60}},
    {"hind_shin", {-60, 140}, {-25, 25}, {-25, 25}},
    {"hind_paw", {-110, 60}, {-35, 35}, {-35, 35}},
};

bool ends_with_side(std::string_view name, char side) {
  return name.size() > 2 && name[name.size() - 2] == '.' && name.back() == side;
}

}  // namespace

bool is_trunk(const Skeleton& skeleton, int joint) {
  return joint > 0 && skeleton.children(joint).size() > 1;
}

JointLimits joint_limits(const Skeleton& skeleton, int joint) {
  std::string_view name = skeleton.joints[joint].name;
  const bool right = ends_with_side(name, 'R');
  if (right || ends_with_side(name, 'L')) name.remove_suffix(2);
  for (const Row& row : kRows) {
    if (joint == 0 || name != row.name) continue;
    JointLimits limits{{radians(row.x.least), radians(row.y.least), radians(row.z.least)},
                       {radians(row.x.most), radians(row.y.most), radians(row.z.most)}};
    if (right) {  // across the plane x = 0, turns about y and z go the other way
      const JointLimits left = limits;
      limits.least.tail<2>() = -left.most.tail<2>();
      limits.most.tail<2>() = -left.least.tail<2>();
    }
    return limits;
  }
  const double reach = joint == 0 ? kPi : radians(is_trunk(skeleton, joint) ? 45 : 155);
  return {Vec3::Constant(-reach), Vec3::Constant(reach)};
}

Vec3 beyond(const JointLimits& limits, const Vec3& turn) {
  return turn - turn.cwiseMax(limits.least).cwiseMin(limits.most);
}

}  // namespace artisketch
