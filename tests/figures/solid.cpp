#include "figures/solid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace artisketch::figures {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double limb_distance(const Blob& blob, const Vec3& p) {
  const Vec3 axis = blob.b - blob.a;
  const double length = axis.norm(), narrowing = blob.radius_a - blob.radius_b;
  // One end's sphere holds the other's: the limb is that sphere.
  if (length <= std::abs(narrowing)) {
    return narrowing > 0 ? (p - blob.a).norm() - blob.radius_a
                         : (p - blob.b).norm() - blob.radius_b;
  }
  const Vec3 along = axis / length;
  const double y = (p - blob.a).dot(along);
  const double x = (p - blob.a - y * along).norm();
  // The sphere of the family that p is nearest to: the cone's normal through p meets the axis at t.
  const double sine = narrowing / length;
  const double t = std::clamp(y - x * sine / std::sqrt(1 - sine * sine), 0.0, length);
  // Not hypot: nothing here is near overflow, and most of a drawing's time is spent here.
  return std::sqrt(x * x + (y - t) * (y - t)) - (blob.radius_a - narrowing * t / length);
}

double ellipsoid_distance(const Blob& blob, const Vec3& p) {
  const Vec3 q = blob.turn.conjugate() * (p - blob.a);
  const double k0 = q.cwiseQuotient(blob.radii).norm();
  const double k1 = q.cwiseQuotient(blob.radii.cwiseAbs2()).norm();
  return k1 > 1e-12 ? k0 * (k0 - 1) / k1 : -blob.radii.minCoeff();
}

double box_distance(const Blob& blob, const Vec3& p) {
  const Vec3 q = (blob.turn.conjugate() * (p - blob.a)).cwiseAbs() - blob.radii +
                 Vec3::Constant(blob.radius_a);
  return q.cwiseMax(0).norm() + std::min(q.maxCoeff(), 0.0) - blob.radius_a;
}

double smooth_minimum(double a, double b, double k) {
  const double overlap = k - std::abs(a - b);
  return std::min(a, b) - (overlap > 0 ? overlap * overlap / (4 * k) : 0);
}

Box3 bounds(const Blob& blob) {
  if (blob.kind == Blob::Kind::limb) {
    Box3 box(Vec3(blob.a - Vec3::Constant(blob.radius_a)),
             Vec3(blob.a + Vec3::Constant(blob.radius_a)));
    box.extend(Vec3(blob.b - Vec3::Constant(blob.radius_b)));
    box.extend(Vec3(blob.b + Vec3::Constant(blob.radius_b)));
    return box;
  }
  const Vec3 half = blob.turn.toRotationMatrix().cwiseAbs() * blob.radii;
  return {Vec3(blob.a - half), Vec3(blob.a + half)};
}

}  // namespace

Blob ball(const Vec3& centre, double radius) {
  return limb(centre, radius, centre, radius);
}

Blob limb(const Vec3& a, double radius_a, const Vec3& b, double radius_b) {
  Blob blob;
  blob.kind = Blob::Kind::limb;
  blob.a = a;
  blob.b = b;
  blob.radius_a = radius_a;
  blob.radius_b = radius_b;
  return blob;
}

Blob ellipsoid(const Vec3& centre, const Vec3& radii, const Quat& turn) {
  Blob blob;
  blob.a = centre;
  blob.radii = radii;
  blob.turn = turn;
  return blob;
}

Blob box(const Vec3& centre, const Vec3& half, double rounding, const Quat& turn) {
  Blob blob = ellipsoid(centre, half, turn);
  blob.kind = Blob::Kind::box;
  blob.radius_a = rounding;
  return blob;
}

double distance(const Blob& blob, const Vec3& p) {
  switch (blob.kind) {
    case Blob::Kind::limb:
      return limb_distance(blob, p);
    case Blob::Kind::ellipsoid:
      return ellipsoid_distance(blob, p);
    case Blob::Kind::box:
      return box_distance(blob, p);
  }
  return kInfinity;
}

double blended(const std::vector<const Blob*>& blobs, double k, const Vec3& p) {
  double d = kInfinity;
  for (const Blob* blob : blobs) d = smooth_minimum(d, distance(*blob, p), k);
  return d;
}

double distance(const Solid& solid, const Vec3& p) {
  double d = kInfinity;
  for (const Blob& blob : solid.blobs) d = smooth_minimum(d, distance(blob, p), solid.blend);
  return d;
}

