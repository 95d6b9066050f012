#include "files/render.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/raster.h"
#include "base/srgb.h"
#include "files/marks.h"
#include "files/occlusion.h"

namespace artisketch {
namespace {

using Linear = Eigen::Vector3f;  // red, green, blue

Linear linear(unsigned rrggbb) {
  return {to_linear((rrggbb >> 16 & 255) / 255.0f), to_linear((rrggbb >> 8 & 255) / 255.0f),
          to_linear((rrggbb & 255) / 255.0f)};
}

constexpr unsigned kClay = 0xD4AC8C;

// ---------------------------------------------------------------- shading

// In view space: x right, y up, z toward the viewer.
const Vec3 kKeyDirection = Vec3(-0.48, 0.72, 0.55).normalized();
const Vec3 kFillDirection = Vec3(0.80, 0.10, 0.55).normalized();
const Vec3 kRimDirection = Vec3(0.45, 0.65, -0.62).normalized();

struct Material {
  Linear albedo;
  float shine = 0.05f;
};

// n, eye: unit vectors in view space, eye toward the viewer. open, key: light that is not blocked.
Linear shade(const Material& material, const Eigen::Vector3f& n, const Eigen::Vector3f& eye,
             float open, float key) {
  const Eigen::Vector3f key_direction = kKeyDirection.cast<float>(),
                        fill_direction = kFillDirection.cast<float>(),
                        rim_direction = kRimDirection.cast<float>();
  const float up = 0.5f + 0.5f * n.y();
  const Linear ambient = (1 - up) * Linear(0.17f, 0.14f, 0.13f) + up * Linear(0.34f, 0.38f, 0.44f);
  // Linear that wraps a little round the edge of the shade reads as a soft, large lamp.
  const auto wrapped = [](float c, float wrap) { return std::max((c + wrap) / (1 + wrap), 0.0f); };
  const float lit = wrapped(n.dot(key_direction), 0.08f) * (0.10f + 0.90f * key);
  const float filled = wrapped(n.dot(fill_direction), 0.4f) * open;
  Linear light = ambient * (0.12f + 0.88f * open) + lit * Linear(1.16f, 1.08f, 0.97f) +
                 filled * Linear(0.10f, 0.12f, 0.15f);
  const float grazing = 1 - std::clamp(n.dot(eye), 0.0f, 1.0f);
  const float rim = grazing * grazing * grazing * wrapped(n.dot(rim_direction), 0.5f) * open;
  float glint = std::max(n.dot((key_direction + eye).normalized()), 0.0f);
  for (int doubling = 0; doubling < 5; ++doubling) glint *= glint;  // to the 32nd power
  glint *= key;
  return material.albedo.cwiseProduct(light) + Linear::Constant(material.shine * glint) +
         rim * Linear(0.30f, 0.31f, 0.33f);
}

// As cels are painted: a tone where the key light falls, a darker and cooler one where not.
Linear two_tones(const Linear& albedo, const Eigen::Vector3f& n, float key) {
  constexpr float kParted = 0.12f, kHalf = 0.5f;
  const Linear shade(0.52f, 0.50f, 0.60f);
  const bool lit = n.dot(kKeyDirection.cast<float>()) > kParted && key > kHalf;
  return lit ? albedo : Linear(albedo.cwiseProduct(shade));
}

Linear texel(const Image& texture, const Vec2& uv) {
  const double x = std::clamp(uv.x(), 0.0, 1.0) * texture.width - 0.5;
  const double y = std::clamp(uv.y(), 0.0, 1.0) * texture.height - 0.5;
  const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
  const float wx = float(x - x0), wy = float(y - y0);
  const auto at = [&](int i, int j) {
    i = std::clamp(i, 0, texture.width - 1);
    j = std::clamp(j, 0, texture.height - 1);
    const std::uint8_t* p = texture.at(i, j);
    return Linear(p[0], p[1], p[2]);
  };
  const Linear s = ((1 - wy) * ((1 - wx) * at(x0, y0) + wx * at(x0 + 1, y0)) +
                    wy * ((1 - wx) * at(x0, y0 + 1) + wx * at(x0 + 1, y0 + 1))) /
                   255;
  return {to_linear(s.x()), to_linear(s.y()), to_linear(s.z())};
}

// ---------------------------------------------------------------- a picture

// All of a picture before its samples become pixels.
struct Shot {
  int per_pixel = 3;  // samples along x and y
  Points3 V, N;       // view space
  std::vector<Vec2> samples;
  std::vector<double> distance;  // before the camera
  FrameCamera camera;            // in samples
  Visible seen;
  std::vector<Linear> light;   // per sample, where a face is seen
  std::vector<Linear> normal;  // the same as RenderLook has it, where asked for
  std::vector<float> ink;      // per sample, the outline's opacity

