#include "model/surface/held_back.h"

#include <algorithm>
#include <cmath>

namespace artisketch {
namespace {

// Radii: where nothing bulges out by more the hull leaves no crease to be seen; where something
// does, all is held that bulges out by so much.
constexpr double kCrease = 0.03, kHeld = 0.01;
constexpr double kApart = 0.1;          // radii, between two of the points, or more
constexpr std::size_t kMostHeld = 100;  // points: the equations are dense

struct Bulging {
  float depth;  // inside the surface; negative
  Index3 at;
};

// The surface's point nearest to one of the inner samples.
Vec3 on_surface(const Grid3<float>& g, const Index3& at) {
  const int i = at.x(), j = at.y(), k = at.z();
  const Vec3 slope(g(i + 1, j, k) - g(i - 1, j, k), g(i, j + 1, k) - g(i, j - 1, k),
                   g(i, j, k + 1) - g(i, j, k - 1));
  return g.position(i, j, k) - g(i, j, k) * slope.normalized();  // slope 0: the sample itself
}

// The samples just outside the hull that lie inside the surface by more than `least`.
std::vector<Bulging> bulging_out(const Grid3<float>& surface, const Grid3<float>& hull,
                                 double least) {
  std::vector<Bulging> out;
  for (int k = 1; k + 1 < hull.size.z(); ++k)
    for (int j = 1; j + 1 < hull.size.y(); ++j)
      for (int i = 1; i + 1 < hull.size.x(); ++i)
        if (const float h = hull(i, j, k); h >= 0 && h < hull.cell && surface(i, j, k) < -least)
          out.push_back({surface(i, j, k), {i, j, k}});
  return out;
}

}  // namespace

std::vector<Vec3> held_back(const Grid3<float>& surface, const Grid3<float>& hull, double radius) {
  std::vector<Bulging> bulging = bulging_out(surface, hull, kHeld * radius);
  std::stable_sort(bulging.begin(), bulging.end(),
                   [](const Bulging& a, const Bulging& b) { return a.depth < b.depth; });
  if (bulging.empty() || bulging[0].depth > -kCrease * radius) return {};
  // All that bulges out has its share of the points.
  const double area = double(bulging.size()) * hull.cell * hull.cell;
  const double apart = std::max(kApart * radius, std::sqrt(area / double(kMostHeld)));
  std::vector<Vec3> points;
  for (const Bulging& one : bulging) {
    if (points.size() == kMostHeld) break;
    const Vec3 position = on_surface(hull, one.at);
    const auto near = [&](const Vec3& other) { return (other - position).norm() < apart; };
    if (std::any_of(points.begin(), points.end(), near)) continue;
    points.push_back(position);
  }
  return points;
}

}  // namespace artisketch
