// What one does in a mode is shown at the first visit there, until it is put away; it is asked for
// again by the command "hints". Which modes' were seen is kept between sessions.
#pragma once

#include "editor/session/app.h"

namespace artisketch {

// Of the mode one is in. They wait for a drawing: until then the canvas says what to do.
bool hints_shown(const App& app);
// Where their picture is, 0 … 1; it rests after some rounds, with all done.
float hints_time(const App& app);
bool hints_move(const App& app);
void close_hints(App& app);
// What was kept comes in. Before that, nothing is shown.
void recall_hints(App& app);
// Once a frame: the first visit, and the mode that was left.
void follow_hints(App& app);

}  // namespace artisketch
