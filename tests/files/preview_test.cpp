#include "files/preview.h"

#include <cmath>

#include <gtest/gtest.h>

#include "files/marks.h"

namespace artisketch {
namespace {

constexpr double kRadius = 0.35, kScale = 100;
constexpr int kWidth = 320, kHeight = 240, kSheetWidth = 560;

// Three balls in a row along x, one joint each, and a drawing of them per frame.
struct Row {
  Document document;
  Reconstruction result;

  explicit Row(int frames) {
    document.name = "row";
    document.camera.pixels_per_unit = kScale;
    for (int j = 0; j < 3; ++j)
      document.skeleton.joints.push_back(
          {"ball " + std::to_string(j), j - 1, Vec3(j ? 0.6 : -0.6, 0, 0), -1, ""});
    Model& model = result.model;
    model.name = document.name;
    model.skeleton = document.skeleton;
    const std::vector<Vec3> rest = rest_positions(document.skeleton);
    for (int j = 0; j < 3; ++j) add_ball(model, rest[j], j);
    for (int f = 0; f < frames; ++f) add_frame(f);
    result.calibrated = document;
    Clip clip{"frames", {}, {}};
    for (const Frame& frame : document.frames) {
      clip.times.push_back(double(clip.times.size()));
      clip.poses.push_back(frame.pose);
    }
    model.clips.push_back(clip);
    result.fits = measure_fit(document, model, {});
  }

  static void add_ball(Model& model, const Vec3& centre, int joint) {
    const Mesh ball = icosphere(centre, kRadius, 3);
    const auto v = model.mesh.V.rows(), f = model.mesh.F.rows();
    model.mesh.V.conservativeResize(v + ball.V.rows(), 3);
    model.mesh.V.bottomRows(ball.V.rows()) = ball.V;
    model.mesh.F.conservativeResize(f + ball.F.rows(), 3);
    model.mesh.F.bottomRows(ball.F.rows()) = ball.F.array() + int(v);
    model.weights.joints.conservativeResize(v + ball.V.rows(), 4);
    model.weights.weights.conservativeResize(v + ball.V.rows(), 4);
    for (auto i = v; i < model.mesh.V.rows(); ++i) {
      model.weights.joints.row(i) << joint, 0, 0, 0;
      model.weights.weights.row(i) << 1, 0, 0, 0;
    }
  }

  void add_frame(int f) {
    Frame frame;
    frame.name = "view " + std::to_string(f);
    frame.width = kWidth;
    frame.height = kHeight;
    frame.pose = rest_pose(document.skeleton);
    frame.pose.rotations[1] = Quat(Eigen::AngleAxisd(0.4 * f, Vec3::UnitZ()));
    const auto joints = posed_joints(document.skeleton, frame.pose);
    for (int j = 0; j < 3; ++j) {
      Contour contour{j, {}, ""};
      const Vec3 X = joints[j].translation();
      for (int i = 0; i < 60; ++i)
        contour.line.points.emplace_back(
            kWidth / 2 + kScale * (X.x() + kRadius * std::cos(2 * kPi * i / 60)),
            kHeight / 2 - kScale * (X.y() + kRadius * std::sin(2 * kPi * i / 60)));
      frame.contours.push_back(contour);
    }
    document.frames.push_back(std::move(frame));
  }
};

// Pixels that differ from the picture of nothing.
int changed(const Image& image, const Image& blank) {
  int count = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    count +=
        std::abs(image.rgba[i] - blank.rgba[i]) + std::abs(image.rgba[i + 2] - blank.rgba[i + 2]) >
        40;
  return count;
}

RenderOptions small() {
  RenderOptions options;
  options.width = 160;
  options.height = 120;
  return options;
}

TEST(Preview, AModelWithoutFacesIsABlankPicture) {
  const Image image = render_model(Model(), small());
  EXPECT_EQ(image.width, 160);
  EXPECT_EQ(image.height, 120);
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 160; ++x) {
      EXPECT_EQ(image.at(x, y)[0], image.at(0, y)[0]);
      EXPECT_EQ(image.at(x, y)[3], 255);
    }
}

TEST(Preview, TheModelFitsIntoThePictureFromEverySide) {
  const Row row(1);
  RenderOptions options = small();
  const Image blank = render_model(Model(), options);
  for (const double pitch : {0.0, 0.7})
    for (const double yaw : {0.0, 1.2}) {
      options.yaw = yaw;
      options.pitch = pitch;
      const Image image = render_model(row.result.model, options);
      EXPECT_GT(changed(image, blank), 300);
      for (int x = 0; x < 160; ++x) {
        EXPECT_EQ(image.at(x, 0)[0], blank.at(x, 0)[0]);
        EXPECT_EQ(image.at(x, 119)[3], 255);
      }
    }
}

TEST(Preview, FramesShowTheirPoses) {
  const Row row(3);
  RenderOptions options = small();
  const Image rest = render_model(row.result.model, options);
  options.frame = 0;  // posed as at rest
  EXPECT_EQ(render_model(row.result.model, options).rgba, rest.rgba);
  options.frame = 2;
  EXPECT_NE(render_model(row.result.model, options).rgba, rest.rgba);
  options.frame = 99;
  EXPECT_EQ(render_model(row.result.model, options).rgba, rest.rgba);
}

TEST(Preview, JointsTintTheirParts) {
  const Row row(1);
  RenderOptions options = small();
  options.by_joint = true;
  const Image image = render_model(row.result.model, options);
  // The middle ball is the second joint's: orange.
  const std::uint8_t* p = image.at(80, 60);
  EXPECT_GT(p[0], p[2] + 60);
  options.skeleton = true;
  EXPECT_NE(render_model(row.result.model, options).rgba, image.rgba);
}

TEST(Preview, ATurntableIsARowOfPictures) {
  const Row row(1);
  const RenderOptions options = small();
  const Image strip = render_turntable(row.result.model, options, 3);
  EXPECT_EQ(strip.width, 3 * 160);
  EXPECT_EQ(strip.height, 120);
  RenderOptions second = options;
  second.yaw = 2 * kPi / 3;
  const Image alone = render_model(row.result.model, second);
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 160; ++x) ASSERT_EQ(strip.at(160 + x, y)[1], alone.at(x, y)[1]);
}

