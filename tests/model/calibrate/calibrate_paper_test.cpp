#include <cmath>

#include <gtest/gtest.h>

#include "model/calibrate/euler_solver.h"
#include "model/calibrate/ray_voxels.h"
#include "model/stages.h"

namespace artisketch {
namespace {

// Outline of an egg, `height` units tall, as seen from any side of its axis.
std::vector<Vec2> egg(const FrameCamera& camera, const Vec3& at, double height) {
  std::vector<Vec2> points;
  for (int i = 0; i < 120; ++i) {
    const double a = 2 * kPi * i / 120, y = std::sin(a), w = 0.35 * std::cos(a) * (1 - 0.3 * y);
    points.push_back(camera.project(at + height * Vec3(w, y / 2, 0)));
  }
  return points;
}

// An egg from the front and from the side, drawn at `shift` in the second sketch, posed at the
// origin.
Document two_eggs(const Camera& camera, const Vec3& shift) {
  Document d;
  d.camera = camera;
  d.skeleton.joints.push_back({"egg", -1, Vec3::Zero(), -1, ""});
  d.calibration.max_translation = 1;
  for (int f = 0; f < 2; ++f) {
    Frame frame;
    frame.name = f ? "side" : "front";
    frame.width = frame.height = 400;
    frame.pose = rest_pose(d.skeleton);
    if (f) frame.pose.rotations[0] = Eigen::AngleAxisd(kPi / 2, Vec3::UnitY());
    d.frames.push_back(frame);
    const Vec3 at = f ? shift : Vec3(Vec3::Zero());
    d.frames[f].contours.push_back({0, {egg(frame_camera(d, f), at, 1), true}, ""});
  }
  return d;
}

TEST(CalibratePaper, AVerticalOffsetIsFound) {  // the paper's Fig. 3
  const Document d = two_eggs({Camera::Type::orthographic, 200, 0, 0}, {0, -0.2, 0});
  artisketch::Run run;
  const auto found = calibrate_paper(d, run);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->poses[0].root_position, Vec3(Vec3::Zero()));
  // Rays that share a voxel rest: they come as near as that.
  constexpr double kFinestVoxel = 1.6 * 1.22 / 96;  // of a cube about an egg 0.7 wide and 1 high
  EXPECT_NEAR(found->poses[1].root_position.y(), -0.2, kFinestVoxel);
  EXPECT_LT(found->energy_after, 0.05 * found->energy_before);
}

TEST(CalibratePaper, SaysThatItFindsNoScale) {
  Document d = two_eggs({Camera::Type::orthographic, 200, 0, 0}, Vec3::Zero());
  artisketch::Run run;
  EXPECT_TRUE(calibrate_paper(d, run)->warnings.empty());
  d.calibration.scale = true;
  d.frames[1].scale = 1.5;
  const auto found = calibrate_paper(d, run);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->warnings.size(), 1u);
  EXPECT_EQ(found->scales[1], 1.5);
}

TEST(CalibratePaper, ACameraThatMustDollyBack) {  // the paper's Fig. 4
  const Document d = two_eggs({Camera::Type::perspective, 0, 800, 4}, {0, 0, -0.6});
  artisketch::Run run;
  const auto found = calibrate_paper(d, run);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->poses[1].root_position.z(), -0.6, 0.15);  // a voxel at the outline
}

TEST(CalibratePaper, StaysWithinItsLimits) {
  Document d = two_eggs({Camera::Type::orthographic, 200, 0, 0}, {0, -0.2, 0});
  d.calibration.max_translation = 0.05;
  d.calibration.locked = {0};
  artisketch::Run run;
  const auto found = calibrate_paper(d, run);
  ASSERT_TRUE(found);
  EXPECT_LE(found->poses[1].root_position.norm(), 0.05 + 1e-12);
  EXPECT_EQ(found->poses[1].rotations[0].coeffs(), d.frames[1].pose.rotations[0].coeffs());
}

TEST(CalibratePaper, StopsWhenAsked) {
  const std::atomic<bool> stop = true;
  artisketch::Run run;
  run.cancel = &stop;
  const auto found =
      calibrate_paper(two_eggs({Camera::Type::orthographic, 200, 0, 0}, {0, -0.2, 0}), run);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().kind, Error::Kind::cancelled);
}

