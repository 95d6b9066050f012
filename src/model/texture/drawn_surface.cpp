#include "model/texture/drawn_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "base/at_once.h"
#include "model/texture/drawn_colours.h"
#include "model/texture/props.h"
#include "model/texture/tones.h"
#include "model/working_scale.h"

namespace artisketch {
namespace {

constexpr double kPulledFacing = 0.35;  // the same of what takes its colour from farther inside
constexpr double kLeastFacing = 0.2;    // cosine; nearer to grazing, a drawing shows a smear
constexpr double kReach = 12;           // pixels of depth that still count as on the surface
constexpr double kMirrorReach = 0.04;   // of the figure's size: how unlike its two sides may be
constexpr float kSquarely = 0.5f;       // quality: what is seen less well takes no lines of ink

double camera_depth(const FrameCamera& camera, const Vec3& X) {
  return (camera.camera.type == Camera::Type::perspective ? camera.camera.distance : 0) - X.z();
}

void project(const Points3& V, const FrameCamera& camera, SurfaceView& view) {
  view.pixels.resize(V.rows());
  view.depth.resize(V.rows());
  for (int v = 0; v < V.rows(); ++v) {
    const Vec3 X = V.row(v).transpose();
    const bool shown = X.allFinite() && camera.in_front(X);
    view.pixels[v] =
        shown ? camera.project(X) : Vec2(Vec2::Constant(std::numeric_limits<double>::quiet_NaN()));
    view.depth[v] = camera_depth(camera, X);
  }
}

// The model's other half: every vertex reflected in the rest pose, and bound to its joints' mirror
// images. `has`: whether all its joints have one.
struct MirrorImage {
  Points3 V;
  Weights weights;
  std::vector<bool> has;
};
MirrorImage mirror_image(const Model& model) {
  MirrorImage out{model.mesh.V, model.weights, std::vector<bool>(model.mesh.V.rows(), true)};
  const double middle = model.skeleton.joints[0].offset.x();
  for (int v = 0; v < out.V.rows(); ++v) {
    out.V(v, 0) = 2 * middle - out.V(v, 0);
    for (int k = 0; k < 4; ++k) {
      if (out.weights.weights(v, k) == 0) continue;
      const int other = model.skeleton.joints[out.weights.joints(v, k)].mirror;
      if (other >= 0)
        out.weights.joints(v, k) = other;
      else
        out.has[v] = false;
    }
  }
  return out;
}

// Judges every triangle of a view. V: world places of the vertices, reflected where view.mirrored.
void judge(const Points3& V, const Triangles& F, const FrameCamera& camera, const Sketch& sketch,
           double finest, SurfaceView& view) {
  view.quality.assign(F.rows(), 0.0f);
  for (int f = 0; f < F.rows(); ++f) {
    const Vec3 a = V.row(F(f, 0)).transpose(), b = V.row(F(f, 1)).transpose(),
               c = V.row(F(f, 2)).transpose(), centre = (a + b + c) / 3;
    if (!camera.in_front(a) || !camera.in_front(b) || !camera.in_front(c)) continue;
    const Vec3 normal = (view.mirrored ? -1 : 1) * (b - a).cross(c - a).normalized();
    const Vec3 to_camera = camera.camera.type == Camera::Type::perspective
                               ? Vec3((Vec3(0, 0, camera.camera.distance) - centre).normalized())
                               : Vec3(0, 0, 1);
    const double facing = normal.dot(to_camera);
    if (!(facing > kLeastFacing)) continue;
    const double scale = camera.pixels_per_unit(centre.z());
    const double slope = std::sqrt(1 - std::min(facing * facing, 1.0)) / facing;
    const double reach = view.mirrored ? view.reach : 1.5 * (1 + slope) / scale;
    bool seen = true, pulled = false;
    for (int i = 0; i < 4 && seen; ++i) {
      // The middle, and three places near the corners.
      const Vec3 w =
          i == 3 ? Vec3(Vec3::Constant(1 / 3.0)) : Vec3(Vec3::Constant(0.1) + 0.7 * Vec3::Unit(i));
      Vec2 p = Vec2::Zero();
      double depth = 0;
      for (int k = 0; k < 3; ++k) {
        p += w[k] * view.pixels[F(f, k)];
        depth += w[k] * view.depth[F(f, k)];
      }
      seen = p.x() >= 0 && p.y() >= 0 && p.x() < sketch.width && p.y() < sketch.height;
      if (!seen) break;
      const std::size_t at = std::size_t(p.y()) * sketch.width + std::size_t(p.x());
      seen = sketch.state[at] != Sketch::nothing && std::abs(depth - sketch.depth[at]) <= reach &&
             (*view.holders)[f].has(sketch.joint[at]);
      pulled = pulled || sketch.state[at] == Sketch::pulled;
    }
    if (seen && !(pulled && facing < kPulledFacing))
      view.quality[f] =
          std::max(float(facing * scale / finest), 0.01f) * (pulled ? kPulledQuality : 1);
  }
}

// Adds the colours of a drawing of few colours with hard edges; false where it isn't one.
bool add_palette(const Image& picture, std::set<Pixel>& palette) {
  constexpr std::size_t kMostColours = 256;
  Pixel last = {};
  for (std::size_t p = 0; p < picture.rgba.size(); p += 4) {
    const Pixel pixel = {picture.rgba[p], picture.rgba[p + 1], picture.rgba[p + 2],
                         picture.rgba[p + 3]};
    if (pixel[3] == 0 || pixel == last) continue;
    if (pixel[3] < 255) return false;
    last = pixel;
    palette.insert(pixel);
    if (palette.size() > kMostColours) return false;
  }
  return true;
}

// The colours of all drawings where these are pixel art.
std::vector<Rgb> palette_of(const Document& document, std::span<const Image> drawings) {
  std::set<Pixel> pixels;
  for (int f = 0; f < int(drawings.size()) && f < int(document.frames.size()); ++f)
    if (drawings[f].width == document.frames[f].width &&
        drawings[f].height == document.frames[f].height && !add_palette(drawings[f], pixels))
      return {};
  std::vector<Rgb> palette;
  for (const Pixel& pixel : pixels) palette.push_back(Rgb(pixel[0], pixel[1], pixel[2]) / 255);
  return palette;
}

}  // namespace

std::vector<Holders> holders_of(const Triangles& F, const Weights& weights) {
  constexpr double kShare = 0.1;  // of a triangle; less moves it, but doesn't make it a part's
  std::vector<Holders> holders(F.rows());
  std::vector<std::pair<double, int>> shares;
  for (int f = 0; f < F.rows(); ++f) {
    shares.clear();
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < 4; ++i) {
        const int joint = weights.joints(F(f, k), i);
        const double share = weights.weights(F(f, k), i) / 3;
        if (share <= 0) continue;
        const auto same = std::find_if(shares.begin(), shares.end(),
                                       [&](const auto& one) { return one.second == joint; });
        if (same == shares.end())
          shares.emplace_back(share, joint);
        else
          same->first += share;
      }
    std::sort(shares.begin(), shares.end(), [](const auto& a, const auto& b) {
      return a.first != b.first ? a.first > b.first : a.second < b.second;
    });
    for (std::size_t i = 0; i < std::min<std::size_t>(shares.size(), 4); ++i)
      if (i == 0 || shares[i].first >= kShare) holders[f].joints[i] = shares[i].second;
  }
  return holders;
}

