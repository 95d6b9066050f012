// The letters of canvas.h: Inter, through stb_truetype.
#include <algorithm>
#include <cmath>
#include <string>

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb/stb_truetype.h>

#include "files/canvas.h"

namespace artisketch {

namespace embedded {
extern const std::string_view kInterRegular, kInterSemiBold;
}

namespace {

struct Face {
  stbtt_fontinfo info;
  explicit Face(std::string_view bytes) {
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    stbtt_InitFont(&info, data, stbtt_GetFontOffsetForIndex(data, 0));
  }
};

const stbtt_fontinfo& face(const Lettering& lettering) {
  static const Face regular(embedded::kInterRegular), semi_bold(embedded::kInterSemiBold);
  return lettering.bold ? semi_bold.info : regular.info;
}

double scale(const Lettering& lettering) {
  return stbtt_ScaleForMappingEmToPixels(&face(lettering), float(lettering.size));
}

// The next character of a UTF-8 text; bytes that are none count as unknown characters.
unsigned next_code(std::string_view text, std::size_t& at) {
  const auto byte = [&](std::size_t i) { return unsigned(static_cast<unsigned char>(text[i])); };
  const unsigned lead = byte(at++);
  const int more = lead < 0xC0 ? 0 : lead < 0xE0 ? 1 : lead < 0xF0 ? 2 : 3;
  unsigned code = more == 0 ? lead : lead & (0x3Fu >> more);
  for (int k = 0; k < more && at < text.size() && (byte(at) & 0xC0) == 0x80; ++k)
    code = code << 6 | (byte(at++) & 0x3F);
  return lead < 0x80 || lead >= 0xC0 ? code : 0;
}

double advance(const stbtt_fontinfo& font, int glyph) {
  int width = 0, bearing = 0;
  stbtt_GetGlyphHMetrics(&font, glyph, &width, &bearing);
  return width;
}

// Lays a glyph's coverage on the image, its origin at `at`.
void draw_glyph(Image& image, const stbtt_fontinfo& font, int glyph, double scale, const Vec2& at,
                const Colour& colour) {
  if (!(at.cwiseAbs().maxCoeff() < 1e6)) return;  // far off any image, or nowhere
  const Vec2 whole = at.array().floor(), part = at - whole;
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  const float s = float(scale), right = float(part.x()), down = float(part.y());
  stbtt_GetGlyphBitmapBoxSubpixel(&font, glyph, s, s, right, down, &x0, &y0, &x1, &y1);
  const int width = x1 - x0, height = y1 - y0;
  if (width <= 0 || height <= 0) return;
  std::vector<unsigned char> covered(std::size_t(width) * height);
  stbtt_MakeGlyphBitmapSubpixel(&font, covered.data(), width, height, width, s, s, right, down,
                                glyph);
  const int left = int(whole.x()) + x0, top = int(whole.y()) + y0;
  for (int y = std::max(0, -top); y < std::min(height, image.height - top); ++y)
    for (int x = std::max(0, -left); x < std::min(width, image.width - left); ++x)
      if (const int c = covered[std::size_t(y) * width + x])
        blend(image, left + x, top + y, colour, c / 255.0);
}

}  // namespace

double text_width(std::string_view text, const Lettering& lettering) {
  const stbtt_fontinfo& font = face(lettering);
  double units = 0;
  for (std::size_t at = 0; at < text.size();)
    units += advance(font, stbtt_FindGlyphIndex(&font, int(next_code(text, at))));
  return units * scale(lettering);
}

double draw_text(Image& image, const Vec2& baseline, std::string_view text,
                 const Lettering& lettering, const Colour& colour) {
  const stbtt_fontinfo& font = face(lettering);
  const double unit = scale(lettering);
  double units = 0;
  for (std::size_t at = 0; at < text.size();) {
    const int glyph = stbtt_FindGlyphIndex(&font, int(next_code(text, at)));
    draw_glyph(image, font, glyph, unit, baseline + Vec2(units * unit, 0), colour);
    units += advance(font, glyph);
  }
  return baseline.x() + units * unit;
}

std::string shortened(std::string_view text, const Lettering& lettering, double width) {
  if (text_width(text, lettering) <= width) return std::string(text);
  const std::string ellipsis = "\xE2\x80\xA6";
  std::string kept;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t start = at;
    next_code(text, at);
    std::string longer = kept;
    longer += text.substr(start, at - start);
    if (text_width(longer + ellipsis, lettering) > width) break;
    kept = std::move(longer);
  }
  return kept + ellipsis;
}

}  // namespace artisketch
