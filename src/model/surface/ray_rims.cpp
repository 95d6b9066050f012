#include "model/surface/ray_rims.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <Eigen/Dense>

namespace artisketch {
namespace {

constexpr int kDepths = 48;  // depths tried along a ray

// A ray's samples at common depths relative to the plane through the box's centre across the view:
// rays of one view are near parallel, so equal indices mean equal depths to the eye.
struct Depths {
  double first = 0, step = 1;  // along the ray
  double at(double k) const { return first + k * step; }
};
Depths depths_of(const Box3& box, const Ray& ray) {
  const double middle = (box.center() - ray.origin).dot(ray.direction);
  const double half = box.diagonal().norm() / 2;
  return {middle - half, 2 * half / (kDepths - 1)};
}

// How far a point of the rim's ray lies outside of what the other views (and the slab) allow.
struct Others {
  std::vector<const Silhouette*> views;
  const Slab* slab;
  // At each of a ray's depths.
  std::array<float, kDepths> distances(const Ray& ray, const Depths& depths) const {
    std::array<float, kDepths> most;
    for (int k = 0; k < kDepths; ++k) most[k] = float(slab->distance(ray.at(depths.at(k))));
    for (const Silhouette* view : views)
      view->raise(ray.at(depths.first), depths.step * ray.direction, kDepths, most.data());
    return most;
  }
};
Others others_of(const Carving& carving, int view) {
  Others others{{}, &carving.slab};
  for (const Silhouette& other : carving.views)
    if (sin2_between(other.direction, carving.views[view].direction) > kOneDirection)
      others.views.push_back(&other);
  return others;
}

// A polygon's point and smoothed tangent at an arc length.
class ArcLength {
 public:
  explicit ArcLength(const Polyline& line) : line_(line), at_(1, 0) {
    for (std::size_t i = 0; i < line.segments(); ++i)
      at_.push_back(at_.back() + (line.end_of(i) - line.points[i]).norm());
  }
  double total() const { return at_.back(); }
  Vec2 point(double s) const {
    s -= total() * std::floor(s / total());
    const auto after = std::upper_bound(at_.begin() + 1, at_.end() - 1, s);
    const std::size_t i = after - at_.begin() - 1;
    const double span = at_[i + 1] - at_[i];
    return line_.points[i] +
           (line_.end_of(i) - line_.points[i]) * (span > 0 ? (s - at_[i]) / span : 0);
  }

