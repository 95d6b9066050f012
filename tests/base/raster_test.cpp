#include "base/raster.h"

#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

namespace artisketch {
namespace {

int count(const Mask& mask) {
  return std::accumulate(mask.in.begin(), mask.in.end(), 0);
}

std::vector<Vec2> rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}

Mask rectangle_mask(double x0, double y0, double x1, double y1, int size = 100) {
  Mask mask(size, size);
  const std::vector<std::vector<Vec2>> polygons{rectangle(x0, y0, x1, y1)};
  add_polygons(polygons, mask);
  return mask;
}

std::vector<Vec2> circle(const Vec2& centre, double radius, int n) {
  std::vector<Vec2> points;
  for (int i = 0; i < n; ++i)
    points.push_back(centre + radius * Vec2(std::cos(2 * kPi * i / n), std::sin(2 * kPi * i / n)));
  return points;
}

// A fan of n triangles about the centre of a circle.
struct Fan {
  std::vector<Vec2> pixels;
  Triangles F;
};
Fan fan(const Vec2& centre, double radius, int n) {
  Fan made{circle(centre, radius, n), Triangles(n, 3)};
  made.pixels.push_back(centre);
  for (int i = 0; i < n; ++i) made.F.row(i) << i, (i + 1) % n, n;
  return made;
}

TEST(Raster, PixelCentresDecide) {
  const Mask mask = rectangle_mask(1.5, 2.5, 4.5, 3.5, 8);
  EXPECT_EQ(count(mask), 3);
  EXPECT_TRUE(mask.at(1, 2) && mask.at(3, 2));
  EXPECT_FALSE(mask.at(4, 2) || mask.at(1, 3) || mask.at(0, 2));
  EXPECT_EQ(count(rectangle_mask(1.6, 2.6, 2.4, 3.4, 8)), 0);
}

TEST(Raster, PolygonsCombineByTheEvenOddRule) {
  Mask mask(100, 100);
  const std::vector<std::vector<Vec2>> ring{rectangle(10, 10, 90, 90), rectangle(30, 30, 70, 70)};
  add_polygons(ring, mask);
  EXPECT_EQ(count(mask), 80 * 80 - 40 * 40);
  const std::vector<std::vector<Vec2>> plug{rectangle(30, 30, 70, 70)};
  add_polygons(plug, mask);
  EXPECT_EQ(count(mask), 80 * 80);
}

TEST(Raster, NeighbouringTrianglesLeaveNoGapAndShareNoPixel) {
  const Fan disc = fan({50.3, 49.7}, 41.2, 37);
  Mask together(100, 100), polygon(100, 100);
  add_triangles(disc.pixels, disc.F, together);
  const std::vector<std::vector<Vec2>> outline{circle({50.3, 49.7}, 41.2, 37)};
  add_polygons(outline, polygon);
  EXPECT_EQ(together.in, polygon.in);
  int sum = 0;
  for (int f = 0; f < disc.F.rows(); ++f) {
    Mask alone(100, 100);
    add_triangles(disc.pixels, disc.F.row(f), alone);
    sum += count(alone);
  }
  EXPECT_EQ(sum, count(together));
}

TEST(Raster, CornersOnPixelCentresAreSharedOut) {
  // Two triangles of a square whose diagonal runs through pixel centres.
  const std::vector<Vec2> corners = rectangle(2.5, 2.5, 12.5, 12.5);
  Triangles F(2, 3);
  F << 0, 1, 2, 0, 2, 3;
  int sum = 0;
  for (int f = 0; f < 2; ++f) {
    Mask alone(16, 16);
    add_triangles(corners, F.row(f), alone);
    sum += count(alone);
  }
  EXPECT_EQ(sum, 100);
}

TEST(Raster, LeavesOutCoordinatesThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, inf, -inf, 1e300}) {
    const std::vector<Vec2> pixels{{2, 2}, {bad, 9}, {9, 2}, {9, 9}};
    Triangles F(2, 3);
    F << 0, 1, 2, 0, 3, 2;
    Mask mask(16, 16);
    add_triangles(pixels, F, mask);
    Mask whole(16, 16);
    add_triangles(pixels, F.row(1), whole);
    EXPECT_EQ(mask.in, whole.in);
    const std::vector<std::vector<Vec2>> polygons{pixels};
    Mask none(16, 16);
    add_polygons(polygons, none);
    EXPECT_EQ(count(none), 0);
    const std::vector<double> depth{1, 1, 1, 1};
    const Visible seen = raster_triangles(pixels, depth, {}, F, 16, 16);
    for (const int face : seen.face) EXPECT_NE(face, 0);
  }
  // Far, but still a place: the whole raster lies inside.
  const std::vector<Vec2> far{{-1e8, -1e8}, {3e8, -1e8}, {-1e8, 3e8}};
  Triangles F(1, 3);
  F << 0, 1, 2;
  Mask mask(16, 16);
  add_triangles(far, F, mask);
  EXPECT_EQ(count(mask), 256);
}

TEST(Raster, OverlapOfMasks) {
  const Mask a = rectangle_mask(10, 10, 50, 50), b = rectangle_mask(30, 10, 70, 50);
  const Mask far = rectangle_mask(60, 60, 80, 80), none(100, 100);
  EXPECT_EQ(intersection_over_union(a, a), 1);
  EXPECT_EQ(intersection_over_union(a, far), 0);
  EXPECT_DOUBLE_EQ(intersection_over_union(a, b), 1.0 / 3);
  EXPECT_EQ(intersection_over_union(none, none), 1);
  EXPECT_EQ(intersection_over_union(a, none), 0);
}

