#include <algorithm>
#include <atomic>
#include <cmath>

#include <gtest/gtest.h>

#include "base/coarsen.h"
#include "model/drawn_parts.h"
#include "model/stages.h"

namespace artisketch {
namespace {

std::vector<Rim> rims_on(const Part& part, const Mesh& mesh) {
  artisketch::Run run;
  const Result<std::vector<Rim>> rims = rim_paths(part, mesh, run);
  EXPECT_TRUE(rims);
  return *rims;
}

void expect_closed_path(const Rim& rim, const Mesh& mesh) {
  const Adjacency adjacency = vertex_adjacency(mesh);
  ASSERT_GE(rim.vertices.size(), 3u);
  for (std::size_t i = 0; i < rim.vertices.size(); ++i) {
    const int next = rim.vertices[(i + 1) % rim.vertices.size()];
    const auto near = adjacency.of(rim.vertices[i]);
    EXPECT_NE(std::find(near.begin(), near.end(), next), near.end());
  }
}

// How often the rim goes round the middle of the picture.
double turns(const Rim& rim, const Mesh& mesh, const PartView& view) {
  const Vec2 middle = view.outline.box().center();
  double angle = 0;
  for (std::size_t i = 0; i < rim.vertices.size(); ++i) {
    const int v = rim.vertices[i], w = rim.vertices[(i + 1) % rim.vertices.size()];
    const Vec2 a = view.project(mesh.V.row(v).transpose()) - middle;
    const Vec2 b = view.project(mesh.V.row(w).transpose()) - middle;
    angle += std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
  }
  return std::abs(angle) / (2 * kPi);
}

double mean_off_contour(const Rim& rim, const Mesh& mesh, const PartView& view) {
  double sum = 0;
  for (const int v : rim.vertices)
    sum += std::abs(view.outline.distance(view.project(mesh.V.row(v).transpose())));
  return sum / double(rim.vertices.size());
}

TEST(RimPaths, OfASphereAreItsGreatCircles) {
  const Part part = drawn::two_circles();
  const Mesh sphere = icosphere(Vec3::Zero(), 1, 4);
  const std::vector<Rim> rims = rims_on(part, sphere);
  ASSERT_EQ(rims.size(), 2u);
  for (int r = 0; r < 2; ++r) {
    SCOPED_TRACE(r);
    EXPECT_EQ(rims[r].frame, r);
    expect_closed_path(rims[r], sphere);
    EXPECT_NEAR(turns(rims[r], sphere, part.views[r]), 1, 1e-6);
    EXPECT_LT(mean_off_contour(rims[r], sphere, part.views[r]), 0.5);
    double length = 0;
    for (std::size_t i = 0; i < rims[r].vertices.size(); ++i) {
      const int v = rims[r].vertices[i], w = rims[r].vertices[(i + 1) % rims[r].vertices.size()];
      length += (sphere.V.row(v) - sphere.V.row(w)).norm();
      const double depth = (part.views[r].to_world * Vec3(sphere.V.row(v).transpose())).z();
      EXPECT_LT(std::abs(depth), 0.2);
    }
    EXPECT_NEAR(length, 2 * kPi, 0.2 * 2 * kPi);
  }
}

// The hull follows each contour ray for a stretch; the rim keeps to the middle of it.
TEST(RimPaths, OfAHullKeepToTheMiddleInDepth) {
  const Part part = drawn::two_circles();
  const Mesh hull = coarsened(*isosurface(drawn::hull_of(part, 48)), 4000);
  const std::vector<Rim> rims = rims_on(part, hull);
  ASSERT_EQ(rims.size(), 2u);
  for (int r = 0; r < 2; ++r) {
    expect_closed_path(rims[r], hull);
    EXPECT_NEAR(turns(rims[r], hull, part.views[r]), 1, 1e-6);
    EXPECT_LT(mean_off_contour(rims[r], hull, part.views[r]), 2);
    double mean = 0;
    for (const int v : rims[r].vertices)
      mean += std::abs((part.views[r].to_world * Vec3(hull.V.row(v).transpose())).z());
    EXPECT_LT(mean / double(rims[r].vertices.size()), 0.08);
  }
}

TEST(RimPaths, FollowHolesToo) {
  const Part part = drawn::ring();
  const Mesh hull = *isosurface(drawn::hull_of(part, 48));
  const std::vector<Rim> rims = rims_on(part, hull);
  ASSERT_EQ(rims.size(), 3u);
  EXPECT_EQ(rims[0].frame, 0);
  EXPECT_EQ(rims[1].frame, 0);
  EXPECT_EQ(rims[2].frame, 1);
  const auto mean_radius = [&](const Rim& rim) {
    double sum = 0;
    for (const int v : rim.vertices) sum += hull.V.row(v).head<2>().norm();
    return sum / double(rim.vertices.size());
  };
  const auto [inner, outer] = std::minmax({mean_radius(rims[0]), mean_radius(rims[1])});
  EXPECT_NEAR(outer, 1, 0.05);
  EXPECT_NEAR(inner, 0.55, 0.05);
  for (const Rim& rim : rims) expect_closed_path(rim, hull);
}

TEST(RimPaths, LeaveOutWhatTheSurfaceDoesNotReach) {
  const Part part = drawn::part({{drawn::from_front(), {drawn::ellipse(1, 1)}, {}},
                                 {drawn::from_right(), {drawn::ellipse(3, 3)}, {}}});
  const std::vector<Rim> rims = rims_on(part, icosphere(Vec3::Zero(), 1, 3));
  ASSERT_EQ(rims.size(), 1u);
  EXPECT_EQ(rims[0].frame, 0);
}

TEST(RimPaths, OfNothingAreNone) {
  EXPECT_TRUE(rims_on(drawn::two_circles(), Mesh{Points3(0, 3), Triangles(0, 3)}).empty());
}

TEST(RimPaths, StopWhenToldTo) {
  const std::atomic<bool> cancel = true;
  artisketch::Run run;
  run.cancel = &cancel;
  const auto rims = rim_paths(drawn::two_circles(), icosphere(Vec3::Zero(), 1, 3), run);
  ASSERT_FALSE(rims);
  EXPECT_EQ(rims.error().kind, Error::Kind::cancelled);
}

}  // namespace
}  // namespace artisketch
