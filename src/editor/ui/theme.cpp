#include "editor/ui/theme.h"

#include "files/marks.h"

namespace artisketch {

ImU32 rgb(unsigned rrggbb, float alpha) {
  return IM_COL32(rrggbb >> 16 & 255, rrggbb >> 8 & 255, rrggbb & 255, int(alpha * 255 + 0.5f));
}

ImU32 faded(ImU32 colour, float alpha) {
  const float own = float(colour >> IM_COL32_A_SHIFT & 255);
  return (colour & ~IM_COL32_A_MASK) | ImU32(own * alpha + 0.5f) << IM_COL32_A_SHIFT;
}

ImU32 mixed(ImU32 a, ImU32 b, float t) {
  ImU32 result = 0;
  for (int shift = 0; shift < 32; shift += 8) {
    const float x = float(a >> shift & 255), y = float(b >> shift & 255);
    result |= ImU32(x + (y - x) * t + 0.5f) << shift;
  }
  return result;
}

const Theme& dark_theme() {
  static const Theme dark = {
      .canvas = rgb(0x17191D),
      .panel = rgb(0x1F2227),
      .raised = rgb(0x292D33),
      .control = rgb(0x2E3239),
      .hover = rgb(0x3A4048),
      .line = rgb(0x343940),
      .text = rgb(0xE8EAED),
      .muted = rgb(0xA3A9B2),
      .disabled = rgb(0x6E757F),
      .accent = rgb(0x4FD1B5),
      .on_accent = rgb(0x0B241E),
      .selection = rgb(0x25403B),
      .warning = rgb(0xF5B942),
      .error = rgb(0xFF7A6B),
      .paper_tint = rgb(0xDDE0E5),
      .dark_ground = rgb(0x7C8590),
      .dark = true,
  };
  return dark;
}

const Theme& light_theme() {
  static const Theme light = {
      .canvas = rgb(0xDFE2E6),
      .panel = rgb(0xF5F6F8),
      .raised = rgb(0xFFFFFF),
      .control = rgb(0xE8EAEE),
      .hover = rgb(0xDCDFE4),
      .line = rgb(0xD2D6DC),
      .text = rgb(0x1C2025),
      .muted = rgb(0x59616B),
      .disabled = rgb(0x949BA5),
      .accent = rgb(0x0B7F6B),
      .on_accent = rgb(0xFFFFFF),
      .selection = rgb(0xD3EBE5),
      .warning = rgb(0x8A5A00),
      .error = rgb(0xBF2F1F),
      .paper_tint = rgb(0xFFFFFF),
      .dark_ground = rgb(0x7C8590),
      .dark = false,
  };
  return light;
}

namespace {
const Theme* current = &dark_theme();
}

const Theme& theme() {
  return *current;
}
void use_theme(const Theme& theme) {
  current = &theme;
}

ImU32 joint_tint(int joint, float alpha) {
  return rgb(joint_colour(joint), alpha);
}

}  // namespace artisketch
