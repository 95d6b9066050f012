#include "files/palette.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace artisketch {
namespace {

void paint(Image& image, int x, int y, Rgb colour) {
  std::uint8_t* p = image.at(x, y);
  p[0] = std::uint8_t(colour >> 16), p[1] = std::uint8_t(colour >> 8), p[2] = std::uint8_t(colour);
  p[3] = 255;
}

// Red left, green right, and between them a column of their mixture.
Image two_colours(int side) {
  Image image(side, side, 0);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      paint(image, x, y, x < side / 2 ? 0xd02020u : x == side / 2 ? 0xd12121u : 0x20a040u);
  return image;
}

TEST(Palette, HasTheCommonestColoursAndNoneThatIsNearOne) {
  EXPECT_EQ(palette_of(two_colours(40)), (std::vector<Rgb>{0xd02020u, 0x20a040u}));
  EXPECT_TRUE(palette_of(Image(8, 8, 0)).empty());  // nothing is opaque
}

TEST(Palette, EveryPixelIsOneColourOfItOrClear) {
  Image image = two_colours(12);
  for (int y = 0; y < 12; ++y)
    for (int x = 0; x < 4; ++x)
      image.at(x, y)[3] = x < 2 ? 0 : 255;  // two of three columns are clear
  const Image small = in_pixels(image, 3, 2, {0xc01010u, 0x10b030u});
  ASSERT_EQ(small.width, 8);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const std::uint8_t* p = small.at(x, y);
      EXPECT_EQ(p[3], x < 2 ? 0 : 255);
      if (x >= 2) {
        EXPECT_EQ(p[0], x < 4 ? 0xc0 : 0x10) << x;
      }
      EXPECT_TRUE(std::equal(p, p + 4, small.at(x / 2 * 2, y / 2 * 2)));
    }
}

}  // namespace
}  // namespace artisketch
