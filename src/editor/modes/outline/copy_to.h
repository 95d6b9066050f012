// Copy to: the chosen outlines in another drawing. Which one is asked where there are several, and
// what becomes of a part that has outlines there already.
#pragma once

#include "editor/session/app.h"

namespace artisketch {

void copy_to(App& app);
// The drawings to choose from, while they are asked for.
void copy_menu(App& app, const Rect& canvas);

}  // namespace artisketch
