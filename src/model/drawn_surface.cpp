#include "model/drawn_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/raster.h"

namespace artisketch {
namespace {

constexpr double kLeastFacing = 0.1;    // cosine; nearer to grazing, a drawing shows a smear
constexpr double kStep = 4;             // pixels of depth between neighbours that make an edge
constexpr double kMirrorReach = 0.04;   // of the figure's size: how unlike its two sides may be
constexpr float kPulledQuality = 0.4f;  // of a triangle whose colour comes from farther inside
constexpr float kSquarely = 0.5f;       // quality: what is seen less well takes no lines of ink
constexpr float kInkDarker = 0.08f;     // than what is beside it

constexpr std::array<std::array<int, 2>, 4> kBeside = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

// ---------------------------------------------------------------- a drawing's colours

// The model over one drawing, while its colours are made.
struct Overlay {
  const Picture& picture;
  const Triangles& F;
  Visible seen;
  double pixel = 0;  // units

  std::size_t index(int x, int y) const { return std::size_t(y) * seen.width + x; }
  bool inside(int x, int y) const {
    return x >= 0 && y >= 0 && x < seen.width && y < seen.height && seen.face[index(x, y)] >= 0;
  }
  // Whether the surface runs on from one pixel to its neighbour.
  bool runs_on(std::size_t p, std::size_t q) const {
    const int f = seen.face[p], g = seen.face[q];
    if (f < 0 || g < 0) return false;
    if (f == g || std::abs(seen.depth[p] - seen.depth[q]) < kStep * pixel) return true;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (F(f, i) == F(g, j)) return true;
    return false;
  }
  Rgb colour(std::size_t p) const {
    return Rgb(picture.rgba[4 * p], picture.rgba[4 * p + 1], picture.rgba[4 * p + 2]) / 255;
  }
  bool opaque(std::size_t p) const { return picture.rgba[4 * p + 3] >= 128; }
};

// Pixels from each pixel of the model to its nearest outline: chamfer distances (Borgefors 1986).
std::vector<float> outline_distances(const Overlay& o) {
  const int w = o.seen.width, h = o.seen.height;
  constexpr float kDiagonal = 1.414f;
  std::vector<float> distance(o.seen.face.size(), 0.0f);
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      if (!o.inside(x, y)) continue;
      const std::size_t p = o.index(x, y);
      distance[p] = std::numeric_limits<float>::max();
      for (const auto& [dx, dy] : kBeside)
        if (!o.inside(x + dx, y + dy) || !o.runs_on(p, o.index(x + dx, y + dy))) {
          distance[p] = 0.5f;
          break;
        }
    }
  const auto relax = [&](int x, int y, int sign) {
    float& d = distance[o.index(x, y)];
    if (d <= 0.5f) return;  // an outline, or beside the model
    for (const auto& [dx, dy, step] : {std::tuple(-1, 0, 1.0f), std::tuple(0, -1, 1.0f),
                                       std::tuple(-1, -1, kDiagonal), std::tuple(1, -1, kDiagonal)})
      if (const int u = x + sign * dx, v = y + sign * dy; u >= 0 && v >= 0 && u < w && v < h)
        d = std::min(d, distance[o.index(u, v)] + step);
  };
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) relax(x, y, 1);
  for (int y = h - 1; y >= 0; --y)
    for (int x = w - 1; x >= 0; --x) relax(x, y, -1);
  return distance;
}

// How far, in pixels, the ink along outlines reaches into the model: to where the drawing is, on
// average, nearly as bright as farther in.
float ink_width(const Overlay& o, const std::vector<float>& distance) {
  constexpr int kBins = 24;
  constexpr double kAsBright = 0.85;
  std::array<double, kBins> light = {}, count = {};
  for (std::size_t p = 0; p < distance.size(); ++p) {
    if (o.seen.face[p] < 0 || !o.opaque(p) || distance[p] >= kBins) continue;
    light[std::size_t(distance[p])] += o.colour(p).mean();
    count[std::size_t(distance[p])] += 1;
  }
  double within = 0, pixels = 0;
  for (int b = kBins / 3; b < kBins; ++b) within += light[b], pixels += count[b];
  int b = 0;
  while (b < kBins / 3 && light[b] * pixels < kAsBright * within * count[b]) ++b;
  // The drawn line and the model's outline are a pixel apart here and there.
  return float(b) + 1.5f;
}

