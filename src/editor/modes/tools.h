// Every tool there is. A new one is a file of its own in its mode's folder, and a line in
// tools.cpp.
#pragma once

#include <span>
#include <vector>

#include "editor/session/command.h"
#include "editor/session/tool.h"

namespace artisketch {

// By mode, in the order of the rail.
std::span<const ToolRow> all_tools();
// What takes each of them up, by id: "outline.draw".
std::vector<Command> tool_commands();

}  // namespace artisketch
