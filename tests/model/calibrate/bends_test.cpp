#include "model/calibrate/bends.h"

#include <gtest/gtest.h>

#include "document/edit.h"
#include "figures.h"

namespace artisketch {
namespace {

// A limb 200 pixels long and 30 wide, bent in its middle by so many degrees toward +x (up in the
// picture is along it), drawn about (200, 200).
Polyline bent_limb(double angle) {
  const double half = radians(angle) / 2;
  const Vec2 up(std::sin(half), -std::cos(half)), down(std::sin(half), std::cos(half));
  const Vec2 middle(200, 200), aside(15, 0);
  Polyline line;
  line.closed = true;
  line.points = {middle - aside, middle - aside + 100 * up,   middle + aside + 100 * up,
                 middle + aside, middle + aside + 100 * down, middle - aside + 100 * down};
  return line;
}

// A drawing of it for each pair of an angle and the side that it is seen from, in degrees.
Document limb_drawn(const std::vector<std::pair<double, double>>& drawings) {
  Document document;
  document.camera.pixels_per_unit = 100;
  document.skeleton.joints = {{"arm", -1, {0, 0, 0}, -1, ""}, {"tip", 0, {0, 1, 0}, -1, ""}};
  for (const auto& [angle, side] : drawings) {
    Frame frame;
    frame.width = frame.height = 400;
    frame.pose = rest_pose(document.skeleton);
    frame.pose.rotations[0] = Quat(Eigen::AngleAxisd(radians(side), Vec3::UnitY()));
    frame.contours.push_back({0, bent_limb(angle), ""});
    document.frames.push_back(std::move(frame));
  }
  return document;
}

std::vector<Bend> bends_in(const Document& document) {
  return bends_of(parts_of(document));
}

TEST(Bends, APartThatBendsFromDrawingToDrawingIsNamed) {
  const Document document = limb_drawn({{0, 0}, {70, 15}, {5, 80}});
  const std::vector<Bend> bends = bends_in(document);
  ASSERT_EQ(bends.size(), 1u);
  EXPECT_EQ(bends[0].joint, 0);
  EXPECT_EQ(bends[0].bent, 1);
  EXPECT_EQ(bends[0].straighter, 0);
  EXPECT_NEAR(degrees(bends[0].angle), 70, 15);
  const std::string words = bend_words(document, bends[0]);
  EXPECT_NE(words.find("'arm' is bent"), words.npos) << words;
  EXPECT_NE(words.find("Split it at a joint"), words.npos) << words;
}

TEST(Bends, ABentPartThatStaysAsItIsIsNot) {
  EXPECT_TRUE(bends_in(limb_drawn({{60, 0}, {55, 20}})).empty());
  EXPECT_TRUE(bends_in(limb_drawn({{60, 0}, {-60, 180}})).empty()) << "from behind";
  EXPECT_TRUE(bends_in(limb_drawn({{60, 0}, {0, 90}})).empty())
      << "from its side it looks straight";
}

TEST(Bends, FiguresOfRigidPartsHaveNone) {
  for (int seed = 0; seed < 4; ++seed)
    for (const figures::Figure& figure :
         {figures::human(seed), figures::quadruped(seed), figures::fox()}) {
      const Camera fitting = figures::fitting_camera(figure, Camera::Type::orthographic, 400, 400);
      figures::Noise noise;
      noise.pose_error_degrees = 10;
      noise.contour_wobble_px = 1;
      const Document given =
          figures::draw(figure, figures::random_views(figure, 4, seed), fitting, 400, 400, noise)
              .given;
      EXPECT_TRUE(bends_in(given).empty()) << seed;
    }
}

}  // namespace
}  // namespace artisketch
