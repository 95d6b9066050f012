#include "model/calibrate/ray_residuals.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/LU>

#include "model/calibrate/ray_search.h"

namespace artisketch {
namespace {

constexpr double kDrawnSize = 500;      // pixels: the figure in which unit() is a pixel
constexpr double kLeastUnit = 0.5;      // pixels: nobody draws finer
constexpr int kLeastRays = 8;           // of a contour
constexpr double kMargin = 6;           // of an outline's raster about its box, in unit()
constexpr double kMostSamples = 200;    // of a raster along a side
constexpr double kReach = 1.3;          // of a part's radius: poses may be that far off
constexpr double kOutOfSight = 1e6;     // pixels²: a ray with no depth in front of every camera
constexpr double kMiddleToBone = 1e-2;  // weight of the bone where centroids leave the depth open

double drawn_size(const Document& document) {
  double sum = 0;
  int frames = 0;
  for (const Frame& frame : document.frames) {
    Box2 box;
    for (const Contour& contour : frame.contours)
      for (const Vec2& p : contour.line.points) box.extend(p);
    if (box.isEmpty()) continue;
    sum += box.diagonal().norm();
    ++frames;
  }
  return frames ? sum / frames : kDrawnSize;
}

RayResiduals::View view_of(const Document& document, int frame, int joint, double unit, double step,
                           int most) {
  RayResiduals::View view;
  view.frame = frame;
  const std::vector<Polyline> lines = contours_of(document.frames[frame], joint);
  double total = 0, area = 0;
  for (const Polyline& line : lines) {
    total += length(line);
    if (line.closed) area += std::abs(signed_area(line));
  }
  const PolygonDistance exact(closed_polygons(lines));
  const double margin = kMargin * unit;
  const double widest = exact.box().sizes().maxCoeff() + 2 * margin;
  view.outline = std::make_shared<const SampledDistance>(
      exact, std::min(1 / unit, kMostSamples / widest), margin);
  step = std::max(step, total / most);
  for (const Polyline& line : lines) {
    const std::vector<Vec2> points = resampled(line, step).points;
    view.points.insert(view.points.end(), points.begin(), points.end());
  }
  const double rays = std::max(double(view.points.size()), 1.0);
  view.weight = total / rays / (unit * unit * unit);
  view.centroid = centroid(lines);
  view.size = std::max(std::sqrt(area), unit);
  return view;
}

// What a residual is made of, for its derivatives.
struct Row {
  int view = 0;
  double r = 0;         // pixels outside the silhouette
  double by_depth = 0;  // its derivatives: by the ray's depth,
  Vec3 by_point;        // by the point in that view's world,
  double by_scale = 0;  // by the logarithm of that view's scale
  Vec3 X;               // the point
};

// Adds one ray's rows. The depth t is projected out (Golub and Pereyra 1973):
//   H = JᵀJ − (Jᵀq)(Jᵀq)ᵀ / h,   g = Jᵀr,
// with q = ∂r/∂t and h the second derivative by the depth. Without that, angles err twice as much.
void add_ray(const std::vector<Row>& rows, const std::vector<int>& frames, int from, const Vec3& X,
             const std::vector<Mat3>& turned, double h, double weight, bool scales,
             MotionSystem& system) {
  using Block = Eigen::Matrix<double, kMotion, kMotion>;
  Block HA = Block::Zero();
  PartMotion gA = PartMotion::Zero(), qA = PartMotion::Zero();
  const int a = kMotion * from;
  static thread_local std::vector<std::pair<int, PartMotion>> q;
  q.clear();
  for (const Row& row : rows) {
    const int v = kMotion * frames[row.view];
    // The frame seen moves the point; the ray's own frame moves it the other way.
    const Vec3 back = turned[row.view].transpose() * row.by_point;
    PartMotion seen, own;
    seen << row.X.cross(row.by_point), row.by_point, (scales ? row.by_scale : 0.0);
    own << -X.cross(back), -back, (scales ? -back.head<2>().dot(X.head<2>()) : 0.0);
    system.H.block<kMotion, kMotion>(v, v) += weight * seen * seen.transpose();
    const Block both = weight * seen * own.transpose();
    system.H.block<kMotion, kMotion>(v, a) += both;
    system.H.block<kMotion, kMotion>(a, v) += both.transpose();
    HA += weight * own * own.transpose();
    system.g.segment<kMotion>(v) += weight * row.r * seen;
    gA += row.r * own;
    qA += row.by_depth * own;
    q.emplace_back(v, row.by_depth * seen);
  }
  system.H.block<kMotion, kMotion>(a, a) += HA;
  system.g.segment<kMotion>(a) += weight * gA;
  if (h <= 1e-12) return;
  q.emplace_back(a, qA);
  for (const auto& [i, x] : q)
    for (const auto& [j, y] : q)
      system.H.block<kMotion, kMotion>(i, j) -= (weight / h) * x * y.transpose();
}

}  // namespace

Placement placed(const Document& document, std::span<const Pose> poses,
                 std::span<const double> scales) {
  Placement placement;
  for (std::size_t f = 0; f < document.frames.size(); ++f) {
    placement.posed.push_back(posed_joints(document.skeleton, poses[f]));
    placement.cameras.push_back(frame_camera(document, int(f)));
    if (document.camera.type == Camera::Type::orthographic)
      placement.cameras.back().scale = scales[f];
  }
  return placement;
}

RayResiduals::RayResiduals(const Document& document, double step, int most) {
  unit_ = std::max(kLeastUnit, drawn_size(document) / kDrawnSize);
  std::vector<Pose> poses;
  std::vector<double> scales;
  for (const Frame& frame : document.frames) {
    poses.push_back(frame.pose);
    scales.push_back(frame.scale);
  }
  const Placement placement = placed(document, poses, scales);
  const auto shared = shared_contours(document);
  for (const int joint : drawn_joints(document)) {
    Part part;
    part.joint = joint;
    part.radius = 0;
    part.bone = middle_of_bones(document, joint);
    for (int f = 0; f < int(document.frames.size()); ++f) {
      if (!shared[f][joint]) continue;
      part.views.push_back(view_of(document, f, joint, unit_, step * unit_, most));
      const Transform& to_world = placement.posed[f][joint];
      const double per_unit = placement.cameras[f].pixels_per_unit(to_world.translation().z());
      const Box2 box = bounds(contours_of(document.frames[f], joint));
      if (per_unit > 0) part.radius = std::max(part.radius, box.diagonal().norm() / 2 / per_unit);
    }
    if (part.views.size() > 1) parts_.push_back(std::move(part));
  }
}

Vec3 RayResiduals::Part::middle(const Placement& placement) const {
  NearestToRays nearest(bone, kMiddleToBone);
  for (const View& view : views) {
    const Transform& to_world = placement.posed[view.frame][joint];
    const Ray ray = placement.cameras[view.frame].ray(view.centroid);
    nearest.add({to_world.inverse() * ray.origin, to_world.linear().transpose() * ray.direction});
  }
  return nearest.point();
}

RayResiduals RayResiduals::thinned(int most) const {
  RayResiduals fewer = *this;
  for (Part& part : fewer.parts_) {
    const int wanted = std::max(kLeastRays, most / int(part.views.size() - 1));
    for (View& view : part.views) {
      const std::size_t all = view.points.size(), kept = std::min<std::size_t>(all, wanted);
      for (std::size_t i = 0; i < kept; ++i) view.points[i] = view.points[i * all / kept];
      view.points.resize(kept);
      if (kept > 0) view.weight *= double(all) / double(kept);
    }
  }
  return fewer;
}

RayResiduals RayResiduals::of(const std::vector<char>& joints) const {
  RayResiduals some = *this;
  some.parts_.erase(std::remove_if(some.parts_.begin(), some.parts_.end(),
                                   [&](const Part& part) { return !joints[part.joint]; }),
                    some.parts_.end());
  return some;
}

double RayResiduals::contour_length() const {
  double sum = 0;
  for (const Part& part : parts_)
    for (const View& view : part.views) sum += view.weight * double(view.points.size());
  return sum * unit_ * unit_;
}

// Calls visit(view, point, squared miss, depth from the middle, ray, the search's rays) for every
// ray of a part, until that returns false.
template <class Visit>
void RayResiduals::each_ray(const Part& part, const Placement& placement,
                            const Visit& visit) const {
  const int n = int(part.views.size());
  const Vec3 about = part.middle(placement);
  RaySearch search;
  std::vector<Transform> across(n - 1);
  for (int a = 0; a < n; ++a) {
    const View& from = part.views[a];
    const Transform& to_world = placement.posed[from.frame][part.joint];
    const Transform to_part = to_world.inverse();
    search.outlines.clear();
    for (int i = 0; i < n - 1; ++i) {
      const View& other = part.views[i + (i >= a)];
      across[i] = placement.posed[other.frame][part.joint] * to_part;
      search.outlines.push_back(other.outline.get());
    }
    const Vec3 middle = to_world * about;
    for (std::size_t p = 0; p < from.points.size(); ++p) {
      Ray ray = placement.cameras[from.frame].ray(from.points[p]);
      ray.origin = ray.at((middle - ray.origin).dot(ray.direction));
      search.rays.clear();
      for (int i = 0; i < n - 1; ++i)
        search.rays.emplace_back(placement.cameras[part.views[i + (i >= a)].frame],
                                 across[i] * ray.origin, across[i].linear() * ray.direction);
      double e;
      const double t = search.best_depth(kReach * part.radius, e);
      if (!visit(a, int(p), std::min(e, kOutOfSight), t, ray, search, across)) return;
    }
  }
}

void RayResiduals::clear(MotionSystems& systems, int frames) const {
  systems.resize(parts_.size());
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    systems[i].first = parts_[i].joint;
    systems[i].second.clear(frames);
  }
}

