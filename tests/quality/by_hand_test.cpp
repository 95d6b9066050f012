#include "quality/by_hand.h"

#include <gtest/gtest.h>

namespace artisketch::quality {
namespace {

// Where joints lie as well as a hand puts them, silhouettes say little of what it could not see:
// meeting them more closely must not make a worse body.
TEST(PosesByHand, CalibrationDoesNotHarmUnseenSides) {
  PipelineOptions pipeline;
  pipeline.grid = 32;
  const ByHandCell cell = by_hand_cell(
      3, {.bone_error = 0.05, .place_error_px = 5, .twist_degrees = 20}, 0.1, 2, pipeline);
  EXPECT_GE(cell.novel[0], cell.novel[1]);
  EXPECT_GE(cell.volume[0], cell.volume[1]);
  EXPECT_LE(cell.after.joint_px, cell.before.joint_px);
}

}  // namespace
}  // namespace artisketch::quality
