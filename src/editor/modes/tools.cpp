#include "editor/modes/tools.h"

#include "editor/session/app.h"

namespace artisketch {

// A line here, and NAME_tool() in modes/MODE/NAME_tool.cpp, is all that makes a tool known. Listed
// rather than registered by the files themselves: a linker drops what nothing names.
#define ARTISKETCH_TOOLS(TOOL) \
  TOOL(edit_outline)           \
  TOOL(arrange)                \
  TOOL(draw)                   \
  TOOL(points)                 \
  TOOL(trace)                  \
  TOOL(cut)                    \
  TOOL(edit_skeleton)          \
  TOOL(pose)                   \
  TOOL(turn)                   \
  TOOL(twist)                  \
  TOOL(orbit)                  \
  TOOL(pose_model)             \
  TOOL(spheres)                \
  TOOL(fatness)

#define ARTISKETCH_DECLARE(name) ToolRow name##_tool();
ARTISKETCH_TOOLS(ARTISKETCH_DECLARE)
#undef ARTISKETCH_DECLARE

std::span<const ToolRow> all_tools() {
#define ARTISKETCH_ROW(name) name##_tool(),
  static const ToolRow rows[] = {ARTISKETCH_TOOLS(ARTISKETCH_ROW)};
#undef ARTISKETCH_ROW
  return rows;
}

std::vector<Command> tool_commands() {
  constexpr const char* kModeNames[kModes] = {"outline.", "skeleton.", "pose.", "result."};
  std::vector<Command> commands;
  for (const ToolRow& row : all_tools()) {
    Command& command = commands.emplace_back();
    command.id = std::string(kModeNames[std::size_t(row.mode)]) + row.id;
    command.name = row.name;
    command.icon = row.icon;
    command.about = row.about;
    command.key = row.key;
    command.mode = row.mode;
    command.is_tool = true;
    command.available = row.available;
    command.what_it_lacks = row.what_it_lacks;
    command.on = [&row](const App& app) { return app.in_hand(row); };
    command.run = [&row](App& app) { app.take_up(row); };
  }
  return commands;
}

}  // namespace artisketch
