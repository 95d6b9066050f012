// Arrow keys: what is chosen moves by a pixel of the drawing, with Shift by ten. Until something
// else is done that is one step of undo.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "editor/session/app.h"
#include "editor/session/command.h"

namespace artisketch {

// The four commands of a mode.
//   id    begins their ids
//   move  by so many pixels of the drawing, as the next piece of a gesture
std::vector<Command> nudge_commands(const std::string& id, bool (*available)(const App&),
                                    void (*move)(App&, const Vec2&));

// Rows that run as long as a key is held, all of it one step of undo.
std::function<void(App&)> held_down(std::function<void(App&)> change);

}  // namespace artisketch
