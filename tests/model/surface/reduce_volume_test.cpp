#include <atomic>
#include <cmath>

#include <gtest/gtest.h>

#include "base/coarsen.h"
#include "model/drawn_parts.h"
#include "model/stages.h"

namespace artisketch {
namespace {

struct Reduced {
  Mesh before, after;
};

Reduced reduced(const Part& part, int cells, int vertices, bool soft) {
  artisketch::Run run;
  Reduced r;
  r.before = coarsened(*isosurface(drawn::hull_of(part, cells)), vertices);
  const std::vector<Rim> rims = *rim_paths(part, r.before, run);
  r.after = *reduce_volume(part, r.before, rims, {soft}, run);
  return r;
}

// The paper's two circles: what spans them is as good as a ball.
class TwoCircles : public testing::TestWithParam<bool> {};

TEST_P(TwoCircles, BecomeASphere) {
  const double radius = 1.5;
  const Reduced r = reduced(drawn::two_circles(radius), 48, 4000, GetParam());
  const double ball = 4 * kPi / 3 * std::pow(radius, 3);
  EXPECT_GT(signed_volume(r.before), 1.2 * ball);  // the hull
  EXPECT_NEAR(signed_volume(r.after), ball, 0.02 * ball);
  double mean = 0;
  for (int v = 0; v < r.after.V.rows(); ++v) {
    const double error = std::abs(r.after.V.row(v).norm() / radius - 1);
    EXPECT_LT(error, 0.07);
    mean += error / double(r.after.V.rows());
  }
  EXPECT_LT(mean, 0.015);
}

TEST_P(TwoCircles, KeepTheirSilhouettes) {
  const Part part = drawn::two_circles();
  const Reduced r = reduced(part, 40, 3000, GetParam());
  for (const PartView& view : part.views) EXPECT_GT(drawn::silhouette_fit(view, r.after), 0.99);
}

TEST_P(TwoCircles, KeepTheirFaces) {
  const Reduced r = reduced(drawn::two_circles(), 24, 1000, GetParam());
  EXPECT_EQ(r.after.F, r.before.F);
  EXPECT_TRUE(topology(r.after).manifold());
}

INSTANTIATE_TEST_SUITE_P(ReduceVolume, TwoCircles, testing::Bool(),
                         [](const auto& info) { return info.param ? "Soft" : "Hard"; });

// A notch in one view: what spans the rims beside it must not fill it.
TEST(ReduceVolume, StaysInsideANotchedSilhouette) {
  const drawn::Outline notched = {{-0.8, -0.5}, {0.8, -0.5},  {0.8, 0.5},   {0.25, 0.5},
                                  {0.25, 0.1},  {-0.25, 0.1}, {-0.25, 0.5}, {-0.8, 0.5}};
  const Part part = drawn::part({{drawn::from_front(), {notched}, {}},
                                 {drawn::from_right(), {drawn::ellipse(0.5, 0.5)}, {}}});
  const Reduced r = reduced(part, 48, 4000, false);
  for (const PartView& view : part.views) EXPECT_GT(drawn::silhouette_fit(view, r.after), 0.975);
}

TEST(ReduceVolume, WithoutRimsChangesNothing) {
  artisketch::Run run;
  const Mesh sphere = icosphere(Vec3::Zero(), 1, 2);
  const Result<Mesh> same = reduce_volume(drawn::two_circles(), sphere, {}, {}, run);
  ASSERT_TRUE(same);
  EXPECT_EQ(same->V, sphere.V);
}

// One anchored ring on a mesh with triangles of no area, one piece of it without any anchor.
TEST(ReduceVolume, StaysFiniteOnBadMeshes) {
  artisketch::Run run;
  const Part part = drawn::two_circles();
  Mesh mesh = icosphere(Vec3::Zero(), 1, 3);
  const std::vector<Rim> rims = *rim_paths(part, mesh, run);
  const int n = int(mesh.V.rows()), m = int(mesh.F.rows());
  mesh.V.conservativeResize(2 * n, 3);
  mesh.F.conservativeResize(2 * m, 3);
  mesh.V.bottomRows(n) = mesh.V.topRows(n).rowwise() + Eigen::RowVector3d(5, 0, 0);
  mesh.F.bottomRows(m) = mesh.F.topRows(m).array() + n;
  for (int v = 0; v < 40; ++v) mesh.V.row(v + 1) = mesh.V.row(0);
  for (const bool soft : {false, true}) {
    const Result<Mesh> result = reduce_volume(part, mesh, rims, {soft}, run);
    ASSERT_TRUE(result);
    EXPECT_TRUE(result->V.allFinite());
    EXPECT_LT(result->V.cwiseAbs().maxCoeff(), 20);
  }
}

TEST(ReduceVolume, TakesAMeshWithoutSize) {
  artisketch::Run run;
  Mesh point = icosphere(Vec3::Zero(), 1, 1);
  point.V.setZero();
  const Result<Mesh> same = reduce_volume(drawn::two_circles(), point, {}, {}, run);
  ASSERT_TRUE(same);
  EXPECT_TRUE(same->V.allFinite());
}

TEST(ReduceVolume, StopsWhenToldTo) {
  const Part part = drawn::two_circles();
  const Mesh sphere = icosphere(Vec3::Zero(), 1, 3);
  artisketch::Run run;
  const std::vector<Rim> rims = *rim_paths(part, sphere, run);
  const std::atomic<bool> cancel = true;
  run.cancel = &cancel;
  const Result<Mesh> result = reduce_volume(part, sphere, rims, {}, run);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().kind, Error::Kind::cancelled);
}

}  // namespace
}  // namespace artisketch
