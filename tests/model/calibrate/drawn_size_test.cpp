#include "model/calibrate/drawn_size.h"

#include <gtest/gtest.h>

#include "document/edit.h"
#include "figures.h"
#include "model/stages.h"

namespace artisketch {
namespace {

figures::Sketches turned_round(const figures::Noise& noise = {}, int seed = 3) {
  const figures::Figure figure = figures::human(2);
  std::vector<figures::View> views;
  for (const double side : {0, 15, 70, 180})
    views.push_back(figures::view(figure, "view", figures::about_y(side)));
  const Camera camera = figures::fitting_camera(figure, Camera::Type::orthographic, 512, 512);
  return figures::draw(figure, views, camera, 512, 512, noise, seed);
}

void enlarge(Frame& frame, double factor) {
  const Vec2 middle = Vec2(frame.width, frame.height) / 2;
  for (Contour& contour : frame.contours)
    for (Vec2& p : contour.line.points) p = middle + factor * (p - middle);
}

std::vector<DrawnSize> sizes_of(const Document& document) {
  std::vector<Pose> poses;
  std::vector<double> scales;
  for (const Frame& frame : document.frames) {
    poses.push_back(frame.pose);
    scales.push_back(frame.scale);
  }
  return drawn_sizes(RayResiduals(document, 3, 32), placed(document, poses, scales));
}

std::string size_line(const Document& document) {
  artisketch::Run run;
  const auto found = calibrate(document, {Method::rays}, run);
  EXPECT_TRUE(found);
  std::string lines;
  for (const std::string& line : found->warnings)
    if (line.find("seems drawn") != std::string::npos) lines += line + "\n";
  return lines;
}

TEST(DrawnSizes, DrawingsOfOneSizeAreOfOneSize) {
  for (const DrawnSize& size : sizes_of(turned_round().truth)) {
    EXPECT_NEAR(size.factor, 1, 0.01);
    EXPECT_FALSE(size.differs());
  }
}

// From near the first drawing's side, from aside, and from behind.
TEST(DrawnSizes, OneDrawnLargerIsFoundFromAnySide) {
  for (const int frame : {1, 2, 3})
    for (const double factor : {0.7, 1.2}) {
      Document document = turned_round().truth;
      enlarge(document.frames[frame], factor);
      const std::vector<DrawnSize> sizes = sizes_of(document);
      for (int f = 0; f < 4; ++f) {
        EXPECT_NEAR(sizes[f].factor, f == frame ? factor : 1, 0.02) << frame << ' ' << f;
        EXPECT_EQ(sizes[f].differs(), f == frame) << frame << ' ' << f;
      }
      document.frames[frame].scale = factor;
      EXPECT_FALSE(sizes_of(document)[frame].differs()) << frame;
    }
}

// A hand that draws parts longer here and wider there, and poses that are guessed, don't make the
// whole larger.
TEST(DrawnSizes, PartsThatDifferEachItsOwnWaySayNothingOfTheWhole) {
  const figures::Noise inexact{.pose_error_degrees = 10, .root_error = 0.02, .part_size = 0.1};
  for (int seed = 1; seed <= 6; ++seed)
    for (const DrawnSize& size : sizes_of(turned_round(inexact, seed).given))
      EXPECT_FALSE(size.differs()) << seed << ' ' << size.factor << " ± " << size.error;
}

TEST(DrawnSizes, TheScaleThatIsOfferedMakesUpForIt) {
  Document document = turned_round().given;
  EXPECT_EQ(offered_scales(document), std::vector<double>(4, 1.0));
  enlarge(document.frames[2], 1.25);
  const std::vector<double> scales = offered_scales(document);
  EXPECT_NEAR(scales[2], 1.25, 0.04);
  document = with_frame_scale(document, 2, scales[2]);
  EXPECT_EQ(offered_scales(document)[2], scales[2]) << "and nothing more is offered";
}

TEST(DrawnSizes, CalibrationOffersTheScaleThatMakesUpForIt) {
  Document document = turned_round({.pose_error_degrees = 6}).given;
  EXPECT_EQ(size_line(document), "");
  document.frames[2].name = "side";
  enlarge(document.frames[2], 1.25);
  const std::string line = size_line(document);
  EXPECT_NE(line.find("frame 3 'side' seems drawn 2"), std::string::npos) << line;
  EXPECT_NE(line.find("with frames[2].scale at 1.2"), std::string::npos) << line;
}

}  // namespace
}  // namespace artisketch
