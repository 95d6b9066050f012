#include "model/surface/carving.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <Eigen/Dense>

namespace artisketch {

Vec3 middle_of_bones(const Part& part) {
  if (part.bones.empty()) return part.origin;
  Vec3 sum = Vec3::Zero();
  for (const Bone& bone : part.bones) sum += (bone.a + bone.b) / 2;
  return sum / double(part.bones.size());
}

namespace {

// Half the outline's width across its narrow side, in pixels: the extent of its points along the
// axis of their least deviation.
double narrow_half_width(const PartView& view) {
  std::vector<Vec2> points;
  for (const Polyline& line : view.contours)
    if (line.closed)
      for (const Vec2& p : resampled(line, 1).points) points.push_back(p);
  Vec2 mean = Vec2::Zero();
  for (const Vec2& p : points) mean += p / double(points.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Vec2& p : points) spread += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec2& p : points) {
    const double x = axes.eigenvectors().col(0).dot(p - mean);
    low = std::min(low, x);
    high = std::max(high, x);
  }
  return (high - low) / 2;
}

// How far the bones' ends lie from a point along a direction: a limb that points at the camera is
// as deep as it is long.
double reach_of_bones(const Part& part, const Vec3& centre, const Vec3& direction) {
  double reach = 0;
  for (const Bone& bone : part.bones)
    for (const Vec3& end : {bone.a, bone.b})
      reach = std::max(reach, std::abs((end - centre).dot(direction)));
  return reach;
}

// No part is so deep that it shows only from where no view looks: the bound is generous, for a foot
// is longer than wide, and grows beyond every part as the views spread to a right angle.
Slab slab_of(const Part& part, const Carving& carving) {
  constexpr double kDeeper = 3;  // times the tangent's square
  Slab slab;
  if (carving.spread > 0.999) return slab;
  slab.centre = carving.centre;
  slab.direction = carving.views[0].direction;
  slab.half = 0;
  for (const Silhouette& view : carving.views)
    slab.half = std::max(
        slab.half, narrow_half_width(*view.view) / view.view->pixels_per_unit(carving.centre));
  slab.half *= part.fatness * (1 + kDeeper * carving.spread / (1 - carving.spread));
  slab.half += reach_of_bones(part, carving.centre, slab.direction);
  return slab;
}

// The point nearest to the middles of all outlines, pulled to the part's bones as firmly as `pull`
// views would.
Vec3 nearest_to_middles(const Carving& carving, double pull) {
  Mat3 A = pull * Mat3::Identity();
  Vec3 b = pull * carving.middle;
  for (const Silhouette& view : carving.views) {
    const Ray ray = view.view->ray(view.view->outline.box().center());
    const Mat3 across = Mat3::Identity() - ray.direction * ray.direction.transpose();
    A += across;
    b += across * ray.origin;
  }
  return A.ldlt().solve(b);
}

// A cube about the point nearest to the middles of all outlines.
Box3 room_of(const Carving& carving) {
  double diameter = 0;
  for (const Silhouette& view : carving.views)
    diameter = std::max(diameter, view.view->outline.box().diagonal().norm() /
                                      view.view->pixels_per_unit(carving.middle));
  const Vec3 centre = nearest_to_middles(carving, 1e-3);
  return {centre - Vec3::Constant(0.75 * diameter), centre + Vec3::Constant(0.75 * diameter)};
}

// What ever finer carving leaves of the room.
Box3 hull_box(const Carving& carving) {
  double grown = 0;
  for (const Silhouette& view : carving.views)
    grown = std::max(grown, view.grown / view.view->pixels_per_unit(carving.middle));
  Box3 box(carving.room.min() - Vec3::Constant(grown), carving.room.max() + Vec3::Constant(grown));
  constexpr int n = 20;
  for (int pass = 0; pass < 3; ++pass) {
    const Vec3 step = box.sizes() / n;
    const float reach = float(step.norm() / 2 * 1.05);  // the rasters' few per cent
    // From the middle out: what lies between samples that are kept need not be asked.
    Index3 from = Index3::Constant(n), to = Index3::Constant(-1);  // the kept samples
    const auto outward = [](int i) { return n / 2 + (i % 2 ? -(i + 1) / 2 : i / 2); };
    float row[n];
    const auto ask = [&](int begin, int end, int j, int k) {
      if (begin >= end) return;
      const Vec3 start = box.min() + Vec3(0.5, j + 0.5, k + 0.5).cwiseProduct(step);
      const Vec3 along(step.x(), 0, 0);
      for (int i = begin; i < end; ++i) row[i] = float(carving.slab.distance(start + i * along));
      for (const Silhouette& view : carving.views) {
        // What one view leaves out needn't be asked of the others.
        while (begin < end && row[begin] > reach) ++begin;
        while (begin < end && row[end - 1] > reach) --end;
        if (begin == end) return;
        view.raise(start + begin * along, along, end - begin, row + begin);
      }
      for (int i = begin; i < end; ++i)
        if (row[i] <= reach) {
          from = from.cwiseMin(Index3(i, j, k));
          to = to.cwiseMax(Index3(i, j, k));
        }
    };
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < n; ++j) {
        const Index3 at(0, outward(j), outward(k));
        const bool between = (at.tail<2>().array() >= from.tail<2>().array()).all() &&
                             (at.tail<2>().array() <= to.tail<2>().array()).all();
        const int first = between ? from.x() : n, last = between ? to.x() : n;
        ask(0, first, at.y(), at.z());
        ask(last + 1, n, at.y(), at.z());
      }
    if (to.x() < 0) return {};
    box = Box3(box.min() + from.cast<double>().cwiseProduct(step),
               box.min() + (to + Index3::Ones()).cast<double>().cwiseProduct(step));
  }
  return box;
}

