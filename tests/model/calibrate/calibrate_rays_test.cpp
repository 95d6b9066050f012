#include <cmath>
#include <functional>
#include <random>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "figures.h"
#include "figures/measure.h"
#include "model/calibrate/calibrate.h"
#include "model/calibrate/landmark_residuals.h"

namespace artisketch {
namespace {

using namespace figures;

constexpr int kWidth = 360, kHeight = 400;

Sketches sketched(const Figure& figure, int frames, Camera::Type type, double degrees_off,
                  double wobble = 0, int seed = 1) {
  const Camera camera = fitting_camera(figure, type, kWidth, kHeight);
  return draw(figure, random_views(figure, frames, seed), camera, kWidth, kHeight,
              {.contour_wobble_px = wobble,
               .pose_error_degrees = degrees_off,
               .root_error = degrees_off / 400},
              seed);
}

Calibration calibrated(const Document& document) {
  artisketch::Run run;
  Result<Calibration> found = calibrate(document, {Method::rays}, run);
  EXPECT_TRUE(found);
  return std::move(found).value();
}

double joint_px(const Figure& figure, const Document& truth, const std::vector<Pose>& poses) {
  double sum = 0;
  for (std::size_t f = 1; f < poses.size(); ++f)
    sum +=
        pose_errors(figure, frame_camera(truth, int(f)), truth.frames[f].pose, poses[f]).joint_px;
  return sum / double(poses.size() - 1);
}

std::vector<Pose> poses_of(const Document& document) {
  std::vector<Pose> poses;
  for (const Frame& frame : document.frames) poses.push_back(frame.pose);
  return poses;
}

double share(const std::vector<PartCoverage>& all, double PartCoverage::*when) {
  double sum = 0;
  for (const PartCoverage& one : all) sum += one.*when;
  return sum / double(all.size());
}

bool mentions(const std::vector<std::string>& lines, const std::string& words) {
  for (const std::string& line : lines)
    if (line.find(words) != std::string::npos) return true;
  return false;
}

// ---------------------------------------------------------------- limits

// A limit of 0 holds what it limits, and nothing else.
TEST(CalibrateRays, ALimitOfNothingHolds) {
  const Figure figure = capsule_arm();
  for (const Camera::Type type : {Camera::Type::orthographic, Camera::Type::perspective}) {
    Document document = sketched(figure, 3, type, 8).given;
    for (const auto& [rotation, translation] :
         {std::pair(0.0, 0.5), std::pair(radians(30), 0.0), std::pair(0.0, 0.0)}) {
      document.calibration.max_rotation = rotation;
      document.calibration.max_translation = translation;
      const Calibration found = calibrated(document);
      EXPECT_TRUE(std::isfinite(found.energy_after));
      EXPECT_LE(found.energy_after, found.energy_before);
      bool turned = false, shifted = false;
      for (std::size_t f = 0; f < found.poses.size(); ++f) {
        const Pose &user = document.frames[f].pose, &pose = found.poses[f];
        for (std::size_t j = 0; j < pose.rotations.size(); ++j)
          turned |= pose.rotations[j].angularDistance(user.rotations[j]) > 1e-9;
        shifted |= (pose.root_position - user.root_position).norm() > 1e-9;
      }
      EXPECT_EQ(turned, rotation > 0);
      EXPECT_EQ(shifted, translation > 0);
    }
  }
}

// ---------------------------------------------------------------- derivatives

Placement user_placement(const Document& document) {
  return placed(document, poses_of(document), std::vector<double>(document.frames.size(), 1.0));
}

// The placement with all joints moved alike in one frame, as one rigid figure.
Placement moved(Placement placement, int frame, const PartMotion& m) {
  const Vec3 turn = m.head<3>();
  Transform t = Transform::Identity();
  if (!turn.isZero(0)) t.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).matrix();
  t.translation() = m.segment<3>(3);
  for (Transform& posed : placement.posed[frame]) posed = t * posed;
  placement.cameras[frame].scale *= std::exp(m[6]);
  return placement;
}

// Half the energy's derivatives by the motions of whole frames, as the systems have them and by
// differences.
void expect_same_derivatives(const Document& document, const RayResiduals& rays,
                             const std::function<double(const Placement&, MotionSystems*)>& energy,
                             double tolerance) {
  const Placement placement = user_placement(document);
  MotionSystems systems;
  rays.clear(systems, int(document.frames.size()));
  energy(placement, &systems);
  Eigen::VectorXd g = Eigen::VectorXd::Zero(kMotion * document.frames.size());
  for (const auto& [joint, system] : systems) g += system.g;
  const double h = 1e-4;
  for (int i = 0; i < g.size(); ++i) {
    if (i % kMotion == 6 && document.camera.type == Camera::Type::perspective) continue;
    PartMotion m = PartMotion::Zero();
    m[i % kMotion] = h;
    const double numeric = (energy(moved(placement, i / kMotion, m), nullptr) -
                            energy(moved(placement, i / kMotion, -m), nullptr)) /
                           (4 * h);
    EXPECT_NEAR(g[i], numeric, tolerance * g.norm())
        << "frame " << i / kMotion << " of " << i % kMotion;
  }
}

class Derivatives : public testing::TestWithParam<Camera::Type> {};

TEST_P(Derivatives, OfRaysAreThoseOfTheirEnergy) {
  const Document given = sketched(human(2), 3, GetParam(), 8).given;
  const RayResiduals rays(given, 4, 24);
  // Distances are bilinear between samples: slopes jump where a step crosses from one to the next.
  for (const double reach : {0, 12, 4})
    expect_same_derivatives(
        given, rays,
        [&](const Placement& p, MotionSystems* s) { return rays.evaluate(p, reach, 1, s); }, 0.04);
}

TEST_P(Derivatives, OfLandmarksAreThoseOfTheirEnergy) {
  const Document given = sketched(human(2), 3, GetParam(), 8).given;
  const RayResiduals rays(given, 4, 24);
  expect_same_derivatives(
      given, rays,
      [&](const Placement& p, MotionSystems* s) {
        return landmark_energy(rays, given, p, {100, 50}, s);
      },
      1e-3);
}

// The steps of the unknowns themselves: a quadratic energy in all parts' motions, whose least lies
// at a change known beforehand, is reached by the system's own step.
TEST(PoseSystem, StepsToTheLeastOfAQuadratic) {
  const Document d = sketched(human(2), 3, Camera::Type::perspective, 8).given;
  PoseFreedom freedom{1, 1, {0, 1, 1}, shared_contours(d), false};
  freedom.joint[0].assign(d.skeleton.size(), 0);
  PoseSystem system(d, freedom);
  PoseChange wanted = no_change(d);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> small(-0.002, 0.002);
  const auto any = [&] { return Vec3(small(random), small(random), small(random)); };
  for (int f = 1; f < 3; ++f) {
    for (int j = 0; j < d.skeleton.size(); ++j)
      if (freedom.joint[f][j]) wanted[f].rotation[j] = any();
    wanted[f].translation = any();
  }
  MotionSystems parts;
  for (const int joint : drawn_joints(d)) {
    MotionSystem part(3);
    part.H.setIdentity();
    for (int f = 1; f < 3; ++f) {
      const Pose& user = d.frames[f].pose;
      const Transform motion = posed_joints(d.skeleton, changed(user, wanted[f]))[joint] *
                               posed_joints(d.skeleton, user)[joint].inverse();
      const Eigen::AngleAxisd turn(motion.linear());
      part.g.segment<3>(kMotion * f) = -turn.angle() * turn.axis();
      part.g.segment<3>(kMotion * f + 3) = -motion.translation();
    }
    parts.emplace_back(joint, part);
  }
  system.assemble(no_change(d), parts);
  const PoseChange found = system.stepped(no_change(d), {1e3, 1e3, 1e3, 1e3}, 0);
  for (int f = 0; f < 3; ++f) {
    EXPECT_NEAR((found[f].translation - wanted[f].translation).norm(), 0, 1e-4);
    for (int j = 0; j < d.skeleton.size(); ++j)
      EXPECT_NEAR((found[f].rotation[j] - wanted[f].rotation[j]).norm(), 0, 1e-4) << f << " " << j;
  }
}

// A tail of some joints, on which another begins half-way, in three frames.
Document forked_tail(int joints) {
  Document d;
  for (int j = 0; j < joints; ++j) {
    const int parent = j == joints / 2 ? joints / 4 : j - 1;
    d.skeleton.joints.push_back(
        {"j" + std::to_string(j), parent, Vec3(0.1, 0.02 * (j % 3), 0), -1, ""});
  }
  d.frames.resize(3);
  std::mt19937 random(2);
  std::normal_distribution<double> any(0, 0.2);
  for (Frame& frame : d.frames) {
    frame.pose = rest_pose(d.skeleton);
    for (Quat& q : frame.pose.rotations)
      q = rotation_by(Vec3(any(random), any(random), any(random)));
  }
  return d;
}

// Elimination joint by joint gives the step that the whole system gives, written out in all
// unknowns and solved at once.
TEST(PoseSystem, AStepIsThatOfAllUnknownsAtOnce) {
  constexpr int kJoints = 20, kFrames = 3, kUnknowns = 3 * (kJoints + 1) * kFrames;
  const Document d = forked_tail(kJoints);
  const PosePrior prior{0.5, 2, 3, 0.1, 0.5};
  const double damping = 0.1;
  PoseFreedom freedom{9, 9, {0, 1, 1}, {}, false};
  freedom.joint.assign(kFrames, std::vector<char>(kJoints, 1));
  freedom.joint[0].assign(kJoints, 0);
  for (int f = 0; f < kFrames; ++f) freedom.joint[f][7] = 0;  // moves with the joint it hangs on

  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(kUnknowns, kUnknowns);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(kUnknowns);
  MotionSystems parts;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> spread(-1, 1);
  const auto any = [&] { return spread(random); };
  for (int part = 0; part < kJoints; ++part) {
    // Per frame the root's shift, then each joint's turn.
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(kMotion * kFrames, kUnknowns);
    for (int f = 0; f < kFrames; ++f) {
      const std::vector<Transform> posed = posed_joints(d.skeleton, d.frames[f].pose);
      const int at = 3 * (kJoints + 1) * f;
      if (freedom.frame[f]) J.block<3, 3>(kMotion * f + 3, at).setIdentity();
      for (int j = part; j >= 0; j = d.skeleton.joints[j].parent) {
        if (!freedom.joint[f][j]) continue;
        for (int axis = 0; axis < 3; ++axis) {
          const Vec3 turn = posed[j].linear().col(axis), pivot = posed[j].translation();
          J.block<3, 1>(kMotion * f, at + 3 * (j + 1) + axis) = turn;
          J.block<3, 1>(kMotion * f + 3, at + 3 * (j + 1) + axis) = pivot.cross(turn);
        }
      }
    }
    const Eigen::MatrixXd R = Eigen::MatrixXd::NullaryExpr(kMotion * kFrames, 9, any);
    MotionSystem system(kFrames);
    system.H = R * R.transpose();
    system.g = 0.1 * Eigen::VectorXd::NullaryExpr(kMotion * kFrames, any);
    A += J.transpose() * system.H * J;
    b += J.transpose() * system.g;
    parts.emplace_back(part, system);
  }
  for (int f = 0; f < kFrames; ++f)
    for (int i = 0; i < 3 * (kJoints + 1); ++i) {
      const double width = prior.share(f) * (i == 2  ? prior.depth
                                             : i < 3 ? prior.translation
                                                     : prior.rotation);
      const int at = 3 * (kJoints + 1) * f + i;
      A(at, at) += 1 / (width * width);
    }
  A.diagonal() *= 1 + damping;
  const Eigen::VectorXd x = -A.ldlt().solve(b);

  PoseSystem system(d, freedom);
  system.assemble(no_change(d), parts);
  const PoseChange found = system.stepped(no_change(d), prior, damping);
  ASSERT_GT(x.norm(), 0.01);
  for (int f = 0; f < kFrames; ++f) {
    const int at = 3 * (kJoints + 1) * f;
    EXPECT_NEAR((found[f].translation - x.segment<3>(at)).norm(), 0, 1e-9 * x.norm()) << f;
    for (int j = 0; j < kJoints; ++j)
      EXPECT_NEAR((found[f].rotation[j] - x.segment<3>(at + 3 * (j + 1))).norm(), 0,
                  1e-9 * x.norm())
          << f << " " << j;
  }
}

INSTANTIATE_TEST_SUITE_P(Cameras, Derivatives,
                         testing::Values(Camera::Type::orthographic, Camera::Type::perspective));

// ---------------------------------------------------------------- what is found

// Front and side of a figure of one joint, drawn where `shift` puts it in the second sketch, and
// posed at the origin.
Document shifted(const Figure& figure, Camera::Type type, const Vec3& shift) {
  const std::vector<View> views = {view(figure, "front", Quat::Identity()),
                                   view(figure, "side", about_y(80), {}, shift)};
  Document d =
      draw(figure, views, fitting_camera(figure, type, kWidth, kHeight), kWidth, kHeight).given;
  d.frames[1].pose.root_position.setZero();
  d.calibration.max_translation = 2;
  return d;
}

TEST(CalibrateRays, FindsAVerticalOffset) {  // the paper's Fig. 3
  const Document d = shifted(heart(), Camera::Type::orthographic, {0, -0.25, 0});
  const Calibration found = calibrated(d);
  EXPECT_NEAR(found.poses[1].root_position.y(), -0.25, 0.005);
  EXPECT_LT(share(found.coverage, &PartCoverage::before), 0.8);
  EXPECT_GT(share(found.coverage, &PartCoverage::after), 0.99);
}

TEST(CalibrateRays, DolliesBack) {  // the paper's Fig. 4
  const Document d = shifted(ball_figure(), Camera::Type::perspective, {0, 0, -0.4});
  const Calibration found = calibrated(d);
  EXPECT_NEAR(found.poses[1].root_position.z(), -0.4, 0.03);
  EXPECT_GT(share(found.coverage, &PartCoverage::after), 0.99);
}

TEST(CalibrateRays, FindsTheScaleOfAFrameWhereAskedTo) {
  Document d = shifted(heart(), Camera::Type::orthographic, Vec3::Zero());
  d.frames[1].scale = 1.12;
  EXPECT_EQ(calibrated(d).scales, (std::vector<double>{1, 1.12}));
  d.calibration.scale = true;
  EXPECT_NEAR(calibrated(d).scales[1], 1, 0.01);
}

TEST(CalibrateRays, PosesThatAreRightStay) {
  for (const Figure& figure : {human(3), quadruped(1)})
    for (const auto type : {Camera::Type::orthographic, Camera::Type::perspective}) {
      const Sketches s = sketched(figure, 3, type, 0);
      const Calibration found = calibrated(s.truth);
      EXPECT_LT(joint_px(figure, s.truth, found.poses), 0.3) << figure.name;
      EXPECT_GE(share(found.coverage, &PartCoverage::after), 0.995) << figure.name;
    }
}

TEST(CalibrateRays, BringsPosesNearer) {
  struct {
    int frames;
    double off, wobble, left;
  } cases[] = {{3, 8, 0, 0.35}, {4, 15, 0, 0.35}, {3, 12, 1, 0.5}, {3, 30, 0, 0.6}};
  for (const auto& c : cases) {
    const Figure figure = human(5);
    const Sketches s = sketched(figure, c.frames, Camera::Type::perspective, c.off, c.wobble, 4);
    const Calibration found = calibrated(s.given);
    const double before = joint_px(figure, s.truth, poses_of(s.given));
    EXPECT_LT(joint_px(figure, s.truth, found.poses), c.left * before)
        << c.off << "° off, wobble " << c.wobble;
    EXPECT_GT(share(found.coverage, &PartCoverage::after),
              share(found.coverage, &PartCoverage::before));
  }
}

// Boxy limbs fit in more ways than one: these had fallen into wrong ones, a whole leg at a time.
TEST(CalibrateRays, BeginsALimbAnewThatFellIntoAnotherMinimum) {
  for (const int seed : {8, 15, 36}) {
    const Figure figure = robot(seed);
    const Camera camera = fitting_camera(figure, Camera::Type::orthographic, 512, 512);
    const Sketches sketches = draw(figure, random_views(figure, 3, seed), camera, 512, 512,
                                   {.pose_error_degrees = 15, .root_error = 15.0 / 400}, seed);
    EXPECT_GE(share(calibrated(sketches.given).coverage, &PartCoverage::after), 0.999) << seed;
  }
}

TEST(CalibrateRays, GivesTheSameBitsAgain) {
  const Document d = sketched(human(1), 2, Camera::Type::orthographic, 10, 1).given;
  const Calibration a = calibrated(d), b = calibrated(d);
  for (int f = 0; f < 2; ++f) EXPECT_TRUE(same_pose(a.poses[f], b.poses[f]));
  EXPECT_EQ(a.energy_after, b.energy_after);
  EXPECT_EQ(a.undetermined, b.undetermined);
}

// ---------------------------------------------------------------- what stays

TEST(CalibrateRays, LimitsHoldExactly) {
  Document d = sketched(human(1), 3, Camera::Type::orthographic, 15).given;
  d.calibration.max_rotation = radians(3);
  d.calibration.max_translation = 0.01;
  d.calibration.locked = {0, 4};
  const Calibration found = calibrated(d);
  for (int f = 0; f < 3; ++f) {
    const Pose &user = d.frames[f].pose, &pose = found.poses[f];
    EXPECT_LE((pose.root_position - user.root_position).norm(), 0.01);
    for (int j = 0; j < d.skeleton.size(); ++j) {
      EXPECT_LE(pose.rotations[j].angularDistance(user.rotations[j]), radians(3));
      EXPECT_NEAR(pose.rotations[j].norm(), 1, 1e-12);
    }
    EXPECT_EQ(pose.rotations[0].coeffs(), user.rotations[0].coeffs());
    EXPECT_EQ(pose.rotations[4].coeffs(), user.rotations[4].coeffs());
  }
  EXPECT_NEAR(found.largest_rotation, radians(3), 1e-6);
  EXPECT_TRUE(mentions(found.warnings, "max_rotation"));
}

double largest_turn(const Pose& a, const Pose& b) {
  double most = 0;
  for (std::size_t j = 0; j < a.rotations.size(); ++j)
    most = std::max(most, a.rotations[j].angularDistance(b.rotations[j]));
  return most;
}

TEST(CalibrateRays, TheFirstFrameStaysUnlessFree) {
  Sketches s = sketched(human(1), 3, Camera::Type::orthographic, 8);
  EXPECT_TRUE(same_pose(calibrated(s.given).poses[0], s.given.frames[0].pose));
  // The first frame off, the others true: where it stands and faces is held.
  Document d = s.truth;
  d.frames[0].pose.root_position += Vec3(0, 0.05, 0);
  const Pose held = calibrated(d).poses[0];
  EXPECT_EQ(held.root_position, d.frames[0].pose.root_position);
  EXPECT_EQ(held.rotations[0].coeffs(), d.frames[0].pose.rotations[0].coeffs());
  d.calibration.free_first_frame = true;
  const Calibration found = calibrated(d);
  EXPECT_LT(found.poses[0].root_position.y(), d.frames[0].pose.root_position.y() - 0.02);
}

// Whoever draws a figure otherwise each time didn't set its first pose to the degree either.
TEST(CalibrateRays, TheFirstFrameMovesTooWhereDrawingsContradictEachOther) {
  const Figure figure = human(2);
  const Camera camera = fitting_camera(figure, Camera::Type::orthographic, kWidth, kHeight);
  const auto turn = [&](double part_size) {
    const Document d = draw(figure, random_views(figure, 3, 2), camera, kWidth, kHeight,
                            {.pose_error_degrees = 10, .part_size = part_size}, 2)
                           .given;
    return largest_turn(calibrated(d).poses[0], d.frames[0].pose);
  };
  const double agreeing = turn(0), contradicting = turn(0.15);
  EXPECT_LT(agreeing, radians(0.1));
  EXPECT_GT(contradicting, radians(0.4));
  EXPECT_LT(contradicting, radians(20));
}

TEST(CalibrateRays, OneFrameHasNothingToCalibrate) {
  const Document d = sketched(human(1), 1, Camera::Type::orthographic, 0).given;
  const Calibration found = calibrated(d);
  EXPECT_TRUE(same_pose(found.poses[0], d.frames[0].pose));
  EXPECT_TRUE(mentions(found.warnings, "one frame"));
  EXPECT_EQ(share(found.coverage, &PartCoverage::after), 1);
}

TEST(CalibrateRays, AFrameWithFewContoursKeepsItsPose) {
  Document d = sketched(human(1), 3, Camera::Type::orthographic, 8).given;
  d.frames[1].contours.resize(2);
  Calibration found = calibrated(d);
  EXPECT_TRUE(same_pose(found.poses[1], d.frames[1].pose));
  EXPECT_FALSE(same_pose(found.poses[2], d.frames[2].pose));
  EXPECT_TRUE(mentions(found.warnings, "frame 2"));
  d.frames[1].contours.clear();
  d.frames[2].contours.clear();
  found = calibrated(d);
  EXPECT_TRUE(same_pose(found.poses[2], d.frames[2].pose));
  EXPECT_TRUE(mentions(found.warnings, "nothing to calibrate"));
}

TEST(CalibrateRays, AJointWithoutContoursTurnsOnlyWhereItsChildrenNeedIt) {
  const Figure figure = capsule_arm();
  const std::vector<View> views = {view(figure, "front", Quat::Identity()),
                                   view(figure, "below", about_x(70)),
                                   view(figure, "aslant", Quat(about_y(25) * about_x(-40)))};
  // As large as calibration takes drawings: a smaller one's pixels count as several.
  const int width = 2 * kWidth, height = 2 * kHeight;
  Document d =
      draw(figure, views, fitting_camera(figure, Camera::Type::orthographic, width, height), width,
           height)
          .given;
  const int middle = 1;  // the forearm
  for (Frame& frame : d.frames)
    std::erase_if(frame.contours, [&](const Contour& c) { return c.joint == middle; });
  const Document truth = d;
  Pose& pose = d.frames[1].pose;
  pose.rotations[2] = about_z(8);  // the hand: it can be put right alone
  EXPECT_EQ(calibrated(d).poses[1].rotations[middle].coeffs(),
            truth.frames[1].pose.rotations[middle].coeffs());
  pose = truth.frames[1].pose;
  pose.rotations[middle] = about_z(-15);  // it took the hand away
  const Calibration found = calibrated(d);
  // Where the second sketch shows the hand; its depth stays open.
  const auto hand = [&](const Pose& p) {
    return frame_camera(d, 1).project(posed_joints(d.skeleton, p)[2].translation());
  };
  const Vec2 wanted = hand(truth.frames[1].pose);
  EXPECT_LT((hand(found.poses[1]) - wanted).norm(), 0.5 * (hand(pose) - wanted).norm());
}

TEST(CalibrateRays, DrawingsMayHaveDifferentSizes) {
  const Document d = sketched(human(1), 3, Camera::Type::perspective, 8).given;
  // The second drawing on a larger sheet, its middle where it was on the figure.
  Document wide = d;
  Frame& frame = wide.frames[1];
  const Vec2 shift(130, 45);
  frame.principal_point = frame_camera(d, 1).principal_point + shift;
  frame.width += 400;
  frame.height += 90;
  for (Contour& contour : frame.contours)
    for (Vec2& p : contour.line.points) p += shift;
  const Calibration a = calibrated(d), b = calibrated(wide);
  for (int f = 0; f < 3; ++f) {
    const PoseErrors apart = pose_errors(human(1), frame_camera(d, f), a.poses[f], b.poses[f]);
    EXPECT_LT(apart.joint_px, 0.5);
  }
}

// ---------------------------------------------------------------- drawings that disagree

// Of contours of two joints swapped in one frame, and another one drawn far off.
void expect_no_less_agreement(int seed, double degrees, Method method) {
  Document d = sketched(human(seed), 3, Camera::Type::orthographic, degrees, 2, seed).given;
  std::swap(d.frames[1].contours[1].joint, d.frames[1].contours[5].joint);
  for (Vec2& p : d.frames[2].contours[3].line.points) p += Vec2(60, -45);
  artisketch::Run run;
  const auto found = calibrate(d, {method}, run);
  ASSERT_TRUE(found);
  EXPECT_GE(share(found->coverage, &PartCoverage::after),
            share(found->coverage, &PartCoverage::before));
}

TEST(CalibrateRays, NeverAgreesLessThanTheUsersPoses) {
  for (int seed = 0; seed < 4; ++seed) expect_no_less_agreement(seed, 6, Method::rays);
}

TEST(CalibratePaper, NeverAgreesLessThanTheUsersPoses) {
  expect_no_less_agreement(0, 0, Method::paper);  // its own poses would agree by .61, not .70
}

TEST(CalibrateRays, OneWrongContourLeavesTheOthersRight) {
  const Figure figure = human(2);
  const Sketches s = sketched(figure, 3, Camera::Type::orthographic, 8);
  Document d = s.given;
  const int wrong = d.frames[2].contours[4].joint;
  Polyline& line = d.frames[2].contours[4].line;
  const Vec2 middle = centroid({&line, 1});
  for (Vec2& p : line.points) p = middle + 1.9 * (p - middle);
  const Calibration found = calibrated(d);
  EXPECT_LT(joint_px(figure, s.truth, found.poses),
            0.5 * joint_px(figure, s.truth, poses_of(s.given)));
  EXPECT_TRUE(mentions(found.warnings, "'" + d.skeleton.joints[wrong].name + "' cannot agree"));
}

TEST(CalibrateRays, NamesAnglesThatSilhouettesLeaveOpen) {
  const Calibration ball =
      calibrated(shifted(ball_figure(), Camera::Type::orthographic, Vec3::Zero()));
  EXPECT_TRUE(mentions(ball.undetermined, "swing of 'ball' toward the camera or away, frame 2"));
  EXPECT_TRUE(mentions(ball.undetermined, "turn of 'ball' in the picture, frame 2"));
  const Sketches s = sketched(quadruped(1), 4, Camera::Type::orthographic, 0);
  for (const std::string& line : calibrated(s.truth).undetermined)
    EXPECT_EQ(line.find("turn of 'chest' in the picture"), std::string::npos) << line;
}

TEST(CalibrateRays, StopsWhenAsked) {
  const std::atomic<bool> stop = true;
  artisketch::Run run;
  run.cancel = &stop;
  const auto found =
      calibrate(sketched(human(1), 2, Camera::Type::orthographic, 8).given, {Method::rays}, run);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().kind, Error::Kind::cancelled);
}

}  // namespace
}  // namespace artisketch
