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

float lightness(const Pixel& pixel) {
  return float(pixel[0] + pixel[1] + pixel[2]) / (3 * 255);
}

struct Span {
  int begin = 0, end = 0;
  int size() const { return end - begin; }
};

// The model over one drawing, while its colours are made.
struct Overlay {
  const Picture& picture;
  const Triangles& F;
  Visible seen;
  double pixel = 0;  // units
  Span x, y;         // the pixels that the model lies in

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
  Pixel pixel_at(std::size_t p) const {
    Pixel pixel;
    std::copy_n(&picture.rgba[4 * p], 4, pixel.begin());
    return pixel;
  }
  bool opaque(std::size_t p) const { return picture.rgba[4 * p + 3] >= 128; }
};

Overlay overlay_of(const Picture& picture, const Triangles& F, Visible seen, double pixel) {
  Overlay o{picture, F, std::move(seen), pixel, {}, {}};
  o.x = {o.seen.width, 0};
  o.y = {o.seen.height, 0};
  for (int y = 0; y < o.seen.height; ++y) {
    const auto row = o.seen.face.begin() + std::ptrdiff_t(o.index(0, y));
    const auto shown = [](int face) { return face >= 0; };
    const int first = int(std::find_if(row, row + o.seen.width, shown) - row);
    if (first == o.seen.width) continue;
    int last = o.seen.width;
    while (!shown(row[last - 1])) --last;
    o.x = {std::min(o.x.begin, first), std::max(o.x.end, last)};
    o.y = {std::min(o.y.begin, y), y + 1};
  }
  if (o.x.size() < 0) o.x = o.y = {};
  return o;
}