// Spreads colours to the pixels of the model that have none, without crossing an outline.
void spread(const Overlay& o, std::vector<Rgb>& colour, std::vector<std::uint8_t>& state) {
  std::vector<std::array<int, 2>> queue;  // coloured, beside what isn't yet
  for (int y = 0; y < o.seen.height; ++y)
    for (int x = 0; x < o.seen.width; ++x)
      if (state[o.index(x, y)] == Sketch::drawn &&
          std::any_of(kBeside.begin(), kBeside.end(), [&](const auto& to) {
            return o.inside(x + to[0], y + to[1]) &&
                   state[o.index(x + to[0], y + to[1])] == Sketch::nothing;
          }))
        queue.push_back({x, y});
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const int x = queue[head][0], y = queue[head][1];
    const std::size_t p = o.index(x, y);
    for (const auto& [dx, dy] : kBeside) {
      if (!o.inside(x + dx, y + dy)) continue;
      const std::size_t q = o.index(x + dx, y + dy);
      if (state[q] != Sketch::nothing || !o.runs_on(p, q)) continue;
      colour[q] = colour[p];
      state[q] = Sketch::pulled;
      queue.push_back({x + dx, y + dy});
    }
  }
}

// Of what is painted; all is light beside it, so that a line along its edge is thin, too.
std::vector<float> lightness(const Sketch& sketch) {
  std::vector<float> light(sketch.state.size(), 1.0f);
  for (std::size_t p = 0; p < light.size(); ++p)
    if (sketch.state[p] != Sketch::nothing) light[p] = sketch.colour[p].mean();
  return light;
}

// Morphological closing by a square of side 2 r + 1: what is dark and thinner than that is filled.
std::vector<float> without_thin_dark(std::vector<float> light, int width, int height, int r) {
  const auto filter = [&](int count, int length, std::size_t across, std::size_t along,
                          const auto& better) {
    std::vector<float> line(length);
    for (int i = 0; i < count; ++i) {
      float* at = &light[i * across];
      for (int k = 0; k < length; ++k) line[k] = at[k * along];
      for (int k = 0; k < length; ++k) {
        float best = line[k];
        for (int n = std::max(k - r, 0); n <= std::min(k + r, length - 1); ++n)
          best = better(best, line[n]);
        at[k * along] = best;
      }
    }
  };
  const auto both = [&](const auto& better) {
    filter(height, width, std::size_t(width), 1, better);
    filter(width, height, 1, std::size_t(width), better);
  };
  both([](float a, float b) { return std::max(a, b); });
  both([](float a, float b) { return std::min(a, b); });
  return light;
}

// Takes the drawing's colours where they can be trusted, and spreads them from there to the
// outlines without crossing one.
void fill_colours(const Overlay& o, Sketch& sketch) {
  const std::vector<float> distance = outline_distances(o);
  const float ink = ink_width(o, distance);
  sketch.colour.assign(distance.size(), Rgb::Zero());
  sketch.state.assign(distance.size(), Sketch::nothing);
  // The middle of what is thinner than two lines of ink is still its best colour.
  const auto in_the_middle = [&](int x, int y) {
    const float d = distance[o.index(x, y)];
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, sketch.height - 1); ++v)
      for (int u = std::max(x - 1, 0); u <= std::min(x + 1, sketch.width - 1); ++u)
        if (distance[o.index(u, v)] > d) return false;
    return d > 1;
  };
  for (int y = 0; y < sketch.height; ++y)
    for (int x = 0; x < sketch.width; ++x) {
      const std::size_t p = o.index(x, y);
      if (!o.inside(x, y) || !o.opaque(p)) continue;
      if (distance[p] < ink && !in_the_middle(x, y)) continue;
      sketch.colour[p] = o.colour(p);
      sketch.state[p] = Sketch::drawn;
    }
  spread(o, sketch.colour, sketch.state);
  sketch.plain = sketch.colour;
  std::vector<std::uint8_t> state = sketch.state;
  const std::vector<float> light = lightness(sketch);
  const std::vector<float> closed = without_thin_dark(light, sketch.width, sketch.height, int(ink));
  for (std::size_t p = 0; p < state.size(); ++p)
    if (state[p] == Sketch::pulled || light[p] < closed[p] - kInkDarker) state[p] = Sketch::nothing;
  spread(o, sketch.plain, state);
}

