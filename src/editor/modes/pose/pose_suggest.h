// A pose from the outlines; then its rivals, and which way its bones lean, to choose from.
#pragma once

#include "editor/session/app.h"

namespace artisketch {

void suggest_pose(App& app);
void pose_chooser(App& app, ImVec2 corner);  // its lower left one

}  // namespace artisketch
