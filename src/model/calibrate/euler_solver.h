// The coupled skeleton problem of the paper's section 2.3: local rotations in Euler angles and the
// root's translation that bring part points to where the newest frame's rays want them, within
// limits, by an augmented Lagrangian.
#pragma once

#include <vector>

#include "document/skeleton.h"

namespace artisketch {

// A rest-space point bound to a joint, and the world point that it should reach.
struct PointPair {
  int joint = 0;
  Vec3 rest, world;
  double weight = 1;
};

struct EulerLimits {
  double max_rotation = 0;     // radians from the user's rotation, per joint
  double max_translation = 0;  // units from the user's root position
  std::vector<char> free;      // per joint: may rotate
};

// Minimises Σ weight |posed(rest) − world|² over the pose, starting at `start`; `user` is the pose
// that the limits are about. Limits hold exactly in the result.
//   Rotation j = user rotation · Rz(γ) Ry(β) Rx(α), the Euler angles about the user's own pose.
Pose solve_pose(const Skeleton& skeleton, const Pose& user, const Pose& start,
                const std::vector<PointPair>& pairs, const EulerLimits& limits);

// The nearest pose to `pose` within the limits.
Pose within_limits(const Pose& user, Pose pose, const EulerLimits& limits);

}  // namespace artisketch