TEST(Preview, TheContactSheetHoldsEveryFrame) {
  int height[4] = {};
  for (const int frames : {0, 1, 3}) {
    const Row row(frames);
    std::vector<Image> sketches(frames ? 1 : 0);  // fewer than frames: plain paper
    const Image sheet = contact_sheet(row.document, sketches, row.result, kSheetWidth);
    EXPECT_LE(sheet.width, kSheetWidth);
    EXPECT_GT(sheet.width, kSheetWidth - 10);
    height[frames] = sheet.height;
    EXPECT_GT(height[frames], 200);
  }
  EXPECT_LT(height[0], height[1]);
  EXPECT_LT(height[1], height[3]);
}

TEST(Preview, TheContactSheetShowsTheContoursInTheirColours) {
  const Row row(1);
  const Image sheet = contact_sheet(row.document, {}, row.result, kSheetWidth);
  EXPECT_EQ(sheet.rgba, contact_sheet(row.document, {}, row.result, kSheetWidth).rgba);
  for (int joint = 0; joint < 3; ++joint) {
    const unsigned c = joint_colour(joint);
    int found = 0;
    for (std::size_t i = 0; i < sheet.rgba.size(); i += 4)
      found += sheet.rgba[i] == (c >> 16 & 255) && sheet.rgba[i + 1] == (c >> 8 & 255) &&
               sheet.rgba[i + 2] == (c & 255);
    EXPECT_GT(found, 200) << joint;
  }
}

TEST(Preview, TheContactSheetShowsWhatCalibrationMoved) {
  Row row(1);
  const Image still = contact_sheet(row.document, {}, row.result, kSheetWidth);
  row.document.frames[0].pose.root_position.y() += 0.2;
  const Image moved = contact_sheet(row.document, {}, row.result, kSheetWidth);
  EXPECT_EQ(still.width, moved.width);
  EXPECT_NE(still.rgba, moved.rgba);
}

TEST(Preview, OddFramesMakeASheetAllTheSame) {
  Row row(1);
  const auto sheet = [&](int width, int height) {
    row.document.frames[0].width = width;
    row.document.frames[0].height = height;
    row.result.calibrated = row.document;
    return contact_sheet(row.document, {}, row.result, kSheetWidth);
  };
  EXPECT_LE(sheet(9000, 3).width, kSheetWidth);
  EXPECT_LT(sheet(3, 9000).height, 3 * kSheetWidth);
}

TEST(Preview, TheFirstTwentyJointsHaveColoursOfTheirOwn) {
  for (int a = 0; a < 20; ++a)
    for (int b = 0; b < a; ++b) EXPECT_NE(joint_colour(a), joint_colour(b));
  EXPECT_EQ(joint_colour(0), joint_colour(20));
}

}  // namespace
}  // namespace artisketch
