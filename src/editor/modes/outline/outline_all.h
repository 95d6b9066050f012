// All parts of the figure outlined at once, where the skeleton lies over it.
#pragma once

#include "editor/session/app.h"

namespace artisketch {

// Whether the drawing has a picture, and parts without an outline; else what it lacks, in words.
bool can_outline_all(const App& app);
std::string why_not_outline_all(const App& app);
// One step of undo; says which parts it left out.
void outline_all(App& app);

}  // namespace artisketch
