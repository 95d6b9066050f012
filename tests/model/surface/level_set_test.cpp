#include <atomic>
#include <cmath>

#include <gtest/gtest.h>

#include "model/drawn_parts.h"
#include "model/stages.h"

namespace artisketch {
namespace {

Grid3<float> evolved(const Part& part, const Grid3<float>& hull,
                     const LevelSetOptions& options = {}) {
  artisketch::Run run;
  const Result<Grid3<float>> field = level_set(part, hull, options, run);
  EXPECT_TRUE(field);
  return *field;
}

TEST(LevelSet, StaysOnTheHullWhereTheViewsAgree) {
  const Part part = drawn::two_circles();
  const Grid3<float> hull = drawn::hull_of(part, 48);
  const Grid3<float> field = evolved(part, hull);
  const Mesh mesh = *isosurface(field);
  double mean = 0;
  for (int v = 0; v < mesh.V.rows(); ++v) {
    const double off = sample(hull, mesh.V.row(v).transpose()) / hull.cell;
    EXPECT_LT(std::abs(off), 1.1);  // at the creases, which it rounds
    mean += std::abs(off) / double(mesh.V.rows());
  }
  EXPECT_LT(mean, 0.3);
  EXPECT_NEAR(signed_volume(mesh), 16.0 / 3, 0.03 * 16 / 3);  // Steinmetz's solid
  for (const PartView& view : part.views) EXPECT_GT(drawn::silhouette_fit(view, mesh), 0.975);
}

TEST(LevelSet, IsASignedDistanceNearTheSurface) {
  const Part part = drawn::two_circles();
  const Grid3<float> field = evolved(part, drawn::hull_of(part, 40));
  const Mesh mesh = *isosurface(field);
  const Points3 normals = vertex_normals(mesh);
  double mean = 0;
  for (int v = 0; v < mesh.V.rows(); ++v) {
    const Vec3 p = mesh.V.row(v).transpose(), n = normals.row(v).transpose();
    mean += (sample(field, p + field.cell * n) - sample(field, p - field.cell * n)) /
            (2 * field.cell) / double(mesh.V.rows());
  }
  EXPECT_NEAR(mean, 1, 0.1);
}

// Creases are sharp in the hull and smooth after.
TEST(LevelSet, RoundsTheCreasesOfTheHull) {
  const Part part = drawn::two_circles();
  const Grid3<float> hull = drawn::hull_of(part, 40);
  const auto sharpest = [](const Grid3<float>& field) {
    const Mesh mesh = *isosurface(field);
    const Points3 normals = vertex_normals(mesh);
    double least = 1;
    for (int f = 0; f < mesh.F.rows(); ++f)
      for (int c = 0; c < 3; ++c)
        least = std::min(least, normals.row(mesh.F(f, c)).dot(normals.row(mesh.F(f, (c + 1) % 3))));
    return least;
  };
  EXPECT_GT(sharpest(evolved(part, hull)), sharpest(hull));
}

TEST(LevelSet, DoesNotDriftOrBurstWithTime) {
  const Part part = drawn::ring();
  const Grid3<float> hull = drawn::hull_of(part, 32);
  LevelSetOptions longer;
  longer.iterations = 200;
  const double volume = signed_volume(*isosurface(evolved(part, hull)));
  EXPECT_NEAR(signed_volume(*isosurface(evolved(part, hull, longer))), volume, 0.03 * volume);
}

TEST(LevelSet, KeepsTheHoleOfARing) {
  const Part part = drawn::ring();
  const Topology t = topology(*isosurface(evolved(part, drawn::hull_of(part, 40))));
  EXPECT_EQ(t.genus(), 1);
}

// An open stroke drawn two cells inside the outline, from a side of its own, pulls the surface to
// where the view's rays through it run.
TEST(LevelSet, AnOpenStrokePullsByTheEdgeTermAlone) {
  const double cell = 2.0 / 40, inside = 1 - 1.5 * cell;
  drawn::Side above{drawn::from_above(), {}, {{{-0.3, -inside}, {0, -inside}, {0.3, -inside}}}};
  const Part without = drawn::two_circles();
  Part with = drawn::part({{drawn::from_front(), {drawn::ellipse(1, 1)}, {}},
                           {drawn::from_right(), {drawn::ellipse(1, 1)}, {}},
                           above});
  const Grid3<float> hull = drawn::hull_of(without, 40);
  ASSERT_FALSE(with.views[2].seen());
  LevelSetOptions options;
  options.region = 0.3;
  const Grid3<float> plain = evolved(without, hull, options), pulled = evolved(with, hull, options);
  // Before the stroke, in the middle: one of the hull's two flat ends.
  const Vec3 front = with.views[2].ray(with.views[2].contours[0].points[1]).origin;
  const Vec3 probe(0, 0, std::copysign(1, front.z()));
  EXPECT_GT(sample(pulled, probe), sample(plain, probe) + 0.1 * cell);
  // Behind, where nothing was drawn, it stays.
  EXPECT_NEAR(sample(pulled, -probe), sample(plain, -probe), 0.1 * cell);
}

TEST(LevelSet, KeepsTheBodyThatWidenedContoursLeave) {
  const Part part = drawn::part({{drawn::from_front(), {drawn::ellipse(0.3, 0.3, {0, 0.4})}, {}},
                                 {drawn::from_right(), {drawn::ellipse(0.3, 0.3, {0, -0.4})}, {}}});
  const Grid3<float> hull = drawn::hull_of(part, 32);
  const Result<Mesh> body = isosurface(evolved(part, hull));
  ASSERT_TRUE(body);
  const double volume = signed_volume(*isosurface(hull));
  EXPECT_NEAR(signed_volume(*body), volume, 0.1 * volume);
}

TEST(LevelSet, GrownContoursMoveTheSurfaceOut) {
  const Part part = drawn::two_circles();
  const Grid3<float> hull = drawn::hull_of(part, 32);
  LevelSetOptions options;
  options.grown = 1;
  const Mesh mesh = *isosurface(evolved(part, hull, options));
  double mean = 0;
  for (int v = 0; v < mesh.V.rows(); ++v)
    mean += sample(hull, mesh.V.row(v).transpose()) / hull.cell / double(mesh.V.rows());
  EXPECT_NEAR(mean, 1, 0.4);
}

TEST(LevelSet, StopsWhenToldTo) {
  const Part part = drawn::two_circles();
  const Grid3<float> hull = drawn::hull_of(part, 24);
  const std::atomic<bool> cancel = true;
  artisketch::Run run;
  run.cancel = &cancel;
  const Result<Grid3<float>> field = level_set(part, hull, {}, run);
  ASSERT_FALSE(field);
  EXPECT_EQ(field.error().kind, Error::Kind::cancelled);
}

}  // namespace
}  // namespace artisketch
