// The library's clips, pose by pose: what library.cpp lists.
#pragma once

#include <algorithm>
#include <cmath>

#include "model/rig/library.h"
#include "model/rig/puppet.h"

namespace artisketch {

// Each takes how far round the clip is, 0 … 1.
Pose walk_pose(const Puppet& body, const ClipStyle& style, double phase);
Pose run_pose(const Puppet& body, const ClipStyle& style, double phase);
Pose four_walk_pose(const Puppet& body, const ClipStyle& style, double phase);
Pose trot_pose(const Puppet& body, const ClipStyle& style, double phase);
Pose idle_pose(const Puppet& body, const ClipStyle& style, double phase);
Pose wave_pose(const Puppet& body, const ClipStyle& style, double phase);
Pose jump_pose(const Puppet& body, const ClipStyle& style, double phase);
Pose sit_pose(const Puppet& body, const ClipStyle& style, double phase);

inline double wave(double phase) {
  return std::sin(2 * kPi * phase);
}
inline double smooth(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}
// 0 before a, 1 from b to c, 0 after d.
inline double plateau(double t, double a, double b, double c, double d) {
  return smooth((t - a) / (b - a)) * (1 - smooth((t - c) / (d - c)));
}

}  // namespace artisketch
