#include <algorithm>
#include <cmath>
#include <limits>

#include "base/at_once.h"
#include "base/raster.h"
#include "model/stages.h"

namespace artisketch {
namespace {

constexpr double kPerPixel = 2;        // samples per pixel of the sketch, along x and y
constexpr double kMostSamples = 1024;  // along a side; a larger sketch is sampled more coarsely
constexpr double kMargin = 2;          // sketch pixels round a part

// A raster over a window of the sketch.
struct Window {
  Vec2 origin = Vec2::Zero();  // sketch pixels
  double per_pixel = kPerPixel;
  int width = 0, height = 0;

  explicit Window(const Box2& box, double wanted = kPerPixel) : origin(box.min()) {
    const Vec2 size = box.sizes();
    per_pixel = std::min(wanted, kMostSamples / std::max(size.maxCoeff(), 1.0));
    width = int(std::ceil(size.x() * per_pixel));
    height = int(std::ceil(size.y() * per_pixel));
  }
  Vec2 sample(const Vec2& pixel) const { return (pixel - origin) * per_pixel; }
};

// In sketch pixels. What stands behind the camera goes nowhere, which leaves its triangles out.
std::vector<Vec2> projected(const Points3& V, const FrameCamera& camera) {
  std::vector<Vec2> pixels(V.rows());
  for (int v = 0; v < V.rows(); ++v) {
    const Vec3 X = V.row(v).transpose();
    pixels[v] = camera.in_front(X) ? camera.project(X)
                                   : Vec2(Vec2::Constant(std::numeric_limits<double>::quiet_NaN()));
  }
  return pixels;
}

Mask triangle_mask(std::vector<Vec2> pixels, const Triangles& F, const Window& window) {
  Mask mask(window.width, window.height);
  for (Vec2& p : pixels) p = window.sample(p);
  add_surface(pixels, F, mask);
  return mask;
}

using Polygons = std::vector<std::vector<Vec2>>;

void add_part(Polygons polygons, const Window& window, Mask& mask) {
  for (std::vector<Vec2>& polygon : polygons)
    for (Vec2& p : polygon) p = window.sample(p);
  add_polygons(polygons, mask);
}

Points3 moved(const Points3& V, const Transform& motion) {
  return (V * motion.linear().transpose()).rowwise() + motion.translation().transpose();
}

double silhouette_overlap(const Document& document, int frame, const Model& model) {
  const Frame& f = document.frames[frame];
  const Window window(Box2(Vec2::Zero(), Vec2(f.width, f.height)));
  const Points3 V = posed_vertices(model.mesh.V, model.weights, model.skeleton, f.pose);
  const Mask posed =
      triangle_mask(projected(V, frame_camera(document, frame)), model.mesh.F, window);
  Mask drawn(window.width, window.height);
  for (int joint = 0; joint < document.skeleton.size(); ++joint)
    add_part(closed_contours(f, joint), window, drawn);
  return intersection_over_union(posed, drawn);
}

// Sketch pixels between the outline of a part and its contours within a room of the sketch;
// +infinity where there is nothing to compare.
double contour_distance(const Polygons& contours, const std::vector<Vec2>& pixels,
                        const Triangles& F, const Box2& room, double per_pixel) {
  Box2 box;
  for (const std::vector<Vec2>& polygon : contours)
    for (const Vec2& p : polygon) box.extend(p);
  for (const Vec2& p : pixels)
    if (p.allFinite()) box.extend(p);
  box = box.intersection(room);
  if (box.isEmpty()) return std::numeric_limits<double>::infinity();
  const Window window(
      Box2(box.min() - Vec2::Constant(kMargin), box.max() + Vec2::Constant(kMargin)), per_pixel);
  Mask drawn(window.width, window.height);
  add_part(contours, window, drawn);
  const double samples = outline_distance(drawn, triangle_mask(pixels, F, window));
  return samples / window.per_pixel;
}

// Of a part with contours in a frame.
double part_distance(const Document& document, int frame, const PartSurface& part) {
  const Frame& f = document.frames[frame];
  // What projects far off the sketch is off by far, wherever it ends.
  const Vec2 size(f.width, f.height);
  const Box2 room(-size, 2 * size);
  const Polygons contours = closed_contours(f, part.joint);
  if (contours.empty()) return std::numeric_limits<double>::infinity();
  const Transform motion = skinning_transforms(document.skeleton, f.pose)[part.joint];
  const auto pixels = projected(moved(part.mesh.V, motion), frame_camera(document, frame));
  return contour_distance(contours, pixels, part.mesh.F, room, kPerPixel);
}

}  // namespace

std::vector<FrameFit> measure_fit(const Document& calibrated, const Model& model,
                                  std::span<const PartSurface> parts, int threads) {
  // The whole of each frame, then its parts.
  const int of_frame = 1 + int(parts.size());
  std::vector<FrameFit> fits(calibrated.frames.size());
  std::vector<double> distances(fits.size() * of_frame);
  at_once(int(distances.size()), threads, [&](int i) {
    const int frame = i / of_frame, part = i % of_frame - 1;
    if (part < 0)
      fits[frame].iou = silhouette_overlap(calibrated, frame, model);
    else
      distances[i] = part_distance(calibrated, frame, parts[part]);
  });
  for (std::size_t i = 0; i < distances.size(); ++i)
    if (const int part = int(i) % of_frame - 1; part >= 0 && std::isfinite(distances[i]))
      fits[i / of_frame].parts.push_back({parts[part].joint, distances[i]});
  return fits;
}

std::vector<double> view_distances(const Part& part, const Mesh& mesh) {
  std::vector<double> distances;
  for (const PartView& view : part.views) {
    // What lies farther off than this is off by far, wherever it ends.
    const Vec2 reach = Vec2::Constant(view.seen() ? view.outline.box().diagonal().norm() : 0);
    const Box2 room(view.outline.box().min() - reach, view.outline.box().max() + reach);
    distances.push_back(contour_distance(closed_polygons(view.contours),
                                         projected(moved(mesh.V, view.to_world), view.camera),
                                         mesh.F, room, 0.5));
  }
  return distances;
}

}  // namespace artisketch
