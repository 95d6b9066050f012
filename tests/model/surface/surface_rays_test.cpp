#include <array>
#include <atomic>
#include <cmath>

#include <gtest/gtest.h>

#include "model/drawn_parts.h"
#include "model/stages.h"
#include "model/surface/carving.h"
#include "model/surface/ray_rims.h"
#include "model/surface/rays_field.h"

namespace artisketch {
namespace {

using drawn::ellipse;
using drawn::from_above;
using drawn::from_front;
using drawn::from_right;
using drawn::rectangle;

PartSurface surface_of(const Part& part, int grid = 48) {
  artisketch::Run run;
  const Result<PartSurface> surface = surface_rays(part, {Method::rays, grid, false}, run);
  EXPECT_TRUE(surface) << (surface ? "" : surface.error().text());
  return *surface;
}

void expect_sound(const PartSurface& surface, int genus = 0) {
  const Topology t = topology(surface.mesh);
  EXPECT_TRUE(t.manifold());
  EXPECT_EQ(t.components, 1);
  EXPECT_EQ(t.genus(), genus);
  EXPECT_GT(signed_volume(surface.mesh), 0);
}

void expect_silhouettes(const Part& part, const Mesh& mesh, double least) {
  for (const PartView& view : part.views)
    EXPECT_GT(drawn::silhouette_fit(view, mesh), least) << "frame " << view.frame;
}

double hull_volume(const Part& part, int grid = 48) {
  return signed_volume(*isosurface(drawn::hull_of(part, grid)));
}

TEST(SurfaceRays, TwoCirclesGiveASphere) {
  const PartSurface surface = surface_of(drawn::two_circles(), 100);
  expect_sound(surface);
  double mean = 0;
  for (int v = 0; v < surface.mesh.V.rows(); ++v) {
    const double error = std::abs(surface.mesh.V.row(v).norm() - 1);
    EXPECT_LT(error, 0.02);
    mean += error / double(surface.mesh.V.rows());
  }
  EXPECT_LT(mean, 0.005);
  EXPECT_NEAR(signed_volume(surface.mesh), 4 * kPi / 3, 0.01 * 4 * kPi / 3);
}

// Cones that open so fast leave a hull far larger than the ball.
TEST(SurfaceRays, ABallDrawnFromNearIsABall) {
  for (const double distance : {2.0, 3.0}) {
    const Part part = drawn::near_ball(distance);
    const PartSurface surface = surface_of(part, 64);
    expect_sound(surface);
    expect_silhouettes(part, surface.mesh, 0.99);
    double mean = 0;
    for (int v = 0; v < surface.mesh.V.rows(); ++v)
      mean += std::abs(surface.mesh.V.row(v).norm() - 1) / double(surface.mesh.V.rows());
    EXPECT_LT(mean, 0.55 / std::pow(distance, 3)) << "from " << distance;
  }
}

TEST(SurfaceRays, ThreeEllipsesGiveAnEllipsoid) {
  const Part part = drawn::part({{from_front(), {ellipse(0.8, 1)}, {}},
                                 {from_right(), {ellipse(0.5, 1)}, {}},
                                 {from_above(), {ellipse(0.8, 0.5)}, {}}});
  const PartSurface surface = surface_of(part, 64);
  expect_sound(surface);
  const double truth = 4 * kPi / 3 * 0.8 * 0.5;
  EXPECT_NEAR(signed_volume(surface.mesh), truth, 0.01 * truth);
  expect_silhouettes(part, surface.mesh, 0.99);
}

// Hearts from the front and from the side, as the paper's figure 5.
TEST(SurfaceRays, HeartsKeepTheirSilhouettesInLessThanTheHull) {
  drawn::Outline heart;
  for (int i = 0; i < 200; ++i) {
    const double t = 2 * kPi * i / 200;
    heart.push_back(
        {std::pow(std::sin(t), 3),
         (13 * std::cos(t) - 5 * std::cos(2 * t) - 2 * std::cos(3 * t) - std::cos(4 * t)) / 16});
  }
  const Part part = drawn::part({{from_front(), {heart}, {}}, {from_right(), {heart}, {}}}, 150);
  const PartSurface surface = surface_of(part, 100);
  expect_sound(surface);
  expect_silhouettes(part, surface.mesh, 0.99);
  EXPECT_LT(signed_volume(surface.mesh), 0.93 * hull_volume(part, 100));
}

TEST(SurfaceRays, ARingKeepsItsHole) {
  const Part part = drawn::ring();
  const PartSurface surface = surface_of(part, 64);
  expect_sound(surface, 1);
  expect_silhouettes(part, surface.mesh, 0.97);
}

TEST(SurfaceRays, ABladeStaysOnePiece) {
  const Quat askew(Eigen::AngleAxisd(0.6, Vec3(1, 2, 3).normalized()));
  const Part part = drawn::part(
      {{askew, {rectangle(0.08, 1)}, {}}, {from_right() * askew, {rectangle(0.02, 1)}, {}}}, 200);
  const PartSurface surface = surface_of(part, 100);
  expect_sound(surface);
  EXPECT_GT(bounds(surface.mesh.V).sizes().norm(), 1.8);
  EXPECT_GT(drawn::silhouette_fit(part.views[0], surface.mesh), 0.94);
}

TEST(SurfaceRays, LongAndFlatParts) {
  const Part staff = drawn::part(
      {{from_front(), {ellipse(0.05, 2)}, {}}, {from_right(), {ellipse(0.05, 2)}, {}}}, 120);
  expect_sound(surface_of(staff));
  const Part plate =
      drawn::part({{from_front(), {ellipse(1, 1)}, {}}, {from_right(), {ellipse(0.08, 1)}, {}}});
  const PartSurface flat = surface_of(plate, 64);
  expect_sound(flat);
  expect_silhouettes(plate, flat.mesh, 0.97);
}

TEST(SurfaceRays, PlatesOfAnyThicknessAreWhole) {
  for (const double thickness : {0.03, 0.05, 0.12, 0.2, 0.3})
    for (const double degrees : {60.0, 90.0}) {
      const Quat turned(Eigen::AngleAxisd(radians(degrees), Vec3::UnitY()));
      // The plate's own width from there: that of an ellipse of half axes 1 and `thickness`.
      const double across =
          std::hypot(std::cos(radians(degrees)), thickness * std::sin(radians(degrees)));
      const Part plate = drawn::part(
          {{from_front(), {ellipse(1, 1)}, {}}, {turned, {ellipse(across, 1)}, {}}}, 200);
      const PartSurface surface = surface_of(plate, 100);
      SCOPED_TRACE(testing::Message() << thickness << " thick, " << degrees);
      expect_sound(surface);
      expect_silhouettes(plate, surface.mesh, 0.95);
    }
}

TEST(SurfaceRays, WhatIsSeenFromOneDirectionIsRound) {
  const Part part = drawn::part({{from_front(), {ellipse(0.5, 0.5)}, {}}});
  const PartSurface surface = surface_of(part);
  expect_sound(surface);
  expect_silhouettes(part, surface.mesh, 0.98);
  EXPECT_NEAR(bounds(surface.mesh.V).sizes().z(), 1, 0.15);
}

// Two sides, `degrees` apart, that show the same outline.
Part twice_drawn(double degrees, const drawn::Outline& first, const drawn::Outline& second) {
  const Quat turned(Eigen::AngleAxisd(radians(degrees), Vec3::UnitY()));
  return drawn::part({{from_front(), {first}, {}}, {turned, {second}, {}}});
}
double depth_over_width(const PartSurface& surface) {
  const Vec3 size = bounds(surface.mesh.V).sizes();
  return size.z() / size.x();
}

// From near sides, and from behind, a limb's depth is a guess: about as deep as wide, and so it
// stays while the sides part, until they show it.
TEST(SurfaceRays, FromSidesNearEachOtherALimbIsAboutAsDeepAsWide) {
  double last = 0;
  for (const double degrees : {0, 5, 9, 11, 15, 20, 30, 45, 60, 75, 90, 165, 180}) {
    const Part part = twice_drawn(degrees, ellipse(0.4, 1), ellipse(0.4, 1));
    const PartSurface surface = surface_of(part);
    expect_sound(surface);
    expect_silhouettes(part, surface.mesh, 0.97);
    const double depth = depth_over_width(surface);
    EXPECT_NEAR(depth, 1, 0.25) << degrees;
    if (degrees > 0) {
      EXPECT_NEAR(depth, last, 0.15) << degrees;
    }
    last = depth;
  }
}

// A hand that draws the part wider, and beside where it was, makes no plank of it.
TEST(SurfaceRays, NearSidesThatContradictEachOtherMakeNoPlank) {
  for (const double degrees : {10, 20, 30, 170}) {
    const Part part = twice_drawn(degrees, ellipse(0.4, 1), ellipse(0.46, 0.94, {0.05, 0.02}));
    const PartSurface surface = surface_of(part);
    expect_sound(surface);
    EXPECT_NEAR(depth_over_width(surface), 1.1, 0.5) << degrees;
    expect_silhouettes(part, surface.mesh, 0.82);
  }
}

// A ball with two pointed ears, as a drawing shows it that has it turned so far.
drawn::Outline eared_ball(double degrees) {
  constexpr double kBall = 0.7, kTip = 1.4, kAside = 0.5, kHalf = 0.18, kBase = 0.4;
  drawn::Outline outline;
  for (int i = 0; i < 720; ++i) {
    const Vec2 way(std::cos(i * kPi / 360), std::sin(i * kPi / 360));
    double far = kBall;
    for (const double side : {-kAside, kAside}) {
      const double x = side * std::cos(radians(degrees));
      const Vec2 tip(x, kTip);
      for (const double edge : {x - kHalf, x + kHalf}) {
        const Vec2 from(edge, kBase), along = tip - from;
        const double across = cross(way, along);
        if (std::abs(across) < 1e-9) continue;
        const double t = cross(from, way) / across, r = cross(from, along) / across;
        if (t >= 0 && t <= 1) far = std::max(far, r);
      }
    }
    outline.push_back(far * way);
  }
  return outline;
}

// What is guessed of a depth takes no ears away.
TEST(SurfaceRays, EarsStayWhereTheDepthIsAGuess) {
  for (const double degrees : {60.0, 65.0}) {
    const Part part = drawn::part(
        {{from_front(), {eared_ball(0)}, {}},
         {Quat(Eigen::AngleAxisd(radians(degrees), Vec3::UnitY())), {eared_ball(degrees)}, {}}});
    const PartSurface surface = surface_of(part, 64);
    expect_sound(surface);
    expect_silhouettes(part, surface.mesh, 0.93);
    double left = 0, right = 0;  // how far up they reach
    for (int v = 0; v < surface.mesh.V.rows(); ++v)
      (surface.mesh.V(v, 0) < 0 ? left : right) =
          std::max(surface.mesh.V(v, 0) < 0 ? left : right, surface.mesh.V(v, 1));
    EXPECT_GT(std::min(left, right), 1.2) << degrees;
  }
}

// The rays are equally far from each other along an outline, and tips that lie between two have
// more.
TEST(SurfaceRays, NoTipIsPassedBy) {
  const Part part =
      drawn::part({{from_front(), {eared_ball(0)}, {}}, {from_right(), {eared_ball(90)}, {}}});
  const Result<Carving> carving = carving_of(part, 64);
  ASSERT_TRUE(carving);
  const Polyline& outline = part.views[0].contours[0];
  Box2 box;
  for (const Vec2& p : outline.points) box.extend(p);
  std::array<Vec2, 2> tips = {box.max(), box.max()};
  for (const Vec2& p : outline.points)
    if (Vec2& tip = tips[p.x() > box.center().x()]; p.y() < tip.y()) tip = p;
  for (const int count : {29, 32, 37, 41, 50}) {
    const std::vector<RayRim> rims = outline_rays(carving->views[0], count);
    ASSERT_EQ(rims.size(), 1u);
    const double spacing = length(outline) / double(rims[0].rays.size());
    for (const Vec2& tip : tips) {
      double nearest = box.sizes().norm();
      for (const RimRay& ray : rims[0].rays) nearest = std::min(nearest, (ray.pixel - tip).norm());
      for (const TipRay& one : rims[0].tips)
        nearest = std::min(nearest, (one.ray.pixel - tip).norm());
      EXPECT_LT(nearest, 0.2 * spacing) << count;
    }
  }
}

// Outlines 35° apart tell something of the depth: less of it is believed where they contradict each
// other, and the part stays nearer to as deep as wide than its outlines would have it (1.41).
TEST(SurfaceRays, OutlinesTellTheDepthAsFarAsTheyAgree) {
  const Part part = twice_drawn(35, ellipse(0.4, 1), ellipse(0.46, 0.94, {0.05, 0.02}));
  EXPECT_LT(depth_over_width(surface_of(part)), 1.39);
}

TEST(SurfaceRays, FatnessActsBetweenNearSides) {
  Part part = twice_drawn(20, ellipse(0.4, 1), ellipse(0.4, 1));
  double last = 0;
  for (const double fatness : {0.6, 1.0, 1.5}) {
    part.fatness = fatness;
    const double depth = depth_over_width(surface_of(part));
    EXPECT_GT(depth, 1.2 * last) << fatness;
    last = depth;
  }
}

// An arm that points half at the camera is as deep as it is long.
TEST(SurfaceRays, OneDrawingOfALeaningLimbFollowsItsBone) {
  Part part = drawn::part({{from_front(), {ellipse(0.9, 0.25)}, {}}});
  part.bones = {{0, 1, {-0.8, 0, -0.8}, {0.8, 0, 0.8}}};
  const PartSurface surface = surface_of(part);
  expect_sound(surface);
  expect_silhouettes(part, surface.mesh, 0.97);
  EXPECT_GT(bounds(surface.mesh.V).sizes().z(), 1.2);
}

TEST(SurfaceRays, StrokesAloneAreNoPartButDoNotHurtOne) {
  artisketch::Run run;
  const drawn::Outline stroke = {{0, 0}, {0.5, 0.5}, {1, 0}};
  const auto none =
      surface_rays(drawn::part({{from_front(), {}, {stroke}}}), {Method::rays, 32, false}, run);
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().text().find("part"), std::string::npos);
  const PartSurface with = surface_of(drawn::part(
      {{from_front(), {ellipse(1, 1)}, {stroke}}, {from_right(), {ellipse(1, 1)}, {}}}));
  EXPECT_NEAR(signed_volume(with.mesh), 4 * kPi / 3, 0.02 * 4 * kPi / 3);
}

// The side view says 4 pixels less at the top and at the bottom than the front view.
TEST(SurfaceRays, ViewsThatDisagreeByPixelsGiveABodyBetweenThem) {
  const Part part =
      drawn::part({{from_front(), {ellipse(1, 1)}, {}}, {from_right(), {ellipse(1, 0.96)}, {}}});
  const PartSurface surface = surface_of(part, 64);
  expect_sound(surface);
  EXPECT_TRUE(surface.warnings.empty());
  expect_silhouettes(part, surface.mesh, 0.95);
}

TEST(SurfaceRays, ViewsThatShareNoVolumeGiveABodyAndAWarning) {
  const Part part = drawn::part({{from_front(), {ellipse(0.2, 0.2, {0, 0.7})}, {}},
                                 {from_right(), {ellipse(0.2, 0.2, {0, -0.7})}, {}}});
  const PartSurface surface = surface_of(part);
  expect_sound(surface);
  ASSERT_FALSE(surface.warnings.empty());
  EXPECT_NE(surface.warnings[0].find("'part'"), std::string::npos);
  EXPECT_NE(surface.warnings[0].find("frames 1, 2"), std::string::npos);
}

// Radii that wander by up to three pixels, slowly, differently in each view.
TEST(SurfaceRays, AWobblyHandGivesNearlyTheCleanShape) {
  const auto wobbly = [](double phase) {
    drawn::Outline outline = ellipse(1, 1);
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const double t = 2 * kPi * double(i) / double(outline.size());
      outline[i] *= 1 + 0.015 * (std::sin(5 * t + phase) + std::sin(8 * t + 2 * phase));
    }
    return outline;
  };
  const Part part = drawn::part({{from_front(), {wobbly(0)}, {}},
                                 {from_right(), {wobbly(1)}, {}},
                                 {from_above(), {wobbly(2)}, {}}});
  const PartSurface surface = surface_of(part, 64);
  expect_sound(surface);
  EXPECT_NEAR(signed_volume(surface.mesh), 4 * kPi / 3, 0.04 * 4 * kPi / 3);
  double mean = 0;
  for (int v = 0; v < surface.mesh.V.rows(); ++v)
    mean += std::abs(surface.mesh.V.row(v).norm() - 1) / double(surface.mesh.V.rows());
  EXPECT_LT(mean, 0.02);
  expect_silhouettes(part, surface.mesh, 0.97);
}

