// A new outline from when it is drawn or traced until it is kept: whose part it is.
#pragma once

#include "editor/canvas/pointer.h"

namespace artisketch {

// Makes it the pending one, with the parts that it may be; one that was pending is kept.
void propose(Work& work, NewOutline fresh);
// Another line for the same gesture, or none: then nothing is pending any more.
void propose_again(Work& work, std::optional<Traced> traced);
void keep_outline(Work& work);
// Whose the pending outline is, or else the chosen one.
void reassign(Work& work, int joint);

// The pending outline, dashed, with a chip that says whose it will be. Enter keeps, Tab goes on.
void pending_outline(Work& work, const Rect& place, const OnScreen& on);

// A press on a joint that says whose outline it is, where one is pending or its joint is being
// picked; true where the press is used up.
bool picks_joint(Work& work, const Pointer& p, const OnScreen& on);

}  // namespace artisketch
