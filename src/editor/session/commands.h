// Everything that a key, a menu or a button can ask for, in one table: its words, icon and key.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <imgui.h>

namespace artisketch {

enum class Command {
  none,
  new_document,
  open,
  save,
  save_as,
  add_drawings,
  blank_drawing,
  export_model,
  undo,
  redo,
  reconstruct,
  calibrate,
  cancel_job,
  mode_outline,
  mode_skeleton,
  mode_pose,
  mode_result,
  previous_drawing,
  next_drawing,
  show_drawing,
  show_bones,
  show_model,
  fit,
  home,
  zoom_in,
  zoom_out,
  play,
  fade,
  theme,
  help,
  tool_edit,
  tool_draw,
  tool_points,
  tool_trace,
  tool_cut,
  mirror,
  copy_to,
  behind,
  in_front,
  remove,
  redraw,
  other_joint,
  join,
  mend,
  hidden_here,
  both_sides,
  equalise,
  rename,
  tool_pose,
  flip,
  tool_twist,
  tool_turn,
  lock,
  copy_pose,
  suggest,
  tool_orbit,
  tool_joints,
  tool_fatness,
  set_key,
  new_clip,
  reset,
};

struct CommandWords {
  Command command;
  const char* name;
  const char* icon;  // null: none
  ImGuiKey key = ImGuiKey_None;
  bool ctrl = false, shift = false;
  const char* hint = nullptr;  // in place of the name, where that says too little
};

std::span<const CommandWords> all_commands();
const CommandWords& words_of(Command command);
std::string key_words(const CommandWords& words, bool mac);  // "Ctrl+Shift+Z"; empty without a key

// The commands whose keys went down in this frame. None while a text field has the keyboard.
std::vector<Command> pressed_commands();

}  // namespace artisketch
