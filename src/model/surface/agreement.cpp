#include "model/surface/agreement.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/golden_section.h"

namespace artisketch {
namespace {

constexpr double kMostSwelling = 0.06;  // of the outline's diagonal
constexpr double kMostGiven = 0.1;      // the same, of a mirrored outline
constexpr double kWidth = 12;           // of a swelling, times its height: a gentle one

}  // namespace

std::vector<const Silhouette*> all_but(const Carving& carving, const Silhouette& out,
                                       bool mirrored) {
  std::vector<const Silhouette*> rest;
  for (const Silhouette& view : carving.views)
    if (&view != &out && (mirrored || !view.view->mirrored)) rest.push_back(&view);
  return rest;
}

Miss miss(const Ray& ray, const std::vector<const Silhouette*>& others, const Box3& room,
          double enough) {
  const auto outside = [&](double depth) {
    const Vec3 p = ray.at(depth);
    double most = -std::numeric_limits<double>::infinity();
    for (const Silhouette* other : others)
      most = std::max(most, other->distance(p) * other->view->pixels_per_unit(p));
    return most;
  };
  constexpr int kSteps = 48;
  const double middle = (room.center() - ray.origin).dot(ray.direction);
  const double first = middle - room.diagonal().norm() / 2;
  const double step = room.diagonal().norm() / kSteps;
  std::array<float, kSteps + 1> along;
  along.fill(-std::numeric_limits<float>::infinity());
  // No view lowers a sample: what is farther out already than some sample is for all views needn't
  // be asked again.
  int begin = 0, end = kSteps + 1;
  float bound = std::numeric_limits<float>::infinity();
  for (std::size_t v = 0; v < others.size(); ++v) {
    others[v]->raise(ray.at(first + begin * step), step * ray.direction, end - begin,
                     along.data() + begin, Silhouette::Unit::pixels);
    if (v + 1 == others.size()) break;
    const int best =
        int(std::min_element(along.begin() + begin, along.begin() + end) - along.begin());
    constexpr float kRounding = 1e-3f;  // pixels
    if (v == 0) bound = float(outside(first + best * step)) + kRounding;
    while (begin < best && along[begin] > bound) ++begin;
    while (end > best + 1 && along[end - 1] > bound) --end;
  }
  const auto nearest = std::min_element(along.begin() + begin, along.begin() + end);
  double least = *nearest;
  double at = std::isinf(least) ? middle : first + step * double(nearest - along.begin());
  if (least <= enough) return {least, ray.at(at)};
  constexpr int kCloser = 12;  // steps about the best sample
  const Minimum found = golden_section(at - step, at + step, kCloser, outside);
  const double closer = (found.low + found.high) / 2, there = outside(closer);
  return there < least ? Miss{there, ray.at(closer)} : Miss{least, ray.at(at)};
}

double coverage(const Silhouette& outline, const std::vector<const Silhouette*>& others,
                const Box3& room, double tolerance) {
  int met = 0, all = 0;
  each_ray(outline, [&](const Ray& ray) {
    ++all;
    met += miss(ray, others, room, tolerance).distance <= tolerance;
  });
  return all ? double(met) / all : 1;
}

namespace {

// Rays of the outlines (of the own ones, if just the mirrored yield) come inside all others.
// Returns how far they lay outside on average, in the carving's radii.
double swell(Carving& carving, bool mirrored_yield) {
  double missed = 0;
  int rays = 0;
  const auto asks = [&](const Silhouette& s) { return !mirrored_yield || !s.view->mirrored; };
  const auto yields = [&](const Silhouette& s) { return !mirrored_yield || s.view->mirrored; };
  std::vector<std::vector<DistanceRaster::Swelling>> swellings(carving.views.size());
  for (const Silhouette& view : carving.views) {
    if (!asks(view)) continue;
    const auto others = all_but(carving, view);
    each_ray(view, [&](const Ray& ray) {
      const Miss found = miss(ray, others, carving.room, 0);
      ++rays;
      if (!(found.distance > 0)) return;
      missed += found.distance / (view.view->pixels_per_unit(found.point) * carving.radius);
      // Every outline that it passes there must give way, each by what it lacks.
      for (const Silhouette& other : carving.views) {
        if (&other == &view || !yields(other)) continue;
        const double lacks = other.distance(found.point) * other.view->pixels_per_unit(found.point);
        const double most = (mirrored_yield ? kMostGiven : kMostSwelling) *
                            other.view->outline.box().diagonal().norm();
        if (lacks > 0)
          swellings[&other - carving.views.data()].push_back(
              {other.view->project(found.point), std::min(lacks, most)});
      }
    });
  }
  for (std::size_t v = 0; v < swellings.size(); ++v)
    carving.views[v].raster.swell(swellings[v], kWidth);
  return rays > 0 ? missed / rays : 0;
}

}  // namespace

double swell_until_covered(Carving& carving) {
  return swell(carving, false);
}

void swell_mirrored(Carving& carving) {
  swell(carving, true);
}

}  // namespace artisketch
