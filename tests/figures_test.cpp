#include "figures.h"

#include <gtest/gtest.h>

#include "base/distance_field.h"
#include "base/mesh.h"

namespace artisketch::figures {
namespace {

const Figure* cast(int which) {
  static const Figure figures[] = {ball_figure(), two_balls(), heart(),     capsule_arm(),
                                   human(1),      human(2),    quadruped(), robot()};
  return which < 8 ? &figures[which] : nullptr;
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
  for (int i = 0; i < 8; ++i) {
    const Topology t = topology(rest_mesh(*cast(i), 0.03));
    EXPECT_TRUE(t.manifold()) << cast(i)->name;
    EXPECT_EQ(t.components, 1) << cast(i)->name;
  }
}

TEST(Figures, OutlinesHoldTheProjectedTruth) {
  for (int i = 0; i < 8; ++i)
    for (const auto type : {Camera::Type::orthographic, Camera::Type::perspective}) {
      const Figure& figure = *cast(i);
      const Camera camera = fitting_camera(figure, type, 400, 400);
      const Sketches s = draw(figure, random_views(figure, 2, i + 1), camera, 400, 400);
      for (int f = 0; f < 2; ++f) {
        const std::vector<Mesh> parts = posed_parts(figure, s.truth.frames[f].pose, 0.015);
        const FrameCamera seen = frame_camera(s.truth, f);
        for (int j = 0; j < figure.skeleton.size(); ++j) {
          if (figure.parts[j].empty()) continue;
          std::vector<std::vector<Vec2>> polygons;
          for (const Polyline& line : contours_of(s.truth.frames[f], j))
            polygons.push_back(line.points);
          ASSERT_FALSE(polygons.empty());
          const PolygonDistance outside(polygons);
          double farthest = -1e9;
          Box2 box, drawn;
          for (int v = 0; v < parts[j].V.rows(); ++v) {
            const Vec2 p = seen.project(parts[j].V.row(v).transpose());
            farthest = std::max(farthest, outside.distance(p));
            box.extend(p);
          }
          for (const auto& polygon : polygons)
            for (const Vec2& p : polygon) drawn.extend(p);
          const std::string where = figure.name + " " + figure.skeleton.joints[j].name;
          EXPECT_LT(farthest, kOutlineTolerance + 0.3) << where;
          // … and nothing more: the mesh's corners reach the outline.
          EXPECT_LT((box.min() - drawn.min()).norm(), 1.0) << where;
          EXPECT_LT((box.max() - drawn.max()).norm(), 1.0) << where;
        }
      }
    }
}

TEST(Figures, ContoursDoNotCrossThemselves) {
  for (int i = 0; i < 8; ++i)
    for (const double wobble : {0.0, 1.5}) {
      const Figure& figure = *cast(i);
      const Camera camera = fitting_camera(figure, Camera::Type::orthographic, 512, 512);
      const Sketches s = draw(figure, random_views(figure, 2, i), camera, 512, 512,
                              {.contour_wobble_px = wobble}, i);
      for (const Frame& frame : s.given.frames)
        for (const Contour& contour : frame.contours) {
          EXPECT_FALSE(self_crossing(contour.line)) << figure.name;
          EXPECT_GE(contour.line.points.size(), 12u);
          EXPECT_LE(contour.line.points.size(), 300u);
        }
    }
}

TEST(Figures, PosesAreOffByWhatWasAsked) {
  const Figure figure = human(3);
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
    const Figure figure = human(seed);
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
