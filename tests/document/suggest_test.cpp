#include "document/suggest.h"

#include <gtest/gtest.h>

#include "document/edit.h"
#include "document/joint_limits.h"
#include "document/posing.h"
#include "figures.h"

namespace artisketch {
namespace {

// How far the joints that carry parts are from where they are: in the picture (pixels) and in space
// (units, from the root).
struct Off {
  double pixels = 0, units = 0;
};
Off off(const Document& document, int frame, const Pose& pose, const Pose& truth) {
  const FrameCamera camera = frame_camera(document, frame);
  const std::vector<Transform> a = posed_joints(document.skeleton, pose),
                               b = posed_joints(document.skeleton, truth);
  Off mean;
  const std::vector<int> joints = drawn_joints(document);
  for (const int j : joints) {
    const Vec3 p = a[j].translation(), q = b[j].translation();
    mean.pixels += (camera.project(p) - camera.project(q)).norm() / double(joints.size());
    mean.units +=
        ((p - a[0].translation()) - (q - b[0].translation())).norm() / double(joints.size());
  }
  return mean;
}

// The figure's drawings without any pose but the first drawing's; `truth` gets the poses.
Document unposed(const figures::Figure& figure, Camera::Type type, std::uint64_t seed,
                 std::vector<Pose>& truth) {
  const Camera camera = figures::fitting_camera(figure, type, 640, 800);
  const std::vector<figures::View> views = figures::random_views(figure, 3, seed);
  Document document = figures::draw(figure, views, camera, 640, 800).given;
  for (Frame& frame : document.frames) truth.push_back(frame.pose);
  for (std::size_t f = 1; f < document.frames.size(); ++f)
    document.frames[f].pose = fitted_rest_pose(document, document.frames[f]);
  return document;
}

// Mean over the later drawings of several figures: the suggestion's error is below these shares of
// the rest pose's.
void compare(const std::vector<figures::Figure>& cast, Camera::Type type, double pixels_share,
             double units_share) {
  Off rest, suggested;
  for (std::size_t c = 0; c < cast.size(); ++c) {
    std::vector<Pose> truth;
    const Document document = unposed(cast[c], type, 7 + c, truth);
    for (int f = 1; f < int(document.frames.size()); ++f) {
      const Off before = off(document, f, document.frames[f].pose, truth[f]);
      const Off after = off(document, f, suggested_pose(document, f), truth[f]);
      rest.pixels += before.pixels;
      rest.units += before.units;
      suggested.pixels += after.pixels;
      suggested.units += after.units;
    }
  }
  EXPECT_LT(suggested.pixels, pixels_share * rest.pixels);
  EXPECT_LT(suggested.units, units_share * rest.units);
}

TEST(Suggest, HumansComeWithinAFractionOfTheRestPosesError) {
  compare({figures::human(1), figures::human(2), figures::human(3), figures::hero()},
          Camera::Type::perspective, 0.1, 0.35);
}

TEST(Suggest, SoDoQuadrupeds) {
  compare({figures::quadruped(1), figures::quadruped(2), figures::fox()},
          Camera::Type::orthographic, 0.1, 0.35);
}

TEST(Suggest, TheFirstDrawingHasNoneToLearnFromAndStillGains) {
  std::vector<Pose> truth;
  Document document = unposed(figures::hero(), Camera::Type::perspective, 3, truth);
  document.frames[0].pose = fitted_rest_pose(document, document.frames[0]);
  const double before = off(document, 0, document.frames[0].pose, truth[0]).pixels;
  EXPECT_LT(off(document, 0, suggested_pose(document, 0), truth[0]).pixels, 0.5 * before);
}

TEST(Suggest, TheOtherLeanShowsMuchTheSame) {
  std::vector<Pose> truth;
  const Document document = unposed(figures::hero(), Camera::Type::perspective, 9, truth);
  const Skeleton& skeleton = document.skeleton;
  const Pose pose = suggested_pose(document, 1);
  int tried = 0;
  for (const int joint : drawn_joints(document)) {
    if (joint == 0 || skeleton.children(joint).size() != 1 || !leans(skeleton, pose, joint))
      continue;
    const Pose other = with_lean_flipped(document, 1, pose, joint);
    const int end = end_of_bone(skeleton, joint);
    const auto lean = [&](const Pose& p) {
      const std::vector<Transform> posed = posed_joints(skeleton, p);
      return posed[end].translation().z() - posed[joint].translation().z();
    };
    EXPECT_LT(lean(pose) * lean(other), 0) << skeleton.joints[joint].name;
    EXPECT_LT(off(document, 1, other, truth[1]).pixels, 25) << skeleton.joints[joint].name;
    ++tried;
  }
  EXPECT_GT(tried, 1);
}

TEST(Suggest, JointsSetByHandStay) {
  std::vector<Pose> truth;
  Document document = unposed(figures::hero(), Camera::Type::perspective, 9, truth);
  const int arm = document.skeleton.find("upper_arm.L");
  Pose mine = document.frames[1].pose;
  mine.rotations[std::size_t(arm)] = Quat(Eigen::AngleAxisd(1.2, Vec3::UnitZ()));
  document = with_pose(document, 1, mine);
  for (const Pose& pose : suggested_poses(document, 1))
    EXPECT_EQ(pose.rotations[std::size_t(arm)].coeffs(), mine.rotations[std::size_t(arm)].coeffs());
}

// The right turn, roughly given, is never turned back, whatever other side explains the places too.
TEST(Suggest, ABodyThatIsTurnedStaysNearItsTurn) {
  for (const std::uint64_t seed : {3, 4, 5}) {
    std::vector<Pose> truth;
    Document document = unposed(figures::hero(), Camera::Type::orthographic, seed, truth);
    for (int f = 1; f < 3; ++f) {
      Pose turned = document.frames[std::size_t(f)].pose;
      turned.rotations[0] =
          Quat(Eigen::AngleAxisd(0.2, Vec3::UnitY())) * truth[std::size_t(f)].rotations[0];
      const Document given = with_guessed_pose(document, f, turned);
      const Quat found = suggested_pose(given, f).rotations[0];
      EXPECT_LT(degrees(found.angularDistance(truth[std::size_t(f)].rotations[0])), 30)
          << seed << " " << f;
    }
  }
}

TEST(Suggest, RivalsDifferAndAreFew) {
  for (const std::uint64_t seed : {7, 8, 9}) {
    std::vector<Pose> truth;
    const Document document = unposed(figures::human(1), Camera::Type::orthographic, seed, truth);
    const std::vector<Pose> poses = suggested_poses(document, 1);
    ASSERT_FALSE(poses.empty());
    EXPECT_LE(poses.size(), 3u);
    for (std::size_t a = 0; a < poses.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        EXPECT_GT(off(document, 1, poses[a], poses[b]).units, 0.02) << seed;
  }
}

// Elbows and knees that bend the other way, necks wrung round: no body can.
TEST(Suggest, NoJointTurnsFartherThanBodiesCan) {
  for (const std::uint64_t seed : {11, 12, 13}) {
    std::vector<Pose> truth;
    const Document document = unposed(figures::hero(), Camera::Type::orthographic, seed, truth);
    const Skeleton& skeleton = document.skeleton;
    for (int f = 1; f < 3; ++f) {
      const Pose pose = suggested_pose(document, f);
      for (const int joint : drawn_joints(document)) {
        if (joint == 0) continue;
        const Eigen::AngleAxisd turn(pose.rotations[std::size_t(joint)]);
        const Vec3 vector = std::remainder(turn.angle(), 2 * kPi) * turn.axis();
        EXPECT_LT(degrees(beyond(joint_limits(skeleton, joint), vector).norm()), 15)
            << skeleton.joints[std::size_t(joint)].name << " " << seed << " " << f;
      }
    }
  }
}

TEST(Suggest, WithoutOutlinesThePoseStays) {
  std::vector<Pose> truth;
  Document document = unposed(figures::hero(), Camera::Type::perspective, 9, truth);
  document.frames[1].contours.clear();
  const Pose pose = suggested_pose(document, 1);
  EXPECT_EQ(pose.root_position, document.frames[1].pose.root_position);
}

}  // namespace
}  // namespace artisketch
