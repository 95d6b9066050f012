#include "files/occlusion.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/raster.h"

namespace artisketch {
namespace {

// Evenly spread over the sphere (Fibonacci lattice).
std::vector<Vec3> directions(int n) {
  std::vector<Vec3> all;
  const double golden = kPi * (3 - std::sqrt(5.0));
  for (int i = 0; i < n; ++i) {
    const double y = 1 - (2 * i + 1.0) / n, r = std::sqrt(1 - y * y);
    all.emplace_back(r * std::cos(golden * i), y, r * std::sin(golden * i));
  }
  return all;
}

// Two unit vectors that make a right-handed frame with d.
std::array<Vec3, 2> across(const Vec3& d) {
  const Vec3 u = d.unitOrthogonal();
  return {u, d.cross(u)};
}

// The triangles that face a light, counter-clockwise in its own axes. The others are never the
// nearest of a closed mesh, and cost half the time.
Triangles facing(const Mesh& mesh, const std::vector<Vec2>& pixels) {
  Triangles F(mesh.F.rows(), 3);
  int n = 0;
  for (int f = 0; f < mesh.F.rows(); ++f) {
    const Vec2 &a = pixels[mesh.F(f, 0)], u = pixels[mesh.F(f, 1)] - a,
               v = pixels[mesh.F(f, 2)] - a;
    if (u.x() * v.y() - u.y() * v.x() > 0) F.row(n++) = mesh.F.row(f);
  }
  F.conservativeResize(n, 3);
  return F;
}

// What a far light sees of a mesh: the depth map of a parallel projection along its direction.
class ShadowMap {
 public:
  // direction: from the mesh to the light, unit length.
  ShadowMap(const Mesh& mesh, const Vec3& centre, double radius, const Vec3& direction, int size)
      : centre_(centre), direction_(direction), axes_(across(direction)), size_(size) {
    scale_ = size / (2.02 * radius);
    std::vector<Vec2> pixels(mesh.V.rows());
    std::vector<double> depth(mesh.V.rows());
    for (int v = 0; v < mesh.V.rows(); ++v) {
      const Vec3 p = mesh.V.row(v).transpose();
      pixels[v] = pixel(p);
      depth[v] = this->depth(p);
    }
    seen_ = raster_triangles(pixels, depth, {}, facing(mesh, pixels), size, size);
  }

  // The share of the light that reaches p, smoothed over the four nearest samples.
  double reaching(const Vec3& p) const {
    const Vec2 at = pixel(p) - Vec2::Constant(0.5);
    if (!(at.minCoeff() > -1 && at.maxCoeff() < size_)) return 1;
    const float z = float(depth(p));
    const int x = int(std::floor(at.x())), y = int(std::floor(at.y()));
    const double wx = at.x() - x, wy = at.y() - y;
    const auto open = [&](int i, int j) {
      if (i < 0 || j < 0 || i >= size_ || j >= size_) return 1.0;
      return seen_.depth[std::size_t(j) * size_ + i] >= z ? 1.0 : 0.0;
    };
    return (1 - wy) * ((1 - wx) * open(x, y) + wx * open(x + 1, y)) +
           wy * ((1 - wx) * open(x, y + 1) + wx * open(x + 1, y + 1));
  }

 private:
  Vec2 pixel(const Vec3& p) const {
    const Vec3 d = p - centre_;
    return Vec2(d.dot(axes_[0]), d.dot(axes_[1])) * scale_ + Vec2::Constant(size_ / 2.0);
  }
  double depth(const Vec3& p) const { return -(p - centre_).dot(direction_); }