TEST(RayVoxels, ARayPassesThroughNeighbours) {
  const VoxelCube cube{Vec3(-1, -1, -1), 0.25, 8};
  const Ray ray{Vec3(-3, 0.1, 0.3), Vec3(1, 0.2, -0.1).normalized()};
  const std::vector<int> voxels = voxels_along(cube, ray, false);
  ASSERT_GE(voxels.size(), 8u);
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const Vec3 c = cube.centre(voxels[i]);
    EXPECT_LT((c - ray.origin).cross(ray.direction).norm(), 0.25 * std::sqrt(3.0) / 2);
    if (i > 0) {
      EXPECT_NEAR((c - cube.centre(voxels[i - 1])).norm(), 0.25, 1e-12);
    }
  }
  EXPECT_TRUE(voxels_along(cube, {Vec3(-3, 5, 0), Vec3(1, 0, 0)}, true).empty());
}

TEST(RayVoxels, BestPairPrefersVoxelsThatMoreFramesHit) {
  const VoxelCube cube{Vec3::Zero(), 1, 16};
  const auto line_x = [&](double y, double z) {
    return voxels_along(cube, {Vec3(-1, y, z), Vec3::UnitX()}, false);
  };
  const auto line_z = voxels_along(cube, {Vec3(10.5, 6.5, -1), Vec3::UnitZ()}, false);
  HitCount all(cube);
  all.add({line_x(6.5, 8.5), line_x(6.5, 8.5)});
  all.add({line_z});
  EXPECT_EQ(all.frames(), 2);
  EXPECT_EQ(*std::max_element(line_z.begin(), line_z.end(),
                              [&](int a, int b) { return all.of(a) < all.of(b); }),
            line_z[8]);
  const HitVoxels hits(cube, {line_x(6.5, 8.5)}, all);
  const Ray line{Vec3(-1, 4.5, 8.5), Vec3::UnitX()};
  const auto ray = voxels_along(cube, line, false);
  const HitVoxels::Pair pair = hits.best_pair(ray, line, 1.5, 10);
  EXPECT_NEAR((cube.centre(pair.hit) - Vec3(10.5, 6.5, 8.5)).norm(), 0, 1e-9);
  EXPECT_NEAR(pair.cost, 2, 1e-9);
  EXPECT_EQ(hits.best_pair(ray, line, 1.5, 1).on_ray, -1);
}

TEST(EulerSolver, FindsABentArm) {
  Skeleton s;
  s.joints = {{"upper", -1, Vec3::Zero(), -1, ""}, {"lower", 0, Vec3(1, 0, 0), -1, ""}};
  const Pose user = rest_pose(s);
  Pose bent = user;
  bent.root_position = Vec3(0.1, 0.2, -0.1);
  bent.rotations[0] = Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized());
  bent.rotations[1] = Eigen::AngleAxisd(-0.4, Vec3::UnitY());
  const auto to_world = skinning_transforms(s, bent);
  std::vector<PointPair> pairs;
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 12; ++i) {
      const Vec3 p(j + 0.1 * i, 0.2 * std::sin(2.0 * i), 0.2 * std::cos(2.0 * i));
      pairs.push_back({j, p, to_world[j] * p, 1});
    }
  const Pose found = solve_pose(s, user, user, pairs, {radians(60), 1, {1, 1}});
  EXPECT_LT((found.root_position - bent.root_position).norm(), 1e-3);
  for (int j = 0; j < 2; ++j)
    EXPECT_LT(found.rotations[j].angularDistance(bent.rotations[j]), 2e-3);
  const Pose limited = solve_pose(s, user, user, pairs, {radians(10), 0.1, {1, 1}});
  EXPECT_LE(limited.root_position.norm(), 0.1 + 1e-12);
  for (int j = 0; j < 2; ++j)
    EXPECT_LE(limited.rotations[j].angularDistance(user.rotations[j]), radians(10) + 1e-9);
  EXPECT_GT(limited.rotations[1].angularDistance(user.rotations[1]), radians(9));
}

}  // namespace
}  // namespace artisketch
