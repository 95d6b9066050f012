#include "model/calibrate.h"

#include <algorithm>

namespace artisketch {

PoseLimits pose_limits(const Document& document) {
  PoseLimits limits;
  limits.max_rotation = document.calibration.max_rotation.value_or(radians(30));
  Box3 box;
  for (const Vec3& p : rest_positions(document.skeleton)) box.extend(p);
  limits.max_translation =
      document.calibration.max_translation.value_or(0.25 * std::max(box.diagonal().norm(), 1e-3));
  limits.free.assign(document.skeleton.size(), 0);
  for (const int joint : drawn_joints(document)) limits.free[joint] = 1;
  for (const int joint : document.calibration.locked) limits.free[joint] = 0;
  return limits;
}

}  // namespace artisketch
