// The silhouette of a solid: the least distance of each pixel's ray from the solid is a smooth
// function of the pixel whose zero set is the outline; marching squares follow it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/golden_section.h"
#include "figures/solid.h"

namespace artisketch::figures {
namespace {

constexpr double kStep = 2;  // pixels between samples
constexpr int kBlock = 6;    // samples along a block that is skipped or sampled as a whole

struct Sight {
  Sight(const Solid& solid, const Transform& to_world, const FrameCamera& camera)
      : solid(solid), camera(camera), to_rest(to_world.inverse()), ball(bounding_ball(solid)) {
    for (const Blob& blob : solid.blobs) balls.push_back(bounding_ball(blob));
  }

  const Solid& solid;
  FrameCamera camera;
  Transform to_rest;
  Ball ball;                // in rest space
  std::vector<Ball> balls;  // around each blob

  Ray ray(const Vec2& pixel) const {
    const Ray r = camera.ray(pixel);
    return {to_rest * r.origin, to_rest.linear() * r.direction};
  }

  // Distance of the pixel's ray from the solid in units, negative where it passes through: exact
  // near the outline, else of the right sign and not too large.
  double miss(const Vec2& pixel) const {
    const Ray r = ray(pixel);
    const double middle = (ball.centre - r.origin).dot(r.direction);
    const double away = (r.at(middle) - ball.centre).norm();
    if (away >= ball.radius) return away - ball.radius + 1e-9;
    // Only blobs that the ray comes near to shape what it sees of the surface.
    thread_local std::vector<const Blob*> near;
    near.clear();
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < balls.size(); ++i) {
      const Vec3 aside = balls[i].centre - r.origin;
      const double clear = (aside - aside.dot(r.direction) * r.direction).norm() - balls[i].radius;
      if (clear < solid.blend + 0.02 * ball.radius)
        near.push_back(&solid.blobs[i]);
      else
        best = std::min(best, clear);
    }
    if (near.empty()) return best;
    const double half = std::sqrt(ball.radius * ball.radius - away * away);
    const auto f = [&](double t) { return blended(near, solid.blend, r.at(t)); };
    const double shortest = ball.radius / 30;
    constexpr int kSteps = 10;  // an error of 1 % in the place hardly shows in the value
    // The last three samples: a middle one below both others brackets a valley.
    double t0 = middle - half, f0 = f(t0), t1 = t0, f1 = f0;
    for (double t = t0; t < middle + half;) {
      t = std::min(t + std::max(0.7 * std::abs(f1), shortest), middle + half);
      const double now = f(t);
      if (f1 <= f0 && f1 <= now && f1 < best + shortest)
        best = std::min(best, golden_section(t0, t, kSteps, f).value);
      best = std::min(best, now);
      t0 = t1, f0 = f1, t1 = t, f1 = now;
    }
    return best;
  }
};

// Samples of Sight::miss on a lattice of pixels, exact near the outline, of the right sign
// elsewhere.
class Lattice {
 public:
  Lattice(const Sight& sight, const Box2& box, double step)
      : sight_(sight), origin_(box.min()), step_(step) {
    nx_ = (int(std::ceil(box.sizes().x() / step)) / kBlock + 1) * kBlock + 1;
    ny_ = (int(std::ceil(box.sizes().y() / step)) / kBlock + 1) * kBlock + 1;
    values_.assign(std::size_t(nx_) * ny_, std::numeric_limits<double>::quiet_NaN());
    // A ray a pixel further misses by at most one pixel's width at the far side more.
    const Vec3 centre = sight.to_rest.inverse() * sight.ball.centre;
    const double unit = 1 / sight.camera.pixels_per_unit(centre.z() - sight.ball.radius);
    const double reach = 2 * unit * step * kBlock * std::sqrt(0.5);
    std::vector<std::pair<int, double>> skipped;
    for (int y = 0; y + 1 < ny_; y += kBlock)
      for (int x = 0; x + 1 < nx_; x += kBlock) {
        const double middle = sight.miss(position(x + kBlock / 2.0, y + kBlock / 2.0));
        if (std::abs(middle) > reach)
          skipped.emplace_back(index(x, y), middle);
        else
          for (int j = y; j <= y + kBlock; ++j)
            for (int i = x; i <= x + kBlock; ++i) sample(i, j);
      }
    for (const auto& [corner, value] : skipped)
      for (int j = 0; j <= kBlock; ++j)
        for (int i = 0; i <= kBlock; ++i)
          if (double& v = values_[corner + i + j * nx_]; std::isnan(v)) v = value;
  }