// ---------------------------------------------------------------- where the surface stands

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
      seen = sketch.state[at] != Sketch::nothing && std::abs(depth - sketch.depth[at]) <= reach;
      pulled = pulled || sketch.state[at] == Sketch::pulled;
    }
    if (seen)
      view.quality[f] =
          std::max(float(facing * scale / finest), 0.01f) * (pulled ? kPulledQuality : 1);
  }
}

}  // namespace

std::optional<Rgb> Sketch::at(const std::vector<Rgb>& colours, const Vec2& pixel,
                              double depth_there, double reach) const {
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
      if (w <= 0 || state[at] == nothing || !(std::abs(depth[at] - depth_there) <= reach)) continue;
      sum += w * colours[at];
      all += w;
    }
  if (all <= 0) return std::nullopt;
  return Rgb(sum / all);
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
  return drawn.at(quality[face] < kSquarely ? drawn.plain : drawn.colour, p, d, reach);
}

Result<DrawnSurface> drawn_surface(const Document& calibrated, std::span<const Picture> drawings,
                                   const Model& model, Run& run) {
  DrawnSurface out;
  const Triangles& F = model.mesh.F;
  const MirrorImage mirror = mirror_image(model);
  const double size = bounds(model.mesh.V).sizes().norm();
  double finest = 0;
  for (int f = 0; f < int(calibrated.frames.size()); ++f)
    finest = std::max(finest, frame_camera(calibrated, f).pixels_per_unit(0));
  std::vector<SurfaceView> mirrored;
  for (int f = 0; f < int(drawings.size()) && f < int(calibrated.frames.size()); ++f) {
    const Frame& frame = calibrated.frames[f];
    if (drawings[f].width != frame.width || drawings[f].height != frame.height) continue;
    if (run.cancelled()) return cancelled();
    const FrameCamera camera = frame_camera(calibrated, f);
    const double pixel = 1 / camera.pixels_per_unit(frame.pose.root_position.z());
    Points3 V = posed_vertices(model.mesh.V, model.weights, model.skeleton, frame.pose);
    SurfaceView view;
    view.sketch = int(out.sketches.size());
    view.reach = 3 * kStep * pixel;
    project(V, camera, view);
    Overlay overlay{drawings[f], F, {}, pixel};
    const bool perspective = camera.camera.type == Camera::Type::perspective;
    overlay.seen = raster_triangles(
        view.pixels, view.depth,
        perspective ? std::span<const double>(view.depth) : std::span<const double>(), F,
        frame.width, frame.height);
    Sketch& sketch = out.sketches.emplace_back();
    sketch.width = frame.width;
    sketch.height = frame.height;
    fill_colours(overlay, sketch);
    sketch.depth = std::move(overlay.seen.depth);
    judge(V, F, camera, sketch, finest, view);
    out.views.push_back(view);

    view.mirrored = true;
    view.reach = kMirrorReach * size;
    V = posed_vertices(mirror.V, mirror.weights, model.skeleton, frame.pose);
    project(V, camera, view);
    judge(V, F, camera, sketch, finest, view);
    for (int t = 0; t < F.rows(); ++t)
      for (int k = 0; k < 3; ++k)
        if (!mirror.has[F(t, k)]) view.quality[t] = 0;
    mirrored.push_back(std::move(view));
    run.report(0.5 * (f + 1) / double(drawings.size()));
  }
  out.views.insert(out.views.end(), mirrored.begin(), mirrored.end());
  return out;
}

}  // namespace artisketch
