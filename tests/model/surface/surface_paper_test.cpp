#include <atomic>
#include <cmath>

#include <gtest/gtest.h>

#include "model/drawn_parts.h"
#include "model/stages.h"

namespace artisketch {
namespace {

PartSurface surface_of(const Part& part, int grid = 36) {
  artisketch::Run run;
  const Result<PartSurface> surface = surface_paper(part, {Method::paper, grid, false}, run);
  EXPECT_TRUE(surface) << (surface ? "" : surface.error().text());
  return *surface;
}

void expect_sound(const PartSurface& surface, int genus) {
  const Topology t = topology(surface.mesh);
  EXPECT_TRUE(t.manifold());
  EXPECT_EQ(t.components, 1);
  EXPECT_EQ(t.genus(), genus);
  EXPECT_GT(signed_volume(surface.mesh), 0);
  const Result<Mesh> sampled = isosurface(surface.distance);
  ASSERT_TRUE(sampled);
  EXPECT_EQ(topology(*sampled).genus(), genus);
  // The field holds all of the mesh, not an island of it.
  const Box3 a = bounds(surface.mesh.V), b = bounds(sampled->V);
  EXPECT_LT((a.sizes() - b.sizes()).cwiseAbs().maxCoeff(), 4 * surface.distance.cell);
}

void expect_silhouettes(const Part& part, const Mesh& mesh, double least) {
  for (const PartView& view : part.views)
    EXPECT_GT(drawn::silhouette_fit(view, mesh), least) << "frame " << view.frame;
}

TEST(SurfacePaper, TwoCirclesGiveASphere) {
  const Part part = drawn::two_circles();
  const PartSurface surface = surface_of(part);
  expect_sound(surface, 0);
  EXPECT_NEAR(signed_volume(surface.mesh), 4 * kPi / 3, 0.05 * 4 * kPi / 3);
  expect_silhouettes(part, surface.mesh, 0.99);
  EXPECT_EQ(surface.rims.size(), 2u);
  EXPECT_TRUE(surface.warnings.empty());
  // The field is the mesh's own distance.
  for (int v = 0; v < surface.mesh.V.rows(); v += 17)
    EXPECT_NEAR(sample(surface.distance, surface.mesh.V.row(v).transpose()), 0,
                0.3 * surface.distance.cell);
}

TEST(SurfacePaper, FatnessBulgesBetweenSilhouettesThatStay) {
  Part part = drawn::two_circles();
  double last = 0;
  for (const double fatness : {0.6, 1.0, 1.5}) {
    part.fatness = fatness;
    const PartSurface surface = surface_of(part);
    expect_sound(surface, 0);
    expect_silhouettes(part, surface.mesh, 0.985);
    const double volume = signed_volume(surface.mesh);
    EXPECT_GT(volume, 1.03 * last) << fatness;
    last = volume;
  }
}

TEST(SurfacePaper, ThinPartsAreThinnedNoFurtherThanTheyHold) {
  Part ring = drawn::ring();
  ring.fatness = 0.1;
  expect_sound(surface_of(ring, 40), 1);
}

TEST(SurfacePaper, ARingKeepsItsHole) {
  const Part part = drawn::ring();
  const PartSurface surface = surface_of(part, 40);
  expect_sound(surface, 1);
  expect_silhouettes(part, surface.mesh, 0.975);
}

// Thinner than a cell of the grid that was asked for, and askew to it.
TEST(SurfacePaper, ABladeStaysOnePiece) {
  const Quat askew(Eigen::AngleAxisd(0.6, Vec3(1, 2, 3).normalized()));
  const Part part = drawn::part({{askew, {drawn::rectangle(0.08, 1)}, {}},
                                 {drawn::from_right() * askew, {drawn::rectangle(0.01, 1)}, {}}},
                                200);
  const PartSurface surface = surface_of(part, 32);
  expect_sound(surface, 0);
  EXPECT_GT(drawn::silhouette_fit(part.views[0], surface.mesh), 0.95);
  EXPECT_GT((bounds(surface.mesh.V).sizes()).norm(), 1.8);
}

TEST(SurfacePaper, WhatIsSeenFromOneDirectionIsRound) {
  const Part part = drawn::part({{drawn::from_front(), {drawn::ellipse(0.5, 0.5)}, {}}});
  const PartSurface surface = surface_of(part, 40);
  expect_sound(surface, 0);
  expect_silhouettes(part, surface.mesh, 0.975);
  const Vec3 size = bounds(surface.mesh.V).sizes();
  EXPECT_NEAR(size.z(), 1, 0.25);
  EXPECT_LT(signed_volume(surface.mesh), 0.8 * size.prod());  // no slab
}

// Contours that contradict each other: a warning in words, and the best that can be had.
TEST(SurfacePaper, ViewsThatShareNoVolumeGiveABodyAndAWarning) {
  const Part part = drawn::part({{drawn::from_front(), {drawn::ellipse(0.2, 0.2, {0, 0.7})}, {}},
                                 {drawn::from_right(), {drawn::ellipse(0.2, 0.2, {0, -0.7})}, {}}});
  const PartSurface surface = surface_of(part, 32);
  expect_sound(surface, 0);
  ASSERT_FALSE(surface.warnings.empty());
  EXPECT_NE(surface.warnings[0].find("part"), std::string::npos);
}

TEST(SurfacePaper, SaysWhichContoursItsSurfaceMisses) {
  const Part part =
      drawn::part({{drawn::from_front(),
                    {drawn::ellipse(0.3, 0.3, {-0.5, 0}), drawn::ellipse(0.2, 0.2, {0.5, 0})},
                    {}},
                   {drawn::from_right(), {drawn::ellipse(0.3, 0.3)}, {}}});
  const PartSurface surface = surface_of(part, 40);
  expect_sound(surface, 0);
  ASSERT_EQ(surface.warnings.size(), 1u);
  EXPECT_NE(surface.warnings[0].find("1 of its 2 contours in frame 1"), std::string::npos)
      << surface.warnings[0];
}

TEST(SurfacePaper, TheHullAloneIsTheHull) {
  const Part part = drawn::two_circles();
  artisketch::Run run;
  const Result<PartSurface> surface = surface_paper(part, {Method::paper, 40, true}, run);
  ASSERT_TRUE(surface);
  expect_sound(*surface, 0);
  EXPECT_NEAR(signed_volume(surface->mesh), 16.0 / 3, 0.02 * 16 / 3);
  EXPECT_TRUE(surface->rims.empty());
}

TEST(SurfacePaper, LeavesATrace) {
  Trace trace;
  artisketch::Run run;
  run.trace = &trace;
  ASSERT_TRUE(surface_paper(drawn::two_circles(), {Method::paper, 24, false}, run));
  std::vector<std::string> names;
  for (const Trace::Entry& entry : trace.entries) names.push_back(entry.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"part/hull", "part/level set", "part/rims", "part/surface"}));
}

