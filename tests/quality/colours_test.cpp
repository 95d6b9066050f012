#include "quality/colours.h"

#include <gtest/gtest.h>

namespace artisketch::quality {
namespace {

// A floor under what has been reached, from three drawings in the true poses: less detail than
// `artisketch_quality --colours` shows, and the same faults.
TEST(Colours, HoldInPosesThatNobodyDrew) {
  ColourOptions options;
  options.size = 224;
  options.poses = 3;
  options.pipeline.grid = 40;
  options.pipeline.triangles = 4000;
  options.pipeline.calibrate = false;
  constexpr double kMostWrong = 0.072, kMostWrongAsDrawn = 0.07;
  for (const figures::Figure& figure : {figures::robot(3)}) {
    const ColourCell cell = colour_cell(figure, 3, 1, options);
    EXPECT_LT(cell.wrong, kMostWrong) << figure.name;
    EXPECT_LT(cell.drawn_wrong, kMostWrongAsDrawn) << figure.name;
  }
}

}  // namespace
}  // namespace artisketch::quality