  bool perspective() const { return camera.camera.type == Camera::Type::perspective; }
};

FrameCamera in_samples(FrameCamera camera, double per_pixel) {
  camera.camera.pixels_per_unit *= per_pixel;
  camera.camera.focal_length *= per_pixel;
  camera.principal_point *= per_pixel;
  return camera;
}

void project(const Shape& shape, const Transform& view, Shot& shot) {
  shot.V = (shape.mesh.V * view.linear().transpose()).rowwise() + view.translation().transpose();
  shot.N = shape.normals * view.linear().transpose();
  const int n = int(shot.V.rows());
  shot.samples.resize(n);
  shot.distance.resize(n);
  const double eye = shot.perspective() ? shot.camera.camera.distance : 0;
  for (int v = 0; v < n; ++v) {
    const Vec3 X = shot.V.row(v).transpose();
    const bool shown = X.allFinite() && shot.camera.in_front(X);
    shot.samples[v] = shown ? shot.camera.project(X) : Vec2(Vec2::Constant(kFarthestPixel * 2));
    shot.distance[v] = shown ? eye - X.z() : 1;
  }
}

// Corner weights of the face that the sample at (x, y) sees.
Vec3 weights_at(const Shot& shot, const Triangles& F, int face, int x, int y) {
  Vec3 w = Vec3::Ones();
  if (shot.perspective())
    for (int c = 0; c < 3; ++c) w[c] = shot.distance[F(face, c)];
  return corner_weights({x + 0.5, y + 0.5}, shot.samples[F(face, 0)], shot.samples[F(face, 1)],
                        shot.samples[F(face, 2)], w);
}

void shade_samples(const Shape& shape, const Eigen::VectorXd& key, const RenderLook& look,
                   Shot& shot) {
  const Triangles& F = shape.mesh.F;
  const bool textured = shape.texture && !shape.texcoords.empty();
  shot.light.assign(shot.seen.face.size(), Linear::Zero());
  if (look.normals) shot.normal = shot.light;
  for (int y = 0; y < shot.seen.height; ++y)
    for (int x = 0; x < shot.seen.width; ++x) {
      const std::size_t at = std::size_t(y) * shot.seen.width + x;
      const int face = shot.seen.face[at];
      if (face < 0) continue;
      const Vec3 weights = weights_at(shot, F, face, x, y);
      Vec3 n = Vec3::Zero(), p = Vec3::Zero(), tint = Vec3::Zero();
      Vec2 uv = Vec2::Zero();
      double open = 0, lit = 0;
      for (int c = 0; c < 3; ++c) {
        const int v = F(face, c);
        n += weights[c] * shot.N.row(v).transpose();
        p += weights[c] * shot.V.row(v).transpose();
        open += weights[c] * shape.ambient[v];
        lit += weights[c] * key[v];
        if (textured)
          uv += weights[c] * shape.texcoords[v];
        else
          tint += weights[c] * shape.tint.row(v).transpose();
      }
      const Vec3 eye = shot.perspective()
                           ? Vec3((Vec3(0, 0, shot.camera.camera.distance) - p).normalized())
                           : Vec3(0, 0, 1);
      const Material material{textured ? texel(*shape.texture, uv) : Linear(tint.cast<float>())};
      const Eigen::Vector3f unit = n.normalized().cast<float>();
      if (look.normals) shot.normal[at] = (unit + Eigen::Vector3f::Ones()) / 2;
      shot.light[at] = look.light == Light::plain ? material.albedo
                       : look.light == Light::toon
                           ? two_tones(material.albedo, unit, float(lit))
                           : shade(material, unit, eye.cast<float>(), float(open), float(lit));
    }
}

// Lays discs of ink along the outline and along steps in depth.
void draw_outline(const Shape& shape, double line_width, Shot& shot) {
  const int width = shot.seen.width, height = shot.seen.height;
  const double radius = surrounding(shape.mesh.V).radius;
  // A step from one sample to the next counts as an edge from here on, and fully at three times it.
  const double least_step = 0.02 * radius;
  constexpr float kOuter = 0.92f, kInner = 0.8f;
  shot.ink.assign(shot.seen.face.size(), 0.0f);
  const auto stamp = [&](int x, int y, double diameter, float strength) {
    const double r = diameter * shot.per_pixel / 2;
    const int reach = int(std::ceil(r));
    for (int v = std::max(y - reach, 0); v <= std::min(y + reach, height - 1); ++v)
      for (int u = std::max(x - reach, 0); u <= std::min(x + reach, width - 1); ++u)
        if ((u - x) * (u - x) + (v - y) * (v - y) <= r * r) {
          float& ink = shot.ink[std::size_t(v) * width + u];
          ink = std::max(ink, strength);
        }
  };
  // How much deeper the surface runs from one sample to the next where it is whole.
  const auto slope = [&](std::size_t at) {
    const int face = shot.seen.face[at];
    const Triangles& F = shape.mesh.F;
    const Vec3 a = shot.V.row(F(face, 0)).transpose(), b = shot.V.row(F(face, 1)).transpose(),
               c = shot.V.row(F(face, 2)).transpose();
    const Vec3 n = (b - a).cross(c - a);
    const double across = std::hypot(n.x(), n.y()), toward = std::abs(n.z());
    return across / std::max(toward, 0.1 * across + 1e-300) / shot.camera.pixels_per_unit(a.z());
  };
  const auto compare = [&](int x, int y, int u, int v) {
    const std::size_t p = std::size_t(y) * width + x, q = std::size_t(v) * width + u;
    const bool here = shot.seen.face[p] >= 0, there = shot.seen.face[q] >= 0;
    if (here != there) {
      stamp(here ? x : u, here ? y : v, line_width, kOuter);
    } else if (here && shot.seen.face[p] != shot.seen.face[q]) {
      const bool nearer = shot.seen.depth[p] < shot.seen.depth[q];
      const double step = std::abs(shot.seen.depth[p] - shot.seen.depth[q]);
      if (step < least_step) return;
      const double beyond = step - 2 * std::min(slope(p), slope(q));
      const double share = std::clamp((beyond - least_step) / (2 * least_step), 0.0, 1.0);
      if (share > 0)
        stamp(nearer ? x : u, nearer ? y : v, 0.85 * line_width, kInner * float(share));
    }
  };
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      if (x + 1 < width) compare(x, y, x + 1, y);
      if (y + 1 < height) compare(x, y, x, y + 1);
    }
}

// A pixel's samples put together, and the alpha that they come to. sample(i): what is on it, and
// how much of the sample it covers.
template <class Sample, class Encode>
void develop(const Shot& shot, int left, int top, Image& image, Sample sample, Encode encode) {
  const int n = shot.per_pixel;
  for (int y = 0; y < shot.seen.height / n; ++y)
    for (int x = 0; x < shot.seen.width / n; ++x) {
      Linear sum = Linear::Zero();
      float alpha = 0;
      for (int s = 0; s < n * n; ++s) {
        const std::pair<Linear, float> one =
            sample(std::size_t(y * n + s / n) * shot.seen.width + std::size_t(x * n + s % n));
        sum += one.first;
        alpha += one.second;
      }
      if (alpha == 0) continue;
      std::uint8_t* p = image.at(left + x, top + y);
      for (int c = 0; c < 3; ++c) p[c] = std::uint8_t(255 * encode(sum[c] / alpha) + 0.5f);
      p[3] = std::uint8_t(255 * alpha / (n * n) + 0.5f);
    }
}

void develop_colours(const Shot& shot, int left, int top, Image& image) {
  const Linear ink = linear(kInkColour);
  const auto sample = [&](std::size_t at) {
    const float body = shot.seen.face[at] >= 0 ? 1 : 0, line = shot.ink[at];
    return std::pair<Linear, float>(line * ink + (1 - line) * body * shot.light[at].cwiseMin(1.0f),
                                    line + (1 - line) * body);
  };
  develop(shot, left, top, image, sample, [](float v) { return to_srgb(v); });
}

// Numbers, not light: they are stored as they are.
template <class Value>
void develop_map(const Shot& shot, int left, int top, Image& image, Value value) {
  const auto sample = [&](std::size_t at) {
    const bool body = shot.seen.face[at] >= 0;
    return std::pair<Linear, float>(body ? value(at) : Linear(Linear::Zero()), body ? 1 : 0);
  };
  develop(shot, left, top, image, sample, [](float v) { return std::clamp(v, 0.0f, 1.0f); });
}

}  // namespace