 private:
  const Polyline& line_;
  std::vector<double> at_;
};

// The ray through an outline at so many spacings along it, its normal by the outline's run within
// `reach` of them, on either side; nothing where it doesn't run on.
std::optional<RimRay> ray_at(const Silhouette& silhouette, const ArcLength& arc, double spacing,
                             double at, double reach) {
  const Vec2 along = arc.point((at + reach) * spacing) - arc.point((at - reach) * spacing);
  if (!(along.norm() > 1e-9)) return std::nullopt;
  RimRay ray;
  ray.pixel = arc.point(at * spacing);
  ray.outward = Vec2(along.y(), -along.x()).normalized();
  ray.ray = silhouette.view->ray(ray.pixel);
  return ray;
}

// Of tips of ears, fingers and tufts, equally spaced rays show next to nothing: the line turns
// round them between two.
void add_tips(const Silhouette& silhouette, const ArcLength& arc, double spacing, RayRim& rim) {
  constexpr double kTurn = 0.5;  // cosine of what the outline turns from one ray to the next
  const int n = int(rim.rays.size());
  for (int i = 0; i < n; ++i) {
    const RimRay &a = rim.rays[i], &b = rim.rays[(i + 1) % n];
    const bool convex = (b.pixel - a.pixel).dot(b.outward - a.outward) > 0;
    if (!convex || a.outward.dot(b.outward) > kTurn) continue;
    for (const double share : {0.25, 0.5, 0.75}) {
      std::optional<RimRay> ray = ray_at(silhouette, arc, spacing, i + share, 0.1);
      if (!ray) continue;
      if (ray->outward.dot(a.outward + b.outward) < 0) ray->outward = -ray->outward;
      rim.tips.push_back({*ray, i, share});
    }
  }
}

}  // namespace

std::vector<RayRim> outline_rays(const Silhouette& silhouette, int count) {
  std::vector<RayRim> rims;
  double total = 0;
  for (const Polyline& line : silhouette.view->contours)
    if (line.closed) total += length(line);
  for (const Polyline& line : silhouette.view->contours) {
    if (!line.closed) continue;
    const ArcLength arc(line);
    if (!(arc.total() > 0)) continue;
    const int n = std::max(8, int(std::lround(count * arc.total() / total)));
    const double spacing = arc.total() / n;
    RayRim rim;
    double votes = 0;
    for (int i = 0; i < n; ++i) {
      const std::optional<RimRay> ray = ray_at(silhouette, arc, spacing, i, 0.4);
      if (!ray) continue;
      const Vec2 way = std::min(0.25 * spacing, 1.0) * ray->outward;
      votes += silhouette.raster.distance(ray->pixel + way) -
               silhouette.raster.distance(ray->pixel - way);
      rim.rays.push_back(*ray);
    }
    if (votes < 0)
      for (RimRay& ray : rim.rays) ray.outward = -ray.outward;
    if (int(rim.rays.size()) == n) add_tips(silhouette, arc, spacing, rim);
    if (rim.rays.size() >= 3) rims.push_back(std::move(rim));
  }
  return rims;
}

void choose_depths(const Carving& carving, const Box3& box, RayRim& rim) {
  const int n = int(rim.rays.size());
  const double R = carving.radius;
  const Others others = others_of(carving, rim.view);
  // Data term per ray and depth: far outside is dear, deep inside is good.
  constexpr double kOutside = 100, kSmooth = 0.5, kSheet = 1;
  std::vector<Depths> depths;
  std::vector<float> data(std::size_t(n) * kDepths);
  for (int i = 0; i < n; ++i) {
    depths.push_back(depths_of(box, rim.rays[i].ray));
    const std::array<float, kDepths> outside = others.distances(rim.rays[i].ray, depths[i]);
    for (int k = 0; k < kDepths; ++k) {
      const double e = outside[k] / R, off = (depths[i].at(k) - rim.rays[i].sheet) / R;
      data[i * kDepths + k] =
          float((e > 0 ? kOutside * std::min(e * e, 100.0) : (1 - rim.doubt) * e) +
                rim.doubt * kSheet * off * off);
    }
  }
  // Twice around, so that the seam lies in the middle of a path that is then cut at both ends.
  const int steps = 2 * n;
  std::vector<float> cost(data.begin(), data.begin() + kDepths), next(kDepths);
  std::vector<int> from(std::size_t(steps) * kDepths);
  const float step = float(depths[0].step / R);
  for (int s = 1; s < steps; ++s) {
    const Vec3 a = rim.rays[(s - 1) % n].ray.at(depths[(s - 1) % n].at(kDepths / 2));
    const Vec3 b = rim.rays[s % n].ray.at(depths[s % n].at(kDepths / 2));
    const float way = float(std::max((b - a).norm() / R, 1e-3));
    const float dear = float(kSmooth) * step * step / way;
    for (int k = 0; k < kDepths; ++k) {
      float best = std::numeric_limits<float>::max();
      int best_k = k;
      for (int q = 0; q < kDepths; ++q) {
        const float c = cost[q] + dear * float((k - q) * (k - q));
        if (c < best) best = c, best_k = q;
      }
      next[k] = best + data[(s % n) * kDepths + k] * way;
      from[s * kDepths + k] = best_k;
    }
    cost.swap(next);
  }
  int k = int(std::min_element(cost.begin(), cost.end()) - cost.begin());
  for (int s = steps - 1; s > 0; --s) {
    if (s >= n / 2 && s < n / 2 + n) rim.rays[s % n].depth = depths[s % n].at(k);
    k = from[s * kDepths + k];
  }
  if (n / 2 == 0) rim.rays[0].depth = depths[0].at(k);
}

namespace {

// Where f is least along a ray, and how sharply it bends there.
struct Least {
  double depth = 0, bend = 0;
};
Least least_along(const Ray& ray, const Depths& depths, const HermiteSurface& f,
                  const Others& others) {
  float values[kDepths];
  f.values(ray.at(depths.first), depths.step * ray.direction, kDepths, values);
  const std::array<float, kDepths> outside = others.distances(ray, depths);
  for (int k = 0; k < kDepths; ++k) values[k] += 2 * std::max(0.0f, outside[k]);
  const int best = int(std::min_element(values, values + kDepths) - values);
  if (best == 0 || best + 1 == kDepths) return {depths.at(best), 0};
  // The parabola through three samples.
  const double a = values[best - 1], b = values[best], c = values[best + 1];
  const double bend = a - 2 * b + c;
  if (!(bend > 0)) return {depths.at(best), 0};
  return {depths.at(best + std::clamp((a - c) / (2 * bend), -0.5, 0.5)),
          bend / (depths.step * depths.step)};
}

}  // namespace

void detect_depths(const Carving& carving, const Box3& box, const HermiteSurface& f, RayRim& rim) {
  const Others others = others_of(carving, rim.view);
  const int n = int(rim.rays.size());
  const double R = carving.radius;
  // Least squares: each depth near the one found, as firmly as f bends there though no more than a
  // ball of the part's size would, and near its neighbours' depths. Where f is flat along the rays
  // the neighbours decide.
  constexpr double kSmooth = 0.5, kLoosest = 1e-3, kGuess = 0.3;
  const auto step_after = [&](int i) {
    const RimRay &a = rim.rays[i], &b = rim.rays[(i + 1) % n];
    return std::max((a.ray.at(a.depth) - b.ray.at(a.depth)).norm(), 1e-3 * R);
  };
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd rhs(n);
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    const double after = step_after(i), before = step_after((i + n - 1) % n);
    const Least least = least_along(rim.rays[i].ray, depths_of(box, rim.rays[i].ray), f, others);
    const double firm = (before + after) / 2 * std::clamp(least.bend, kLoosest / R, 1 / R);
    const double guess = (before + after) / 2 * kGuess * rim.doubt / R;
    A(i, i) += firm + guess;
    rhs[i] = firm * least.depth + guess * rim.rays[i].sheet;
    const double tie = kSmooth * R / after;
    A(i, i) += tie;
    A(next, next) += tie;
    A(i, next) -= tie;
    A(next, i) -= tie;
  }
  const Eigen::VectorXd smooth = A.llt().solve(rhs);
  for (int i = 0; i < n; ++i) rim.rays[i].depth = smooth[i];
}

