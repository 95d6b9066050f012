#include "quality/baselines.h"

#include <gtest/gtest.h>

namespace artisketch::quality {
namespace {

BaselineOptions quick() {
  BaselineOptions options;
  options.figures = 1;
  options.pipeline.grid = 40;
  options.pipeline.triangles = 3000;
  options.pipeline.calibrate = false;
  return options;
}

// A second drawing from nearly the same side, or from behind, tells little; it must not make the
// body worse, nor may a third.
TEST(Baselines, NoFurtherDrawingMakesABodyWorse) {
  constexpr double kSlack = 0.005;
  const BaselineCell one = baseline_cell(1, 0, quick());
  EXPECT_GT(one.novel, 0.8);
  for (const double baseline : {15.0, 180.0}) {
    const BaselineCell two = baseline_cell(2, baseline, quick());
    EXPECT_GT(two.novel, one.novel - kSlack) << baseline;
    EXPECT_GT(two.depth, 0.7) << baseline;
    EXPECT_LT(two.deepest, 2) << baseline;
  }
  const BaselineCell two = baseline_cell(2, 30, quick()), three = baseline_cell(3, 30, quick());
  EXPECT_GT(two.novel, one.novel);
  EXPECT_GT(three.novel, two.novel - kSlack);
}

}  // namespace
}  // namespace artisketch::quality
