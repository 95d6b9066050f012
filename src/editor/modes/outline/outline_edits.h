// What tools, commands and chips do to the outlines of the drawing in view.
#pragma once

#include <string>
#include <vector>

#include "document/outline_edit.h"
#include "editor/session/app.h"

namespace artisketch {

// The chosen outline and another one as one.
void join_with(App& app, int other);

// What they are called: "Hand R", "3 outlines".
std::string outlines_words(const App& app, const ContourSet& contours);

// Lays outlines into the drawing in view, and chooses them. `next`: the document but for them.
void lay(App& app, const std::string& undo_name, Document next,
         const std::vector<LooseOutline>& outlines);

// Where outlines of the drawing in view cross themselves: which, −1 for the pending one, and where.
struct CrossingMark {
  int contour;
  Vec2 at;
};
std::vector<CrossingMark> crossing_marks(const App& app);
void mend(App& app, int contour);

}  // namespace artisketch