TEST(SurfaceRays, FatnessBulgesBetweenSilhouettesThatStay) {
  for (const std::vector<drawn::Side>& sides :
       {std::vector<drawn::Side>{{from_front(), {ellipse(1, 1)}, {}},
                                 {from_right(), {ellipse(0.7, 1)}, {}}},
        std::vector<drawn::Side>{{from_front(), {ellipse(0.6, 1)}, {}}}}) {
    Part part = drawn::part(sides);
    double last = 0;
    for (const double fatness : {0.5, 0.8, 1.0, 1.2, 1.5}) {
      part.fatness = fatness;
      const PartSurface surface = surface_of(part, 64);
      expect_sound(surface);
      expect_silhouettes(part, surface.mesh, 0.985);
      const double volume = signed_volume(surface.mesh);
      EXPECT_GT(volume, 1.01 * last) << fatness;
      last = volume;
    }
  }
}

TEST(SurfaceRays, ThinPartsAreThinnedNoFurtherThanTheyHold) {
  Part ring = drawn::ring();
  ring.fatness = 0.1;
  expect_sound(surface_of(ring, 64), 1);
}

TEST(SurfaceRays, TheFieldIsTheMeshsDistance) {
  const PartSurface surface = surface_of(drawn::two_circles());
  for (int v = 0; v < surface.mesh.V.rows(); v += 7) {
    const Vec3 p = surface.mesh.V.row(v).transpose();
    EXPECT_NEAR(sample(surface.distance, p), 0, 0.1 * surface.distance.cell);
    for (const double way : {-1.0, 1.0}) {
      const double cells = sample(surface.distance, p * (1 + way * surface.distance.cell));
      EXPECT_NEAR(cells, way * surface.distance.cell, 0.35 * surface.distance.cell);
    }
  }
}

