// Over the drawing in Pose: where the model's edge and the outlines part ways.
#pragma once

#include "editor/session/app.h"

namespace artisketch {

void paint_fit_marks(App& app, const OnScreen& on);
// The worst of them, beside what floats over the drawing.
void paint_fit_tag(App& app, const Rect& place, const std::vector<Rect>& floating,
                   const OnScreen& on);

}  // namespace artisketch
