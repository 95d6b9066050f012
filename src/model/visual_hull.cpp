// The visual hull of a part (Laurentini 1994), and the grid it lives on.
#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

#include "model/stages.h"

namespace artisketch {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// Views whose directions lie this near each other (or to each other's opposite) leave the part's
// depth open: one direction, as far as depth goes.
const double kSameDirection = radians(10);

std::vector<const PartView*> seen_views(const Part& part) {
  std::vector<const PartView*> views;
  for (const PartView& view : part.views)
    if (view.seen()) views.push_back(&view);
  return views;
}

// A point of the part's bone (or its joint), about which a part without a depth of its own lies.
Vec3 middle_of_bones(const Part& part) {
  if (part.bones.empty()) return part.origin;
  Vec3 sum = Vec3::Zero();
  for (const Bone& bone : part.bones) sum += (bone.a + bone.b) / 2;
  return sum / double(part.bones.size());
}

// The slab of depths that a view without a partner leaves to the part: its narrow side's width,
// centred on the bone. Signed distance in units, negative inside.
struct Slab {
  Vec3 centre, direction;
  double half = kNever;
  double distance(const Vec3& p) const {
    return half == kNever ? -kNever : std::abs((p - centre).dot(direction)) - half;
  }
};

Slab slab_of(const Part& part, const std::vector<const PartView*>& views) {
  const Vec3 middle = middle_of_bones(part);
  Slab slab;
  const Ray first = views[0]->ray(views[0]->outline.box().center());
  for (const PartView* view : views) {
    const Ray ray = view->ray(view->outline.box().center());
    if (std::abs(ray.direction.dot(first.direction)) < std::cos(kSameDirection)) return slab;
  }
  // Narrow side of the outline: least standard deviation of its points, as a rectangle's width.
  double half = 0;
  for (const PartView* view : views) {
    Vec2 mean = Vec2::Zero();
    int n = 0;
    std::vector<Vec2> points;
    for (const Polyline& line : view->contours)
      if (line.closed)
        for (const Vec2& p : resampled(line, 1).points) points.push_back(p);
    for (const Vec2& p : points) mean += p, ++n;
    mean /= n;
    Eigen::Matrix2d cov = Eigen::Matrix2d::Zero();
    for (const Vec2& p : points) cov += (p - mean) * (p - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(cov);
    double low = kNever, high = -kNever;
    for (const Vec2& p : points) {
      const double x = axes.eigenvectors().col(0).dot(p - mean);
      low = std::min(low, x);
      high = std::max(high, x);
    }
    half = std::max(half, (high - low) / 2 / view->pixels_per_unit(middle));
  }
  slab.centre = middle;
  slab.direction = first.direction;
  slab.half = half;
  return slab;
}

// Largest signed distance over the views and the slab, in units. `grown` pixels are given to every
// contour.
double hull_distance(const std::vector<const PartView*>& views, const Slab& slab, double grown,
                     const Vec3& p) {
  double most = slab.distance(p);
  for (const PartView* view : views) {
    const Vec3 X = view->to_world * p;
    if (!view->camera.in_front(X)) return kNever;
    const double px = view->outline.distance(view->camera.project(X)) - grown;
    most = std::max(most, px / view->camera.pixels_per_unit(X.z()));
  }
  return most;
}

// A box that surely holds the hull: the first guess has the first view's rays meet the middle's
// depth, with room for the part's whole diameter; then only what a coarse carving leaves.
Box3 hull_box(const Part& part, const std::vector<const PartView*>& views, const Slab& slab,
              double grown) {
  // The point nearest to all rays through the outlines' centres, pulled slightly to the bone.
  const Vec3 middle = middle_of_bones(part);
  Mat3 A = 1e-3 * Mat3::Identity();
  Vec3 b = 1e-3 * middle;
  double diameter = 0;
  for (const PartView* view : views) {
    const Ray ray = view->ray(view->outline.box().center());
    const Mat3 across = Mat3::Identity() - ray.direction * ray.direction.transpose();
    A += across;
    b += across * ray.origin;
    diameter = std::max(diameter, (view->outline.box().diagonal().norm() + 2 * grown) /
                                      view->pixels_per_unit(middle));
  }
  const Vec3 centre = A.ldlt().solve(b);
  Box3 box(centre - Vec3::Constant(0.75 * diameter), centre + Vec3::Constant(0.75 * diameter));
  // Twice finer: 32³ each time, keeping every cell that may touch the hull.
  for (int pass = 0; pass < 2; ++pass) {
    constexpr int n = 32;
    const Vec3 step = box.sizes() / n;
    const double reach = step.norm() / 2;
    Box3 kept;
    for (int k = 0; k < n; ++k)
      for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
          const Vec3 p = box.min() + (Vec3(i, j, k) + Vec3::Constant(0.5)).cwiseProduct(step);
          if (hull_distance(views, slab, grown, p) > reach) continue;
          kept.extend(p - step / 2);
          kept.extend(p + step / 2);
        }
    if (kept.isEmpty()) return kept;
    box = kept;
  }
  return box;
}

Result<Grid3<float>> grid_in(const Part& part, const Box3& box, int cells) {
  if (box.isEmpty()) return bad_input("the contours of '" + part.name + "' share no volume");
  const double cell = std::max(box.sizes().maxCoeff(), 1e-9) / cells;
  const Index3 size = (box.sizes() / cell).array().ceil().cast<int>() + 5;
  return Grid3<float>(box.min() - Vec3::Constant(2 * cell), cell, size,
                      std::numeric_limits<float>::max());
}

// The smallest widening of all contours, in pixels, at which a few thousandths of the first view's
// box are left: doubled until there is something, then halved towards the least.
double widening_that_leaves_something(const Part& part, const std::vector<const PartView*>& views,
                                      const Slab& slab) {
  double most = 1;
  while (most < 1e4 && hull_box(part, views, slab, most).isEmpty()) most *= 2;
  double least = most / 2;
  for (int i = 0; i < 4; ++i) {
    const double middle = (least + most) / 2;
    (hull_box(part, views, slab, middle).isEmpty() ? least : most) = middle;
  }
  // The box search keeps cells that only may touch: a share more makes sure of a body.
  double smallest = kNever;
  for (const PartView* view : views)
    smallest = std::min(smallest, view->outline.box().sizes().minCoeff());
  return most + 0.15 * smallest;
}

Result<Grid3<float>> filled(const Part& part, const std::vector<const PartView*>& views,
                            const Slab& slab, double grown, int cells, Run& run) {
  Result<Grid3<float>> grid = grid_in(part, hull_box(part, views, slab, grown), cells);
  if (!grid) return grid;
  Grid3<float>& g = *grid;
  // Blocks of 8³ samples: one query in the middle tells whether the block lies wholly outside or
  // inside by more than its half diagonal. A projection stretches lengths by no more than its
  // pixels per unit, so the distance in units changes by at most the way walked.
  constexpr int kBlock = 8;
  const double reach = g.cell * (kBlock - 1) / 2.0 * std::sqrt(3.0);
  for (int k0 = 0; k0 < g.size.z(); k0 += kBlock) {
    if (run.cancelled()) return cancelled();
    for (int j0 = 0; j0 < g.size.y(); j0 += kBlock)
      for (int i0 = 0; i0 < g.size.x(); i0 += kBlock) {
        const Vec3 centre =
            g.origin + g.cell * (Vec3(i0, j0, k0) + Vec3::Constant((kBlock - 1) / 2.0));
        const double at_centre = hull_distance(views, slab, grown, centre);
        // A margin of four cells keeps true distances where level sets and interpolation look.
        const bool far = std::abs(at_centre) > 1.5 * reach + 4 * g.cell;
        for (int k = k0; k < std::min(k0 + kBlock, g.size.z()); ++k)
          for (int j = j0; j < std::min(j0 + kBlock, g.size.y()); ++j)
            for (int i = i0; i < std::min(i0 + kBlock, g.size.x()); ++i)
              g(i, j, k) =
                  float(far ? at_centre : hull_distance(views, slab, grown, g.position(i, j, k)));
      }
  }
  return grid;
}

}  // namespace