Shape shape_of(const Model& model, const Pose* pose, bool by_joint, bool hollows) {
  Shape shape;
  shape.mesh = model.mesh;
  if (pose) shape.mesh.V = posed_vertices(model.mesh.V, model.weights, model.skeleton, *pose);
  shape.normals = seamless_normals(shape.mesh);
  const auto n = shape.mesh.V.rows();
  shape.tint = linear(kClay).cast<double>().transpose().replicate(n, 1);
  if (by_joint) {
    shape.tint.setZero();
    for (int v = 0; v < n; ++v)
      for (int k = 0; k < 4; ++k)
        shape.tint.row(v) +=
            model.weights.weights(v, k) *
            linear(joint_colour(model.weights.joints(v, k))).cast<double>().transpose();
  } else if (model.texture && model.texture->width > 0 && model.texture->height > 0) {
    shape.texture = &*model.texture;
    shape.texcoords = model.texcoords;
  }
  shape.ambient = hollows ? ambient_occlusion(shape.mesh, shape.normals)
                          : Eigen::VectorXd(Eigen::VectorXd::Ones(n));
  return shape;
}

Image render_shape(const Shape& shape, const Transform& view, const FrameCamera& camera, int width,
                   int height) {
  return render_pictures(shape, view, camera, width, height, {}).colours;
}

