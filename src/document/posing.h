// Posing as functions from a pose to the next one: what a drag, a flip, a turn does. Bones keep
// their lengths; what a picture shows shorter stands in depth.
//
// A joint's own bone runs from it to its first child; a leaf's is the one that ends in it.
#pragma once

#include <vector>

#include "document/document.h"

namespace artisketch {

// Where the joint's own bone begins (the joint whose rotation turns it) and ends.
int start_of_bone(const Skeleton& skeleton, int joint);
int end_of_bone(const Skeleton& skeleton, int joint);

// How many bones a drag of the joint moves: two where a limb ends (a hand, a foot), else the one
// that ends there; 0 for the root, which moves the whole body.
int bones_dragged(const Skeleton& skeleton, int joint);

// The joint at `target` (world), as near as the lengths of its last `bones` bones allow (1 or 2);
// the rest hangs on, and the joint between two bones stays as near as it can to where it was. The
// root moves as a whole.
Pose with_joint_at(const Skeleton& skeleton, const Pose& pose, int joint, const Vec3& target,
                   int bones);

// The joint dragged to a pixel of the picture. A limb's end keeps its depth while it can; a joint
// of one bone swings on its sphere, on the side of the paper where it was. The end of a limb stays
// where it is seen when the joint in its middle is dragged.
Pose with_joint_dragged(const Skeleton& skeleton, const Pose& pose, const FrameCamera& camera,
                        int joint, const Vec2& pixel);

// The bone that ends in `joint` swung to where its end is seen at a pixel, on the side of the paper
// where it was; toward the pixel, where the bone is too short.
Pose with_bone_toward(const Skeleton& skeleton, const Pose& pose, const FrameCamera& camera,
                      int joint, const Vec2& pixel);

// The joint brought to the depth z (world), as near as lengths allow, where it is seen: a limb's
// end keeps its pixel, the end of one bone the bone's direction in the picture.
Pose with_joint_depth(const Skeleton& skeleton, const Pose& pose, const FrameCamera& camera,
                      int joint, double z);

// The bone that ends in `joint` mirrored in depth: what pointed toward the viewer points away.
Pose with_bone_flipped(const Skeleton& skeleton, const Pose& pose, int joint);

// The bone that ends in `joint` turned about its own axis.
Pose with_bone_twisted(const Skeleton& skeleton, const Pose& pose, int joint, double angle);

// The whole body turned about a world axis through the root.
Pose with_body_turned(Pose pose, const Quat& turn);

// The turn of a ball of `radius` that takes its surface under the pointer from one place to the
// next, both from its middle, x right, y down; beyond its rim it rolls about the line of sight.
// Source: Shoemake 1992, "ARCBALL", as Holroyd's smooth variant has it.
Quat ball_turn(const Vec2& from, const Vec2& to, double radius);

// The pose of one drawing in another, at that one's own place.
Document with_pose_copied(Document document, int from, int to);

// Locks a joint for the calibration, or frees it.
Document with_lock(Document document, int joint, bool locked);
bool is_locked(const Document& document, int joint);

}  // namespace artisketch
