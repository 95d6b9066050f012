// What each of the document's bones follows in a motion.
#pragma once

#include <optional>
#include <vector>

#include "model/rig/motion_map.h"

namespace artisketch {

// Of both figures' joints and the map between them. All lists are by the document's joints; `at` is
// where the motion's joints stand in some pose, y up.
class RetargetAims {
 public:
  RetargetAims(const Skeleton& ours, const Skeleton& theirs,
               const JointMap& map);  // refers to them

  // Where the motion points a joint's bone; nothing where it follows none.
  std::optional<Vec3> aimed(int joint, const std::vector<Vec3>& at) const;
  // The bone at rest; only where `aimed` gives something.
  Vec3 bone(int joint) const { return rest_[aims_[joint].to] - rest_[joint]; }
  // Whether it follows a part of the trunk as a whole.
  bool of_trunk(int joint) const { return aims_[joint].trunk >= 0; }

 private:
  // A bone of the document's and what it follows: from a place of the motion's figure to another.
  struct Aim {
    int to = -1;  // of the document; −1: none
    int their_from = -1, their_to = -1;
    int trunk = -1;  // or the part of the trunk that begins here
  };
  struct OnTrunk {
    int from = 0, to = 0;  // of the motion's trunk, between which
    double share = 0;      // how far
  };

  int mover(int joint) const { return joint < 0 ? -1 : map_.mover[joint]; }
  void find_limbs();
  void find_trunk();
  void find_others();
  Vec3 on_trunk(int i, const std::vector<Vec3>& at) const;

  const Skeleton& ours_;
  const Skeleton& theirs_;
  const JointMap& map_;
  const std::vector<Vec3> rest_;
  std::vector<Aim> aims_;
  std::vector<OnTrunk> trunk_at_;
};

// Whether a limb ends in the joint: a hand or a foot.
bool ends_limb(const BodyPlan& figure, int joint);
// Whether the trunk lies, from hips to chest, and arms are forelegs.
bool four_legged(const BodyPlan& figure, const std::vector<Vec3>& at);

}  // namespace artisketch
