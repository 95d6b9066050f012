// A recorded motion: another skeleton than the document's, and its poses at even steps of time.
#pragma once

#include <string>
#include <vector>

#include "document/skeleton.h"

namespace artisketch {

struct Motion {
  std::string name;
  Skeleton skeleton;        // ends of chains are joints too, their names empty
  double step = 0;          // seconds from one pose to the next, > 0
  std::vector<Pose> poses;  // one or more
  // Joints below the root that have places of their own, and where each of them stands in every
  // pose, seen from its parent: in place of its offset.
  std::vector<int> moved;
  std::vector<std::vector<Vec3>> places;  // per pose, one for each of `moved`
  std::vector<std::string> warnings;      // what the file says of itself and doesn't keep
};

// Each joint's frame in the world in pose k.
inline std::vector<Transform> posed_joints(const Motion& motion, int k) {
  if (motion.moved.empty()) return posed_joints(motion.skeleton, motion.poses[std::size_t(k)]);
  Skeleton skeleton = motion.skeleton;
  for (std::size_t i = 0; i < motion.moved.size(); ++i)
    skeleton.joints[std::size_t(motion.moved[i])].offset = motion.places[std::size_t(k)][i];
  return posed_joints(skeleton, motion.poses[std::size_t(k)]);
}

}  // namespace artisketch
