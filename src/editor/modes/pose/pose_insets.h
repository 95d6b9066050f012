// Beside the body in Pose: the ball that turns it, its side view, the drawings to copy from.
#pragma once

#include <vector>

#include "editor/canvas/layout.h"
#include "editor/session/app.h"

namespace artisketch {

std::vector<Rect> pose_inset_places(const Layout& layout);
void pose_insets(App& app, const Layout& layout, float pixel_ratio);

}  // namespace artisketch
