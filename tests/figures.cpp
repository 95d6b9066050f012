#include "figures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "figures/random.h"

namespace artisketch::figures {
namespace {

double away_from_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double square = along.squaredNorm();
  const double t = square > 0 ? std::clamp((p - a).dot(along) / square, 0.0, 1.0) : 0.0;
  return (p - a - t * along).norm();
}

// Douglas and Peucker 1973, between two points of a closed line.
void keep_between(const std::vector<Vec2>& p, std::size_t from, std::size_t to, double tolerance,
                  std::vector<bool>& kept) {
  double farthest = tolerance;
  std::size_t split = to;
  for (std::size_t i = from + 1; i < to; ++i)
    if (const double d = away_from_segment(p[i], p[from], p[to % p.size()]); d > farthest) {
      farthest = d;
      split = i;
    }
  if (split == to) return;
  kept[split] = true;
  keep_between(p, from, split, tolerance, kept);
  keep_between(p, split, to, tolerance, kept);
}

Polyline simplified(const Polyline& closed, double tolerance) {
  const std::vector<Vec2>& p = closed.points;
  std::size_t far = 0;
  for (std::size_t i = 1; i < p.size(); ++i)
    if ((p[i] - p[0]).squaredNorm() > (p[far] - p[0]).squaredNorm()) far = i;
  std::vector<bool> kept(p.size(), false);
  kept[0] = kept[far] = true;
  keep_between(p, 0, far, tolerance, kept);
  keep_between(p, far, p.size(), tolerance, kept);
  Polyline out;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (kept[i]) out.points.push_back(p[i]);
  return out;
}

Polyline rounded(Polyline line) {
  for (Vec2& p : line.points) p = (100 * p).array().round() / 100;
  return line;
}

// As few points as the tolerance allows, but enough to look round and not to cross itself.
Polyline as_drawn(const Polyline& traced) {
  Polyline line;
  for (double tolerance = kOutlineTolerance; tolerance > 0.01; tolerance *= 0.75) {
    line = rounded(simplified(traced, tolerance));
    if (int(line.points.size()) >= kLeastPoints && !self_crossing(line)) return line;
  }
  return line;
}

// A smooth random displacement along the normal, its shortest wave `shortest` pixels long.
Polyline wobbled(const Polyline& traced, double wobble, double shortest, Random& random) {
  const Polyline even = resampled(traced, 2);
  const int n = int(even.points.size());
  const int waves = std::max(2, int(length(traced) / shortest));
  std::vector<double> shift(n, 0);
  for (int k = 1; k <= waves; ++k) {
    const double c = random.gaussian(), s = random.gaussian();
    for (int i = 0; i < n; ++i) {
      const double turn = 2 * kPi * k * i / n;
      shift[i] += c * std::cos(turn) + s * std::sin(turn);
    }
  }
  double square = 0;
  for (const double d : shift) square += d * d / n;
  // Where a thin part's line would cross itself the hand keeps calmer.
  for (double scale = wobble / std::sqrt(square); scale > 1e-3; scale *= 0.7) {
    Polyline line = even;
    for (int i = 0; i < n; ++i) {
      const Vec2 along = even.points[(i + 3) % n] - even.points[(i + n - 3) % n];
      line.points[i] += scale * shift[i] * Vec2(along.y(), -along.x()).normalized();
    }
    if (!self_crossing(line)) return line;
  }
  return even;
}

// Where a joint's bone runs in the picture; any direction for one that has none or points at the
// camera.
Vec2 bone_in_picture(const Figure& figure, int joint, const Pose& pose, const FrameCamera& camera) {
  const std::vector<Transform> posed = posed_joints(figure.skeleton, pose);
  const std::vector<int> children = figure.skeleton.children(joint);
  if (children.empty()) return Vec2::UnitX();
  const Vec2 along =
      camera.project(posed[children[0]].translation()) - camera.project(posed[joint].translation());
  return along.norm() > 1 ? Vec2(along.normalized()) : Vec2(Vec2::UnitX());
}

// As long and as wide as the hand happens to draw it.
Polyline stretched(Polyline line, const Vec2& along, double longer, double wider) {
  const Vec2 middle = centroid({&line, 1}), across(-along.y(), along.x());
  for (Vec2& p : line.points) {
    const Vec2 d = p - middle;
    p = middle + longer * d.dot(along) * along + wider * d.dot(across) * across;
  }
  return line;
}

Frame drawn_frame(const Figure& figure, const View& view, const FrameCamera& camera, int width,
                  int height, const Noise& noise, Random& random) {
  Frame frame;
  frame.name = view.name;
  frame.width = width;
  frame.height = height;
  frame.pose = view.pose;
  const std::vector<Transform> moved = skinning_transforms(figure.skeleton, view.pose);
  const auto any = [&](double share) { return share > 0 ? 1 + random.around(0, share) : 1; };
  const double size = any(noise.drawing_size);
  for (int j = 0; j < figure.skeleton.size(); ++j) {
    const double longer = size * any(noise.part_size), wider = size * any(noise.part_size);
    for (Polyline line : outline(figure.parts[j], moved[j], camera)) {
      if (std::abs(signed_area(line)) < 4) continue;  // a speck no hand would draw
      if (longer != 1 || wider != 1) {
        const Vec2 shift = (size - 1) * (centroid({&line, 1}) - camera.principal_point);
        line = stretched(std::move(line), bone_in_picture(figure, j, view.pose, camera), longer,
                         wider);
        for (Vec2& p : line.points) p += shift;
      }
      const bool calm = noise.contour_wobble_px == 0;
      const Polyline drawn =
          calm ? line : wobbled(line, noise.contour_wobble_px, noise.shortest_wobble_px, random);
      frame.contours.push_back({j, as_drawn(drawn), {}});
    }
  }
  return frame;
}

double radius_about_root(const Figure& figure) {
  const std::vector<Vec3> rest = rest_positions(figure.skeleton);
  double reach = 0;
  for (const Solid& part : figure.parts)
    if (!part.empty()) {
      const Ball ball = bounding_ball(part);
      reach = std::max(reach, (ball.centre - rest[0]).norm() + 0.8 * ball.radius);
    }
  return reach;
}

}  // namespace

