#include "document/sprite_sheet.h"

#include <gtest/gtest.h>

namespace artisketch {
namespace {

struct Sheet : Image {
  Sheet(int width, int height, bool white) : Image(width, height, white ? 255 : 0) {}
  void fill(const PixelBox& box, std::uint8_t red) {
    for (int y = box.y; y < box.bottom(); ++y)
      for (int x = box.x; x < box.right(); ++x) {
        std::uint8_t* p = at(x, y);
        p[0] = red, p[1] = 40, p[2] = 60, p[3] = 255;
      }
  }
};

TEST(SpriteSheet, IsCutByItsGaps) {
  for (bool white : {false, true}) {
    Sheet sheet(600, 400, white);
    // Two rows of three; one jumps, one has a loose hand, and there is a speck.
    for (int row = 0; row < 2; ++row)
      for (int column = 0; column < 3; ++column)
        sheet.fill({40 + 200 * column, 30 + 190 * row, 90, 140}, std::uint8_t(100 + 50 * row));
    sheet.fill({132, 60, 10, 20}, 200);
    sheet.fill({300, 385, 3, 3}, 90);
    const std::vector<Sprite> sprites = sprites_by_gaps(segmented(sheet));
    ASSERT_EQ(sprites.size(), 6u) << white;
    EXPECT_EQ(sprites[4].column, 1);
    EXPECT_EQ(sprites[4].row, 1);
    EXPECT_NEAR(sprites[4].own.x, 240, 1);
    EXPECT_NEAR(sprites[4].own.bottom(), 360, 1);
    EXPECT_NEAR(sprites[0].own.width, 102, 2);
    for (const Sprite& sprite : sprites) {
      EXPECT_EQ(sprite.drawing.width, sprites[0].drawing.width);
      EXPECT_EQ(sprite.drawing.height, sprites[0].drawing.height);
      EXPECT_GT(sprite.drawing.width, 110);
      const Image cut = cut_out(sheet, sprite);
      EXPECT_EQ(*cut.at(0, 0), white ? 255 : 0);
      EXPECT_EQ(*cut.at(cut.width / 2, cut.height / 2), 100 + 50 * sprite.row);
    }
  }
}

TEST(SpriteSheet, OneFigureOrUnlikeThingsAreNoSheet) {
  Sheet one(300, 300, false);
  one.fill({60, 40, 150, 220}, 100);
  EXPECT_TRUE(sprites_by_gaps(segmented(one)).empty());
  one.fill({260, 40, 30, 100}, 100);
  EXPECT_TRUE(sprites_by_gaps(segmented(one)).empty());
  EXPECT_TRUE(sprites_by_gaps(segmented(Sheet(50, 50, true))).empty());
}

TEST(SpriteSheet, IsCutByAGrid) {
  const std::vector<Sprite> cells = sprites_by_grid(100, 50, 3, 2);
  ASSERT_EQ(cells.size(), 6u);
  EXPECT_EQ(cells[5].own.x, 66);
  EXPECT_EQ(cells[5].own.y, 25);
  EXPECT_EQ(cells[5].drawing.width, 33);
  EXPECT_TRUE(sprites_by_grid(100, 50, 0, 2).empty());
  EXPECT_TRUE(sprites_by_grid(100, 50, 101, 1).empty());
}

}  // namespace
}  // namespace artisketch
