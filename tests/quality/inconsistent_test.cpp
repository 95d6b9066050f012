#include "quality/inconsistent.h"

#include <gtest/gtest.h>

namespace artisketch::quality {
namespace {

constexpr double kWorse = 0.01;  // of a silhouette: what the poses given may be better by

// Turning bones cannot explain that a part is drawn longer here and wider there: where that is all
// that may move, a closer fit to the drawings is a worse body from every other side.
TEST(InconsistentDrawings, CalibrationDoesNotHarmUnseenSides) {
  PipelineOptions pipeline;
  pipeline.grid = 32;
  const InconsistentCell cell = inconsistent_cell(2, 60, 10, 1, false, pipeline);
  EXPECT_GE(cell.novel[0], cell.novel[1] - kWorse);
  EXPECT_LT(cell.after.joint_px, cell.before.joint_px);
}

}  // namespace
}  // namespace artisketch::quality