std::optional<Rgb> Sketch::at(const std::vector<Pixel>& colours, const Vec2& pixel,
                              double depth_there, double reach, const Holders& holders) const {
  const Vec2 p = pixel - Vec2::Constant(0.5);
  if (!(p.x() > -1 && p.y() > -1 && p.x() < width && p.y() < height)) return std::nullopt;
  const int x = int(std::floor(p.x())), y = int(std::floor(p.y()));
  const float wx = float(p.x() - x), wy = float(p.y() - y);
  Rgb sum = Rgb::Zero();
  float all = 0;
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) {
      const int u = x + i, v = y + j;
      if (u < 0 || v < 0 || u >= width || v >= height) continue;
      const std::size_t at = std::size_t(v) * width + u;
      const float w = (i ? wx : 1 - wx) * (j ? wy : 1 - wy);
      if (w <= 0 || state[at] == nothing || !(std::abs(depth[at] - depth_there) <= reach) ||
          !holders.has(joint[at]))
        continue;
      const Rgb c(colours[at][0], colours[at][1], colours[at][2]);
      if (pixel_art) {
        if (w <= all) continue;
        sum = w * c;
        all = w;
      } else {
        sum += w * c;
        all += w;
      }
    }
  if (all <= 0) return std::nullopt;
  return Rgb(sum / (255 * all));
}