// A finer grid than the smooth surface needs sharpens what the outlines cut: a square prism's edges
// come nearer to it, on the same distances.
TEST(SurfaceRays, TheFinestGridsSharpenTheHullAlone) {
  const Part part = drawn::part(
      {{from_front(), {rectangle(0.5, 1)}, {}}, {from_right(), {ellipse(0.4, 1)}, {}}}, 150);
  const PartSurface given = surface_of(part, kSmoothCells),
                    fine = surface_of(part, 2 * kSmoothCells);
  expect_sound(fine);
  expect_silhouettes(part, fine.mesh, 0.99);
  EXPECT_EQ(fine.distance.size, given.distance.size);
  EXPECT_GT(double(fine.mesh.V.rows()), 3.5 * double(given.mesh.V.rows()));
  double off = 0;
  for (int v = 0; v < fine.mesh.V.rows(); ++v)
    off = std::max(off, std::abs(sample(given.distance, fine.mesh.V.row(v).transpose())));
  EXPECT_LT(off, given.distance.cell);
  EXPECT_NEAR(signed_volume(fine.mesh), signed_volume(given.mesh),
              0.005 * signed_volume(given.mesh));
}

// The system through them is dense: without a bound, outlines of thousands of crumbs took more
// memory than there is.
TEST(SurfaceRays, ManyPiecesGiveNoMorePointsThanASystemHolds) {
  const Part part = drawn::two_circles();
  const Result<Carving> carving = carving_of(part, 24);
  ASSERT_TRUE(carving);
  std::vector<RayRim> rims;
  for (int i = 0; i < 1000; ++i)
    for (RayRim& rim : outline_rays(carving->views[0], 16)) {
      rim.view = 0;
      rims.push_back(std::move(rim));
    }
  EXPECT_EQ(surface_points(*carving, rims).size(), kMostSurfacePoints);
  rims.resize(10);
  const std::size_t few = surface_points(*carving, rims).size();
  EXPECT_GT(few, 100u);
  EXPECT_LT(few, 200u) << "few are all taken";
}

TEST(SurfaceRays, IsTheSameEveryTime) {
  const PartSurface a = surface_of(drawn::ring(), 32), b = surface_of(drawn::ring(), 32);
  EXPECT_EQ(a.mesh.V, b.mesh.V);
  EXPECT_EQ(a.distance.values, b.distance.values);
}

TEST(SurfaceRays, StopsWhenToldTo) {
  const std::atomic<bool> cancel = true;
  artisketch::Run run;
  run.cancel = &cancel;
  const auto surface = surface_rays(drawn::two_circles(), {Method::rays, 48, false}, run);
  ASSERT_FALSE(surface);
  EXPECT_EQ(surface.error().kind, Error::Kind::cancelled);
}

}  // namespace
}  // namespace artisketch
