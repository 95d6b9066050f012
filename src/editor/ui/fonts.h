// Inter and the icons, rasterised for the screen's pixel ratio.
#pragma once

#include <imgui.h>

namespace artisketch {

enum class Font {
  small,
  caption,
  body,
  body_bold,
  caption_bold,
  title,
  headline
};                                             // 11 12 13 13 12 15 24
enum class IconSize { small, normal, large };  // 16, 18, 22 px

ImFont* font(Font font);
ImFont* icon_font(IconSize size);
float em(Font font);  // its size in points

// Makes the fonts anew where the pixel ratio changed; before ImGui::NewFrame. True if it did: the
// graphics back end then has to make its texture again.
bool fit_fonts(float pixel_ratio);

}  // namespace artisketch