  std::vector<Polyline> lines() {
    std::map<int, int> next;  // crossed edge → the crossed edge after it, inside on the left
    for (int y = 0; y + 1 < ny_; ++y)
      for (int x = 0; x + 1 < nx_; ++x) link(x, y, next);
    std::vector<Polyline> found;
    while (!next.empty()) {
      Polyline line;
      int at = next.begin()->first;
      for (auto here = next.find(at); here != next.end(); here = next.find(at)) {
        line.points.push_back(crossing(at));
        at = here->second;
        next.erase(here);
      }
      found.push_back(std::move(line));
    }
    return found;
  }

 private:
  int index(int x, int y) const { return x + y * nx_; }
  Vec2 position(double x, double y) const { return origin_ + step_ * Vec2(x, y); }
  bool in(int x, int y) const { return values_[index(x, y)] < 0; }
  void sample(int x, int y) {
    if (double& v = values_[index(x, y)]; std::isnan(v)) v = sight_.miss(position(x, y));
  }
  // Edges: 2 · sample along +x, and one more along +y.
  int edge(int x, int y, bool upright) const { return 2 * index(x, y) + upright; }

  void link(int x, int y, std::map<int, int>& next) const {
    const bool a = in(x, y), b = in(x + 1, y), c = in(x + 1, y + 1), d = in(x, y + 1);
    if (a == b && b == c && c == d) return;
    // Round the cell: top, right, bottom, left. Where the sign turns from in to out a line leaves
    // the cell, where it turns from out to in one enters.
    const int edges[4] = {edge(x, y, false), edge(x + 1, y, true), edge(x, y + 1, false),
                          edge(x, y, true)};
    const bool corners[5] = {a, b, c, d, a};
    int enter[2], leave[2], entries = 0, exits = 0;
    for (int k = 0; k < 4; ++k) {
      if (!corners[k] && corners[k + 1]) enter[entries++] = k;
      if (corners[k] && !corners[k + 1]) leave[exits++] = k;
    }
    if (entries == 1) {
      next[edges[enter[0]]] = edges[leave[0]];
      return;
    }
    // Two opposite corners in: the middle says whether they join.
    const bool joined = sight_.miss(position(x + 0.5, y + 0.5)) < 0;
    for (const int e : enter) {
      const int after = (e + 1) % 4, before = (e + 3) % 4;
      next[edges[e]] = edges[joined ? before : after];
    }
  }

  Vec2 crossing(int edge) const {
    const int s = edge / 2, x = s % nx_, y = s / nx_;
    const Vec2 from = position(x, y), to = edge % 2 ? position(x, y + 1) : position(x + 1, y);
    double a = 0, b = 1, fa = values_[s], fb = values_[s + (edge % 2 ? nx_ : 1)];
    double t = fa / (fa - fb);
    for (int i = 0; i < 2; ++i) {  // false position
      const double f = sight_.miss(from + t * (to - from));
      if ((f < 0) == (fa < 0)) {
        a = t, fa = f;
      } else {
        b = t, fb = f;
      }
      if (fa == fb) break;
      t = a + (b - a) * fa / (fa - fb);
    }
    return from + t * (to - from);
  }

  const Sight& sight_;
  Vec2 origin_;
  double step_;
  int nx_ = 0, ny_ = 0;
  std::vector<double> values_;
};

}  // namespace

std::vector<Polyline> outline(const Solid& solid, const Transform& to_world,
                              const FrameCamera& camera) {
  if (solid.empty()) return {};
  const Sight sight(solid, to_world, camera);
  // The ball's silhouette lies inside the projected corners of a cube around it.
  const Vec3 centre = to_world * sight.ball.centre;
  Box2 box;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    box.extend(camera.project(centre + sight.ball.radius * sign));
  }
  const Vec2 margin = Vec2::Constant(2 * kStep);
  return Lattice(sight, Box2(Vec2(box.min() - margin), Vec2(box.max() + margin)), kStep).lines();
}

}  // namespace artisketch::figures
