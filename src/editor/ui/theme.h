// Colours and measures of the whole editor (EDITOR.md, "Theme").
#pragma once

#include <imgui.h>

namespace artisketch {

// Packed as Dear ImGui wants them.
struct Theme {
  ImU32 canvas, panel, raised, control, hover, line;
  ImU32 text, muted, disabled;
  ImU32 accent, on_accent, selection, warning, error;
  ImU32 paper_tint;   // multiplies the drawings
  ImU32 dark_ground;  // behind pale figures, instead of paper
  bool dark;
};
const Theme& dark_theme();
const Theme& light_theme();

// The theme of the frame that is being drawn.
const Theme& theme();
void use_theme(const Theme& theme);

ImU32 rgb(unsigned rrggbb, float alpha = 1);
ImU32 faded(ImU32 colour, float alpha);  // times its own alpha
ImU32 mixed(ImU32 a, ImU32 b, float t);

ImU32 joint_tint(int joint, float alpha = 1);  // the palette's

inline constexpr float kRadiusSmall = 4, kRadius = 6, kRadiusCard = 8, kRadiusPanel = 10;

}  // namespace artisketch