Pictures render_pictures(const Shape& shape, const Transform& view, const FrameCamera& camera,
                         int width, int height, const RenderLook& look) {
  constexpr double kLamp = 0.16;  // the key light's radius, one unit away
  constexpr double kMargin = 2;   // pixels round what the shape covers
  Pictures out;
  out.colours = Image(width, height, 0);
  if (look.normals) out.normals = out.colours;
  if (look.depth) out.depth = out.colours;
  Shot shot;
  shot.per_pixel = look.samples;
  shot.camera = in_samples(camera, shot.per_pixel);
  project(shape, view, shot);
  Box2 box;
  for (const Vec2& p : shot.samples)
    if (std::abs(p.x()) <= kFarthestPixel && std::abs(p.y()) <= kFarthestPixel)
      box.extend(p / shot.per_pixel);
  if (box.isEmpty()) return out;
  const auto within = [](double v, int n) { return int(std::clamp(v, 0.0, double(n))); };
  const int left = within(box.min().x() - kMargin, width),
            top = within(box.min().y() - kMargin, height),
            right = within(box.max().x() + kMargin + 1, width),
            bottom = within(box.max().y() + kMargin + 1, height);
  for (Vec2& p : shot.samples) p -= shot.per_pixel * Vec2(left, top);
  const std::span<const double> distances(shot.distance);
  shot.seen = raster_triangles(
      shot.samples, distances, shot.perspective() ? distances : std::span<const double>(),
      shape.mesh.F, (right - left) * shot.per_pixel, (bottom - top) * shot.per_pixel);
  const bool lit = look.light != Light::plain;
  shade_samples(shape,
                lit ? lamp_light({shot.V, shape.mesh.F}, shot.N, kKeyDirection, kLamp)
                    : Eigen::VectorXd(Eigen::VectorXd::Ones(shot.V.rows())),
                look, shot);
  if (look.ink)
    draw_outline(shape, look.line_width, shot);
  else
    shot.ink.assign(shot.seen.face.size(), 0.0f);
  develop_colours(shot, left, top, out.colours);
  if (look.normals)
    develop_map(shot, left, top, out.normals, [&](std::size_t at) { return shot.normal[at]; });
  if (look.depth)
    develop_map(shot, left, top, out.depth, [&](std::size_t at) {
      const double z =
          (shot.perspective() ? shot.camera.camera.distance : 0) - double(shot.seen.depth[at]);
      return Linear(Linear::Constant(float((z - look.farthest) / (look.nearest - look.farthest))));
    });
  return out;
}

}  // namespace artisketch
