#include "model/rig/upright_motion.h"

#include <algorithm>

namespace artisketch {

UprightMotion::UprightMotion(const Motion& motion) : motion_(motion) {
  z_up_ = stands_along_z();
}

std::vector<Transform> UprightMotion::posed(int k) const {
  std::vector<Transform> all = k < 0 ? posed_joints(motion_.skeleton, rest_pose(motion_.skeleton))
                                     : posed_joints(motion_, k);
  const Transform turn(Mat3(Eigen::AngleAxisd(-kPi / 2, Vec3::UnitX())));
  if (z_up_)
    for (Transform& one : all) one = turn * one;
  return all;
}

std::vector<int> UprightMotion::sampled(int most) const {
  std::vector<int> some;
  const int step = std::max(1, size() / most);
  for (int k = 0; k < size(); k += step) some.push_back(k);
  return some;
}

// Whether z is up: the figure stands along it, for more of the time than along y. Where its joints
// say nothing, it is taller along it.
bool UprightMotion::stands_along_z() const {
  constexpr double kUpright = 0.8;  // cosine
  const BodyPlan figure = body_plan_of(skeleton(), places_of(posed(0)), false);
  int along_y = 0, along_z = 0;
  double tall_y = 0, tall_z = 0;
  for (const int k : sampled(200)) {
    const std::vector<Vec3> at = places_of(posed(k));
    if (const auto up = standing_direction(figure, at)) {
      along_y += up->y() > kUpright;
      along_z += up->z() > kUpright;
    } else {
      Box3 box;
      for (const Vec3& p : at) box.extend(p);
      tall_y += box.sizes().y();
      tall_z += box.sizes().z();
    }
  }
  return along_z > along_y || (along_y == 0 && along_z == 0 && tall_z > 1.3 * tall_y);
}

}  // namespace artisketch