// Pixels from each pixel of the model to its nearest outline: chamfer distances (Borgefors 1986).
std::vector<float> outline_distances(const Overlay& o) {
  const int w = o.seen.width, h = o.seen.height;
  constexpr float kDiagonal = 1.414f;
  std::vector<float> distance(o.seen.face.size(), 0.0f);
  const auto mark = [&](std::size_t p) { distance[p] = std::min(distance[p], 0.5f); };
  for (int y = o.y.begin; y < o.y.end; ++y)
    for (int x = o.x.begin; x < o.x.end; ++x) {
      if (!o.inside(x, y)) continue;
      const std::size_t p = o.index(x, y);
      distance[p] = std::numeric_limits<float>::max();
      if (!o.inside(x - 1, y) || !o.inside(x + 1, y) || !o.inside(x, y - 1) || !o.inside(x, y + 1))
        mark(p);
      if (o.inside(x - 1, y) && !o.runs_on(p, p - 1)) mark(p), mark(p - 1);
      if (o.inside(x, y - 1) && !o.runs_on(p, p - w)) mark(p), mark(p - w);
    }
  const auto relax = [&](int x, int y, int sign) {
    float& d = distance[o.index(x, y)];
    if (d <= 0.5f) return;  // an outline, or beside the model
    for (const auto& [dx, dy, step] : {std::tuple(-1, 0, 1.0f), std::tuple(0, -1, 1.0f),
                                       std::tuple(-1, -1, kDiagonal), std::tuple(1, -1, kDiagonal)})
      if (const int u = x + sign * dx, v = y + sign * dy; u >= 0 && v >= 0 && u < w && v < h)
        d = std::min(d, distance[o.index(u, v)] + step);
  };
  for (int y = o.y.begin; y < o.y.end; ++y)
    for (int x = o.x.begin; x < o.x.end; ++x) relax(x, y, 1);
  for (int y = o.y.end; y-- > o.y.begin;)
    for (int x = o.x.end; x-- > o.x.begin;) relax(x, y, -1);
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
    light[std::size_t(distance[p])] += lightness(o.pixel_at(p));
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
void spread(const Overlay& o, std::vector<Pixel>& colour, std::vector<std::uint8_t>& state) {
  std::vector<std::array<int, 2>> queue;  // coloured, beside what isn't yet
  for (int y = o.y.begin; y < o.y.end; ++y)
    for (int x = o.x.begin; x < o.x.end; ++x)
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

// The most (or least) of the columns within r of each, transposed. Two of the largest windows that
// doubling makes cover each; what is nearer than r to the first or last column is left undefined.
template <class Better>
Eigen::ArrayXXf columns_within(Eigen::ArrayXXf a, int r, const Better& better) {
  const Eigen::Index n = a.cols();
  Eigen::Index window = 1;  // of column i: the best of [i, i + window)
  for (; 2 * window <= 2 * r + 1; window *= 2)
    for (Eigen::Index i = 0; i + window < n; ++i) better(a.col(i), a.col(i + window), a.col(i));
  Eigen::ArrayXXf out(a.rows(), n);
  for (Eigen::Index i = 0; i < n; ++i)
    better(a.col(std::max<Eigen::Index>(i - r, 0)),
           a.col(std::clamp<Eigen::Index>(i + r + 1 - window, 0, n - 1)), out.col(i));
  return out.transpose();
}

// Morphological closing by a square of side 2 r + 1: what is dark and thinner than that is filled.
// The outermost r rows and columns have to be light.
Eigen::ArrayXXf without_thin_dark(Eigen::ArrayXXf light, int r) {
  const auto most = [](const auto& a, const auto& b, auto&& out) { out = a.max(b); };
  const auto least = [](const auto& a, const auto& b, auto&& out) { out = a.min(b); };
  for (int axis = 0; axis < 2; ++axis) light = columns_within(std::move(light), r, most);
  for (int axis = 0; axis < 2; ++axis) light = columns_within(std::move(light), r, least);
  return light;
}

// Takes the drawing's colours where they can be trusted, and spreads them from there to the
// outlines without crossing one.
void fill_colours(const Overlay& o, Sketch& sketch) {
  const std::vector<float> distance = outline_distances(o);
  const float ink = ink_width(o, distance);
  sketch.colour.assign(distance.size(), Pixel{});
  sketch.state.assign(distance.size(), Sketch::nothing);
  // The middle of what is thinner than two lines of ink is still its best colour.
  const auto in_the_middle = [&](int x, int y) {
    const float d = distance[o.index(x, y)];
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, sketch.height - 1); ++v)
      for (int u = std::max(x - 1, 0); u <= std::min(x + 1, sketch.width - 1); ++u)
        if (distance[o.index(u, v)] > d) return false;
    return d > 1;
  };
  for (int y = o.y.begin; y < o.y.end; ++y)
    for (int x = o.x.begin; x < o.x.end; ++x) {
      const std::size_t p = o.index(x, y);
      if (!o.inside(x, y) || !o.opaque(p)) continue;
      if (distance[p] < ink && !in_the_middle(x, y)) continue;
      sketch.colour[p] = o.pixel_at(p);
      sketch.state[p] = Sketch::drawn;
    }
  spread(o, sketch.colour, sketch.state);
  sketch.plain = sketch.colour;
  std::vector<std::uint8_t> state = sketch.state;
  const int r = int(ink);
  const auto each = [&](Eigen::ArrayXXf& values, const auto& visit) {
    for (int y = o.y.begin; y < o.y.end; ++y)
      for (int x = o.x.begin; x < o.x.end; ++x)
        visit(o.index(x, y), values(x - o.x.begin + r, y - o.y.begin + r));
  };
  // All is light beside the model, so that a line along its edge is thin, too.
  Eigen::ArrayXXf light = Eigen::ArrayXXf::Ones(o.x.size() + 2 * r, o.y.size() + 2 * r);
  each(light, [&](std::size_t p, float& here) {
    if (state[p] != Sketch::nothing) here = lightness(sketch.colour[p]);
  });
  Eigen::ArrayXXf darker = without_thin_dark(light, r) - light;
  each(darker, [&](std::size_t p, float by) {
    if (state[p] == Sketch::pulled || by > kInkDarker) state[p] = Sketch::nothing;
  });
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

std::optional<Rgb> Sketch::at(const std::vector<Pixel>& colours, const Vec2& pixel,
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
      sum += w * Rgb(colours[at][0], colours[at][1], colours[at][2]);
      all += w;
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
    const bool perspective = camera.camera.type == Camera::Type::perspective;
    Overlay overlay = overlay_of(drawings[f], F,
                                 raster_triangles(view.pixels, view.depth,
                                                  perspective ? std::span<const double>(view.depth)
                                                              : std::span<const double>(),
                                                  F, frame.width, frame.height),
                                 pixel);
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
