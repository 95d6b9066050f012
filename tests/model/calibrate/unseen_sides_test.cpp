#include "model/calibrate/unseen_sides.h"

#include <gtest/gtest.h>

#include "figures.h"

namespace artisketch {
namespace {

Document drawn(std::initializer_list<double> sides, const figures::Noise& noise = {}) {
  const figures::Figure figure = figures::human(2);
  std::vector<figures::View> views;
  for (const double side : sides)
    views.push_back(figures::view(figure, "view", figures::about_y(side)));
  const Camera camera = figures::fitting_camera(figure, Camera::Type::orthographic, 512, 512);
  return figures::draw(figure, views, camera, 512, 512, noise, 3).truth;
}

TEST(UnseenSides, AFrontAndASideThatAgreeTell) {
  const UnseenSides sides = unseen_sides(drawn({0, 80}));
  EXPECT_EQ(sides.whole, Trust::good);
  for (const PartTrust& part : sides.parts) {
    EXPECT_NEAR(degrees(part.spread), 80, 1);
    EXPECT_LT(part.disagreement, 0.02);
  }
}

// They show every part twice, and fit perfectly.
TEST(UnseenSides, NearAndOppositeViewsLeaveTheDepthToGuess) {
  EXPECT_EQ(unseen_sides(drawn({0})).whole, Trust::guess);
  EXPECT_EQ(unseen_sides(drawn({0, 15})).whole, Trust::guess);
  EXPECT_EQ(unseen_sides(drawn({0, 180})).whole, Trust::guess);
  EXPECT_EQ(unseen_sides(drawn({0, 35})).whole, Trust::doubtful);
}

TEST(UnseenSides, DrawingsThatDisagreeAreDoubted) {
  const UnseenSides sides = unseen_sides(drawn({0, 80}, {.part_size = 0.3, .drawing_size = 0.1}));
  EXPECT_EQ(sides.whole, Trust::doubtful);
}

TEST(UnseenSides, WordsNameThePartsThatDiffer) {
  Document document = drawn({0, 80});
  Frame& side = document.frames[1];
  std::erase_if(side.contours, [&](const Contour& contour) {
    return contour.joint == document.skeleton.find("head");
  });
  const std::string words = unseen_sides_words(document, unseen_sides(document));
  EXPECT_EQ(words, "from sides not drawn: good (guess: head)");
}

}  // namespace
}  // namespace artisketch
