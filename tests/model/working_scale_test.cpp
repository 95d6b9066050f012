#include "model/working_scale.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "base/raster.h"
#include "figures.h"

namespace artisketch {
namespace {

// Two drawings of a figure, so small that a limb is a few pixels wide.
Document small_drawings() {
  const figures::Figure figure = figures::human(1);
  constexpr int kSize = 96;
  const Camera camera = figures::fitting_camera(figure, Camera::Type::orthographic, kSize, kSize);
  return figures::draw(figure, figures::random_views(figure, 2, 1), camera, kSize, kSize).truth;
}

// Columns of red and blue.
Image stripes(int width, int height) {
  Image picture(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::uint8_t* p = picture.at(x, y);
      p[0] = x % 4 < 2 ? 255 : 0, p[1] = 40, p[2] = x % 4 < 2 ? 0 : 255;
    }
  return picture;
}

TEST(WorkingScale, EnlargesSmallFiguresByAPowerOfTwo) {
  const Document document = small_drawings();
  const double times = working_scale(document);
  EXPECT_EQ(times, 4);
  EXPECT_EQ(working_scale(scaled(document, 2)), 2);
  EXPECT_EQ(working_scale(scaled(document, 4)), 1);
  EXPECT_EQ(working_scale(scaled(document, 8)), 1);
  EXPECT_EQ(working_scale({}), 1);
}

TEST(WorkingScale, ShapesAreTakenFromOneOctaveOfSizes) {
  const Document document = small_drawings();
  const double times = shape_scale(document);
  EXPECT_EQ(std::exp2(std::round(std::log2(times))), times);
  double largest = 0;
  for (const Frame& frame : document.frames) {
    Box2 box;
    for (const Contour& contour : frame.contours)
      for (const Vec2& p : contour.line.points) box.extend(p);
    largest = std::max(largest, box.sizes().maxCoeff());
  }
  EXPECT_GE(times * largest, kShapeSize);
  EXPECT_LT(times * largest, 2 * kShapeSize);
  for (const double by : {0.5, 2.0, 8.0, 64.0})
    EXPECT_EQ(shape_scale(scaled(document, by)), times / by);
  EXPECT_EQ(shape_scale({}), 1);
}

TEST(WorkingScale, AnEnlargedDocumentShowsTheSameInMorePixels) {
  const Document document = small_drawings(), large = scaled(document, 4);
  const FrameCamera before = frame_camera(document, 1), after = frame_camera(large, 1);
  const Vec3 X(0.3, 0.8, -0.2);
  EXPECT_LT((4 * before.project(X) - after.project(X)).norm(), 1e-9);
  EXPECT_LT((4 * document.frames[1].contours[2].line.points[3] -
             large.frames[1].contours[2].line.points[3])
                .norm(),
            1e-12);
  const Image picture = stripes(3, 2), twice = scaled(picture, 2);
  ASSERT_EQ(twice.width, 6);
  ASSERT_EQ(twice.height, 4);
  for (int y = 0; y < 4; ++y)
    for (int x = 0; x < 6; ++x)
      for (int c = 0; c < 4; ++c) EXPECT_EQ(twice.at(x, y)[c], picture.at(x / 2, y / 2)[c]);
}

TEST(WorkingScale, ShrinksWhatHoldsMorePixelsThanTheTexture) {
  const Document document = small_drawings();
  double pixels = 0;
  for (const Frame& frame : document.frames)
    for (const Contour& contour : frame.contours) {
      Mask mask(frame.width, frame.height);
      const std::vector<std::vector<Vec2>> polygon = {contour.line.points};
      add_polygons(polygon, mask);
      pixels += double(std::count(mask.in.begin(), mask.in.end(), 1));
    }
  // Halved, it still has as many.
  const double enough = std::sqrt(4 * kEnoughPixels / pixels);
  EXPECT_EQ(working_scale(scaled(document, 0.9 * enough)), 1);
  EXPECT_EQ(working_scale(scaled(document, 1.1 * enough)), 0.5);
  EXPECT_EQ(working_scale(scaled(document, 2.2 * enough)), 0.25);
}

TEST(WorkingScale, AShrunkPictureKeepsItsColoursAndItsPlaces) {
  // What covers nothing has no say in the colour.
  Image picture(5, 3, 0);
  for (int y = 0; y < 2; ++y)
    std::copy_n(std::array<std::uint8_t, 4>{200, 100, 0, 255}.data(), 4, picture.at(0, y));
  for (int y = 0; y < 3; ++y)
    std::copy_n(std::array<std::uint8_t, 4>{10, 20, 30, 255}.data(), 4, picture.at(4, y));
  const Image half = scaled(picture, 0.5);
  ASSERT_EQ(half.width, 3);
  ASSERT_EQ(half.height, 2);
  const auto at = [&](int x, int y) { return std::vector<int>(half.at(x, y), half.at(x, y) + 4); };
  EXPECT_EQ(at(0, 0), (std::vector{200, 100, 0, 128}));
  EXPECT_EQ(at(1, 0), (std::vector{0, 0, 0, 0}));
  EXPECT_EQ(at(2, 1), (std::vector{10, 20, 30, 255}));
  // So it is of what has no clear pixel, to the last one.
  Image opaque(7, 5);
  for (std::size_t i = 0; i < opaque.rgba.size(); ++i)
    if (i % 4 != 3) opaque.rgba[i] = std::uint8_t(i * i * 37);
  const Image quarter = scaled(opaque, 0.25);
  ASSERT_EQ(quarter.width, 2);
  for (int c = 0; c < 3; ++c) {
    int sum = 0;
    for (int y = 0; y < 4; ++y)
      for (int x = 4; x < 7; ++x) sum += opaque.at(x, y)[c];
    EXPECT_EQ(quarter.at(1, 0)[c], (sum + 6) / 12);
  }
  // The document's pixels lie where the picture's do, of odd sizes too.
  Document document = small_drawings();
  document.frames[1].width = 95;
  const Vec3 X(0.3, 0.8, -0.2);
  const Document small = scaled(document, 0.25);
  EXPECT_EQ(small.frames[1].width, 24);
  EXPECT_LT((frame_camera(document, 1).project(X) / 4 - frame_camera(small, 1).project(X)).norm(),
            1e-9);
}

// What is small is not worse: the model is that of the same drawings enlarged, with its colours.
TEST(WorkingScale, DrawingsOfAnySizeGiveTheSameModel) {
  const Document document = small_drawings();
  PipelineOptions options;
  options.grid = 32;
  options.triangles = 3000;
  options.calibrate = false;
  artisketch::Run run;
  std::optional<Model> first;
  for (const int times : {1, 2, 4}) {
    const Document drawn = scaled(document, times);
    const std::vector<Image> drawings(2, scaled(stripes(96, 96), times));
    options.drawings = drawings;
    const Result<Reconstruction> made = reconstruct(drawn, options, run);
    ASSERT_TRUE(made);
    if (!first) {
      first = made->model;
      ASSERT_TRUE(first->texture);
      continue;
    }
    EXPECT_EQ(made->model.mesh.V, first->mesh.V) << times;
    EXPECT_EQ(made->model.texture->rgba, first->texture->rgba) << times;
  }
}

// Drawn larger or smaller by powers of two the same drawings say the same, bit for bit: their poses
// as calibration finds them and all of the surface; and they paint the same shares of it.
TEST(WorkingScale, SizesOfDrawingsChangeNoPoseAndNoSurface) {
  const figures::Figure figure = figures::human(2);
  constexpr int kSize = 96;
  const Camera camera = figures::fitting_camera(figure, Camera::Type::orthographic, kSize, kSize);
  figures::Noise noise;
  noise.pose_error_degrees = 10;
  const Document given =
      figures::draw(figure, figures::random_views(figure, 2, 3), camera, kSize, kSize, noise).given;
  PipelineOptions options;
  options.grid = 24;
  options.triangles = 2000;
  artisketch::Run run;
  std::optional<Reconstruction> first;
  for (const int times : {1, 2, 4}) {
    const Document drawn = scaled(given, times);
    const std::vector<Image> drawings(2, scaled(stripes(kSize, kSize), times));
    options.drawings = drawings;
    Result<Reconstruction> made = reconstruct(drawn, options, run);
    ASSERT_TRUE(made);
    ASSERT_EQ(made->coloured.size(), 2u);
    EXPECT_GT(made->coloured[0] + made->coloured[1], 0.3) << times;
    if (!first) {
      first = std::move(*made);
      continue;
    }
    for (std::size_t p = 0; p < first->parts.size(); ++p)
      EXPECT_EQ(made->parts[p].mesh.V, first->parts[p].mesh.V) << times;
    for (int f = 0; f < 2; ++f) {
      EXPECT_TRUE(same_pose(made->calibrated.frames[f].pose, first->calibrated.frames[f].pose))
          << times;
      EXPECT_NEAR(made->coloured[f], first->coloured[f], 0.05) << times << ", frame " << f;
    }
  }
}

}  // namespace
}  // namespace artisketch
