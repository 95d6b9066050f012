// How well each part fits its outline, and the calibration's proposal to take.
#pragma once

#include "editor/session/app.h"

namespace artisketch {

void pose_panel(App& app, Rect place);
void proposal_sheet(App& app, Rect place);  // on tablets, in place of the parts

}  // namespace artisketch
