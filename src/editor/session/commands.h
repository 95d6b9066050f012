// The commands that belong to no mode, in the order of the sheet of shortcuts.
#pragma once

#include <string>
#include <vector>

#include "editor/session/command.h"

namespace artisketch {

std::vector<Command> file_commands();
std::vector<Command> edit_commands();  // undo, jobs, a step back
std::vector<Command> view_commands();  // modes, drawings, layers, zoom

// What a model needs first, where it is not there: "Outline a part first."
std::string what_comes_first(const App& app);

}  // namespace artisketch
