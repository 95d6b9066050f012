// A first pose for a drawing from its outlines: good enough for calibration to go on from.
#pragma once

#include <vector>

#include "document/document.h"

namespace artisketch {

// The pose in which the skeleton explains best where the drawing's parts lie: their centroids, and
// where neighbours overlap at the joint between them. The first drawing, whose pose is trusted,
// tells where these places are on the parts; without it (or for it) they are taken to be the
// middles of bones and the joints. Bones keep their lengths, so what is short in the picture leans
// out of the paper; to which side, outlines alone hardly say: the calmer pose, with less bend, is
// taken, and joints turn no farther than bodies can (joint_limits.h). A body that was posed stays
// near the turn it has, one that never was may be seen from any side; joints that were set by hand
// stay. The pose as it is where the frame outlines fewer than two parts. Joints without a part
// there keep their rotation. The best first, and up to two that differ from it and explain the
// drawing nearly as well.
std::vector<Pose> suggested_poses(const Document& document, int frame);
Pose suggested_pose(const Document& document, int frame);  // the best

// The same with the joint's own bone leaning the other way, and the rest of its limb settled again.
Pose with_lean_flipped(const Document& document, int frame, const Pose& pose, int joint);

// Whether the joint's own bone leans out of the paper by more than 15°: there are two ways.
bool leans(const Skeleton& skeleton, const Pose& pose, int joint);

}  // namespace artisketch
