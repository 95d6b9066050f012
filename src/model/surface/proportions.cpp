// Least squares, linear but for which points of the outlines reach farthest. Two views share one
// axis, across both lines of sight (the epipolar tangents touch the outlines at its ends); along
// the other axis in the picture they show the same the better, the nearer their lines of sight lie.
#include "model/surface/proportions.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

#include "model/surface/carving.h"

namespace artisketch {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Standard deviations, lengths in the part's size (the root of its largest outline's area):
constexpr double kShifted = 0.1, kStretched = 0.15;  // of what a hand does to an outline
constexpr double kSame = 0.03;  // of what two outlines of one extent still differ by
constexpr double kDeeperBySine =
    0.5;  // … and per sine between two sights, by what the part is deep
constexpr double kHalfMended = 0.05;   // the contradiction of which half is mended
constexpr double kLeastMended = 0.02;  // of it that is worth the work
// The contradiction up to which mirrored outlines have a say: so many times the own one, and that
// of a left hand drawn larger than the right one by chance. More is how the figure is.
constexpr double kLikeOwn = 1.5, kTwinsDiffer = 0.15;
constexpr double kMostShifted = 0.25, kMostStretched = 0.35;  // more is no hand's doing
constexpr std::size_t kEnoughViews = 16;  // own ones: mirrored ones would only cost time
constexpr int kPasses = 4;                // each with the points found by the one before
constexpr double kSameSight = 1e-3;       // sine between two sights that share all axes across them

// What a hand did to an outline: a shift, then the symmetric stretch's xx, yy and xy.
constexpr int kGive = 5;
using Give = Eigen::Matrix<double, kGive, 1>;

// An outline in the plane through the part's middle, across its line of sight.
struct DrawnOutline {
  Vec3 sight = Vec3::UnitZ(), x = Vec3::UnitX(), y = Vec3::UnitY();
  std::vector<Vec2> points;  // units, of the closed contours one after another
  Vec2 centre = Vec2::Zero();
  double size = 0;
  Give give = Give::Zero();

  Vec2 in_plane(const Vec3& p) const { return {x.dot(p), y.dot(p)}; }
  Vec2 given(const Vec2& p, const Give& by) const {
    const Vec2 d = p - centre;
    return p + by.head<2>() + Vec2(by[2] * d.x() + by[4] * d.y(), by[4] * d.x() + by[3] * d.y());
  }
};

DrawnOutline drawn_outline(const PartView& view, const Vec3& middle) {
  DrawnOutline out;
  out.sight = view.ray(view.outline.box().center()).direction;
  const Vec3 up = view.to_world.linear().transpose() * Vec3::UnitY();
  out.x = out.sight.cross(up);
  out.x = out.x.norm() > kSameSight ? out.x.normalized() : out.sight.unitOrthogonal();
  out.y = out.x.cross(out.sight);
  const double per_unit = view.pixels_per_unit(middle);
  double area = 0;
  Box2 box;
  for (const Polyline& line : view.contours) {
    if (!line.closed) continue;
    area += std::abs(signed_area(line)) / (per_unit * per_unit);
    for (const Vec2& pixel : line.points) {
      const Ray ray = view.ray(pixel);
      const double depth = (middle - ray.origin).dot(out.sight) / ray.direction.dot(out.sight);
      out.points.push_back(out.in_plane(ray.at(depth) - middle));
      box.extend(out.points.back());
    }
  }
  out.centre = box.center();
  out.size = std::sqrt(area);
  return out;
}

// How far an outline reaches along an axis, and its derivative by what it gives.
struct Reach {
  double at = -std::numeric_limits<double>::infinity();
  Give by = Give::Zero();
};

Reach reach(const DrawnOutline& view, const Vec3& axis) {
  const Vec2 along = view.in_plane(axis);
  Reach most;
  Vec2 far = Vec2::Zero();
  for (const Vec2& p : view.points) {
    const double at = along.dot(view.given(p, view.give));
    if (at <= most.at) continue;
    most.at = at;
    far = p - view.centre;
  }
  most.by << along, along.x() * far.x(), along.y() * far.y(),
      along.x() * far.y() + along.y() * far.x();
  return most;
}

// The axis that two views share, and the other one in each one's picture.
struct Axes {
  double sine = 0;  // between the lines of sight
  Vec3 shared, of_first, of_second;
};

Axes axes_of(const DrawnOutline& a, const DrawnOutline& b) {
  Axes axes;
  axes.shared = a.sight.cross(b.sight);
  axes.sine = std::min(axes.shared.norm(), 1.0);
  axes.shared = axes.sine < kSameSight ? a.x : Vec3(axes.shared / axes.sine);
  axes.of_first = axes.shared.cross(a.sight).normalized();
  axes.of_second = axes.shared.cross(b.sight).normalized();
  if (axes.of_first.dot(axes.of_second) < 0) axes.of_second = -axes.of_second;
  return axes;
}

