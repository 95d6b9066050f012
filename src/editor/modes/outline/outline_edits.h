// What tools, commands and chips do to the outlines of the drawing in view.
#pragma once

#include <vector>

#include "editor/session/app.h"

namespace artisketch {

// The chosen outline and another one as one.
void join_with(App& app, int other);

// Where outlines of the drawing in view cross themselves: which, −1 for the pending one, and where.
struct CrossingMark {
  int contour;
  Vec2 at;
};
std::vector<CrossingMark> crossing_marks(const App& app);
void mend(App& app, int contour);

}  // namespace artisketch
