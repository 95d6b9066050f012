// What to export, and with what.
#pragma once

#include "editor/session/app.h"

namespace artisketch {

void export_sheet(App& app, const Rect& place);

}  // namespace artisketch
