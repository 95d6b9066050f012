// The letters of canvas.h: a small alphabet of pen strokes, so that pictures carry words without a
// font file.
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <string>

#include "files/canvas.h"

namespace artisketch {
namespace {

// A glyph's strokes: M moves, L draws a line, H a quarter of an ellipse that sets off level, V one
// that sets off upright, Q a parabola by its control point. Baseline 0, small letters 10 high,
// capitals 14, tails to -4.2.
struct Glyph {
  double width;
  const char* path;
};

constexpr double kCapital = 14, kUnitsPerSize = kCapital / 0.72, kGap = 3.7, kSpace = 5;
constexpr Glyph kUnknown = {8, "M0 0L0 14L8 14L8 0L0 0"};

constexpr std::array<Glyph, 95> kAscii = {{
    {kSpace - kGap, ""},
    {0.4, "M.2 14L.2 4.6M.2 .2L.2 .5"},
    {3.4, "M0 14L0 10M3.4 14L3.4 10"},
    {9, "M3.2 14L1.4 0M7.8 14L6 0M.6 9.6L9 9.6M0 4.4L8.4 4.4"},
    {8, "M7.4 10.8Q6.6 12.6 4 12.6H.4 9.6Q.4 7.6 4 6.8Q7.8 6 7.8 3.9V4 1Q.8 1 0 3.4M4 15L4 -1"},
    {12.4,
     "M2.9 14H0 10.8V2.9 7.6H5.8 10.8V2.9 14M10.8 14L1.6 0M9.5 6.4H6.6 3.2V9.5 0H12.4 3.2V9.5 6.4"},
    {9.8, "M9.8 0L2.2 9Q1.4 10 1.4 11.2V4 14H6.6 11.4Q6.6 9.8 3.8 8.2Q0 6.2 0 3.6V3.8 0Q8 0 9 6.6"},
    {0, "M0 14L0 10"},
    {2.6, "M2.6 15.6Q0 12 0 6.2Q0 .4 2.6 -3.2"},
    {2.6, "M0 15.6Q2.6 12 2.6 6.2Q2.6 .4 0 -3.2"},
    {5.6, "M2.8 14L2.8 8M.2 12.5L5.4 9.5M5.4 12.5L.2 9.5"},
    {8, "M4 10L4 2M0 6L8 6"},
    {.8, "M.6 .4L0 -2.6"},
    {4.6, "M0 5.4L4.6 5.4"},
    {.4, "M.2 .2L.2 .5"},
    {5, "M0 -1.4L5 15"},
    {8.6, "M4.3 14H0 7V4.3 0H8.6 7V4.3 14"},
    {4, "M0 11.2L3.8 14L3.8 0"},
    {8.4, "M.2 10.2V4 14H8 10.2Q8 8.2 5.6 5.8L0 0L8.4 0"},
    {8.4, "M.4 11.2Q1.2 14 4 14H7.8 10.7V4 7.4L2.8 7.4M4 7.4H8.4 3.7V4.1 0Q1 0 0 3"},
    {9, "M6.6 0L6.6 14L0 4L9 4"},
    {8.2, "M7.4 14L1.1 14L.5 7.4Q2 8.8 4 8.8H8.2 4.4V4 0Q1 0 0 2.7"},
    {8.4, "M7.6 11.8Q6.6 14 4.5 14H0 6.4L0 4.4V4.2 0H8.4 4.4V4.2 8.7H0 4.4"},
    {8.2, "M0 14L8.2 14L2.6 0"},
    {8.4, "M4.2 7.5H.5 10.7V4.2 14H7.9 10.7V4.2 7.5H0 3.7V4.2 0H8.4 3.7V4.2 7.5"},
    {8.4, "M.8 2.2Q1.8 0 3.9 0H8.4 7.6L8.4 9.6V4.2 14H0 9.6V4.2 5.3H8.4 9.6"},
    {.4, "M.2 .2L.2 .5M.2 8.6L.2 8.9"},
    {.8, "M.6 .4L0 -2.6M.6 8.6L.6 8.9"},
    {7.4, "M7.4 10L0 6L7.4 2"},
    {8, "M0 8L8 8M0 4L8 4"},
    {7.4, "M0 10L7.4 6L0 2"},
    {7.4, "M0 10.8Q.4 14 3.8 14H7.4 10.6Q7.4 8.6 5.4 7.4Q3.6 6.2 3.6 4.4M3.6 .2L3.6 .5"},
    {13,
     "M9.6 6H6.5 2.8M9.6 6V6.5 9.2H3.4 6V6.5 2.8H9.6 6L9.6 5V11.3 2.8H13 7V6.5 13H0 6V6.5 -1L9.4 "
     "-1"},
    {10.4, "M0 0L5.2 14L10.4 0M1.8 4.8L8.6 4.8"},
    {9.2, "M0 0L0 14L5 14H8.6 10.7V5 7.4L0 7.4M5 7.4H9.2 3.7V5 0L0 0"},
    {10.4, "M10.4 10.4Q9 14 5.6 14H0 7V5.6 0Q9 0 10.4 3.6"},
    {10, "M0 0L0 14L4.4 14H10 7V4.4 0L0 0"},
    {8, "M8 14L0 14L0 0L8 0M0 7.3L7.2 7.3"},
    {8, "M8 14L0 14L0 0M0 7.1L7.2 7.1"},
    {10.8, "M10.4 10.6Q9 14 5.7 14H0 7V5.7 0H10.8 5.4L10.8 6.6L6.2 6.6"},
    {9.6, "M0 14L0 0M9.6 14L9.6 0M0 7.2L9.6 7.2"},
    {0, "M0 14L0 0"},
    {6, "M6 14L6 3.8V3 0H0 3.4"},
    {9.4, "M0 14L0 0M9 14L0 5.2M3.4 8.5L9.4 0"},
    {7.6, "M0 14L0 0L7.6 0"},
    {12, "M0 0L0 14L6 3L12 14L12 0"},
    {9.8, "M0 0L0 14L9.8 0L9.8 14"},
    {11.6, "M5.8 14H0 7V5.8 0H11.6 7V5.8 14"},
    {9, "M0 0L0 14L4.8 14H9 10V4.8 6L0 6"},
    {11.6, "M5.8 14H0 7V5.8 0H11.6 7V5.8 14M7 3.6L11 -1"},
    {9.2, "M0 0L0 14L4.8 14H9 10V4.8 6L0 6M4.6 6L9.2 0"},
    {9.2, "M8.7 11.2Q7.6 14 4.6 14H.4 10.5Q.4 8.2 4.7 7.2Q9.2 6.2 9.2 3.6V4.7 0Q1.2 0 0 3"},
    {10, "M0 14L10 14M5 14L5 0"},
    {9.6, "M0 14L0 5V4.8 0H9.6 5L9.6 14"},
    {10.4, "M0 14L5.2 0L10.4 14"},
    {14.8, "M0 14L3.7 0L7.4 14L11.1 0L14.8 14"},
    {9.4, "M0 14L9.4 0M9.4 14L0 0"},
    {9.8, "M0 14L4.9 6.8L9.8 14M4.9 6.8L4.9 0"},
    {9.2, "M0 14L9 14L0 0L9.2 0"},
    {2.6, "M2.6 15.6L0 15.6L0 -3.2L2.6 -3.2"},
    {5, "M0 15L5 -1.4"},
    {2.6, "M0 15.6L2.6 15.6L2.6 -3.2L0 -3.2"},
    {7.4, "M0 8.6L3.7 14L7.4 8.6"},
    {8, "M0 -2.6L8 -2.6"},
    {2.6, "M0 14.4L2.6 12"},
    {7.5, "M.6 7.8V4 10H7.5 6.6L7.5 0M7.5 5.8L3.6 5.8H0 2.9V3.4 0H7.5 3.4"},
    {8, "M0 14.6L0 0M0 5V4 10H8 5V4 0H0 5"},
    {7.4, "M7.4 7.8Q6.2 10 4.1 10H0 5V4.1 0Q6.2 0 7.4 2.2"},
    {8, "M8 14.6L8 0M8 5V4 10H0 5V4 0H8 5"},
    {7.9, "M0 5.2L7.9 5.2V4 10H0 5V4.1 0Q6.3 0 7.5 2"},
    {5, "M5 14.4L4.4 14.4H1.9 11.9L1.9 0M0 10L4.8 10"},
    {8, "M8 10L8 -.5V4 -4.2Q1.6 -4.2 .5 -2.4M8 5V4 10H0 5V4 0H8 5"},
    {7.4, "M0 14.6L0 0M0 6V4 10H7.4 6.2L7.4 0"},
    {.2, "M.1 10L.1 0M.1 13.7L.1 14"},
    {1.9, "M1.8 10L1.8 -1.6V-.6 -4.1M1.8 13.7L1.8 14"},
    {7.2, "M0 14.6L0 0M6.8 10L0 3.6M2.8 6.2L7.2 0"},
    {0, "M0 14.6L0 0"},
    {12.2, "M0 10L0 0M0 6.2V3.3 10H6.1 6.4L6.1 0M6.1 6.2V9.4 10H12.2 6.4L12.2 0"},
    {7.4, "M0 10L0 0M0 6V4 10H7.4 6.2L7.4 0"},
    {8.2, "M4.1 10H0 5V4.1 0H8.2 5V4.1 10"},
    {8, "M0 10L0 -4.2M0 5V4 10H8 5V4 0H0 5"},
    {8, "M8 10L8 -4.2M8 5V4 10H0 5V4 0H8 5"},
    {4.4, "M0 10L0 0M0 6V3.8 10L4.4 10"},
    {6.8, "M6.4 8.1Q5.6 10 3.4 10H.3 7.5Q.3 5.7 3.5 5.1Q6.8 4.5 6.8 2.6V3.5 0Q1 0 0 2.1"},
    {5, "M1.9 13L1.9 2.5V4.2 0L5 0M0 10L5 10"},
    {7.4, "M0 10L0 3.8V3.4 0H7.4 4M7.4 10L7.4 0"},
    {7.6, "M0 10L3.8 0L7.6 10"},
    {11.6, "M0 10L2.9 0L5.8 10L8.7 0L11.6 10"},
    {7.2, "M0 10L7.2 0M7.2 10L0 0"},
    {7.6, "M0 10L3.9 .2M7.6 10L3.3 -2Q2.4 -4.2 .5 -4.2"},
    {7, "M.2 10L6.8 10L0 0L7 0"},
    {3.4, "M3.4 15.6V1.6 11L1.6 9V0 6.2V1.6 3.4L1.6 1.4V3.4 -3.2"},
    {0, "M0 15.6L0 -3.2"},
    {3.4, "M0 15.6V1.8 11L1.8 9V3.4 6.2V1.8 3.4L1.8 1.4V0 -3.2"},
    {8, "M0 5.2Q1 7.4 2.6 7.2Q3.6 7 4.6 6Q5.6 5 6.4 5Q7.4 5 8 7"},
}};

// Accents about x = 0, for letters 10 high.
constexpr const char* kGrave = "M-1.8 14.4L.6 12.2";
constexpr const char* kAcute = "M1.8 14.4L-.6 12.2";
constexpr const char* kCircumflex = "M-2.4 12.2L0 14.4L2.4 12.2";
constexpr const char* kTilde = "M-2.8 12.4Q-1.6 14.6 0 13.4Q1.6 12.2 2.8 14.2";
constexpr const char* kDiaeresis = "M-2.1 13.3L-2.1 13.6M2.1 13.3L2.1 13.6";
constexpr const char* kRing = "M0 15H-1.7 13.4V0 11.8H1.7 13.4V0 15";
constexpr const char* kCedilla = "M0 0L0 -1.4H1.5 -2.8V-.8 -4.2";

// A letter of Latin-1 as a letter of ASCII and its accent, null where it has none.
struct Accented {
  char letter = 0;
  const char* accent = nullptr;
};
Accented accented(unsigned code) {
  if (code < 0xC0 || code > 0xFF) return {};
  constexpr const char* kLetters =
      "AAAAAA\0CEEEEIIII\0NOOOOO\0\0UUUUY\0\0aaaaaa\0ceeeeiiii\0nooooo\0\0uuuuy\0y";
  constexpr const char* kAccents[32] = {
      kGrave,  kAcute, kCircumflex, kTilde,      kDiaeresis,  kRing,  nullptr,     kCedilla,
      kGrave,  kAcute, kCircumflex, kDiaeresis,  kGrave,      kAcute, kCircumflex, kDiaeresis,
      nullptr, kTilde, kGrave,      kAcute,      kCircumflex, kTilde, kDiaeresis,  nullptr,
      nullptr, kGrave, kAcute,      kCircumflex, kDiaeresis,  kAcute, nullptr,     kDiaeresis};
  return {kLetters[code - 0xC0], kAccents[code % 32]};
}

Glyph glyph(unsigned code) {
  if (code >= 32 && code < 127) return kAscii[code - 32];
  if (const Accented a = accented(code); a.letter) {
    if (a.letter == 'i') return {.2, "M.1 10L.1 0"};  // its dot gives way to the accent
    return kAscii[a.letter - 32];
  }
  switch (code) {
    case 0xB7:
      return {.4, "M.2 5.2L.2 5.5"};  // middle dot
    case 0xB0:
      return {3.6, "M1.8 14H0 12.2V1.8 10.4H3.6 12.2V1.8 14"};  // degree
    case 0xB2:
      return {4.4, "M.2 12.6V2.2 14.4H4.2 12.4Q4.2 11.4 3 10.2L0 7.2L4.4 7.2"};
    case 0xD7:
      return {6, "M0 9L6 3M6 9L0 3"};  // times
    case 0x2013:
      return {6.6, "M0 5.4L6.6 5.4"};  // dash
    case 0x2026:
      return {7, "M.2 .2L.2 .5M3.5 .2L3.5 .5M6.8 .2L6.8 .5"};
    case 0x2192:
      return {10, "M0 5.4L10 5.4M6.4 9L10 5.4L6.4 1.8"};
    default:
      return kUnknown;
  }
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

Vec2 bezier(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d, double t) {
  const double s = 1 - t;
  return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
}

// Calls stroke(points) for each stroke of a path, in glyph units.
template <class Stroke>
void for_strokes(const char* path, Stroke&& stroke) {
  constexpr int kSteps = 8;        // chords per curve
  constexpr double kRound = 0.58;  // handle length: 0.55 is an ellipse, more is squarer
  std::vector<Vec2> points;
  const auto number = [&] {
    char* end = nullptr;
    const double value = std::strtod(path, &end);
    path = end;
    return value;
  };
  const auto point = [&] {
    const double x = number();
    return Vec2(x, number());
  };
  const auto curve = [&](const Vec2& b, const Vec2& c, const Vec2& d) {
    const Vec2 a = points.back();
    for (int i = 1; i <= kSteps; ++i) points.push_back(bezier(a, b, c, d, double(i) / kSteps));
  };
  while (*path) {
    const char command = *path++;
    if (command == 'M' && !points.empty()) {
      stroke(points);
      points.clear();
    }
    const Vec2 p = point();
    if (command == 'M' || command == 'L') {
      points.push_back(p);
    } else if (command == 'Q') {
      const Vec2 a = points.back(), end = point();
      curve(a + (p - a) * 2 / 3, end + (p - end) * 2 / 3, end);
    } else {
      const Vec2 a = points.back();
      const Vec2 corner = command == 'H' ? Vec2(p.x(), a.y()) : Vec2(a.x(), p.y());
      curve(a + (corner - a) * kRound, p + (corner - p) * kRound, p);
    }
  }
  if (!points.empty()) stroke(points);
}

}  // namespace

double text_width(std::string_view text, const Lettering& lettering) {
  double units = 0;
  for (std::size_t at = 0; at < text.size();) units += glyph(next_code(text, at)).width + kGap;
  return std::max(units - kGap, 0.0) * lettering.size / kUnitsPerSize;
}

double draw_text(Image& image, const Vec2& baseline, std::string_view text,
                 const Lettering& lettering, const Colour& colour) {
  const double unit = lettering.size / kUnitsPerSize;
  const double pen = lettering.size * (lettering.bold ? 0.135 : 0.095);
  double x = baseline.x();
  for (std::size_t at = 0; at < text.size();) {
    const unsigned code = next_code(text, at);
    const Glyph g = glyph(code);
    const auto draw = [&](const char* path, double right, double up) {
      for_strokes(path, [&](std::vector<Vec2>& points) {
        for (Vec2& p : points)
          p = Vec2(x + (p.x() + right) * unit, baseline.y() - (p.y() + up) * unit);
        draw_line(image, points, false, pen, colour);
      });
    };
    draw(g.path, 0, 0);
    if (const Accented a = accented(code); a.letter && a.accent) {
      const bool low = a.accent == kCedilla, small = a.letter >= 'a';
      draw(a.accent, g.width / 2, small || low ? 0 : kCapital - 10);
    }
    x += (g.width + kGap) * unit;
  }
  return x - kGap * unit;
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