Result<Grid3<float>> part_grid(const Part& part, int cells) {
  const auto views = seen_views(part);
  if (views.empty()) return bad_input("'" + part.name + "' has no closed contour in any frame");
  return grid_in(part, hull_box(part, views, slab_of(part, views), 0), cells);
}

Result<Grid3<float>> visual_hull(const Part& part, int cells, std::vector<std::string>& warnings,
                                 Run& run) {
  const auto views = seen_views(part);
  if (views.empty()) return bad_input("'" + part.name + "' has no closed contour in any frame");
  const Slab slab = slab_of(part, views);
  const auto has_inside = [](const Grid3<float>& g) {
    return std::any_of(g.values.begin(), g.values.end(), [](float v) { return v < 0; });
  };
  Result<Grid3<float>> hull = filled(part, views, slab, 0, cells, run);
  if (hull ? has_inside(*hull) : hull.error().kind == Error::Kind::cancelled) return hull;
  const double grown = widening_that_leaves_something(part, views, slab);
  std::string frames;
  for (const PartView* view : views)
    frames += (frames.empty() ? "" : ", ") + std::to_string(view->frame + 1);
  warnings.push_back("'" + part.name + "': its contours in frames " + frames +
                     " share no volume at these poses; they were widened by " +
                     std::to_string(int(std::lround(grown))) +
                     " px to give it a body. Check the poses of '" + part.name + "' there");
  return filled(part, views, slab, grown, cells, run);
}

}  // namespace artisketch
