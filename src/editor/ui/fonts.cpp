#include "editor/ui/fonts.h"

#include <array>
#include <string_view>

namespace artisketch {

namespace embedded {
extern const std::string_view kInterRegular, kInterSemiBold, kIcons;
}

namespace {

// Dear ImGui asks for the height from ascender to descender: 2478 of Inter's 2048 units.
constexpr float kInterHeight = 2478.0f / 2048;

struct Face {
  const std::string_view* bytes;
  float em;  // points
};
constexpr int kFaces = 7, kIconSizes = 3;
constexpr std::array<Face, kFaces> kFace = {{{&embedded::kInterRegular, 11},
                                             {&embedded::kInterRegular, 12},
                                             {&embedded::kInterRegular, 13},
                                             {&embedded::kInterSemiBold, 13},
                                             {&embedded::kInterSemiBold, 12},
                                             {&embedded::kInterSemiBold, 15},
                                             {&embedded::kInterSemiBold, 24}}};
constexpr std::array<float, kIconSizes> kIconSize = {16, 18, 22};

constexpr ImWchar kLetters[] = {0x20,   0x17F,  0x386,  0x3CE,  0x400,  0x45F,  0x2010,
                                0x2030, 0x20AC, 0x20AC, 0x2190, 0x2193, 0x21E7, 0x21E7,
                                0x2212, 0x2212, 0x2318, 0x2318, 0};
constexpr ImWchar kIconRange[] = {0xF000, 0xF8FF, 0};

std::array<ImFont*, kFaces> faces;
std::array<ImFont*, kIconSizes> icons;
float made_for = 0;

ImFont* add_font(std::string_view bytes, float pixels, const ImWchar* range) {
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.GlyphRanges = range;
  config.OversampleH = 2;
  return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(const_cast<char*>(bytes.data()),
                                                    int(bytes.size()), pixels, &config);
}

}  // namespace

ImFont* font(Font font) {
  return faces[std::size_t(font)];
}
ImFont* icon_font(IconSize size) {
  return icons[std::size_t(size)];
}
float em(Font font) {
  return kFace[std::size_t(font)].em;
}

bool fit_fonts(float pixel_ratio) {
  ImGuiIO& io = ImGui::GetIO();
  io.FontGlobalScale = 1 / pixel_ratio;
  // Another context may share the atlas.
  const bool there = !io.Fonts->Fonts.empty() && io.Fonts->Fonts[0] == faces[0];
  if (there) io.FontDefault = font(Font::body);
  if (there && pixel_ratio == made_for) return false;
  made_for = pixel_ratio;
  io.Fonts->Clear();
  for (int i = 0; i < kFaces; ++i)
    faces[i] = add_font(*kFace[i].bytes, kFace[i].em * kInterHeight * pixel_ratio, kLetters);
  for (int i = 0; i < kIconSizes; ++i)
    icons[i] = add_font(embedded::kIcons, kIconSize[i] * pixel_ratio, kIconRange);
  io.Fonts->Build();
  io.FontDefault = font(Font::body);
  return true;
}

}  // namespace artisketch