// Mean width of the thinnest outline in units: 2 · area / perimeter, w for a long strip w wide.
double mean_width(const Carving& carving) {
  double least = std::numeric_limits<double>::infinity();
  for (const Silhouette& view : carving.views) {
    double area = 0, perimeter = 0;
    for (const Polyline& line : view.view->contours)
      if (line.closed) {
        area += std::abs(signed_area(line));
        perimeter += length(line);
      }
    least = std::min(least, (2 * area / std::max(perimeter, 1e-9) + 2 * view.grown) /
                                view.view->pixels_per_unit(carving.middle));
  }
  return least;
}

}  // namespace

double sin2_between(const Vec3& a, const Vec3& b) {
  return std::min(a.cross(b).squaredNorm(), 1.0);
}

namespace {

Vec3 direction_of(const PartView& view) {
  return view.ray(view.outline.box().center()).direction;
}

double widest(const std::vector<Vec3>& directions) {
  double most = 0;
  for (std::size_t v = 0; v < directions.size(); ++v)
    for (std::size_t w = 0; w < v; ++w)
      most = std::max(most, sin2_between(directions[v], directions[w]));
  return most;
}

// How much the views lack of telling all depths as well as two at a right angle do: 1 where all
// look along one line, the cosine of the angle between two, 0 where more of them make up for that.
// A view tells what lies across it, so they leave open what most of them look along.
double how_open(const std::vector<Vec3>& directions) {
  Mat3 along = Mat3::Zero();
  for (const Vec3& d : directions) along += d * d.transpose();
  const double most = Eigen::SelfAdjointEigenSolver<Mat3>(along).eigenvalues()[2];
  return std::clamp(1 - (double(directions.size()) - most), 0.0, 1.0);
}

}  // namespace

double widest_spread(const Part& part) {
  std::vector<Vec3> directions;
  for (const PartView& view : part.views)
    if (view.seen()) directions.push_back(direction_of(view));
  return widest(directions);
}

Silhouette::Silhouette(const PartView& view, int cells) : view(&view) {
  const double longest = std::max(view.outline.box().sizes().maxCoeff(), 1e-6);
  const double step = longest / (2.0 * cells);  // half a cell: what the grid can show, and no more
  raster = DistanceRaster(closed_polygons(view.contours), step, 6 * step);
  direction = direction_of(view);
}

double Silhouette::distance(const Vec3& p) const {
  const Vec3 X = view->to_world * p;
  if (!view->camera.in_front(X)) return std::numeric_limits<double>::infinity();
  return (raster.distance(view->camera.project(X)) - grown) / view->camera.pixels_per_unit(X.z());
}

namespace {

using Vec3f = Eigen::Vector3f;

// Raises a row of values to the distances along a line in world space.
void raise_row(const Silhouette& s, const Vec3f& X, const Vec3f& d, int n, float* values,
               Silhouette::Unit unit) {
  const FrameCamera& camera = s.view->camera;
  const bool pixels = unit == Silhouette::Unit::pixels;
  const float px = float(camera.principal_point.x()), py = float(camera.principal_point.y());
  const float x = X.x(), y = X.y(), dx = d.x(), dy = d.y(), grown = float(s.grown);
  constexpr int kLanes = 4;
  float u[kLanes], v[kLanes], distances[kLanes];
  if (camera.camera.type == Camera::Type::orthographic) {
    const float scale = float(camera.pixels_per_unit(0)), per_scale = pixels ? 1 : 1 / scale;
    const float u0 = px + scale * x, du = scale * dx, v0 = py - scale * y, dv = -scale * dy;
    for (int from = 0; from < n; from += kLanes) {
      for (int l = 0; l < kLanes; ++l) {
        u[l] = u0 + float(from + l) * du;
        v[l] = v0 + float(from + l) * dv;
      }
      s.raster.distances(u, v, distances);
      for (int l = 0; l < std::min(kLanes, n - from); ++l)
        values[from + l] = std::max(values[from + l], (distances[l] - grown) * per_scale);
    }
    return;
  }
  const float f = float(camera.camera.focal_length);
  const float w = float(camera.camera.distance) - X.z(), dw = -d.z();
  for (int from = 0; from < n; from += kLanes) {
    float depth[kLanes];
    for (int l = 0; l < kLanes; ++l) {
      depth[l] = w + float(from + l) * dw;
      const float scale = f / depth[l];
      u[l] = px + scale * (x + float(from + l) * dx);
      v[l] = py - scale * (y + float(from + l) * dy);
    }
    s.raster.distances(u, v, distances);
    for (int l = 0; l < std::min(kLanes, n - from); ++l) {
      float& value = values[from + l];
      if (depth[l] <= 0)
        value = std::numeric_limits<float>::infinity();
      else
        value = std::max(value, (distances[l] - grown) * (pixels ? 1 : depth[l] / f));
    }
  }
}

}  // namespace

