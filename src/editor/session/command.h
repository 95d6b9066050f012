// A command: everything that a key, a menu, a button or a script can ask for is one row, and all of
// them run it the one way, perform().
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "editor/session/view.h"

namespace artisketch {

struct App;

struct Command {
  std::string id = "";
  const char* name = "";
  const char* icon = nullptr;   // null: none
  const char* about = nullptr;  // in place of the name, where that says too little
  ImGuiKey key = ImGuiKey_None;
  bool ctrl = false, shift = false;
  bool any_shift = false;                   // '+' needs Shift on many keyboards
  ImGuiKey other_key = ImGuiKey_None;       // does the same, with Shift or without
  bool repeats = false;                     // while its key is held
  const char* key_words = nullptr;          // in place of the key's own
  std::optional<Mode> mode = std::nullopt;  // none: in all of them
  bool is_tool = false;                     // takes up a tool of the mode
  bool in_rail = false, in_menu = false;  // beside the mode's tools; over what a right click chose

  bool (*available)(const App&) = nullptr;             // null: always
  std::string (*what_it_lacks)(const App&) = nullptr;  // where a person may wonder
  std::function<bool(const App&)> on = nullptr;        // pressed in; null: never
  std::function<void(App&)> run = nullptr;
};

// Where the shortcut's keys are named as on that machine: "Ctrl+Shift+Z"; empty without a key.
std::string key_words(const Command& command, bool mac);

// The row of that id. Of one that is not in the table: a row that can't be asked for.
const Command& command(const App& app, std::string_view id);
bool available(const App& app, const Command& command);
// What a command waits for, where a person may wonder; else empty.
std::string what_it_lacks(const App& app, const Command& command);
inline bool available(const App& app, std::string_view id) {
  return available(app, command(app, id));
}

// Does it, or says what it lacks.
void perform(App& app, std::string_view id);

// The commands whose keys went down in this frame. None while a text field or an open menu has the
// keyboard.
std::vector<std::string_view> pressed_commands(const App& app);

}  // namespace artisketch
