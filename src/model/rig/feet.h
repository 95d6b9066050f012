// Feet that stand where they stand.
#pragma once

#include <vector>

#include "model/rig/body_plan.h"
#include "model/stages.h"

namespace artisketch {

// One foot over a clip.
struct FootTrack {
  LimbJoints limb;               // of the document
  std::vector<Vec3> ankle, toe;  // of the motion, y up, per pose
  double stance = 0;             // the ankle's height in the motion while the figure stands
  // Per pose: flat on the ground and at rest; the toes so, whatever the heel does.
  std::vector<bool> stands, toes_stand;
  double height = 0, toe_height = 0;  // of the document's ankle and toes above the ground at rest
};

// When each foot stands: low, and hardly moving. The ground is where the lower foot is for most of
// the time, the motion's own zero where that may be it.
//   leg   the motion's, from top to ankle: what "low" and "hardly" are measured by
//   step  seconds from pose to pose
void find_contacts(std::vector<FootTrack>& feet, double leg, double step);

// Feet that stand are flat on average, as high as at rest, and keep their place for as long as they
// do, also while the heel rises over the toes; none goes below the ground. Feet of which that is
// already true stay as they are. Legs follow by two bones' IK, and bend as they did; the root sinks
// where one would have to be longer. Legs of one bone stay as they are.
void plant_feet(const Skeleton& skeleton, const std::vector<FootTrack>& feet, Clip& clip);

// Two bones' IK: the limb's end comes to `target`, or as near as it reaches, and is turned as
// wanted in the world. Its knee or elbow keeps to the side to which it is bent, at rest if it is
// straight (straight there, too: ahead). The limb has all three joints.
void put_limb(const Skeleton& skeleton, const LimbJoints& limb, const Vec3& target,
              const Quat& end_turn, Pose& pose);

// Without the root's way over the ground: what it goes on average, at even pace.
void stay_in_place(Clip& clip);

// Where the last pose is nearly the first, but for the way: the difference is spread over the
// clip's end, so that it goes on without a jolt. Whether it was.
bool close_loop(const Skeleton& skeleton, Clip& clip);

}  // namespace artisketch