View view(const Figure& figure, std::string name, const Quat& side, const Turns& turns,
          const Vec3& root_position) {
  Pose pose = rest_pose(figure.skeleton);
  pose.root_position = root_position;
  pose.rotations[0] = side;
  for (const auto& turn : turns) {
    const int joint = figure.skeleton.find(turn.first);
    assert(joint >= 0);
    pose.rotations[joint] = pose.rotations[joint] * turn.second;
  }
  return {std::move(name), std::move(pose)};
}

namespace {

// The figure turned, tilted a little, its limbs bent within its freedom.
View bent_view(const Figure& figure, int number, double yaw, Random& random) {
  View v = view(figure, number == 0 ? "front" : "view " + std::to_string(number + 1),
                about_x(random.around(0, 10)) * about_y(yaw) * about_z(random.around(0, 5)));
  for (int j = 1; j < figure.skeleton.size(); ++j) {
    const double angle = random.between(-1, 1) * figure.freedom[j];
    v.pose.rotations[j] = Quat(Eigen::AngleAxisd(angle, random.direction()));
  }
  return v;
}

}  // namespace

std::vector<View> random_views(const Figure& figure, int count, std::uint64_t seed) {
  Random random(seed * 7919 + 17);
  std::vector<View> views;
  for (int i = 0; i < count; ++i) {
    // A quarter turn first, then between: views of a half turn apart would add no new outline.
    const double sides[] = {0, 90, 45, -50, 135, -110, 20, 70};
    const double yaw = i == 0 ? 0 : sides[i % 8] + random.around(0, 15);
    views.push_back(bent_view(figure, i, yaw, random));
  }
  return views;
}

