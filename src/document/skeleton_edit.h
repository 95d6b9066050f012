// Edits of the skeleton, as functions from the document to the next one. Whatever counts joints
// (contours, poses, clips, spheres, parts, limits, motions) is kept right. Joints must exist
// (asserted).
#pragma once

#include <optional>
#include <string>

#include "document/document.h"

namespace artisketch {

// Another skeleton. What belonged to a joint goes to the one of the same name; contours that have
// none get joint −1 until with_contours_at_bones(). Poses keep the rotations of such joints.
Document with_skeleton(Document document, Skeleton skeleton);
// Contours without a joint go to the likeliest, by where they lie.
Document with_contours_at_bones(Document document);

// `wanted`, or with a number where another joint has that name: "arm", "arm 2". The side stays
// last: "arm 2.L". `except` may have the name itself.
std::string unique_joint_name(const Skeleton& skeleton, const std::string& wanted, int except = -1);

// A new joint at the end of the list, `offset` from its parent in the rest pose.
//   mirrored  with its image on the other side: a child of the parent's mirror image, or of the
//             parent itself where that stands in the middle. An offset close to the middle plane is
//             set into it, and the joint is its own mirror image.
Document with_joint_added(Document document, int parent, Vec3 offset, bool mirrored);

// A new joint within the joint's only bone: what that ended in hangs on it, and all stands where it
// stood. Its mirror image likewise, where that has such a bone. Each comes right before what hangs
// on it, and is named after the joint; it has its part's settings.
//   along   of the bone, 0 … 1
//   length  of the bone of a joint that nothing hangs on: it goes on from the one before it
Document with_joint_in_bone(Document document, int joint, double along, double length);

// A new joint at its parent's place for a thing that the parent holds, by the name "thing".
Document with_thing_added(Document document, int parent);

// Without a joint: its children hang on its parent, where they were in the rest pose; its contours
// become the parent's. Its mirror image goes too where `mirrored`. Nothing where it is the root and
// has not exactly one child, which then is the root.
std::optional<Document> without_joint(const Document& document, int joint, bool mirrored);

// Another name, unique; the side (.L, .R) stays, and the mirror image's name follows where they
// were alike. Empty words change nothing.
Document with_joint_renamed(Document document, int joint, const std::string& words);

// A joint elsewhere in the rest pose, alone or with its mirror image.
Document with_joint_moved(Document document, int joint, const Vec3& offset, bool mirrored);

// The bones to a joint and to its mirror image, both as long as their mean; −1: those of all pairs.
Document with_pair_lengths_equal(Document document, int joint);

// The whole figure larger or smaller about its root, in every frame and clip.
Document with_figure_scaled(Document document, double factor);

}  // namespace artisketch
