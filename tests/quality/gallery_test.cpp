#include "quality/gallery.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "files/image_file.h"

namespace artisketch::quality {
namespace {

// A floor under what has been reached, on a coarse grid: less than `artisketch_quality --gallery`
// shows, and the same faults.
struct Floor {
  const char* name;
  double novel, volume;    // at least
  double wrong, joint_px;  // at most
};

class Gallery : public testing::TestWithParam<Floor> {};

TEST_P(Gallery, HoldsInPosesThatNobodyDrew) {
  const Floor& floor = GetParam();
  const figures::Example example = figures::example(floor.name);
  const std::string path = std::string(ARTISKETCH_SOURCE_DIR "/assets/gallery/") + floor.name +
                           "/" + floor.name + ".artisketch";
  std::vector<Image> drawings;
  for (const Frame& frame : example.sketches.given.frames) {
    Result<Image> drawing = load_frame_image(frame, path);
    ASSERT_TRUE(drawing.ok()) << drawing.error().text();
    drawings.push_back(std::move(drawing).value());
  }
  GalleryOptions options;
  options.poses = 3;
  options.size = 192;
  options.pipeline.grid = 64;
  options.pipeline.triangles = 6000;
  options.pipeline.drawings = drawings;
  const GalleryCell cell = gallery_cell(example, options);
  EXPECT_GT(cell.novel, floor.novel);
  EXPECT_GT(cell.volume, floor.volume);
  EXPECT_LT(cell.wrong, floor.wrong);
  EXPECT_LT(cell.joint_px, floor.joint_px);
  EXPECT_EQ(cell.folds, 0);
  EXPECT_EQ(cell.genus, 0);
  EXPECT_EQ(cell.components, 1);
}

constexpr Floor kFloors[] = {
    {"prince", 0.95, 0.81, 0.125, 2},      {"horse", 0.91, 0.825, 0.075, 4},
    {"horse-three", 0.94, 0.88, 0.065, 4}, {"ballerina", 0.935, 0.865, 0.046, 1.6},
    {"alien", 0.91, 0.87, 0.025, 1.7},     {"climber", 0.96, 0.925, 0.07, 0.8},
    {"legs", 0.955, 0.925, 0.06, 1.5},     {"parrot", 0.89, 0.8, 0.115, 2.6},
    {"monster", 0.915, 0.845, 0.06, 1e-6}, {"gnome", 0.915, 0.835, 0.075, 1},
    {"knight", 0.93, 0.885, 0.125, 0.6},   {"bear", 0.94, 0.905, 0.02, 2.2},
};
INSTANTIATE_TEST_SUITE_P(Figures, Gallery, testing::ValuesIn(kFloors), [](const auto& info) {
  std::string name = info.param.name;
  name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
  return name;
});

}  // namespace
}  // namespace artisketch::quality