void Silhouette::raise(const Vec3& start, const Vec3& step, int n, float* values, Unit unit) const {
  raise_row(*this, (view->to_world * start).cast<float>(),
            (view->to_world.linear() * step).cast<float>(), n, values, unit);
}

void Silhouette::raise(const Vec3& start, double cell, const Index3& n, float* values,
                       std::ptrdiff_t stride_y, std::ptrdiff_t stride_z) const {
  const Vec3f X = (view->to_world * start).cast<float>();
  const Eigen::Matrix3f d = (cell * view->to_world.linear()).cast<float>();
  for (int k = 0; k < n.z(); ++k)
    for (int j = 0; j < n.y(); ++j)
      raise_row(*this, X + float(j) * d.col(1) + float(k) * d.col(2), d.col(0), n.x(),
                values + j * stride_y + k * stride_z, Unit::units);
}

Result<Carving> carving_of(const Part& part, int cells) {
  Carving carving;
  carving.name = part.name;
  carving.middle = middle_of_bones(part);
  carving.radius = std::numeric_limits<double>::infinity();
  add_views(part, part.views, cells, carving);
  if (carving.views.empty())
    return bad_input("'" + part.name + "' has no closed contour in any frame");
  return carving;
}

void add_views(const Part& part, std::span<const PartView> views, int cells, Carving& carving) {
  for (const PartView& view : views) {
    if (!view.seen()) continue;
    carving.views.emplace_back(view, cells);
    carving.radius = std::min(carving.radius, carving.views.back().raster.deepest() /
                                                  view.pixels_per_unit(carving.middle));
  }
  if (carving.views.empty()) return;
  std::vector<Vec3> directions, own;
  for (const Silhouette& view : carving.views) {
    directions.push_back(view.direction);
    if (!view.view->mirrored) own.push_back(view.direction);
  }
  carving.spread = widest(directions);
  carving.open_depth = how_open(own);
  constexpr double kPull = 0.1;  // a bone lies in its part, though seldom in its middle
  const Vec3 along = carving.views[0].direction;
  carving.centre =
      carving.middle + along.dot(nearest_to_middles(carving, kPull) - carving.middle) * along;
  carving.slab = slab_of(part, carving);
  carving.room = room_of(carving);
}

Result<Grid3<float>> carving_grid(const Carving& carving, int cells) {
  const Box3 box = hull_box(carving);
  if (box.isEmpty()) return bad_input("the contours of '" + carving.name + "' share no volume");
  double cell = std::max(box.sizes().maxCoeff(), 1e-9) / cells;
  // A thin part needs some cells across its width to stay in one piece; as its box is mostly
  // narrow, they cost no more than a plump part's. Where it isn't, the budget decides.
  const double thin = mean_width(carving) / 5;
  if (thin < cell) {
    const double budget = 1.3 * std::pow(cells + 5.0, 3);
    const Vec3 sizes = box.sizes();
    const auto samples = [&](double c) { return ((sizes / c).array().ceil() + 5).prod(); };
    while (cell > thin && samples(cell * 0.95) <= budget) cell *= 0.95;
  }
  const Index3 size = (box.sizes() / cell).array().ceil().cast<int>() + 5;
  return Grid3<float>(box.min() - Vec3::Constant(2 * cell), cell, size,
                      std::numeric_limits<float>::max());
}

