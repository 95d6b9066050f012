// A new outline from when it is drawn or traced until it is kept: whose part it is.
#pragma once

#include "editor/session/app.h"

namespace artisketch {

// Makes it the pending one, with the parts that it may be; one that was pending is kept.
void propose(App& app, NewOutline fresh);
// The pending outline, which was traced, with another tolerance.
void trace_again(App& app, double tolerance);
// Whose the pending outline is, or else the chosen one.
void reassign(App& app, int joint);

// The part that a press would give the pending outline to, or the chosen one; −1: none.
struct Offer {
  int part = -1;
  ImVec2 at;  // its joint
};
Offer offer_under(const App& app, const Pointer& pointer, const Stage& stage);
void paint_offer(const App& app, const Offer& offer, const Pointer& pointer);

// Enter keeps the pending outline, Tab goes on to the next part that it may be.
void answer_pending(App& app, const Pointer& pointer);
// Dashed, with a chip that says whose it will be.
//   place  where no tools float
void paint_pending(const App& app, const Rect& place, const OnScreen& on);

}  // namespace artisketch
