// Heat-diffusion weights (Baran and Popović 2007, section 5): (−Δ + H) w = H p on the surface.
//
// We differ in two things that the drawn parts tell. p, the bone that a vertex listens to first, is
// the part on whose surface the vertex lies; where several parts' surfaces run together they share
// it by the nearness of their bones. And H = c / r² takes the limb's radius r at the vertex, not
// the distance to the bone: a bone may lie anywhere in its limb, or end in the middle of it.
#include <algorithm>
#include <cmath>

#include "base/at_once.h"
#include "model/consolidate/body.h"
#include "model/rig/heat.h"

namespace artisketch {
namespace {

// c in H = c / r²: nine tenths of the change from one bone to the next take place over about one
// radius. Pinocchio has 1: three radii, over which posed limbs lose their silhouettes.
constexpr double kHeat = 7;
// A vertex listens to all parts whose surfaces and bones lie hardly further off than the nearest
// one's, in shares of the limb's radius: the step from one part to the next must not fall between
// two neighbouring vertices, or else a bend tears teeth along it.
constexpr double kTogether = 0.5;      // of surfaces
constexpr double kAcross = 0.5;        // of bones
constexpr double kGrowth = 0.5;        // of a limb's radius, per way along the surface
constexpr double kLeastWeight = 1e-3;  // less is left out

// Half the shortest way across limbs from a point on their surface.
struct Radii {
  double own = BlockGrid::kOutside, all = BlockGrid::kOutside;  // across the first alone, or any
};

// The ways go straight inward and about that (the shape diameter of Shapira et al. 2008). Samples
// far inside a part say that they are, and not how deep: their distance only tells how far one can
// go without leaving it.
Radii limb_radii(const Body& body, std::span<const int> limbs, double thickness, const Vec3& p,
                 const Vec3& inward) {
  constexpr double kTilt = 0.6;        // tangent of the cone's half angle
  constexpr int kMostSteps = 400;      // where a vertex has no normal
  const double least = thickness / 8;  // a cell or so
  const Vec3 across = inward.unitOrthogonal(), up = inward.cross(across);
  Radii radii;
  for (const Vec3& tilt : {Vec3(Vec3::Zero()), across, Vec3(-across), up, Vec3(-up)}) {
    const Vec3 way = (inward + kTilt * tilt).normalized();
    double gone = least;               // p may lie a little outside
    double own = BlockGrid::kOutside;  // gone where the way left the first limb
    for (int step = 0; step < kMostSteps && gone < 2 * radii.all; ++step) {
      const Vec3 here = p + gone * way;
      double deep = 0;  // in the first limb that holds it
      for (std::size_t i = 0; i < limbs.size() && deep <= 0; ++i) {
        deep = -body.part_distance(limbs[i], here);
        if (i == 0 && deep <= 0) own = std::min(own, gone);
      }
      if (deep <= 0) break;
      gone += std::max(deep, least);
    }
    radii.own = std::min(radii.own, std::min(own, gone) / 2);
    radii.all = std::min(radii.all, gone / 2);
  }
  return radii;
}

struct Listening {
  std::vector<std::pair<int, double>> parts;  // to which it listens, in shares of 1
  double radius = 0;                          // of its limb
};

Listening listening(const Body& body, const PartTree& tree, const Vec3& p, const Vec3& normal) {
  Listening result;
  int nearest = -1;
  double least = 0;
  std::vector<double> distance(body.size(), BlockGrid::kOutside);
  for (int i = 0; i < body.size(); ++i) {
    if (!tree.nodes[i].solid) continue;
    distance[i] = body.part_distance(i, p);
    if (nearest < 0 || distance[i] < least) nearest = i, least = distance[i];
  }
  // Its own limb says who shares it, all that runs together there over how long a way that changes:
  // where a part ends within its neighbour, it is thin by itself.
  std::vector<int> limbs = {nearest};
  for (int i = 0; i < body.size(); ++i)
    if (i != nearest && tree.nodes[i].solid && tree.adjacent(i, nearest)) limbs.push_back(i);
  const auto [radius, of_all] = limb_radii(body, limbs, tree.nodes[nearest].thickness, p, -normal);
  result.radius = of_all;
  // Shares fall to nothing as a part's surface comes to lie kTogether further off than the nearest,
  // and as its bones come to lie kAcross further off.
  double to_bone = BlockGrid::kOutside;
  std::vector<std::pair<int, double>> near;  // parts, distances from their bones
  for (int i = 0; i < body.size(); ++i) {
    if (i != nearest && !tree.adjacent(i, nearest)) continue;
    if (distance[i] >= std::max(least, 0.0) + kTogether * radius) continue;
    double d = BlockGrid::kOutside;
    for (const Segment& axis : tree.nodes[i].axes) d = std::min(d, axis.distance(p));
    near.emplace_back(i, d);
    to_bone = std::min(to_bone, d);
  }
  double sum = 0;
  for (const auto& [i, d] : near) {
    const double surface = std::max(0.0, distance[i] - std::max(least, 0.0)) / (kTogether * radius);
    const double bone = (d - to_bone) / (kAcross * radius);
    const double share = (1 - surface) * std::max(0.0, 1 - bone);
    if (share <= 0) continue;
    result.parts.emplace_back(i, share);
    sum += share;
  }
  for (auto& [i, share] : result.parts) share /= sum;
  return result;
}

// A limb blends into what it hangs on over its own radius, on either side: no vertex has a larger
// radius than a thinner place's, and the way there along the edges.
void limit_growth(const Mesh& mesh, Eigen::VectorXd& radius) {
  constexpr int kSweeps = 24;
  bool changed = true;
  for (int sweep = 0; sweep < kSweeps && changed; ++sweep) {
    changed = false;
    for (Eigen::Index i = 0; i < mesh.F.rows(); ++i) {
      const Eigen::Index f = sweep % 2 ? mesh.F.rows() - 1 - i : i;
      for (int c = 0; c < 3; ++c) {
        const int a = mesh.F(f, c), b = mesh.F(f, (c + 1) % 3);
        const double way = kGrowth * (mesh.V.row(a) - mesh.V.row(b)).norm();
        for (const auto& [low, high] : {std::pair(a, b), std::pair(b, a)})
          if (radius[high] > radius[low] + way) {
            radius[high] = radius[low] + way;
            changed = true;
          }
      }
    }
  }
}

// The four largest of a vertex's weights, as shares of 1.
void keep_four(const Eigen::VectorXd& of_part, std::span<const PartSurface> parts, int v,
               Weights& weights) {
  std::array<std::pair<double, int>, 4> best{};  // weight, −part
  for (int i = 0; i < int(parts.size()); ++i) {
    std::pair<double, int> next{of_part[i], -i};
    if (next.first < kLeastWeight) continue;
    for (auto& slot : best)
      if (next > slot) std::swap(next, slot);
  }
  double sum = 0;
  for (const auto& [w, part] : best) sum += w;
  double others = 0;
  for (int k = 3; k >= 0; --k) {
    const auto& [w, part] = best[k];
    weights.joints(v, k) = w > 0 ? parts[-part].joint : 0;
    weights.weights(v, k) = k > 0 ? w / sum : 1 - others;
    others += w / sum;
  }
}

}  // namespace

Result<HeatSystem> heat_system(const Document& document, std::span<const PartSurface> parts,
                               const Mesh& mesh, Run& run) {
  const PartTree tree = part_tree(document, parts);
  const int count = int(parts.size()), n = int(mesh.V.rows());
  if (std::none_of(tree.nodes.begin(), tree.nodes.end(), [](const auto& p) { return p.solid; }))
    return bad_input("no part has a body: draw a closed contour for at least one joint");
  const Body body(parts, tree, {}, 0);
  const Points3 normals = vertex_normals(mesh);
  const Eigen::VectorXd areas = lumped_areas(mesh);
  HeatSystem system;
  system.right = Columns::Zero(n, count);
  Eigen::VectorXd radius(n);
  constexpr int kAtOnce = 256;  // vertices
  at_once((n + kAtOnce - 1) / kAtOnce, run.threads, [&](int block) {
    for (int v = block * kAtOnce; v < std::min(n, (block + 1) * kAtOnce); ++v) {
      if (run.cancelled()) return;
      const Listening l =
          listening(body, tree, mesh.V.row(v).transpose(), normals.row(v).transpose());
      radius[v] = l.radius;
      for (const auto& [part, share] : l.parts) system.right(v, part) = share;
    }
  });
  if (run.cancelled()) return cancelled();
  limit_growth(mesh, radius);
  system.heat = kHeat * areas.cwiseQuotient(radius.cwiseAbs2());
  system.right = system.heat.asDiagonal() * system.right;
  system.A = -cotangent_laplacian(mesh);
  system.A += SparseMatrix(system.heat.asDiagonal());
  return system;
}

Result<Weights> skin(const Document& document, std::span<const PartSurface> parts, const Mesh& mesh,
                     Run& run) {
  const Result<HeatSystem> system = heat_system(document, parts, mesh, run);
  if (!system) return system.error();
  run.report(0.3);
  const Factors factors(system->A);
  if (factors.info() != Eigen::Success)
    return bad_input("the surface is too degenerate to carry weights");
  if (run.cancelled()) return cancelled();
  run.report(0.8);
  const Columns solved = solve(factors, system->right);
  run.report(1);
  const int n = int(mesh.V.rows());
  Weights weights;
  weights.joints.resize(n, 4);
  weights.weights.resize(n, 4);
  for (int v = 0; v < n; ++v) {
    Eigen::VectorXd row = solved.row(v).transpose().cwiseMax(0);
    // A vertex that no heat reaches (none is known) listens to its own part alone.
    if (!(row.maxCoeff() > kLeastWeight)) row = system->right.row(v).transpose() / system->heat[v];
    keep_four(row, parts, v, weights);
  }
  return weights;
}

}  // namespace artisketch
