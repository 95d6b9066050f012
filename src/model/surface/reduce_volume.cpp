// Section 4, eq. 1: the surface that bends least between its rims, Δ²x = 0. Where we add to it:
//
// - A rim vertex is anchored where its contour's cone is nearest, not where the level set left it:
//   within a cell, but that cell is what one sees.
// - What bends out over a contour between the rims, as over a notch, becomes a soft anchor on that
//   contour in a second round.
//
// Hard anchors, as in the paper, are the default: two circles give a sphere of 1.01 times its
// volume (soft ones: 1.00), the silhouettes of real parts are nearer by a third of what soft ones
// miss, and with the rims out of the way the matrix falls apart into pieces that factor twice as
// fast.
#include <cmath>

#include "model/stages.h"
#include "model/surface/bending.h"

namespace artisketch {
namespace {

// All in mean edges of the mesh, so that the numbers mean the same for every part.
constexpr double kFarFromContour = 2.5;  // a rim vertex this far off its contour anchors nothing
constexpr int kRounds = 2;               // of solving
constexpr int kTurns = 6;                // among the views, to find a place that suits all
constexpr double kSoftWeight = 1;        // of a soft anchor against bending
// Ties every vertex to its place ever so weakly: a piece without anchors, or with too few, then
// stays where it is instead of making the matrix singular.
constexpr double kTie = 1e-8;
constexpr double kStrongTie = 1e-3;  // where rounding makes it singular all the same

double mean_edge(const Mesh& mesh) {
  double sum = 0;
  for (int f = 0; f < mesh.F.rows(); ++f)
    for (int c = 0; c < 3; ++c)
      sum += (mesh.V.row(mesh.F(f, c)) - mesh.V.row(mesh.F(f, (c + 1) % 3))).norm();
  return sum / double(std::max<Eigen::Index>(3 * mesh.F.rows(), 1));
}

struct Anchors {
  std::vector<int> vertices;  // ascending
  std::vector<Vec3> places;
};

const PartView* view_of(const Part& part, int frame) {
  for (const PartView& view : part.views)
    if (view.frame == frame && view.seen() && !view.mirrored) return &view;
  return nullptr;
}

// Signed distance in units across the view's ray from p to the contour, and the move that ends it.
double to_contour(const PartView& view, const Vec3& p, Vec3& move) {
  move.setZero();
  const Vec3 X = view.to_world * p;
  if (!view.camera.in_front(X)) return 0;
  Vec2 away;
  const double scale = view.camera.pixels_per_unit(X.z());
  const double distance = view.outline.distance(view.camera.project(X), away) / scale;
  const Vec3 in_world = view.camera.jacobian(X).transpose() * (away * (distance / scale));
  move = -(view.to_world.linear().transpose() * in_world);
  return distance;
}

// A place near p that lies on the contours of `own` and outside none, by turns. Where it can't do
// both, at p's depths, it lies outside none.
Vec3 settled(const Part& part, std::span<const PartView* const> own, Vec3 p) {
  for (int round = 0; round < kTurns; ++round)
    for (const PartView& view : part.views) {
      if (!view.seen() || view.mirrored) continue;
      Vec3 move;
      const double distance = to_contour(view, p, move);
      const bool onto = round < kTurns / 2 && std::find(own.begin(), own.end(), &view) != own.end();
      if (distance > 0 || onto) p += move;
    }
  return p;
}

// Rim vertices stand within a cell or two of their contours: what anchors them is the contour
// itself.
Anchors anchors_of(const Part& part, const Mesh& mesh, std::span<const Rim> rims, double edge) {
  std::vector<std::vector<const PartView*>> views(mesh.V.rows());
  for (const Rim& rim : rims)
    if (const PartView* view = view_of(part, rim.frame))
      for (const int v : rim.vertices)
        if (std::find(views[v].begin(), views[v].end(), view) == views[v].end())
          views[v].push_back(view);
  Anchors anchors;
  for (int v = 0; v < int(views.size()); ++v) {
    const Vec3 p = mesh.V.row(v).transpose();
    Vec3 unused;
    std::erase_if(views[v], [&](const PartView* view) {
      return std::abs(to_contour(*view, p, unused)) > kFarFromContour * edge;
    });
    if (views[v].empty()) continue;
    anchors.vertices.push_back(v);
    anchors.places.push_back(settled(part, views[v], p));
  }
  return anchors;
}

// The vertices that lie outside some view's silhouette, and where they should be.
Anchors strays_of(const Part& part, const Points3& V) {
  Anchors strays;
  for (int v = 0; v < V.rows(); ++v) {
    const Vec3 p = V.row(v).transpose();
    const Vec3 inside = settled(part, {}, p);
    if (inside == p) continue;
    strays.vertices.push_back(v);
    strays.places.push_back(inside);
  }
  return strays;
}

// Returns false where the matrix can't be factored.
bool minimise(const SparseMatrix& K, const Eigen::VectorXd& weights, const Points3& targets,
              Points3& x) {
  const BendingSystem system = bending_system(K, weights, targets);
  x = targets;
  if (system.right.rows() == 0) return true;
  const Factors factors(system.A);
  if (factors.info() != Eigen::Success) return false;
  const Columns solution = solve(factors, system.right);
  if (!solution.allFinite()) return false;
  for (Eigen::Index v = 0; v < x.rows(); ++v)
    if (system.unknown[v] >= 0) x.row(v) = solution.row(system.unknown[v]);
  return true;
}

}  // namespace

BendingSystem bending_system(const SparseMatrix& K, const Eigen::VectorXd& weights,
                             const Points3& targets) {
  const int n = int(K.rows());
  BendingSystem system;
  std::vector<int>& unknown = system.unknown;
  unknown.assign(n, -1);
  int unknowns = 0;
  for (int v = 0; v < n; ++v)
    if (std::isfinite(weights[v])) unknown[v] = unknowns++;
  Columns& b = system.right;
  b.resize(unknowns, 3);
  for (int v = 0; v < n; ++v)
    if (unknown[v] >= 0) b.row(unknown[v]) = weights[v] * targets.row(v);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(K.nonZeros() / 2 + n);
  for (int column = 0; column < n; ++column)
    for (SparseMatrix::InnerIterator it(K, column); it; ++it) {
      const int i = unknown[it.row()], j = unknown[column];
      if (i < 0) continue;
      if (j < 0)
        b.row(i) -= it.value() * targets.row(column);
      else if (i >= j)
        entries.emplace_back(i, j, it.value() + (i == j ? weights[column] : 0));
    }
  system.A.resize(unknowns, unknowns);
  system.A.setFromTriplets(entries.begin(), entries.end());
  return system;
}

SparseMatrix bi_laplacian(const Mesh& mesh) {
  const SparseMatrix L = cotangent_laplacian(mesh);
  return L * SparseMatrix(lumped_areas(mesh).cwiseInverse().asDiagonal() * L);
}

Result<Mesh> reduce_volume(const Part& part, const Mesh& mesh, std::span<const Rim> rims,
                           const ReduceOptions& options, Run& run) {
  const double edge = mean_edge(mesh);
  if (!(edge > 0)) return mesh;
  const Anchors anchors = anchors_of(part, mesh, rims, edge);
  if (anchors.vertices.empty()) return mesh;  // nothing would hold it open
  if (run.cancelled()) return cancelled();

  Mesh scaled = mesh;
  const Vec3 centre = bounds(mesh.V).center();
  scaled.V = (mesh.V.rowwise() - centre.transpose()) / edge;
  const SparseMatrix K = bi_laplacian(scaled);
  const double infinity = std::numeric_limits<double>::infinity();
  Eigen::VectorXd weights = Eigen::VectorXd::Constant(mesh.V.rows(), kTie);
  Points3 targets = scaled.V;
  const auto anchor = [&](const Anchors& anchors, double weight) {
    for (std::size_t a = 0; a < anchors.vertices.size(); ++a) {
      const int v = anchors.vertices[a];
      if (weights[v] >= weight) continue;
      weights[v] = weight;
      targets.row(v) = ((anchors.places[a] - centre) / edge).transpose();
    }
  };
  anchor(anchors, options.soft_anchors ? kSoftWeight : infinity);
  Mesh reduced = mesh;
  for (int round = 0; round < kRounds; ++round) {
    if (run.cancelled()) return cancelled();
    Points3 x;
    if (!minimise(K, weights, targets, x)) {
      // Better stiff, or unreduced, than not at all.
      weights = weights.cwiseMax(kStrongTie);
      if (!minimise(K, weights, targets, x)) return reduced;
    }
    reduced.V = (x * edge).rowwise() + centre.transpose();
    if (round + 1 < kRounds) anchor(strays_of(part, reduced.V), kSoftWeight);
    run.report((round + 1.0) / kRounds);
  }
  return reduced;
}

}  // namespace artisketch
