// The result's clips in time.
#pragma once

#include "editor/canvas/layout.h"
#include "editor/session/app.h"

namespace artisketch {

void timeline(App& app, const Layout& layout);

}  // namespace artisketch
