// Recorded motions in: what they move, and by whose word.
#pragma once

#include "editor/session/app.h"

namespace artisketch {

// Recorded motions (.bvh, or the animations of a .glb) as clips of the document's; the last is
// played where there is a model.
void add_motion(App& app, const NamedBytes& file);
// A clip at the end of the document's, chosen and played.
void add_clip(App& app, const std::string& undo_name, Animation animation);

// What was dropped last, as long as its clips are in the document; else null. Its maps are as the
// document has them now.
DroppedMotion* dropped_motion(App& app);
// The joint of the document follows that one of the motion from now on, by the person's word: "" is
// nobody. Without `mover` it follows what is found again. Its clips are made anew.
void map_joint(App& app, int joint, const std::optional<std::string>& mover);
void retarget_again(App& app, const std::string& undo_name, const RetargetOptions& options);

}  // namespace artisketch
