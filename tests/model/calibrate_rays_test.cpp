#include <gtest/gtest.h>

#include "figures.h"
#include "model/stages.h"

namespace artisketch {
namespace {

using figures::Figure;
using figures::Sketches;

Sketches sketches(const Figure& figure, int frames, double degrees, double wobble = 0,
                  Camera::Type type = Camera::Type::orthographic) {
  const Camera camera = figures::fitting_camera(figure, type, 320, 320);
  figures::Noise noise;
  noise.pose_error_degrees = degrees;
  noise.root_error = degrees * 0.003;
  noise.contour_wobble_px = wobble;
  return figures::draw(figure, figures::random_views(figure, frames, 3), camera, 320, 320, noise,
                       5);
}

// Mean distance of the joints from their true places, in pixels, over all frames but the first.
double joint_error(const Sketches& s, const std::vector<Pose>& poses) {
  double sum = 0;
  int count = 0;
  for (std::size_t f = 1; f < poses.size(); ++f) {
    const FrameCamera camera = frame_camera(s.truth, int(f));
    const auto a = posed_joints(s.truth.skeleton, poses[f]);
    const auto b = posed_joints(s.truth.skeleton, s.truth.frames[f].pose);
    for (std::size_t j = 0; j < a.size(); ++j, ++count)
      sum += (camera.project(a[j].translation()) - camera.project(b[j].translation())).norm();
  }
  return sum / count;
}

std::vector<Pose> given(const Sketches& s) {
  std::vector<Pose> poses;
  for (const Frame& frame : s.given.frames) poses.push_back(frame.pose);
  return poses;
}

Calibration calibrated(const Document& document) {
  artisketch::Run run;
  Result<Calibration> result = calibrate(document, {Method::rays}, run);
  EXPECT_TRUE(result);
  return std::move(result).value();
}

TEST(CalibrateRays, FindsTheJointsOfAHuman) {
  for (const Camera::Type type : {Camera::Type::orthographic, Camera::Type::perspective}) {
    const Sketches s = sketches(figures::human(2), 3, 8, 0, type);
    const Calibration found = calibrated(s.given);
    EXPECT_LT(joint_error(s, found.poses), 0.5 * joint_error(s, given(s)));
    for (const PartCoverage& c : found.coverage)
      EXPECT_GE(c.after, 0.9) << c.joint << " " << c.frame;
  }
}

TEST(CalibrateRays, PosesThatAreRightStay) {
  for (const auto& figure : {figures::human(1), figures::quadruped(1)}) {
    const Sketches s = sketches(figure, 3, 0);
    EXPECT_LT(joint_error(s, calibrated(s.given).poses), 0.5) << figure.name;
  }
}

TEST(CalibrateRays, LimitsHoldExactly) {
  Sketches s = sketches(figures::human(3), 3, 15);
  s.given.calibration.max_rotation = radians(4);
  s.given.calibration.max_translation = 0.01;
  s.given.calibration.locked = {2, 3};
  const Calibration found = calibrated(s.given);
  for (std::size_t f = 0; f < found.poses.size(); ++f) {
    const Pose& user = s.given.frames[f].pose;
    EXPECT_LE((found.poses[f].root_position - user.root_position).norm(), 0.01 + 1e-12);
    for (int j = 0; j < s.given.skeleton.size(); ++j)
      EXPECT_LE(found.poses[f].rotations[j].angularDistance(user.rotations[j]), radians(4) + 1e-9);
    for (const int j : {2, 3})
      EXPECT_LT(found.poses[f].rotations[j].angularDistance(user.rotations[j]), 1e-12);
  }
}

TEST(CalibrateRays, TheFirstFrameStaysUnlessFreed) {
  Sketches s = sketches(figures::capsule_arm(), 3, 8);
  const Pose& user = s.given.frames[0].pose;
  EXPECT_EQ(calibrated(s.given).poses[0].root_position, user.root_position);
  for (int j = 0; j < s.given.skeleton.size(); ++j)
    EXPECT_EQ(calibrated(s.given).poses[0].rotations[j].coeffs(), user.rotations[j].coeffs());
}

TEST(CalibrateRays, OneFrameHasNothingToAgreeWith) {
  Sketches s = sketches(figures::capsule_arm(), 2, 8);
  s.given.frames.resize(1);
  const Calibration found = calibrated(s.given);
  ASSERT_EQ(found.poses.size(), 1u);
  EXPECT_EQ(found.poses[0].root_position, s.given.frames[0].pose.root_position);
  EXPECT_FALSE(found.warnings.empty());
}

TEST(CalibrateRays, AFrameWithoutContoursKeepsTheUsersPose) {
  Sketches s = sketches(figures::capsule_arm(), 3, 8);
  s.given.frames[1].contours.clear();
  const Calibration found = calibrated(s.given);
  EXPECT_EQ(found.poses[1].root_position, s.given.frames[1].pose.root_position);
}

TEST(CalibrateRays, IsDeterministic) {
  const Sketches s = sketches(figures::human(4), 2, 8, 1);
  const Calibration a = calibrated(s.given), b = calibrated(s.given);
  for (std::size_t f = 0; f < a.poses.size(); ++f)
    for (std::size_t j = 0; j < a.poses[f].rotations.size(); ++j)
      EXPECT_EQ(a.poses[f].rotations[j].coeffs(), b.poses[f].rotations[j].coeffs());
}

TEST(CalibrateRays, StopsWhenAsked) {
  const std::atomic<bool> stop = true;
  artisketch::Run run;
  run.cancel = &stop;
  const auto result = calibrate(sketches(figures::human(1), 3, 8).given, {Method::rays}, run);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, Error::Kind::cancelled);
}

}  // namespace
}  // namespace artisketch