std::vector<SurfacePoint> surface_points(const Carving& carving, const std::vector<RayRim>& rims,
                                         int stride) {
  constexpr double kMostDoubt = 0.5;  // else where a tip lies is a guess
  std::vector<SurfacePoint> points;
  for (const RayRim& rim : rims) {
    const PartView& view = *carving.views[rim.view].view;
    const auto add = [&](const RimRay& ray, double depth) {
      const Vec3 p = ray.ray.at(depth);
      const Vec3 X = view.to_world * p;
      const Vec3 along =
          view.to_world.linear().transpose() * (view.camera.jacobian(X).transpose() * ray.outward);
      if (!(along.norm() > 0)) return;
      const Vec3 n = along.normalized();
      points.push_back({p, n, (ray.ray.direction - ray.ray.direction.dot(n) * n).normalized(),
                        carving.views[rim.view].trust});
    };
    for (std::size_t i = 0; i < rim.rays.size(); i += std::size_t(stride))
      add(rim.rays[i], rim.rays[i].depth);
    if (stride > 1 || rim.doubt > kMostDoubt) continue;
    for (const TipRay& tip : rim.tips) {
      const double before = rim.rays[tip.after].depth,
                   after = rim.rays[(tip.after + 1) % rim.rays.size()].depth;
      add(tip.ray, before + tip.share * (after - before));
    }
  }
  const std::size_t all = points.size();
  if (all <= kMostSurfacePoints) return points;
  for (std::size_t i = 0; i < kMostSurfacePoints; ++i)
    points[i] = points[i * all / kMostSurfacePoints];
  points.resize(kMostSurfacePoints);
  return points;
}

}  // namespace artisketch
