// How far joints of people and animals turn, roughly: what a guessed pose keeps to where outlines
// alone would allow what no body can.
#pragma once

#include "document/skeleton.h"

namespace artisketch {

// Of the rotation vector from the rest pose (axis × angle, radians, in the joint's own axes), for a
// figure that stands upright and faces +z at rest.
struct JointLimits {
  Vec3 least, most;
};

// By the joint's name, as the templates have it; for others by the skeleton's shape: what carries
// several limbs is a trunk and bends little, all else goes nearly everywhere. The root has none.
JointLimits joint_limits(const Skeleton& skeleton, int joint);

// The part of a rotation vector that is beyond the limits.
Vec3 beyond(const JointLimits& limits, const Vec3& turn);

// Whether the joint carries more than one limb, and isn't the root: a chest, no elbow.
bool is_trunk(const Skeleton& skeleton, int joint);

}  // namespace artisketch