double RayResiduals::evaluate(const Placement& placement, double reach, double weight,
                              MotionSystems* systems) const {
  const double c2 = reach * unit_ * reach * unit_;
  const bool scales = placement.cameras[0].camera.type == Camera::Type::orthographic;
  double energy = 0;
  std::vector<Row> rows;
  std::vector<int> other_frames;
  std::vector<Mat3> turned;
  for (std::size_t number = 0; number < parts_.size(); ++number) {
    const Part& part = parts_[number];
    each_ray(part, placement,
             [&](int a, int, double e, double t, const Ray& ray, const RaySearch& search,
                 const std::vector<Transform>& across) {
               if (e == 0) return true;
               const View& from = part.views[a];
               const double share = c2 > 0 ? c2 / (c2 + e) : 1;
               energy += weight * from.weight * share * e;
               if (!systems) return true;
               rows.clear();
               other_frames.clear();
               turned.clear();
               double h = 0;
               for (int i = 0; i < int(search.rays.size()); ++i) {
                 const View& other = part.views[i + (i >= a)];
                 other_frames.push_back(other.frame);
                 turned.push_back(across[i].linear());
                 if (!search.rays[i].in_front(t)) continue;
                 Vec2 along, gradient;
                 const Vec2 u = search.rays[i].pixel(t, along);
                 const double sd = other.outline->distance(u, gradient);
                 if (sd <= 0) continue;
                 const FrameCamera& camera = placement.cameras[other.frame];
                 Row row;
                 row.view = i;
                 row.r = sd;
                 row.by_depth = gradient.dot(along);
                 row.X = across[i] * ray.at(t);
                 row.by_point = camera.jacobian(row.X).transpose() * gradient;
                 row.by_scale = gradient.dot(u - camera.principal_point);
                 // Along a tangent a ray leaves an outline of radius ρ as a parabola does. Where a
                 // single silhouette is missed that bend is all there is: q = 0 there.
                 const double rho = 0.25 * other.size;
                 const double tangent =
                     std::max(0.0, along.squaredNorm() - row.by_depth * row.by_depth);
                 h += row.by_depth * row.by_depth + sd * tangent / (rho + sd);
                 rows.push_back(row);
               }
               if (!rows.empty())
                 add_ray(rows, other_frames, from.frame, ray.at(t), turned, h,
                         weight * from.weight * share * share, scales, (*systems)[number].second);
               return true;
             });
  }
  return energy;
}

