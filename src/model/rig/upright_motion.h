// A motion's poses with y up, whatever its file has.
#pragma once

#include <vector>

#include "document/motion.h"
#include "model/rig/body_plan.h"

namespace artisketch {

class UprightMotion {
 public:
  explicit UprightMotion(const Motion& motion);  // refers to it
  bool z_up() const { return z_up_; }            // the motion's own axis, before it was turned
  int size() const { return int(motion_.poses.size()); }
  const Skeleton& skeleton() const { return motion_.skeleton; }
  // In pose k; k < 0: at rest.
  std::vector<Transform> posed(int k) const;
  // About `most` poses, evenly.
  std::vector<int> sampled(int most) const;

 private:
  bool stands_along_z() const;

  const Motion& motion_;
  bool z_up_ = false;
};

}  // namespace artisketch