std::optional<Rgb> SurfaceView::colour(const std::vector<Sketch>& sketches, const Triangles& F,
                                       int face, const Vec3& weights) const {
  Vec2 p = Vec2::Zero();
  double d = 0;
  for (int k = 0; k < 3; ++k) {
    p += weights[k] * pixels[F(face, k)];
    d += weights[k] * depth[F(face, k)];
  }
  if (!p.allFinite()) return std::nullopt;
  const Sketch& drawn = sketches[sketch];
  return drawn.at(quality[face] < kSquarely ? drawn.plain : drawn.colour, p, d, reach,
                  (*holders)[face]);
}

Ray SurfaceView::ray(const Vec2& pixel, int joint) const {
  const Ray world = camera.ray(pixel);
  Ray rest{to_rest[joint] * world.origin, to_rest[joint].linear() * world.direction};
  if (!mirrored) return rest;
  rest.origin.x() = 2 * middle - rest.origin.x();
  rest.direction.x() = -rest.direction.x();
  return rest;
}

Result<DrawnSurface> drawn_surface(const Document& calibrated, std::span<const Image> drawings,
                                   const Model& model, Run& run) {
  DrawnSurface out;
  const Triangles& F = model.mesh.F;
  const MirrorImage mirror = mirror_image(model);
  const auto holders = std::make_shared<const std::vector<Holders>>(holders_of(F, model.weights));
  const auto others = std::make_shared<const std::vector<Holders>>(holders_of(F, mirror.weights));
  const double size = bounds(model.mesh.V).sizes().norm();
  double finest = 0;
  for (int f = 0; f < int(calibrated.frames.size()); ++f)
    finest = std::max(finest, frame_camera(calibrated, f).pixels_per_unit(0));
  // What is meant in pixels is meant of figures of the size that is worked on.
  const int fine = std::max(1, int(1 / shape_scale(calibrated)));
  out.palette = palette_of(calibrated, drawings);
  PartColours colours(model.skeleton);
  for (int f = 0; f < int(drawings.size()) && f < int(calibrated.frames.size()); ++f)
    if (const Frame& frame = calibrated.frames[f];
        drawings[f].width == frame.width && drawings[f].height == frame.height)
      colours.learn(frame, drawings[f]);
  std::vector<int> frames;
  for (int f = 0; f < int(drawings.size()) && f < int(calibrated.frames.size()); ++f)
    if (drawings[f].width == calibrated.frames[f].width &&
        drawings[f].height == calibrated.frames[f].height)
      frames.push_back(f);
  out.sketches.resize(frames.size());
  out.views.resize(frames.size());
  std::vector<SurfaceView> mirrored(frames.size());
  at_once(int(frames.size()), run.threads, [&](int i) {
    if (run.cancelled()) return;
    const int f = frames[i];
    const Frame& frame = calibrated.frames[f];
    const FrameCamera camera = frame_camera(calibrated, f);
    const double pixel = fine / camera.pixels_per_unit(frame.pose.root_position.z());
    Points3 V = posed_vertices(model.mesh.V, model.weights, model.skeleton, frame.pose);
    SurfaceView view;
    view.sketch = i;
    view.reach = kReach * pixel;
    view.holders = holders;
    view.camera = camera;
    view.middle = model.skeleton.joints[0].offset.x();
    for (const Transform& to_world : skinning_transforms(model.skeleton, frame.pose))
      view.to_rest.push_back(to_world.inverse());
    project(V, camera, view);
    const bool perspective = camera.camera.type == Camera::Type::perspective;
    Sketch& sketch = out.sketches[i];
    sketch.frame = f;
    sketch.pixel_art = !out.palette.empty();
    fill_colours(frame, drawings[f], F, *holders, colours,
                 raster_triangles(
                     view.pixels, view.depth,
                     perspective ? std::span<const double>(view.depth) : std::span<const double>(),
                     F, frame.width, frame.height),
                 held_things(calibrated, f), pixel, fine, sketch);
    judge(V, F, camera, sketch, finest, view);
    out.views[i] = view;

    view.mirrored = true;
    view.reach = kMirrorReach * size;
    view.holders = others;
    V = posed_vertices(mirror.V, mirror.weights, model.skeleton, frame.pose);
    project(V, camera, view);
    judge(V, F, camera, sketch, finest, view);
    for (int t = 0; t < F.rows(); ++t)
      for (int k = 0; k < 3; ++k)
        if (!mirror.has[F(t, k)]) view.quality[t] = 0;
    mirrored[i] = std::move(view);
  });
  if (run.cancelled()) return cancelled();
  run.report(0.5);
  if (out.palette.empty()) take_lit_tones(model, out.views, out.sketches);
  out.views.insert(out.views.end(), mirrored.begin(), mirrored.end());
  return out;
}

}  // namespace artisketch
