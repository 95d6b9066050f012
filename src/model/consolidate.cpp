// One skin from all parts (the paper's section 5): union, closed gaps, one surface, blended.
//
// We differ from the paper in what the spheres do: it unites them with the parts and then fairs all
// vertices inside. A ball of 60 % of a limb's diameter stands out of the limb by a fifth of its
// radius, so we only close inside it what a smaller ball can't enter, and fair the creases there.
#include <algorithm>
#include <cmath>

#include "base/well_composed.h"
#include "model/close_gaps.h"
#include "model/fair.h"

namespace artisketch {
namespace {

constexpr double kCellsAcrossThinnest = 6;
constexpr double kWantedVertices = 25000;  // of the lattice's surface, where no part is thinner
constexpr double kMostVertices = 120000;

// The lattice's step: fine enough for the thinnest part, and for a surface that looks smooth.
double cell_size(const PartTree& tree) {
  double area = 0, thinnest = BlockGrid::kOutside;
  for (const PartTree::Node& node : tree.nodes) {
    if (!node.solid) continue;
    area += node.area;
    thinnest = std::min(thinnest, node.thickness);
  }
  // A lattice surface has about 1.5 vertices per cell² of area.
  const auto cell_for = [&](double vertices) { return std::sqrt(1.5 * area / vertices); };
  return std::max(std::min(cell_for(kWantedVertices), thinnest / kCellsAcrossThinnest),
                  cell_for(kMostVertices));
}

// The pieces of a closed surface.
struct Pieces {
  std::vector<int> of;  // per vertex
  std::vector<double> volume;
  std::vector<int> vertices, quads;
  int largest = 0;
  int genus(int piece) const { return 1 - (vertices[piece] - quads[piece]) / 2; }
};

Pieces pieces(const QuadMesh& mesh) {
  Pieces p;
  int count = 0;
  Mesh triangles{mesh.V, Triangles(mesh.Q.rows(), 3)};
  triangles.F = mesh.Q.leftCols(3);
  // Every vertex of a quad hangs on its first three through other quads: three corners suffice
  // only where each vertex is one of them somewhere, so join the fourth here.
  Triangles F(2 * mesh.Q.rows(), 3);
  for (Eigen::Index q = 0; q < mesh.Q.rows(); ++q) {
    F.row(2 * q) << mesh.Q(q, 0), mesh.Q(q, 1), mesh.Q(q, 2);
    F.row(2 * q + 1) << mesh.Q(q, 0), mesh.Q(q, 2), mesh.Q(q, 3);
  }
  triangles.F = F;
  p.of = vertex_components(triangles, &count);
  p.volume.assign(count, 0);
  p.vertices.assign(count, 0);
  p.quads.assign(count, 0);
  for (const int c : p.of) ++p.vertices[c];
  for (Eigen::Index f = 0; f < F.rows(); ++f) {
    const Vec3 a = mesh.V.row(F(f, 0)), b = mesh.V.row(F(f, 1)), c = mesh.V.row(F(f, 2));
    p.volume[p.of[F(f, 0)]] += a.dot(b.cross(c)) / 6;
  }
  for (Eigen::Index q = 0; q < mesh.Q.rows(); ++q) ++p.quads[p.of[mesh.Q(q, 0)]];
  for (int c = 0; c < count; ++c)
    if (p.volume[c] > p.volume[p.largest]) p.largest = c;
  return p;
}

QuadMesh only(const QuadMesh& mesh, const Pieces& p, int piece) {
  QuadMesh kept{Points3(p.vertices[piece], 3), Quads(p.quads[piece], 4)};
  std::vector<int> index(mesh.V.rows(), -1);
  int v = 0, q = 0;
  for (Eigen::Index i = 0; i < mesh.V.rows(); ++i) {
    if (p.of[i] != piece) continue;
    kept.V.row(v) = mesh.V.row(i);
    index[i] = v++;
  }
  for (Eigen::Index i = 0; i < mesh.Q.rows(); ++i) {
    if (p.of[mesh.Q(i, 0)] != piece) continue;
    for (int c = 0; c < 4; ++c) kept.Q(q, c) = index[mesh.Q(i, c)];
    ++q;
  }
  return kept;
}

}  // namespace

Result<Mesh> consolidate(const Document& document, std::span<const PartSurface> parts,
                         const ConsolidateOptions& options, std::vector<std::string>& warnings,
                         Run& run) {
  const PartTree tree = part_tree(document, parts);
  if (std::none_of(tree.nodes.begin(), tree.nodes.end(), [](const auto& n) { return n.solid; }))
    return bad_input("no part has a body: draw a closed contour for at least one joint");
  const std::vector<JointSphere> spheres = joint_spheres(document, parts, tree);
  const double cell = cell_size(tree);
  const double reach = 3 * cell;
  Body body(parts, tree, spheres, 2 * cell);
  Result<Body::Sampled> sampled = body.sample(cell, reach + cell, run);
  if (!sampled) return sampled.error();
  run.report(0.3);
  if (options.blend)
    close_gaps(sampled->grid, sampled->seam, reach, spheres);
  else
    make_well_composed(sampled->grid);
  QuadMesh mesh = dual_surface(sampled->grid);
  const Pieces found = pieces(mesh);
  mesh = only(mesh, found, found.largest);
  run.report(0.5);
  const Settled settled = settle(body, *sampled, mesh);
  if (run.cancelled()) return cancelled();
  run.report(0.7);
  if (options.blend) fair(body, *sampled, spheres, tree, settled, mesh);
  run.report(1);
  (void)warnings;
  return Mesh{mesh.V, split_quads(mesh.V, mesh.Q)};
}

}  // namespace artisketch
