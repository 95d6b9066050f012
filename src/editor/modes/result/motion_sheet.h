// Which joint of a recorded motion moves which of the document's, and by whose word; each line can
// be changed.
#pragma once

#include "editor/session/app.h"

namespace artisketch {

void motion_sheet(App& app, const Rect& place);

}  // namespace artisketch
