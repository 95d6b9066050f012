// Over the drawing in Pose: where the model's edge and the outlines part ways.
#pragma once

#include "editor/session/app.h"

namespace artisketch {

void paint_fit_marks(App& app, const OnScreen& on);
void paint_fit_tag(App& app, const Rect& place, const OnScreen& on);  // the worst of them

}  // namespace artisketch