Vec3 normal(const Solid& solid, const Vec3& p) {
  constexpr double kStep = 1e-5;
  std::vector<const Blob*> near;  // a blob further away than the blend changes nothing
  const double reach = distance(solid, p) + solid.blend + 4 * kStep;
  for (const Blob& blob : solid.blobs)
    if (distance(blob, p) < reach + solid.blend) near.push_back(&blob);
  Vec3 n;
  for (int a = 0; a < 3; ++a) {
    const Vec3 step = kStep * Vec3::Unit(a);
    n[a] = blended(near, solid.blend, p + step) - blended(near, solid.blend, p - step);
  }
  const double size = n.norm();
  return size > 0 ? Vec3(n / size) : Vec3(Vec3::UnitY());
}

int colour_index(const Solid& solid, const Vec3& p) {
  for (int i = int(solid.paint.size()) - 1; i >= 0; --i)
    if (distance(solid.paint[i], p) < 0) return int(solid.blobs.size()) + i;
  int nearest = 0;
  double best = kInfinity;
  for (std::size_t i = 0; i < solid.blobs.size(); ++i)
    if (const double d = distance(solid.blobs[i], p); d < best) {
      best = d;
      nearest = int(i);
    }
  return nearest;
}

unsigned colour_at(const Solid& solid, int index) {
  const int blobs = int(solid.blobs.size());
  return index < blobs ? solid.blobs[index].colour : solid.paint[index - blobs].colour;
}

Box3 bounds(const Solid& solid) {
  Box3 box;
  for (const Blob& blob : solid.blobs) box.extend(bounds(blob));
  // Blending swells the union by at most a quarter of the blend per blob that takes part.
  const Vec3 swell = Vec3::Constant(solid.blobs.size() > 1 ? solid.blend / 2 : 0);
  return {Vec3(box.min() - swell), Vec3(box.max() + swell)};
}

Ball bounding_ball(const Blob& blob) {
  switch (blob.kind) {
    case Blob::Kind::limb:
      return {(blob.a + blob.b) / 2,
              (blob.b - blob.a).norm() / 2 + std::max(blob.radius_a, blob.radius_b)};
    case Blob::Kind::ellipsoid:
      return {blob.a, blob.radii.maxCoeff()};
    case Blob::Kind::box:
      return {blob.a, blob.radii.norm()};
  }
  return {};
}

Ball bounding_ball(const Solid& solid) {
  const Box3 box = bounds(solid);
  return {box.center(), box.diagonal().norm() / 2};
}

Caster::Caster(const Solid& solid) : solid_(solid), ball_(bounding_ball(solid)) {
  for (const Blob& blob : solid.blobs) balls_.push_back(bounding_ball(blob));
}

std::optional<double> Caster::hit(const Ray& ray) const {
  const double middle = (ball_.centre - ray.origin).dot(ray.direction);
  const double square = ball_.radius * ball_.radius - (ray.at(middle) - ball_.centre).squaredNorm();
  if (square <= 0) return std::nullopt;
  // Blobs that the ray passes at more than the blend leave the surface on it as it is.
  struct Passed {
    double from, to;
    const Blob* blob;
  };
  thread_local std::vector<Passed> passed;
  thread_local std::vector<const Blob*> near;
  passed.clear();
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    const Vec3 aside = balls_[i].centre - ray.origin;
    const double along = aside.dot(ray.direction), reach = balls_[i].radius + solid_.blend;
    const double chord = reach * reach - (aside - along * ray.direction).squaredNorm();
    if (chord <= 0) continue;
    const double half = std::sqrt(chord);
    passed.push_back({along - half, along + half, &solid_.blobs[i]});
  }
  std::sort(passed.begin(), passed.end(),
            [](const Passed& a, const Passed& b) { return a.from < b.from; });
  const double close = 2e-5 * ball_.radius;
  // Through the stretches in which the same blobs are near.
  for (std::size_t next = 0; next < passed.size();) {
    double t = passed[next].from;
    while (true) {
      while (next < passed.size() && passed[next].from <= t) ++next;
      near.clear();
      double end = next < passed.size() ? passed[next].from : kInfinity;
      for (std::size_t i = 0; i < next; ++i)
        if (passed[i].to > t) {
          near.push_back(passed[i].blob);
          end = std::min(end, passed[i].to);
        }
      if (near.empty()) break;
      // Steps shorter than the distance: it is only of first order near ellipsoids and blends.
      while (t < end) {
        const double d = blended(near, solid_.blend, ray.at(t));
        if (d < close) return t;
        t += std::max(0.7 * d, close);
      }
      t = end;
    }
  }
  return std::nullopt;
}

Mesh mesh_of(const Solid& solid, double cell) {
  return polygonise([&](const Vec3& p) { return distance(solid, p); }, bounds(solid), cell);
}

}  // namespace artisketch::figures