std::vector<std::vector<double>> RayResiduals::misses(const Part& part,
                                                      const Placement& placement) const {
  std::vector<std::vector<double>> squared;
  for (const View& view : part.views) squared.emplace_back(view.points.size());
  each_ray(part, placement,
           [&](int a, int p, double e, double, const Ray&, const RaySearch&,
               const std::vector<Transform>&) {
             squared[a][p] = e;
             return true;
           });
  return squared;
}

double RayResiduals::cost(const Part& part, const Placement& placement, double enough) const {
  double sum = 0;
  each_ray(part, placement,
           [&](int a, int, double e, double, const Ray&, const RaySearch&,
               const std::vector<Transform>&) {
             sum += part.views[a].weight * e;
             return sum <= enough;
           });
  return sum;
}

Vec3 line_of_sight(const RayResiduals::Part& part, const RayResiduals::View& view,
                   const Placement& placement) {
  const Transform& to_world = placement.posed[view.frame][part.joint];
  return to_world.linear().transpose() * placement.cameras[view.frame].ray(view.centroid).direction;
}

Vec2 reach_along(const RayResiduals::Part& part, const RayResiduals::View& view,
                 const Placement& placement, const Vec3& middle, const Vec3& axis) {
  const Transform& to_world = placement.posed[view.frame][part.joint];
  const Transform to_part = to_world.inverse();
  const double z = (to_world * middle).z();
  Vec2 reach(std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity());
  for (const Vec2& p : view.points) {
    const double at = axis.dot(to_part * placement.cameras[view.frame].ray(p).at_z(z));
    reach = {std::min(reach.x(), at), std::max(reach.y(), at)};
  }
  return reach;
}

RayResiduals rays_to_compare(const Document& document) {
  constexpr double kPixel = 1;      // between rays
  constexpr int kMostPixels = 160;  // of one contour
  constexpr int kMostMet = 320;     // the same, times the frames it is held against
  return RayResiduals(document, kPixel, kMostPixels).thinned(kMostMet);
}

}  // namespace artisketch