TEST(SurfacePaper, ReportsProgressThatNeverFalls) {
  artisketch::Run run;
  double last = 0;
  int calls = 0;
  run.from = 0.25;
  run.to = 0.5;
  run.on_progress = [&](const Progress& p) {
    EXPECT_GE(p.fraction, last - 1e-12);
    last = p.fraction;
    ++calls;
  };
  ASSERT_TRUE(surface_paper(drawn::two_circles(), {Method::paper, 24, false}, run));
  EXPECT_GT(calls, 10);
  EXPECT_NEAR(last, 0.5, 1e-9);
}

TEST(SurfacePaper, IsTheSameEveryTime) {
  const Part part = drawn::ring();
  const PartSurface a = surface_of(part, 32), b = surface_of(part, 32);
  EXPECT_EQ(a.mesh.V, b.mesh.V);
  EXPECT_EQ(a.mesh.F, b.mesh.F);
  EXPECT_EQ(a.distance.values, b.distance.values);
}

TEST(SurfacePaper, StopsWhenToldTo) {
  const std::atomic<bool> cancel = true;
  artisketch::Run run;
  run.cancel = &cancel;
  const auto surface = surface_paper(drawn::two_circles(), {Method::paper, 48, false}, run);
  ASSERT_FALSE(surface);
  EXPECT_EQ(surface.error().kind, Error::Kind::cancelled);
}

TEST(SurfacePaper, NeedsAClosedContour) {
  const Part part = drawn::part({{drawn::from_front(), {}, {{{0, 0}, {0.5, 0.5}, {1, 0}}}}});
  artisketch::Run run;
  const auto surface = surface_paper(part, {Method::paper, 32, false}, run);
  ASSERT_FALSE(surface);
  EXPECT_NE(surface.error().text().find("part"), std::string::npos);
}

}  // namespace
}  // namespace artisketch
