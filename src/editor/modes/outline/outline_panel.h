// Whose the new or chosen outline is, and what can be done with it.
#pragma once

#include "editor/session/app.h"

namespace artisketch {

void outline_panel(App& app, Rect place);
void new_outline_sheet(App& app, Rect place);  // on tablets, in place of the parts

}  // namespace artisketch
