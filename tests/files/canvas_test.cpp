#include "files/canvas.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace artisketch {
namespace {

const Colour kBlack = colour(0x000000);

// How much ink lies on a white picture, in pixels.
double ink(const Image& image) {
  double sum = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) sum += (255 - image.at(x, y)[0]) / 255.0;
  return sum;
}

TEST(Canvas, ShapesCoverTheirArea) {
  Image disc(100, 100);
  fill_disc(disc, {50.3, 49.8}, 20, kBlack);
  EXPECT_NEAR(ink(disc), kPi * 400, 4);
  Image line(100, 100);
  const Vec2 ends[] = {{20, 30}, {80, 70}};
  draw_line(line, ends, false, 4, kBlack);
  EXPECT_NEAR(ink(line), 4 * std::hypot(60, 40) + kPi * 4, 6);
  Image box(100, 100);
  draw_rectangle(box, Box2(Vec2(10.5, 20), Vec2(60, 40)), 0, 2, kBlack);
  EXPECT_NEAR(ink(box), 2 * 2 * (49.5 + 20), 3);
  Image ring(100, 100);
  const std::vector<std::vector<Vec2>> polygons{{{10, 10}, {90, 10}, {90, 90}, {10, 90}},
                                                {{30, 30}, {70, 30}, {70, 70}, {30, 70}}};
  fill_polygons(ring, polygons, kBlack);
  EXPECT_NEAR(ink(ring), 80 * 80 - 40 * 40, 1);
}

TEST(Canvas, ALineIsOneEvenCoat) {
  Image image(60, 60);
  const Vec2 cross[] = {{10, 10}, {50, 50}, {50, 10}, {10, 50}};
  draw_line(image, cross, true, 6, colour(0x000000, 0.5));
  int darkest = 255;
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 60; ++x) darkest = std::min(darkest, int(image.at(x, y)[0]));
  EXPECT_NEAR(darkest, 128, 1);
}

TEST(Canvas, NothingBreaksOffTheImage) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Image image(20, 20);
  const std::vector<Vec2> wild{{-1e7, 5}, {1e7, 5}, {nan, 3}, {1e300, -1e300}, {4, 4}};
  draw_line(image, wild, true, 2, kBlack);
  const std::vector<std::vector<Vec2>> polygons{wild};
  fill_polygons(image, polygons, kBlack);
  fill_disc(image, {nan, nan}, 5, kBlack);
  draw_dots(image, {-1e6, 10}, {1e6, 10}, 2, 4, kBlack);
  draw_image(image, Image(50, 50), -30, -30);
  draw_text(image, {15, 10}, "far out", {}, kBlack);
  EXPECT_EQ(image.rgba.size(), 20u * 20 * 4);
}

TEST(Canvas, BlendingOverAClearImageKeepsTheColour) {
  Image image(1, 1);
  image.at(0, 0)[3] = 0;
  blend(image, 0, 0, colour(0xFF8000, 0.5), 1);
  EXPECT_EQ(image.at(0, 0)[0], 255);
  EXPECT_EQ(image.at(0, 0)[1], 128);
  EXPECT_EQ(image.at(0, 0)[2], 0);
  EXPECT_EQ(image.at(0, 0)[3], 128);
}

TEST(Canvas, ResizingKeepsTheMean) {
  Image checks(64, 48);
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x)
      for (int c = 0; c < 3; ++c) checks.at(x, y)[c] = (x + y) % 2 ? 255 : 1;
  const Image small = resized(checks, 16, 12);
  EXPECT_EQ(small.width, 16);
  EXPECT_EQ(small.height, 12);
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 16; ++x) EXPECT_NEAR(small.at(x, y)[1], 128, 1);
  // Grown twofold, each pixel is a mix of its neighbours: no value out of their range, ends kept.
  Image ramp(2, 1);
  for (int c = 0; c < 3; ++c) ramp.at(0, 0)[c] = 0;
  const Image wide = resized(ramp, 4, 1);
  EXPECT_EQ(wide.at(0, 0)[0], 0);
  EXPECT_NEAR(wide.at(1, 0)[0], 64, 1);
  EXPECT_NEAR(wide.at(2, 0)[0], 191, 1);
  EXPECT_EQ(wide.at(3, 0)[0], 255);
  EXPECT_EQ(resized(Image(), 4, 4).width, 0);
}

TEST(Canvas, EverySignOfAsciiHasALetterOfItsOwn) {
  std::vector<Image> seen;
  for (char c = 33; c < 127; ++c) {
    Image image(40, 40);
    draw_text(image, {12, 26}, std::string(1, c), {24, false}, kBlack);
    EXPECT_GT(ink(image), 2) << c;
    for (const Image& other : seen) EXPECT_NE(image.rgba, other.rgba) << c;
    seen.push_back(std::move(image));
  }
}

TEST(Canvas, AccentsRideOnTheirLetters) {
  const auto drawn = [](const std::string& text) {
    Image image(40, 40);
    draw_text(image, {12, 26}, text, {24, false}, kBlack);
    return image;
  };
  const Image u = drawn("u"), umlaut = drawn("\xC3\xBC"), other = drawn("\xE8\x8A\xB1");
  EXPECT_GT(ink(umlaut), ink(u));
  EXPECT_EQ(text_width("u", {}), text_width("\xC3\xBC", {}));
  for (int x = 0; x < 40; ++x) EXPECT_EQ(u.at(x, 22)[0], umlaut.at(x, 22)[0]);
  EXPECT_EQ(other.rgba, drawn("\xE2\x98\x83").rgba);  // boxes for what it cannot write
  EXPECT_GT(ink(other), 20);
  for (const char* written : {"\xCE\xA9", "\xD0\x96", "\xC5\x82"}) {  // Ω Ж ł
    EXPECT_NE(drawn(written).rgba, other.rgba) << written;
    EXPECT_GT(ink(drawn(written)), 20) << written;
  }
}

TEST(Canvas, TextEndsWhereItsWidthSays) {
  const Lettering body{13, false};
  Image image(400, 40);
  const double end = draw_text(image, {10, 25}, "Drawing 1", body, kBlack);
  EXPECT_NEAR(end - 10, text_width("Drawing 1", body), 1e-9);
  EXPECT_NEAR(text_width("aa", {26, false}), 2 * text_width("aa", body), 1e-9);
  EXPECT_EQ(text_width("", body), 0);
}

TEST(Canvas, LongTextsAreShortenedWithoutCuttingCharacters) {
  const Lettering body{13, false};
  const std::string name =
      "Bl\xC3\xBC"
      "te \xE8\x8A\xB1 unter dem Hut";
  EXPECT_EQ(shortened(name, body, 1000), name);
  for (double width = 0; width < 150; width += 3) {
    const std::string cut = shortened(name, body, width);
    EXPECT_LE(text_width(cut, body), std::max(width, text_width("\xE2\x80\xA6", body)));
    const std::string kept = cut.substr(0, cut.size() - 3);
    EXPECT_EQ(name.compare(0, kept.size(), kept), 0);
    // The next byte of the name starts a character.
    EXPECT_NE(name[kept.size()] & 0xC0, 0x80);
  }
  Image image(100, 30);
  draw_text(image, {5, 20}, "\xFF\x80\xE2\x82", body, kBlack);  // no UTF-8 at all
  EXPECT_GT(ink(image), 0);
}

}  // namespace
}  // namespace artisketch