namespace {

// Carves a grid a block after the other. One question in a block's middle tells whether it lies
// wholly outside or inside by more than its half diagonal, and which views are nowhere the largest
// in it. A projection stretches lengths by no more than its pixels per unit, so the distance in
// units changes by at most about the way walked; the rasters are a few per cent off.
class Carver {
 public:
  Carver(const Carving& carving, double band, Grid3<float>& g)
      : carving_(carving), band_(band), g_(g), at_centre_(carving.views.size()) {}
  // The samples from `first` on, `side` along each axis; in blocks of 4³ where they aren't all far.
  void carve(const Index3& first, int side) {
    const Vec3 centre =
        g_.origin + g_.cell * (first.cast<double>() + Vec3::Constant((side - 1) / 2.0));
    const double reach = kStretch * g_.cell * (side - 1) / 2.0 * std::sqrt(3.0);
    const double beyond = reach + band_ * g_.cell;
    double most = carving_.slab.distance(centre);
    for (std::size_t v = 0; v < at_centre_.size() && most <= beyond; ++v)
      most = std::max(most, at_centre_[v] = carving_.views[v].distance(centre));
    const bool far = std::abs(most) > beyond;
    const Index3 end = (first + Index3::Constant(side)).cwiseMin(g_.size);
    if (!far && side > kBlock) {
      for (int k = first.z(); k < end.z(); k += kBlock)
        for (int j = first.y(); j < end.y(); j += kBlock)
          for (int i = first.x(); i < end.x(); i += kBlock) carve({i, j, k}, kBlock);
      return;
    }
    for (int k = first.z(); k < end.z(); ++k)
      for (int j = first.y(); j < end.y(); ++j)
        for (int i = first.x(); i < end.x(); ++i)
          g_(i, j, k) = float(far ? most : carving_.slab.distance(g_.position(i, j, k)));
    if (far) return;
    float* const values = &g_(first.x(), first.y(), first.z());
    for (std::size_t v = 0; v < at_centre_.size(); ++v)
      if (at_centre_[v] >= most - 2 * reach)
        carving_.views[v].raise(g_.position(first.x(), first.y(), first.z()), g_.cell, end - first,
                                values, g_.stride_y(), g_.stride_z());
  }
  static constexpr int kBlock = 4;

 private:
  static constexpr double kStretch = 1.2;
  const Carving& carving_;
  double band_;
  Grid3<float>& g_;
  std::vector<double> at_centre_;
};

}  // namespace

Result<Grid3<float>> carve(const Carving& carving, int cells, Run& run, double band,
                           Beyond beyond) {
  Result<Grid3<float>> grid = carving_grid(carving, cells);
  if (!grid) return grid;
  Grid3<float>& g = *grid;
  Carver carver(carving, band, g);
  const int side = (beyond == Beyond::signs ? 4 : 1) * Carver::kBlock;
  for (int k = 0; k < g.size.z(); k += side) {
    if (run.cancelled()) return cancelled();
    for (int j = 0; j < g.size.y(); j += side)
      for (int i = 0; i < g.size.x(); i += side) carver.carve({i, j, k}, side);
  }
  return grid;
}

void widen_until_they_meet(Carving& carving, std::vector<std::string>& warnings) {
  // The box search keeps what may touch, so a hull of nothing may leave a box: look for an inside.
  const auto has_inside = [&](double grown) {
    for (Silhouette& view : carving.views) view.grown = grown;
    const Box3 box = hull_box(carving);
    if (box.isEmpty()) return false;
    constexpr int n = 24;
    for (int k = 0; k <= n; ++k)
      for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
          if (carving.distance(box.min() + Vec3(i, j, k).cwiseProduct(box.sizes() / n)) < 0)
            return true;
    return false;
  };
  std::vector<double> before;
  for (const Silhouette& view : carving.views) before.push_back(view.grown);
  if (has_inside(0)) {
    for (std::size_t v = 0; v < before.size(); ++v) carving.views[v].grown = before[v];
    return;
  }
  double most = 1;
  while (most < 1e4 && !has_inside(most)) most *= 2;
  double least = most / 2;
  for (int i = 0; i < 4; ++i) {
    const double middle = (least + most) / 2;
    (has_inside(middle) ? most : least) = middle;
  }
  // What barely meets is a sliver: a share of the smallest outline gives it a body.
  double smallest = std::numeric_limits<double>::infinity();
  std::set<int> numbers;
  for (const Silhouette& view : carving.views) {
    smallest = std::min(smallest, view.view->outline.box().sizes().minCoeff());
    numbers.insert(view.view->frame + 1);
  }
  std::string frames;
  for (const int number : numbers) frames += (frames.empty() ? "" : ", ") + std::to_string(number);
  const double grown = most + 0.15 * smallest;
  for (Silhouette& view : carving.views) view.grown = grown;
  warnings.push_back("'" + carving.name + "': its contours in frames " + frames +
                     " share no volume at these poses; they were widened by " +
                     std::to_string(int(std::lround(100 * grown / smallest))) +
                     " % of the smallest one's size to give it a body. Check the poses of '" +
                     carving.name + "' there");
}

}  // namespace artisketch
