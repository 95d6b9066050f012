#include "figures.h"

#include <gtest/gtest.h>

#include "base/distance_field.h"
#include "base/mesh.h"

namespace artisketch::figures {
namespace {

std::vector<Figure> cast() {
  return {ball_figure(), two_balls(), heart(), capsule_arm(), human(1), quadruped(1), robot(1)};
}

TEST(Figures, ABallsOutlineIsItsCircle) {
  const Camera camera{Camera::Type::orthographic, 200};
  const Figure figure = ball_figure(0.5);
  const Sketches s =
      draw(figure, std::vector{view(figure, "front", about_y(30))}, camera, 400, 400);
  ASSERT_EQ(s.given.frames[0].contours.size(), 1u);
  const Polyline& line = s.given.frames[0].contours[0].line;
  EXPECT_NEAR(std::abs(signed_area(line)), kPi * 100 * 100, 0.004 * kPi * 100 * 100);
  for (const Vec2& p : line.points) EXPECT_NEAR((p - Vec2(200, 200)).norm(), 100, 0.05);
}

TEST(Figures, ABallsOutlineInPerspectiveIsWhereItsTangentConeMeetsTheImage) {
  Camera camera;
  camera.type = Camera::Type::perspective;
  camera.focal_length = 600;
  camera.distance = 3;
  const Figure figure = ball_figure(0.5);
  const Sketches s =
      draw(figure, std::vector{view(figure, "front", about_y(30))}, camera, 400, 400);
  const double radius = 600 * std::tan(std::asin(0.5 / 3));
  for (const Vec2& p : s.given.frames[0].contours[0].line.points)
    EXPECT_NEAR((p - Vec2(200, 200)).norm(), radius, 0.05);
}

TEST(Figures, RestMeshesAreClosedAndAsLargeAsTheSolid) {
  const Mesh mesh = rest_mesh(ball_figure(0.5), 0.02);
  EXPECT_TRUE(topology(mesh).manifold());
  EXPECT_NEAR(signed_volume(mesh), kPi / 6, 0.005);
  for (const Figure& figure : cast()) {
    const Topology t = topology(rest_mesh(figure, 0.04));
    EXPECT_TRUE(t.manifold()) << figure.name;
    EXPECT_EQ(t.components, 1) << figure.name;
  }
}

// The farthest that a part's mesh reaches outside its drawn outline, and how far the boxes of both
// are apart, in pixels.
void expect_outline_of(const Mesh& part, const FrameCamera& camera,
                       const std::vector<Polyline>& lines, const std::string& where) {
  ASSERT_FALSE(lines.empty()) << where;
  std::vector<std::vector<Vec2>> polygons;
  for (const Polyline& line : lines) polygons.push_back(line.points);
  const PolygonDistance outside(polygons);
  const Box2 drawn = artisketch::bounds(lines);
  double farthest = -1e9;
  Box2 reached;
  for (int v = 0; v < part.V.rows(); ++v) {
    const Vec2 p = camera.project(part.V.row(v).transpose());
    farthest = std::max(farthest, outside.distance(p));
    reached.extend(p);
  }
  EXPECT_LT(farthest, kOutlineTolerance + 0.2) << where;
  EXPECT_LT((reached.min() - drawn.min()).norm(), 1) << where;
  EXPECT_LT((reached.max() - drawn.max()).norm(), 1) << where;
}

TEST(Figures, OutlinesHoldTheProjectedTruthAndNoMore) {
  bool perspective = false;
  for (const Figure& figure : cast()) {
    perspective = !perspective;
    const auto type = perspective ? Camera::Type::perspective : Camera::Type::orthographic;
    const Camera camera = fitting_camera(figure, type, 300, 300);
    const Sketches s = draw(figure, random_views(figure, 2, 7), camera, 300, 300);
    const std::vector<Mesh> parts = posed_parts(figure, s.truth.frames[1].pose, 0.02);
    for (int j = 0; j < figure.skeleton.size(); ++j)
      if (!figure.parts[j].empty())
        expect_outline_of(parts[j], frame_camera(s.truth, 1), contours_of(s.truth.frames[1], j),
                          figure.name + " " + figure.skeleton.joints[j].name);
  }
}

TEST(Figures, ContoursDoNotCrossThemselves) {
  for (const Figure& figure : cast())
    for (const double wobble : {0.0, 1.5}) {
      const Camera camera = fitting_camera(figure, Camera::Type::orthographic, 300, 300);
      const Sketches s = draw(figure, random_views(figure, 1, 3), camera, 300, 300,
                              {.contour_wobble_px = wobble}, 3);
      for (const Contour& contour : s.given.frames[0].contours) {
        EXPECT_FALSE(self_crossing(contour.line)) << figure.name;
        EXPECT_GE(contour.line.points.size(), 12u);
        EXPECT_LE(contour.line.points.size(), 300u);
      }
    }
}

TEST(Figures, TheHandWobblesAsMuchAsAsked) {
  const Camera camera{Camera::Type::orthographic, 200};
  const Figure figure = ball_figure(0.5);
  const Sketches s = draw(figure, std::vector{view(figure, "", about_y(0))}, camera, 300, 300,
                          {.contour_wobble_px = 1.5}, 1);
  const Polyline line = resampled(s.given.frames[0].contours[0].line, 1);
  double square = 0;
  for (const Vec2& p : line.points) {
    const double off = (p - Vec2(150, 150)).norm() - 100;
    square += off * off / double(line.points.size());
  }
  EXPECT_NEAR(std::sqrt(square), 1.5, 0.15);
}

TEST(Figures, PosesAreOffByWhatWasAsked) {
  const Figure figure = capsule_arm();
  const Camera camera = fitting_camera(figure, Camera::Type::orthographic, 200, 200);
  const Sketches s = draw(figure, random_views(figure, 3, 4), camera, 200, 200,
                          {.pose_error_degrees = 8, .root_error = 0.05}, 5);
  for (int f = 0; f < 3; ++f) {
    const Pose &given = s.given.frames[f].pose, &truth = s.truth.frames[f].pose;
    EXPECT_NEAR((given.root_position - truth.root_position).norm(), f ? 0.05 : 0, 1e-12);
    for (int j = 0; j < figure.skeleton.size(); ++j) {
      const double wanted = f && !figure.parts[j].empty() ? radians(8) : 0;
      EXPECT_NEAR(given.rotations[j].angularDistance(truth.rotations[j]), wanted, 1e-6);
    }
  }
}

TEST(Figures, TheSameSeedDrawsTheSameAndAnotherDoesNot) {
  const auto points = [](std::uint64_t seed) {
    const Figure figure = quadruped(seed);
    const Camera camera = fitting_camera(figure, Camera::Type::perspective, 200, 200);
    const Sketches s = draw(figure, random_views(figure, 2, seed), camera, 200, 200,
                            {.contour_wobble_px = 1, .pose_error_degrees = 8}, seed);
    std::vector<double> numbers;
    for (const Frame& frame : s.given.frames) {
      for (const Contour& contour : frame.contours)
        for (const Vec2& p : contour.line.points) numbers.insert(numbers.end(), {p.x(), p.y()});
      for (const Quat& q : frame.pose.rotations) numbers.push_back(q.w());
    }
    return numbers;
  };
  EXPECT_EQ(points(1), points(1));
  EXPECT_NE(points(1), points(2));
}

}  // namespace
}  // namespace artisketch::figures
