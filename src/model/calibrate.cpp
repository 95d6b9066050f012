#include "model/calibrate.h"

#include <algorithm>
#include <cmath>

namespace artisketch {

double figure_size(const Document& document) {
  Box3 box;
  for (const Vec3& p : rest_positions(document.skeleton)) box.extend(p);
  return std::max(box.sizes().norm(), 1e-9);
}

std::vector<std::vector<bool>> shared_parts(const Document& document) {
  const int joints = document.skeleton.size();
  std::vector<std::vector<bool>> drawn(document.frames.size(), std::vector<bool>(joints, false));
  std::vector<int> times(joints, 0);
  for (std::size_t f = 0; f < document.frames.size(); ++f)
    for (const Contour& contour : document.frames[f].contours)
      if (contour.line.closed && !drawn[f][contour.joint]) {
        drawn[f][contour.joint] = true;
        ++times[contour.joint];
      }
  for (auto& frame : drawn)
    for (int j = 0; j < joints; ++j) frame[j] = frame[j] && times[j] > 1;
  return drawn;
}

PoseBounds pose_bounds(const Document& document) {
  const CalibrationLimits& limits = document.calibration;
  PoseBounds bounds;
  bounds.rotation.assign(document.skeleton.size(), limits.max_rotation.value_or(kDefaultMaxRotation));
  for (const int joint : limits.locked) bounds.rotation[joint] = 0;
  bounds.translation =
      limits.max_translation.value_or(kDefaultMaxTranslation * figure_size(document));
  for (std::size_t f = 0; f < document.frames.size(); ++f)
    bounds.moves.push_back(f > 0 || limits.free_first_frame);
  return bounds;
}

}  // namespace artisketch
