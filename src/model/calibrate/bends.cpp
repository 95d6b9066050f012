// The middle line of an outline is broken once, where that fits it best; the angle there is how far
// the view shows the part bent, within the picture. A rigid part that is bent by b, a vector across
// its length, shows b · n from a view whose picture has the direction n across the part: what no b
// explains for all views is a bend from one drawing to another.
#include "model/calibrate/bends.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Dense>

#include "base/trigonometry.h"
#include "document/place_words.h"

namespace artisketch {
namespace {

constexpr double kLongPart = 1.8;        // standard deviations along the part over those across it
constexpr int kSlices = 24;              // across the length
constexpr double kNoJointAtEnds = 0.25;  // of the length, at each end, where no joint is looked for
constexpr double kHandsBend =
    radians(8);  // by which a hand's outlines of one part bend differently
constexpr double kRigidBend = radians(40);  // standard deviation of how far rigid parts are bent
// What is left over, of a view's bend and between two views, that only a joint explains.
constexpr double kUnexplained = radians(18), kBentApart = radians(35);

struct SeenBend {
  int frame = 0;
  double angle = 0;             // radians, positive toward `across`
  Vec3 across = Vec3::UnitX();  // in rest space, within the picture
};

// Points spread evenly over the inside of the closed contours.
std::vector<Vec2> inside_points(const PartView& view) {
  constexpr int kAlong = 80;
  const Box2 box = view.outline.box();
  const double step = box.sizes().maxCoeff() / kAlong;
  std::vector<Vec2> points;
  if (!(step > 0)) return points;
  for (double y = box.min().y() + step / 2; y < box.max().y(); y += step)
    for (double x = box.min().x() + step / 2; x < box.max().x(); x += step)
      if (view.outline.inside(Vec2(x, y))) points.emplace_back(x, y);
  return points;
}

struct Slice {
  double along = 0, across = 0, weight = 0;  // weight: points in it
};

// The middle of each slice across an axis.
std::vector<Slice> slices_of(const std::vector<Vec2>& points, const Vec2& middle,
                             const Vec2& along) {
  const Vec2 across(-along.y(), along.x());
  double low = 0, high = 0;
  for (const Vec2& p : points) {
    low = std::min(low, along.dot(p - middle));
    high = std::max(high, along.dot(p - middle));
  }
  std::vector<Slice> slices(kSlices);
  for (const Vec2& p : points) {
    const double at = along.dot(p - middle);
    const int i = std::clamp(int(kSlices * (at - low) / (high - low)), 0, kSlices - 1);
    slices[i].along += at;
    slices[i].across += across.dot(p - middle);
    slices[i].weight += 1;
  }
  std::erase_if(slices, [](const Slice& slice) { return slice.weight == 0; });
  for (Slice& slice : slices) {
    slice.along /= slice.weight;
    slice.across /= slice.weight;
  }
  return slices;
}

// The angle of the line broken once that fits the slices best.
double broken_by(const std::vector<Slice>& slices) {
  const double first = slices.front().along, length = slices.back().along - first;
  double best = std::numeric_limits<double>::infinity(), angle = 0;
  for (int k = 0; k <= 12; ++k) {
    const double at = first + length * (kNoJointAtEnds + (1 - 2 * kNoJointAtEnds) * k / 12);
    Mat3 A = Mat3::Zero();
    Vec3 b = Vec3::Zero();
    double squares = 0;
    for (const Slice& slice : slices) {
      const Vec3 row(1, slice.along - at, std::max(slice.along - at, 0.0));
      A += slice.weight * row * row.transpose();
      b += slice.weight * slice.across * row;
      squares += slice.weight * slice.across * slice.across;
    }
    const Vec3 x = A.ldlt().solve(b);
    const double left = squares - b.dot(x);
    if (!x.allFinite() || left >= best) continue;
    best = left;
    angle = arctangent(x[1] + x[2], 1) - arctangent(x[1], 1);
  }
  return angle;
}

// How far a view shows the part bent; nothing of one that is short there.
std::optional<SeenBend> seen_by(const PartView& view) {
  const std::vector<Vec2> points = inside_points(view);
  if (points.size() < 3 * kSlices) return std::nullopt;
  Vec2 middle = Vec2::Zero();
  for (const Vec2& p : points) middle += p / double(points.size());
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Vec2& p : points) spread += (p - middle) * (p - middle).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
  if (axes.eigenvalues()[1] < kLongPart * kLongPart * axes.eigenvalues()[0]) return std::nullopt;
  const Vec2 along = axes.eigenvectors().col(1), across(-along.y(), along.x());
  const std::vector<Slice> slices = slices_of(points, middle, along);
  if (slices.size() < kSlices / 2) return std::nullopt;
  // The picture's y goes down.
  const Vec3 in_world(across.x(), -across.y(), 0);
  return SeenBend{view.frame, broken_by(slices), view.to_world.linear().transpose() * in_world};
}

std::optional<Bend> bend_of(const Part& part) {
  std::vector<SeenBend> all;
  for (const PartView& view : part.views)
    if (view.seen())
      if (const std::optional<SeenBend> seen = seen_by(view)) all.push_back(*seen);
  if (all.size() < 2) return std::nullopt;
  Mat3 A = kHandsBend * kHandsBend / (kRigidBend * kRigidBend) * Mat3::Identity();
  Vec3 b = Vec3::Zero();
  for (const SeenBend& seen : all) {
    A += seen.across * seen.across.transpose();
    b += seen.angle * seen.across;
  }
  const Vec3 rigid = A.ldlt().solve(b);
  double most = 0;
  for (const SeenBend& seen : all)
    most = std::max(most, std::abs(seen.angle - rigid.dot(seen.across)));
  if (most < kUnexplained) return std::nullopt;
  // The two that show it most differently, as far as they look at it alike.
  Bend bend{part.joint, 0, 0, 0};
  for (const SeenBend& one : all)
    for (const SeenBend& other : all) {
      const double alike = one.across.dot(other.across);
      const double differ =
          std::abs(alike) * std::abs(one.angle - (alike < 0 ? -1 : 1) * other.angle);
      if (std::abs(one.angle) < std::abs(other.angle) || differ <= bend.angle) continue;
      bend.bent = one.frame;
      bend.straighter = other.frame;
      bend.angle = differ;
    }
  return bend.angle < kBentApart ? std::nullopt : std::optional(bend);
}

}  // namespace

std::vector<Bend> bends_of(std::span<const Part> parts) {
  std::vector<Bend> bends;
  for (const Part& part : parts)
    if (const std::optional<Bend> bend = bend_of(part)) bends.push_back(*bend);
  return bends;
}

std::string bend_words(const Document& document, const Bend& bend) {
  return frame_words(document, bend.bent) + ": '" + document.skeleton.joints[bend.joint].name +
         "' is bent by " + std::to_string(std::lround(degrees(bend.angle))) + "° against " +
         frame_words(document, bend.straighter) +
         ": one rigid part can't show both. Split it at a joint where it bends";
}

}  // namespace artisketch
