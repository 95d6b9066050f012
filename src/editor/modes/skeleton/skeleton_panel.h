// The chosen joint's name and its fellows, and skeletons to begin with.
#pragma once

#include "editor/session/app.h"

namespace artisketch {

void skeleton_panel(App& app, Rect place);
void skeleton_sheet(App& app, Rect place);  // on tablets

}  // namespace artisketch
