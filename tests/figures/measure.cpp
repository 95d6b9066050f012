#include "figures/measure.h"

#include <algorithm>
#include <cmath>

namespace artisketch::figures {
namespace {

struct Crossing {
  double x;
  int turn;  // +1 into the mesh, −1 out of it
};

// Where the line along +x through each sample (y, z) of the grid crosses the mesh.
std::vector<std::vector<Crossing>> crossings(const Mesh& mesh, const Vec3& origin, double cell,
                                             const Index3& size) {
  std::vector<std::vector<Crossing>> columns(std::size_t(size.y()) * size.z());
  for (int f = 0; f < mesh.F.rows(); ++f) {
    Vec3 p[3];
    for (int c = 0; c < 3; ++c) p[c] = (mesh.V.row(mesh.F(f, c)).transpose() - origin) / cell;
    const auto area = [](const Vec3& a, const Vec3& b, double y, double z) {
      return (b.y() - a.y()) * (z - a.z()) - (b.z() - a.z()) * (y - a.y());
    };
    const double whole = area(p[0], p[1], p[2].y(), p[2].z());
    if (whole == 0) continue;
    const auto range = [&](int axis, int count) {
      const auto [low, high] = std::minmax({p[0][axis], p[1][axis], p[2][axis]});
      return std::pair(std::max(0, int(std::ceil(low))),
                       std::min(count - 1, int(std::floor(high))));
    };
    const std::pair<int, int> ys = range(1, size.y()), zs = range(2, size.z());
    for (int z = zs.first; z <= zs.second; ++z)
      for (int y = ys.first; y <= ys.second; ++y) {
        const double a = area(p[1], p[2], y, z) / whole, b = area(p[2], p[0], y, z) / whole,
                     c = 1 - a - b;
        if (a < 0 || b < 0 || c < 0) continue;
        columns[y + std::size_t(size.y()) * z].push_back(
            {a * p[0].x() + b * p[1].x() + c * p[2].x(), whole < 0 ? 1 : -1});
      }
  }
  for (auto& column : columns)
    std::sort(column.begin(), column.end(),
              [](const Crossing& a, const Crossing& b) { return a.x < b.x; });
  return columns;
}

Vec3 bone_direction(const Figure& figure, int joint, const std::vector<Vec3>& rest) {
  const std::vector<int> children = figure.skeleton.children(joint);
  // Without one child to point at, a part points at its middle.
  const Vec3 d = (children.size() == 1 ? rest[children[0]] : bounds(figure.parts[joint]).center()) -
                 rest[joint];
  return d.norm() > 1e-6 ? Vec3(d.normalized()) : Vec3(Vec3::UnitY());
}

}  // namespace

double volume_iou(const Figure& figure, const Mesh& rest, int cells) {
  Box3 box = artisketch::bounds(rest.V);
  std::vector<Ball> balls;
  for (const Solid& part : figure.parts) {
    balls.push_back(part.empty() ? Ball{} : bounding_ball(part));
    if (!part.empty()) box.extend(bounds(part));
  }
  const double cell = box.sizes().maxCoeff() / cells;
  const Index3 size = (box.sizes() / cell).array().ceil().cast<int>() + 1;
  // Samples a hair off the round numbers that meshes' corners like to lie on.
  const Vec3 origin = box.min() + cell * Vec3(0.0123, 0.0171, 0.0147);
  const auto columns = crossings(rest, origin, cell, size);
  std::size_t both = 0, either = 0;
  for (int z = 0; z < size.z(); ++z)
    for (int y = 0; y < size.y(); ++y) {
      const std::vector<Crossing>& column = columns[y + std::size_t(size.y()) * z];
      std::size_t next = 0;
      int winding = 0;
      for (int x = 0; x < size.x(); ++x) {
        for (; next < column.size() && column[next].x <= x; ++next) winding += column[next].turn;
        const Vec3 p = origin + cell * Vec3(x, y, z);
        bool in = false;
        for (std::size_t j = 0; j < balls.size() && !in; ++j)
          in = (p - balls[j].centre).norm() < balls[j].radius && distance(figure.parts[j], p) < 0;
        both += in && winding != 0;
        either += in || winding != 0;
      }
    }
  return either ? double(both) / double(either) : 1;
}

Mask silhouette(const Figure& figure, const Pose& pose, const FrameCamera& camera, int width,
                int height) {
  Mask mask(width, height);
  const std::vector<Transform> moved = skinning_transforms(figure.skeleton, pose);
  for (int j = 0; j < figure.skeleton.size(); ++j) {
    std::vector<std::vector<Vec2>> polygons;
    for (Polyline& line : outline(figure.parts[j], moved[j], camera))
      polygons.push_back(std::move(line.points));
    add_polygons(polygons, mask);
  }
  return mask;
}

Mask silhouette(const Model& model, const Pose& pose, const FrameCamera& camera, int width,
                int height) {
  const Points3 posed = posed_vertices(model.mesh.V, model.weights, model.skeleton, pose);
  std::vector<Vec2> pixels(posed.rows());
  for (int v = 0; v < posed.rows(); ++v) pixels[v] = camera.project(posed.row(v).transpose());
  Mask mask(width, height);
  add_triangles(pixels, model.mesh.F, mask);
  return mask;
}

double unseen_silhouettes(const Figure& figure, const Model& model, const FrameCamera& camera,
                          int width, int height, std::uint64_t seed) {
  constexpr int kPoses = 6;
  double sum = 0;
  for (const View& v : random_views(figure, kPoses, seed + 5000))
    sum += intersection_over_union(silhouette(figure, v.pose, camera, width, height),
                                   silhouette(model, v.pose, camera, width, height));
  return sum / kPoses;
}

PoseErrors pose_errors(const Figure& figure, const FrameCamera& camera, const Pose& truth,
                       const Pose& other) {
  const std::vector<Transform> a = posed_joints(figure.skeleton, truth),
                               b = posed_joints(figure.skeleton, other);
  const std::vector<Vec3> rest = rest_positions(figure.skeleton);
  PoseErrors errors;
  int count = 0;
  for (int j = 0; j < figure.skeleton.size(); ++j) {
    if (figure.parts[j].empty()) continue;
    ++count;
    const double px =
        (camera.project(a[j].translation()) - camera.project(b[j].translation())).norm();
    errors.joint_px += px;
    errors.worst_joint_px = std::max(errors.worst_joint_px, px);
    const Vec3 bone = bone_direction(figure, j, rest);
    const Vec3 there = a[j].linear() * bone, here = b[j].linear() * bone;
    const Quat between(Mat3(b[j].linear() * a[j].linear().transpose()));
    errors.angle += degrees(Quat::Identity().angularDistance(between));
    // How far the bone's end moved, along the image and toward the camera.
    const Vec3 aside = Vec3::UnitZ().cross(there).stableNormalized(), forth = there.cross(aside);
    const auto angle = [&](const Vec3& way) {
      return degrees(std::asin(std::min(1.0, std::abs((here - there).dot(way)))));
    };
    errors.in_plane += angle(aside);
    errors.out_of_plane += angle(forth);
    // The rotation is a swing after a turn about the bone.
    errors.twist +=
        degrees(2 * std::abs(std::atan2(between.vec().dot(there), std::abs(between.w()))));
  }
  for (double* mean :
       {&errors.joint_px, &errors.angle, &errors.in_plane, &errors.out_of_plane, &errors.twist})
    *mean /= std::max(count, 1);
  return errors;
}

void add(PoseErrors& sum, const PoseErrors& one, double share) {
  sum.joint_px += share * one.joint_px;
  sum.worst_joint_px = std::max(sum.worst_joint_px, one.worst_joint_px);
  sum.angle += share * one.angle;
  sum.in_plane += share * one.in_plane;
  sum.out_of_plane += share * one.out_of_plane;
  sum.twist += share * one.twist;
}

}  // namespace artisketch::figures