// By how much outlines reach differently far along the axes that they share, in the part's size:
// root mean square over the pairs of the first `views`.
double contradiction_of(const std::vector<DrawnOutline>& drawn, std::size_t views, double size) {
  double squares = 0;
  int asked = 0;
  for (std::size_t v = 0; v < views; ++v)
    for (std::size_t w = 0; w < v; ++w) {
      const Axes axes = axes_of(drawn[v], drawn[w]);
      if (axes.sine < kSameSight) continue;
      for (const double sign : {1.0, -1.0}) {
        const double differs =
            reach(drawn[v], sign * axes.shared).at - reach(drawn[w], sign * axes.shared).at;
        squares += differs * differs / (size * size);
        ++asked;
      }
    }
  return asked > 0 ? std::sqrt(squares / asked) : 0;
}

// Normal equations in what all outlines give.
struct Equations {
  MatrixXd H;
  VectorXd g;
  double size = 1;

  Equations(const std::vector<DrawnOutline>& views, double size)
      : H(MatrixXd::Zero(kGive * views.size(), kGive * views.size())),
        g(VectorXd::Zero(kGive * views.size())),
        size(size) {
    for (std::size_t v = 0; v < views.size(); ++v)
      for (int i = 0; i < kGive; ++i) {
        const double width = i < 2 ? kShifted * size : kStretched;
        const auto at = Eigen::Index(kGive * v + i);
        H(at, at) = 1 / (width * width);
        g[at] = views[v].give[i] / (width * width);
      }
  }

  // View v reaches as far along one axis, both ways, as view w along another.
  void add(const std::vector<DrawnOutline>& views, int v, const Vec3& of_v, int w, const Vec3& of_w,
           double width) {
    const double weight = 1 / (width * width * size * size);
    const int i = kGive * v, j = kGive * w;
    for (const double sign : {1.0, -1.0}) {
      const Reach a = reach(views[v], sign * of_v), b = reach(views[w], sign * of_w);
      H.block<kGive, kGive>(i, i) += weight * a.by * a.by.transpose();
      H.block<kGive, kGive>(j, j) += weight * b.by * b.by.transpose();
      H.block<kGive, kGive>(i, j) -= weight * a.by * b.by.transpose();
      H.block<kGive, kGive>(j, i) -= weight * b.by * a.by.transpose();
      g.segment<kGive>(i) += weight * (a.at - b.at) * a.by;
      g.segment<kGive>(j) -= weight * (a.at - b.at) * b.by;
    }
  }
};

void find_gives(std::vector<DrawnOutline>& views, double size) {
  for (int pass = 0; pass < kPasses; ++pass) {
    Equations equations(views, size);
    for (int v = 0; v < int(views.size()); ++v)
      for (int w = 0; w < v; ++w) {
        const Axes axes = axes_of(views[v], views[w]);
        equations.add(views, v, axes.shared, w, axes.shared, kSame);
        equations.add(views, v, axes.of_first, w, axes.of_second,
                      std::hypot(kSame, kDeeperBySine * axes.sine));
      }
    const VectorXd step = equations.H.ldlt().solve(-equations.g);
    for (std::size_t v = 0; v < views.size(); ++v)
      views[v].give += step.segment<kGive>(Eigen::Index(kGive * v));
  }
}

Vec2 within_length(const Vec2& v, double most) {
  const double length = v.norm();
  return length > most ? Vec2(most / length * v) : v;
}

// The view with its closed contours where the outline's points are given.
void redraw(const DrawnOutline& outline, const Give& by, const Vec3& middle, PartView& view) {
  std::size_t i = 0;
  for (Polyline& line : view.contours) {
    if (!line.closed) continue;
    for (Vec2& pixel : line.points) {
      const Vec2 p = outline.given(outline.points[i++], by);
      pixel = view.project(middle + p.x() * outline.x + p.y() * outline.y);
    }
  }
  view.outline = outline_of(view.contours);
}

}  // namespace

InProportion in_proportion(const Part& given) {
  InProportion out{given};
  Part& part = out.part;
  const Vec3 middle = middle_of_bones(part);
  std::vector<PartView*> shown;
  std::vector<DrawnOutline> views;
  double size = 0;
  const auto show = [&](std::vector<PartView>& of) {
    for (PartView& view : of) {
      if (!view.seen() || !view.camera.in_front(view.to_world * middle)) continue;
      shown.push_back(&view);
      views.push_back(drawn_outline(view, middle));
      size = std::max(size, views.back().size);
    }
  };
  show(part.views);
  const std::size_t own = views.size();
  if (own < 2 || !(size > 0)) return out;
  double contradiction = contradiction_of(views, own, size);
  out.contradiction = contradiction;
  if (own <= kEnoughViews) show(part.mirrors);
  if (const double all = contradiction_of(views, views.size(), size);
      all > std::hypot(kLikeOwn * contradiction, kTwinsDiffer))
    views.resize(own);
  else
    contradiction = all;
  const double share =
      contradiction * contradiction / (contradiction * contradiction + kHalfMended * kHalfMended);
  if (share < kLeastMended) return out;
  find_gives(views, size);
  const bool sound = std::all_of(views.begin(), views.end(),
                                 [](const DrawnOutline& view) { return view.give.allFinite(); });
  if (!sound) return out;
  for (std::size_t v = 0; v < views.size(); ++v) {
    Give by = share * views[v].give;
    by.head<2>() = within_length(by.head<2>(), kMostShifted * size);
    by.tail<3>() = by.tail<3>().cwiseMax(-kMostStretched).cwiseMin(kMostStretched);
    redraw(views[v], by, middle, *shown[v]);
  }
  return out;
}

}  // namespace artisketch
