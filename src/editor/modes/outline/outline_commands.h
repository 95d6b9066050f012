// What keys and buttons do to the chosen outline, and to a pending one.
#pragma once

#include "editor/session/work.h"

namespace artisketch {

bool outline_available(const Work& work, Command command);
void outline_command(Work& work, Command command);

// The chosen outline and another one as one.
void join_with(Work& work, int other);

// Where outlines of the drawing in view cross themselves: which, −1 for the pending one, and where.
struct CrossingMark {
  int contour;
  Vec2 at;
};
std::vector<CrossingMark> crossing_marks(const Work& work);
void mend(Work& work, int contour);

}  // namespace artisketch
