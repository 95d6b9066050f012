#include "model/surface/mirror.h"

#include <algorithm>
#include <cmath>

#include "model/surface/agreement.h"

namespace artisketch {
void add_mirrored_views(const Document& document, std::vector<Part>& parts) {
  const Skeleton& skeleton = document.skeleton;
  if (skeleton.joints.empty()) return;
  Transform reflection = Transform::Identity();
  reflection.linear()(0, 0) = -1;
  reflection.translation().x() = 2 * rest_positions(skeleton)[0].x();
  for (Part& part : parts) {
    const int image = skeleton.joints[part.joint].mirror;
    if (image < 0) continue;
    const auto of_image = std::find_if(parts.begin(), parts.end(),
                                       [&](const Part& other) { return other.joint == image; });
    if (of_image == parts.end()) continue;
    part.mirrors.clear();
    for (const PartView& view : of_image->views) {
      if (!view.seen()) continue;
      part.mirrors.push_back(view);
      part.mirrors.back().mirrored = true;
      part.mirrors.back().to_world = view.to_world * reflection;
    }
  }
}

namespace {

// Pixels by which a part's outlines differ from their mirror images where those are half trusted:
// what calibration leaves, and what the hand does that drew them. It grows with by how much the
// part's own outlines contradict each other, which is little in rendered figures, 0.3 to 1.5 %, and
// 10 % of the part's size in drawn ones.
double tolerance_of(const Part& part, double contradiction) {
  constexpr double kCalibrated = 0.3;             // pixels
  constexpr double kDrawn = 2, kRendered = 0.04;  // of the contradiction; contradictions
  double area = 0;
  for (const PartView& view : part.views) {
    double of_view = 0;
    for (const Polyline& line : view.contours)
      if (line.closed) of_view += std::abs(signed_area(line));
    area = std::max(area, of_view);
  }
  const double drawn = kDrawn * contradiction * contradiction / (contradiction + kRendered);
  return std::hypot(kCalibrated, drawn * std::sqrt(area));
}

// How many pixels a point lies outside of a view's outline.
double outside(const Silhouette& view, const Vec3& p) {
  return view.distance(p) * view.view->pixels_per_unit(p);
}

// Trusts each mirrored outline the less, the farther its rays miss the own outlines and the own
// ones' rays miss it: root mean square.
void trust_mirrors(double tolerance, Carving& all) {
  constexpr double kSharp = 4;  // power
  std::vector<double> squares(all.views.size(), 0.0);
  std::vector<int> rays(all.views.size(), 0);
  int own_rays = 0;
  for (std::size_t v = 0; v < all.views.size(); ++v) {
    const Silhouette& view = all.views[v];
    const bool mirrored = view.view->mirrored;
    const auto others = all_but(all, view, !mirrored);
    each_ray(view, [&](const Ray& ray) {
      ++(mirrored ? rays[v] : own_rays);
      const Miss found = miss(ray, others, all.room, 0);
      if (!(found.distance > 0)) return;
      if (mirrored) squares[v] += found.distance * found.distance;
      for (std::size_t m = 0; m < all.views.size() && !mirrored; ++m)
        if (all.views[m].view->mirrored)
          squares[m] += std::pow(std::max(outside(all.views[m], found.point), 0.0), 2);
    });
  }
  for (std::size_t m = 0; m < all.views.size(); ++m)
    if (all.views[m].view->mirrored)
      all.views[m].trust =
          1 / (1 + std::pow(std::sqrt(squares[m] / std::max(rays[m] + own_rays, 1)) / tolerance,
                            kSharp));
}

// Grows mirrored outlines until none takes anything that the own ones show.
void grow_mirrors(Carving& all) {
  constexpr double kLoose = 1;   // pixels about what isn't trusted: no creases for so little
  constexpr double kLeft = 1.5;  // pixels that are no loss
  for (Silhouette& view : all.views)
    if (view.view->mirrored) view.grown += kLoose * (1 - view.trust);
  std::vector<double> by(all.views.size(), 0.0);
  for (const Silhouette& view : all.views) {
    if (view.view->mirrored) continue;
    const auto own = all_but(all, view, false), others = all_but(all, view, true);
    each_ray(view, [&](const Ray& ray) {
      const Miss found = miss(ray, others, all.room, kLeft);
      if (!(found.distance > kLeft)) return;
      const double without = std::max(miss(ray, own, all.room, 0).distance, 0.0);
      for (std::size_t m = 0; m < all.views.size(); ++m)
        if (all.views[m].view->mirrored)
          by[m] = std::max(by[m], outside(all.views[m], found.point) - without - kLeft);
    });
  }
  for (std::size_t m = 0; m < all.views.size(); ++m) all.views[m].grown += by[m];
}

}  // namespace

Result<Carving> carving_with_mirrors(const Part& part, double contradiction, int cells) {
  Result<Carving> carving = carving_of(part, cells);
  if (!carving || part.mirrors.empty()) return carving;
  add_views(part, part.mirrors, cells, *carving);
  trust_mirrors(tolerance_of(part, contradiction), *carving);
  swell_mirrored(*carving);
  grow_mirrors(*carving);
  return carving;
}

}  // namespace artisketch