TEST(Raster, OutlineDistanceIsTheWayBetweenOutlines) {
  const Mask a = rectangle_mask(20, 20, 80, 80), none(100, 100);
  EXPECT_EQ(outline_distance(a, a), 0);
  EXPECT_NEAR(outline_distance(a, rectangle_mask(23, 23, 77, 77)), 3, 0.1);
  // Moved along x by 6, only the two upright sides are off; their ends lie on the level ones.
  EXPECT_NEAR(outline_distance(a, rectangle_mask(26, 20, 86, 80)), 3, 0.4);
  EXPECT_EQ(outline_distance(none, none), 0);
  EXPECT_EQ(outline_distance(a, none), std::numeric_limits<double>::infinity());
  // Exact to the farthest corner.
  EXPECT_DOUBLE_EQ(outline_distance(rectangle_mask(0, 0, 1, 1), rectangle_mask(99, 99, 100, 100)),
                   99 * std::sqrt(2));
}

TEST(Raster, TheNearestTriangleIsSeen) {
  const std::vector<Vec2> pixels{{0, 0}, {20, 0}, {0, 20}, {0, 0}, {20, 0}, {0, 20}};
  Triangles F(2, 3);
  F << 0, 1, 2, 3, 4, 5;
  // The second lies in front where x is small, behind where it is large.
  const std::vector<double> depth{5, 5, 5, 1, 9, 1};
  const Visible seen = raster_triangles(pixels, depth, {}, F, 20, 20);
  EXPECT_EQ(seen.face[2 * 20 + 2], 1);
  EXPECT_EQ(seen.face[2 * 20 + 14], 0);
  EXPECT_EQ(seen.face[19 * 20 + 19], -1);
  EXPECT_NEAR(seen.depth[2 * 20 + 2], 1 + 8 * 2.5 / 20, 1e-6);
}

TEST(Raster, DepthAndWeightsFollowThePerspective) {
  // A triangle that runs away from the camera, seen with focal length 10 about (50, 50).
  const Vec3 X[3] = {{-2, -2, 5}, {8, -1, 20}, {-3, 9, 40}};
  std::vector<Vec2> pixels;
  std::vector<double> w;
  for (const Vec3& x : X) {
    pixels.emplace_back(50 + 100 * x.x() / x.z(), 50 + 100 * x.y() / x.z());
    w.push_back(x.z());
  }
  Triangles F(1, 3);
  F << 0, 1, 2;
  const Vec3 inside = 0.2 * X[0] + 0.5 * X[1] + 0.3 * X[2];
  const Vec2 p(50 + 100 * inside.x() / inside.z(), 50 + 100 * inside.y() / inside.z());
  const Vec3 weights = corner_weights(p, pixels[0], pixels[1], pixels[2], Vec3(w[0], w[1], w[2]));
  EXPECT_LT((weights - Vec3(0.2, 0.5, 0.3)).norm(), 1e-9);
  const Visible seen = raster_triangles(pixels, w, w, F, 100, 100);
  const int x = int(p.x()), y = int(p.y());
  ASSERT_EQ(seen.face[y * 100 + x], 0);
  const Vec3 there =
      corner_weights({x + 0.5, y + 0.5}, pixels[0], pixels[1], pixels[2], Vec3(w[0], w[1], w[2]));
  EXPECT_NEAR(seen.depth[y * 100 + x], there.dot(Vec3(w[0], w[1], w[2])), 1e-3);
}

TEST(Raster, ASphereCoversItsDisc) {
  const Mesh ball = icosphere(Vec3::Zero(), 1, 5);
  std::vector<Vec2> pixels;
  for (int v = 0; v < ball.V.rows(); ++v)
    pixels.emplace_back(256 + 200 * ball.V(v, 0), 256 - 200 * ball.V(v, 1));
  Mask mask(512, 512);
  add_triangles(pixels, ball.F, mask);
  EXPECT_NEAR(count(mask), kPi * 200 * 200, 0.002 * kPi * 200 * 200);
}

// Dented, so that it covers itself; smaller than a pixel, larger; either way round; cut by the
// border.
TEST(Raster, AClosedSurfaceCoversWhatAllItsTrianglesDo) {
  Mesh dented = icosphere(Vec3::Zero(), 1, 4);
  for (int v = 0; v < dented.V.rows(); ++v)
    dented.V.row(v) *= 1 + 0.6 * std::sin(9 * dented.V(v, 0)) * std::cos(7 * dented.V(v, 1));
  for (const double scale : {3.0, 40.0, -40.0, 200.0}) {
    std::vector<Vec2> pixels;
    for (int v = 0; v < dented.V.rows(); ++v)
      pixels.emplace_back(70 + scale * dented.V(v, 0), 80 + std::abs(scale) * dented.V(v, 1));
    Mask all(150, 160), surface(150, 160);
    add_triangles(pixels, dented.F, all);
    add_surface(pixels, dented.F, surface);
    EXPECT_GT(count(all), 0);
    EXPECT_EQ(all.in, surface.in) << scale;
  }
}

}  // namespace
}  // namespace artisketch
