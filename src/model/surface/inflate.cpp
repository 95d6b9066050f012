#include "model/surface/inflate.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "base/within.h"

namespace artisketch {

constexpr double kFar = 5;  // cells outside from which a sample needs no better distance

// A bone that points at the camera says nothing of its part's lean: its slope counts by its length
// in the image alone.
MiddleSheet middle_sheet(const PartView& view, std::span<const Bone> bones, const Vec3& through) {
  MiddleSheet sheet;
  const Vec3 M = view.to_world * through;
  sheet.centre = view.camera.project(M);
  sheet.at = M.z();
  const double s = view.camera.pixels_per_unit(M.z());
  Eigen::Matrix2d A = Eigen::Matrix2d::Zero();
  Vec2 b = Vec2::Zero();
  double lengths = 0;
  for (const Bone& bone : bones) {
    const Vec3 a = view.to_world * bone.a, e = view.to_world * bone.b;
    const Vec2 across = (view.camera.project(e) - view.camera.project(a)) / s;
    A += across * across.transpose();
    b += across * (e.z() - a.z());
    lengths += (e - a).squaredNorm();
  }
  if (lengths > 0) {
    A += 0.25 * lengths * Eigen::Matrix2d::Identity();
    sheet.slope = A.ldlt().solve(b) / s;
  }
  return sheet;
}

namespace {

// u on a raster: Δu = −1 where distance < 0 (both in steps), 0 on the line, by over-relaxation.
// Neighbours across the line are mirrored through it at the crossing that the distances tell.
void solve_poisson(const std::vector<float>& distance, int nx, int ny, std::vector<float>& u) {
  u.assign(distance.size(), 0);
  const float relax = float(2 / (1 + std::sin(kPi / std::max(nx, ny))));
  const int sweeps = 2 * std::max(nx, ny);
  const int neighbours[4] = {-1, 1, -nx, nx};
  // Outside nothing is relaxed: u stays 0 there, and adds nothing to its neighbours' sums.
  std::vector<float> weights(distance.size(), 1), relaxed(distance.size(), 0);
  for (int y = 1; y + 1 < ny; ++y)
    for (int x = 1; x + 1 < nx; ++x) {
      const std::size_t i = std::size_t(y) * nx + x;
      if (!(distance[i] < 0)) continue;
      float weight = 0;
      for (const int to : neighbours) {
        const float d = distance[i + to];
        weight += d < 0 ? 1 : (d - distance[i]) / std::max(-distance[i], 0.1f * (d - distance[i]));
      }
      weights[i] = weight;
      relaxed[i] = relax;
    }
  const auto relax_at = [&](std::size_t i) {
    const float sum = 1 + u[i - 1] + u[i + 1] + u[i - nx] + u[i + nx];
    u[i] += relaxed[i] * (sum / weights[i] - u[i]);
  };
  // A sample waits for the one before it. So rows go side by side, each one sample behind the one
  // above, which is the same as one after another.
  constexpr int kRows = 8;
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (int top = 1; top + 1 < ny; top += kRows) {
      const int rows = std::min(kRows, ny - 1 - top);
      for (int t = 1; t + 1 < nx + rows - 1; ++t)
        for (int r = std::max(0, t - (nx - 2)); r < std::min(rows, t); ++r)
          relax_at(std::size_t(top + r) * nx + (t - r));
    }
}

}  // namespace

void inflate(const Silhouette& silhouette, std::span<const Bone> bones, const Vec3& through,
             double fatness, Grid3<float>& field) {
  const PartView& view = *silhouette.view;
  const FrameCamera& camera = view.camera;
  const MiddleSheet sheet = middle_sheet(view, bones, through);
  const double s = camera.pixels_per_unit(sheet.at);
  const double step = field.cell * s;  // pixels between the raster's samples
  const Box2 box = view.outline.box();
  const double margin = 3 * step + silhouette.grown;
  const Vec2 origin = box.min() - Vec2::Constant(margin);
  const int nx = int((box.sizes().x() + 2 * margin) / step) + 2;
  const int ny = int((box.sizes().y() + 2 * margin) / step) + 2;
  const Transform to_rest = view.to_world.inverse();
  std::vector<float> distance(std::size_t(nx) * ny), u;
  double deepest = 0;
  for (int y = 0; y < ny; ++y)
    for (int x = 0; x < nx; ++x) {
      const Vec2 pixel = origin + step * Vec2(x, y);
      const Vec3 X = camera.ray(pixel).at_z(sheet.depth(pixel));
      const double outside = silhouette.distance(to_rest * X);
      distance[std::size_t(y) * nx + x] = float(outside / field.cell);
      deepest = std::max(deepest, -outside / field.cell);
    }
  solve_poisson(distance, nx, ny, u);
  const float most = *std::max_element(u.begin(), u.end());
  if (!(most > 0)) return;
  // As thick at the thickest place as the widest ball inside the outline.
  const double per_u = deepest * deepest / most;

  const float far = float(kFar * field.cell);
  for (int k = 0; k < field.size.z(); ++k)
    for (int j = 0; j < field.size.y(); ++j)
      for (int i = 0; i < field.size.x(); ++i) {
        if (field(i, j, k) >= far) continue;
        const Vec3 X = view.to_world * field.position(i, j, k);
        if (!camera.in_front(X)) continue;
        const Vec2 pixel = camera.project(X);
        const Vec2 at = (pixel - origin) / step;
        const int x = int(within(at.x(), 0, nx - 2)), y = int(within(at.y(), 0, ny - 2));
        const double wx = std::clamp(at.x() - x, 0.0, 1.0), wy = std::clamp(at.y() - y, 0.0, 1.0);
        const float* v = &u[std::size_t(y) * nx + x];
        const double low = (1 - wx) * v[0] + wx * v[1], high = (1 - wx) * v[nx] + wx * v[nx + 1];
        const double here = per_u * ((1 - wy) * low + wy * high);
        const Vec2 slope =
            per_u * Vec2((1 - wy) * (v[1] - v[0]) + wy * (v[nx + 1] - v[nx]), high - low);
        const double z = (X.z() - sheet.depth(pixel)) / field.cell / fatness;
        // z² − u over its gradient's length: the distance, to first order.
        const double gradient = std::sqrt(4 * z * z / (fatness * fatness) + slope.squaredNorm());
        const double d = (z * z - here) / std::max(gradient, 1e-3);
        field(i, j, k) = std::max(field(i, j, k), float(d * field.cell));
      }
}

}  // namespace artisketch
