// A part that bends from drawing to drawing, split at a joint.
#pragma once

#include <vector>

#include "editor/session/app.h"

namespace artisketch {

// The chosen part; where it doesn't bend, at the place that the menu was opened over, or in its
// middle.
bool can_split_chosen(const App& app);
void split_chosen(App& app);

void split_part(App& app, int joint);
// Of the parts that notes are about, those that bend enough for a joint of their own.
std::vector<int> split_offers(const App& app);

}  // namespace artisketch
