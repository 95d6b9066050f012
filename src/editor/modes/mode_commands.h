// The commands of each mode, in the order of its rail and of its menu on the canvas.
#pragma once

#include <vector>

#include "editor/session/command.h"

namespace artisketch {

std::vector<Command> outline_commands();
std::vector<Command> skeleton_commands();
std::vector<Command> pose_commands();
std::vector<Command> result_commands();

}  // namespace artisketch
