// Beside the body in Pose: the ball that turns it, its side view, the drawings to copy from.
#pragma once

#include <vector>

#include "editor/canvas/layout.h"
#include "editor/session/app.h"

namespace artisketch {

// `rail`: where the tools are.
std::vector<Rect> pose_inset_places(const Layout& layout, const Rect& rail);
void pose_insets(App& app, const Layout& layout, const Rect& rail, float pixel_ratio);

}  // namespace artisketch
