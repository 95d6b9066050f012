#include "figures/ink.h"

#include <set>

#include <gtest/gtest.h>

namespace artisketch::figures {
namespace {

constexpr int kSize = 80;

Image ball_picture(const InkStyle& style = {}) {
  const Figure figure = ball_figure(0.5);
  const FrameCamera camera{{Camera::Type::orthographic, 50}, Vec2(kSize, kSize) / 2, 1};
  return ink_drawing(figure, view(figure, "", Quat::Identity()).pose, camera, kSize, kSize, style);
}

TEST(Ink, ABallIsAnInkedDiscOnATransparentSheet) {
  InkStyle style;
  style.wobble = 0;
  const Image image = ball_picture(style);
  int covered = 0;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) covered += image.at(x, y)[3] > 128;
  // The pen follows the outline: half of its width lies outside.
  EXPECT_NEAR(std::sqrt(covered / kPi), 25 + style.line / 2, 1);
  EXPECT_EQ(image.at(2, 2)[3], 0);
  const std::uint8_t* lit = image.at(kSize / 2 - 6, kSize / 2 - 6);
  EXPECT_EQ(lit[0] << 16 | lit[1] << 8 | lit[2], 0xe8553e);
  const std::uint8_t* line = image.at(kSize / 2, kSize / 2 - 25);
  EXPECT_EQ(unsigned(line[0] << 16 | line[1] << 8 | line[2]), style.ink);
}

TEST(Ink, TheSideAwayFromTheLightIsDarker) {
  const Image image = ball_picture();
  const std::uint8_t *lit = image.at(32, 32), *shade = image.at(54, 54);
  EXPECT_GT(lit[0], shade[0] + 10);
}

TEST(Ink, PixelArtHasFewColoursAndHardEdges) {
  InkStyle style;
  style.medium = InkStyle::Medium::pixels;
  const Image image = ball_picture(style);
  std::set<unsigned> colours;
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const std::uint8_t* p = image.at(x, y);
      EXPECT_TRUE(p[3] == 0 || p[3] == 255);
      if (p[3]) colours.insert(unsigned(p[0]) << 16 | p[1] << 8 | p[2]);
    }
  EXPECT_EQ(colours.size(), 3u) << "its colour, that in shade, the ink";
}

TEST(Ink, PencilIsGreyOnPaper) {
  InkStyle style;
  style.medium = InkStyle::Medium::pencil;
  const Image image = ball_picture(style);
  for (int y = 0; y < kSize; ++y)
    for (int x = 0; x < kSize; ++x) {
      const std::uint8_t* p = image.at(x, y);
      EXPECT_EQ(p[3], 255);
      EXPECT_LE(p[0] - p[2], 5) << "a tone, no colour";
    }
  EXPECT_GT(image.at(2, 2)[0], 240);
  EXPECT_LT(image.at(kSize / 2, kSize / 2)[0], 200);
}

TEST(Ink, TheSameSeedDrawsTheSame) {
  EXPECT_EQ(ball_picture().rgba, ball_picture().rgba);
  InkStyle other;
  other.seed = 2;
  EXPECT_NE(ball_picture().rgba, ball_picture(other).rgba);
}

}  // namespace
}  // namespace artisketch::figures