std::vector<View> spread_views(const Figure& figure, int count, double baseline,
                               std::uint64_t seed) {
  Random random(seed * 7919 + 17);
  std::vector<View> views;
  for (int i = 0; i < count; ++i)
    views.push_back(bent_view(figure, i, degrees(baseline) * i / std::max(1, count - 1), random));
  return views;
}

Camera fitting_camera(const Figure& figure, Camera::Type type, int width, int height) {
  const double reach = radius_about_root(figure);
  Camera camera;
  camera.type = type;
  const double per_unit = 0.47 * std::min(width, height) / reach;
  camera.pixels_per_unit = std::round(per_unit * 10) / 10;
  camera.distance = std::round(6 * reach * 100) / 100;
  camera.focal_length = std::round(0.85 * per_unit * camera.distance);
  return camera;
}

Sketches draw(const Figure& figure, std::span<const View> views, const Camera& camera, int width,
              int height, const Noise& noise, std::uint64_t seed) {
  Random hand(seed * 2 + 1), user(seed * 2 + 2);  // the drawing does not depend on the poses given
  Document document;
  document.name = figure.name;
  document.camera = camera;
  document.skeleton = figure.skeleton;
  const FrameCamera seen{camera, Vec2(width, height) / 2, 1};
  for (const View& v : views)
    document.frames.push_back(drawn_frame(figure, v, seen, width, height, noise, hand));
  if (noise.pose_error_degrees > 0)
    document.calibration.max_rotation = radians(1.25 * noise.pose_error_degrees);
  if (noise.root_error > 0) document.calibration.max_translation = 1.5 * noise.root_error;

  Sketches sketches{document, document};
  for (std::size_t i = 1; i < views.size(); ++i) {
    Pose& pose = sketches.given.frames[i].pose;
    for (int j = 0; j < figure.skeleton.size(); ++j) {
      const Vec3 axis = user.direction();
      if (figure.parts[j].empty()) continue;
      const Quat error(Eigen::AngleAxisd(radians(noise.pose_error_degrees), axis));
      pose.rotations[j] = (pose.rotations[j] * error).normalized();
    }
    const double turn = user.between(0, 2 * kPi);
    pose.root_position += noise.root_error * Vec3(std::cos(turn), std::sin(turn), 0);
  }
  return sketches;
}

double distance(const Figure& figure, const Vec3& p) {
  double d = std::numeric_limits<double>::infinity();
  for (const Solid& part : figure.parts) d = std::min(d, distance(part, p));
  return d;
}

Mesh rest_mesh(const Figure& figure, double cell) {
  Box3 box;
  std::vector<std::pair<Ball, const Solid*>> parts;
  for (const Solid& part : figure.parts)
    if (!part.empty()) {
      box.extend(bounds(part));
      parts.emplace_back(bounding_ball(part), &part);
    }
  const auto nearest = [&](const Vec3& p) {
    double d = std::numeric_limits<double>::infinity();
    for (const auto& [ball, part] : parts)
      if ((p - ball.centre).norm() - ball.radius < d) d = std::min(d, distance(*part, p));
    return d;
  };
  return polygonise(nearest, box, cell);
}

std::vector<Mesh> posed_parts(const Figure& figure, const Pose& pose, double cell) {
  const std::vector<Transform> moved = skinning_transforms(figure.skeleton, pose);
  std::vector<Mesh> meshes(figure.parts.size());
  for (std::size_t j = 0; j < figure.parts.size(); ++j) {
    if (figure.parts[j].empty()) continue;
    meshes[j] = mesh_of(figure.parts[j], cell);
    meshes[j].V = ((meshes[j].V * moved[j].linear().transpose()).rowwise() +
                   moved[j].translation().transpose())
                      .eval();
  }
  return meshes;
}

}  // namespace artisketch::figures