  Vec3 centre_, direction_;
  std::array<Vec3, 2> axes_;
  int size_;
  double scale_ = 1;
  Visible seen_;
};

constexpr int kDirections = 48, kOcclusionMap = 160, kLampMap = 384;
// Points lift off the surface by this share of the shape's radius before they look for light, so
// that a depth sample's own slope doesn't darken them.
constexpr double kLift = 0.012;

double brightness_from(const Vec3& d) {
  return 0.65 + 0.35 * d.y();
}

// Binomial blur along both axes, which hides that light comes from a few directions.
void smooth(std::vector<float>& values, int size) {
  constexpr int kTimes = 6;
  std::vector<float> line(size);
  for (int axis = 0; axis < 2; ++axis)
    for (int k = 0; k < size; ++k) {
      const std::size_t start = axis ? std::size_t(k) : std::size_t(k) * size,
                        step = axis ? std::size_t(size) : 1;
      for (int times = 0; times < kTimes; ++times) {
        for (int i = 0; i < size; ++i) line[i] = values[start + i * step];
        for (int i = 1; i + 1 < size; ++i)
          values[start + i * step] = (line[i - 1] + 2 * line[i] + line[i + 1]) / 4;
      }
    }
}

}  // namespace

Ball surrounding(const Points3& V) {
  const Box3 box = bounds(V);
  if (box.isEmpty()) return {};
  Ball ball{box.center(), 1e-9};
  for (int v = 0; v < V.rows(); ++v)
    ball.radius = std::max(ball.radius, (Vec3(V.row(v).transpose()) - ball.centre).norm());
  return ball;
}

Eigen::VectorXd ambient_occlusion(const Mesh& mesh, const Points3& N) {
  const Ball ball = surrounding(mesh.V);
  Eigen::VectorXd light = Eigen::VectorXd::Zero(mesh.V.rows()), all = light;
  for (const Vec3& d : directions(kDirections)) {
    const ShadowMap map(mesh, ball.centre, ball.radius, d, kOcclusionMap);
    for (int v = 0; v < mesh.V.rows(); ++v) {
      const Vec3 n = N.row(v).transpose();
      const double share = n.dot(d) * brightness_from(d);
      if (share <= 0) continue;
      const Vec3 p = mesh.V.row(v).transpose();
      all[v] += share;
      light[v] += share * map.reaching(p + kLift * ball.radius * (n + d));
    }
  }
  return light.cwiseQuotient(all.cwiseMax(1e-12));
}

Eigen::VectorXd lamp_light(const Mesh& mesh, const Points3& N, const Vec3& direction, double lamp) {
  constexpr int kRays = 7;  // over the lamp's face
  const Ball ball = surrounding(mesh.V);
  const std::array<Vec3, 2> axes = across(direction);
  Eigen::VectorXd light = Eigen::VectorXd::Zero(mesh.V.rows());
  for (int i = 0; i < kRays; ++i) {
    const double angle = 2 * kPi * i / (kRays - 1), r = i == kRays - 1 ? 0 : lamp;
    const Vec3 d =
        (direction + r * (std::cos(angle) * axes[0] + std::sin(angle) * axes[1])).normalized();
    const ShadowMap map(mesh, ball.centre, ball.radius, d, kLampMap);
    for (int v = 0; v < mesh.V.rows(); ++v) {
      const Vec3 n = N.row(v).transpose(), p = mesh.V.row(v).transpose();
      light[v] += map.reaching(p + kLift * ball.radius * (n + d)) / kRays;
    }
  }
  return light;
}

GroundShadow ground_shadow(const Mesh& mesh) {
  constexpr int kSize = 160, kRays = 160;
  GroundShadow ground;
  const Ball ball = surrounding(mesh.V);
  const Box3 box = bounds(mesh.V);
  if (box.isEmpty()) return ground;
  const Vec2 middle(ball.centre.x(), ball.centre.z());
  const double reach = 1.6 * ball.radius;
  ground.box = Box2(middle - Vec2::Constant(reach), middle + Vec2::Constant(reach));
  ground.height = box.min().y();
  ground.size = kSize;
  ground.dark.assign(kSize * kSize, 0.0f);
  double all = 0;
  std::vector<Vec2> samples(mesh.V.rows());
  for (const Vec3& d : directions(kRays)) {
    // Light from near the horizon throws shadows far beyond the picture.
    if (d.y() < 0.3) continue;
    for (int v = 0; v < mesh.V.rows(); ++v) {
      const Vec3 p = mesh.V.row(v).transpose();
      const Vec3 q = p - d * ((p.y() - ground.height) / d.y());
      samples[v] = (Vec2(q.x(), q.z()) - ground.box.min()) * (kSize / (2 * reach));
    }
    Mask mask(kSize, kSize);
    add_triangles(samples, mesh.F, mask);
    for (std::size_t i = 0; i < mask.in.size(); ++i)
      ground.dark[i] += float(d.y()) * float(mask.in[i]);
    all += d.y();
  }
  for (float& v : ground.dark) v /= float(all);
  smooth(ground.dark, kSize);
  for (int j = 0; j < kSize; ++j)
    for (int i = 0; i < kSize; ++i) {
      const double r = std::hypot(i + 0.5 - kSize / 2.0, j + 0.5 - kSize / 2.0) / (kSize / 2.0);
      const float t = float(std::clamp((1 - r) / 0.6, 0.0, 1.0));
      ground.dark[std::size_t(j) * kSize + i] *= t * t * (3 - 2 * t);
    }
  return ground;
}

double GroundShadow::at(double x, double z) const {
  if (dark.empty()) return 0;
  const Vec2 p = (Vec2(x, z) - box.min()).cwiseQuotient(box.sizes()) * size - Vec2::Constant(0.5);
  if (!(p.minCoeff() >= 0 && p.maxCoeff() < size - 1)) return 0;
  const int i = int(p.x()), j = int(p.y());
  const double wx = p.x() - i, wy = p.y() - j;
  const float* v = &dark[std::size_t(j) * size + i];
  return (1 - wy) * ((1 - wx) * v[0] + wx * v[1]) + wy * ((1 - wx) * v[size] + wx * v[size + 1]);
}

}  // namespace artisketch
