#include "editor/session/command.h"

#include <cassert>

#include "editor/session/app.h"

namespace artisketch {
namespace {

const char* key_name(ImGuiKey key) {
  switch (key) {
    case ImGuiKey_Comma:
      return ",";
    case ImGuiKey_Period:
      return ".";
    case ImGuiKey_Slash:
      return "/";
    case ImGuiKey_Equal:
      return "+";
    case ImGuiKey_Minus:
      return "−";
    case ImGuiKey_LeftBracket:
      return "[";
    case ImGuiKey_RightBracket:
      return "]";
    case ImGuiKey_Escape:
      return "Esc";
    case ImGuiKey_LeftArrow:
      return "←";
    case ImGuiKey_RightArrow:
      return "→";
    case ImGuiKey_UpArrow:
      return "↑";
    case ImGuiKey_DownArrow:
      return "↓";
    default:
      return ImGui::GetKeyName(key);
  }
}

bool in_its_mode(const App& app, const Command& command) {
  return !command.mode || *command.mode == app.view.mode;
}

bool pressed(const Command& command, bool ctrl, bool shift) {
  if (command.ctrl != ctrl) return false;
  const bool other =
      command.other_key != ImGuiKey_None && ImGui::IsKeyPressed(command.other_key, command.repeats);
  return other || (command.key != ImGuiKey_None && (command.any_shift || command.shift == shift) &&
                   ImGui::IsKeyPressed(command.key, command.repeats));
}

}  // namespace

std::string key_words(const Command& command, bool mac) {
  if (command.key == ImGuiKey_None) return "";
  if (command.key_words) return command.key_words;
  std::string text;
  if (command.ctrl) text += mac ? "⌘" : "Ctrl+";
  if (command.shift) text += mac ? "⇧" : "Shift+";
  return text + key_name(command.key);
}

const Command& command(const App& app, std::string_view id) {
  for (const Command& row : app.commands)
    if (row.id == id) return row;
  assert(!"no such command");
  static const Command none{.available = [](const App&) { return false; }};
  return none;
}

bool available(const App& app, const Command& command) {
  return in_its_mode(app, command) && (!command.available || command.available(app));
}

std::string what_it_lacks(const App& app, const Command& command) {
  if (!command.what_it_lacks || app.view.welcome || !in_its_mode(app, command) ||
      available(app, command))
    return "";
  return command.what_it_lacks(app);
}

void perform(App& app, std::string_view id) {
  const Command& row = command(app, id);
  if (available(app, row)) return row.run(app);
  Toast toast;
  toast.words = what_it_lacks(app, row);
  if (!toast.words.empty()) app.say(std::move(toast));
}

std::vector<std::string_view> pressed_commands(const App& app) {
  std::vector<std::string_view> ids;
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantTextInput ||
      ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
    return ids;
  const bool ctrl = io.KeyCtrl || io.KeySuper;
  for (const Command& row : app.commands)
    if (in_its_mode(app, row) && !(row.is_tool && app.view.welcome) &&
        pressed(row, ctrl, io.KeyShift))
      ids.push_back(row.id);
  return ids;
}

}  // namespace artisketch
