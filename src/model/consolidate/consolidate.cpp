// One skin from all parts (the paper's section 5): union, closed gaps, one surface, blended.
//
// The paper unites the spheres with the parts and then fairs all vertices inside:
// SphereUse::united. A ball of 60 % of a limb's diameter stands out of the limb by a fifth of its
// radius, so we only close inside it what a smaller ball can't enter, and fair the creases there. A
// sphere that the artist made otherwise is meant to be seen: of it we unite what is as thick as the
// limb was.
#include <algorithm>
#include <cmath>

#include "base/self_intersection.h"
#include "base/trigonometry.h"
#include "base/well_composed.h"
#include "base/words.h"
#include "model/consolidate/bridge_parts.h"
#include "model/consolidate/close_gaps.h"
#include "model/consolidate/consolidated.h"
#include "model/consolidate/fair.h"
#include "model/consolidate/resolve_self_intersections.h"
#include "model/consolidate/unfold.h"

namespace artisketch {
namespace {

constexpr double kCellsAcrossThinnest = 6;
constexpr int kSmoothVertices = 40000;  // of the lattice's surface, where no part is thinner
constexpr double kMostTimes = 3;        // as many vertices, where parts are thin
constexpr double kMostSamples = 1e9;    // of the lattice, stored or not
constexpr double kMostStored = 2e7;     // 160 MB
constexpr double kMostAlongSide = 1e4;

// Between non-adjacent parts, in cells: the lattice needs the first to keep them apart; once it
// has, their surfaces may come as near as the second.
constexpr double kLatticeGap = 2, kFinalGap = 0.5;

// The balls that are united with the parts. None reaches farther than the figure itself: a sphere
// may be of any size.
std::vector<Capsule> balls_of(const Document& document, std::span<const PartSurface> parts,
                              const PartTree& tree, std::span<const JointSphere> spheres,
                              SphereUse use) {
  constexpr double kLimb = 1 / 1.2;  // a sphere has 60 % of the limb's diameter for a radius
  Box3 all;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (tree.nodes[i].solid) all.extend(parts[i].distance.box());
  std::vector<Capsule> balls;
  for (const JointSphere& sphere : spheres) {
    const bool is_united = use == SphereUse::united;
    if (!is_united && !document.spheres.contains(sphere.joint)) continue;
    const Vec3 centre = sphere.centre.cwiseMax(all.min()).cwiseMin(all.max());
    const double radius = (is_united ? 1 : kLimb) * sphere.radius;
    balls.push_back({{centre, centre}, std::min(radius, all.sizes().maxCoeff() / 2)});
  }
  return balls;
}

// The lattice's step: fine enough for the thinnest part, and for a surface of so many vertices.
double cell_size(const PartTree& tree, std::span<const PartSurface> parts,
                 std::span<const Capsule> balls, int triangles, double vertices) {
  double area = 0, stored = 0, thinnest = BlockGrid::kOutside;
  Box3 all;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!tree.nodes[i].solid) continue;
    area += tree.nodes[i].area;
    thinnest = std::min(thinnest, tree.nodes[i].width);
    stored += parts[i].distance.box().volume();
    all.extend(parts[i].distance.box());
  }
  double of_balls = 0;
  for (const Capsule& ball : balls) {
    of_balls += 4 * kPi * ball.radius * ball.radius;
    stored += ball.box().volume();
    all.extend(ball.box());
  }
  area = std::max(area, of_balls);  // most lie in the parts, large ones around them
  // A lattice surface has about 1.5 vertices per cell² of area.
  const auto cell_for = [&](double vertices) { return std::sqrt(1.5 * area / vertices); };
  // Two triangles a vertex; parts hide some of their area in each other.
  constexpr double kHidden = 1.7;
  const double asked = kHidden * triangles / 2;
  const double wanted =
      std::max(std::min(cell_for(std::max(vertices, asked)), thinnest / kCellsAcrossThinnest),
               cell_for(std::max(kMostTimes * vertices, asked)));
  // Small parts far apart, thin ones across the grain: memory has its limits.
  const Vec3 sides = all.sizes();
  return std::max({wanted, std::cbrt(stored / kMostStored), std::cbrt(sides.prod() / kMostSamples),
                   sides.maxCoeff() / kMostAlongSide});
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
  // Any two triangles of a quad will do.
  Triangles F(2 * mesh.Q.rows(), 3);
  for (Eigen::Index q = 0; q < mesh.Q.rows(); ++q) {
    F.row(2 * q) << mesh.Q(q, 0), mesh.Q(q, 1), mesh.Q(q, 2);
    F.row(2 * q + 1) << mesh.Q(q, 0), mesh.Q(q, 2), mesh.Q(q, 3);
  }
  p.of = vertex_components({mesh.V, F}, &count);
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

struct Surface {
  QuadMesh mesh;
  Pieces found;
  int genus() const { return found.genus(found.largest); }
};

Surface surface_of(const BlockGrid& grid) {
  Surface s;
  s.mesh = dual_surface(grid);
  s.found = pieces(s.mesh);
  return s;
}

// Holes that the parts have of their own: each is one closed surface, which has three edges to two
// triangles.
int own_genus(std::span<const PartSurface> parts) {
  int genus = 0;
  for (const PartSurface& part : parts)
    if (part.mesh.F.rows() > 0)
      genus += std::max(0, 1 - int(part.mesh.V.rows() - part.mesh.F.rows() / 2) / 2);
  return genus;
}

// The body with its gaps closed, and its handles: ever wider ones until none is left that no part
// has of its own.
constexpr double kGap = 2, kWidestHandle = 8;  // cells
Result<Surface> closed_surface(const Body& body, double cell, std::span<const JointSphere> spheres,
                               std::span<const PartSurface> parts, Body::Sampled& sampled,
                               Run& run) {
  const auto sample_for = [&](double reach) -> Result<Surface> {
    Result<Body::Sampled> found = body.sample(cell, (reach + 1) * cell, run);
    if (!found) return found.error();
    sampled = std::move(*found);
    make_well_composed(sampled.grid);
    sampled.close();
    close_gaps(sampled, body, kGap * cell, spheres);
    return surface_of(sampled.grid);
  };
  Result<Surface> best = sample_for(kGap);
  if (!best || best->genus() <= 0) return best;
  const int wanted = own_genus(parts);
  if (best->genus() <= wanted) return best;
  best = sample_for(kWidestHandle);
  for (double reach = 2 * kGap; best && reach <= kWidestHandle && best->genus() > wanted;
       reach *= 2) {
    close_gaps(sampled, body, reach * cell, {});
    best = surface_of(sampled.grid);
  }
  return best;
}

// Which piece each part lies on for the most part: −1 where it shows nowhere.
std::vector<int> pieces_of_parts(const Body& body, const PartTree& tree, const Surface& s) {
  std::vector<std::vector<int>> count(body.size(), std::vector<int>(s.found.volume.size(), 0));
  for (int v = 0; v < int(s.mesh.V.rows()); ++v) {
    if (s.found.volume[s.found.of[v]] <= 0) continue;
    int nearest = -1;
    double least = BlockGrid::kOutside;
    for (int i = 0; i < body.size(); ++i) {
      if (!tree.nodes[i].solid) continue;
      const double d = body.part_distance(i, s.mesh.V.row(v).transpose());
      if (d < least) least = d, nearest = i;
    }
    // Beside a camera in its midst a part has no distances that are numbers.
    if (nearest >= 0) ++count[nearest][s.found.of[v]];
  }
  std::vector<int> piece_of(body.size(), -1);
  for (int i = 0; i < body.size(); ++i) {
    const auto most = std::max_element(count[i].begin(), count[i].end());
    if (*most > 0) piece_of[i] = int(most - count[i].begin());
  }
  return piece_of;
}

// Parts far from each other in the skeleton whose surfaces run into each other all the same.
void name_the_fused(const Document& document, std::span<const PartSurface> parts,
                    const PartTree& tree, const QuadMesh& mesh, const SurfaceProjection& projection,
                    std::vector<std::string>& warnings) {
  std::vector<std::pair<int, int>> fused;
  for (Eigen::Index q = 0; q < mesh.Q.rows(); ++q)
    for (int c = 0; c < 4; ++c) {
      const int i = projection.owner[mesh.Q(q, c)], j = projection.owner[mesh.Q(q, (c + 1) % 4)];
      if (i < 0 || j <= i || tree.adjacent(i, j) || tree.adjacent(tree.step(i, j), j)) continue;
      if (std::find(fused.begin(), fused.end(), std::pair(i, j)) == fused.end())
        fused.emplace_back(i, j);
    }
  std::sort(fused.begin(), fused.end());
  for (const auto& [i, j] : fused)
    warnings.push_back("'" + document.skeleton.joints[parts[i].joint].name + "' and '" +
                       document.skeleton.joints[parts[j].joint].name +
                       "' touch in the rest pose and are fused there. Move them apart in the rest "
                       "pose, or draw them thinner where they touch");
}

// As self_intersections, among the faces near some vertices alone.
std::vector<std::pair<int, int>> self_intersections_near(const Mesh& mesh,
                                                         const std::vector<char>& vertices) {
  constexpr int kCells = 48;  // along the longest side: wider than any triangle
  const Box3 box = bounds(mesh.V);
  const double cell = box.sizes().maxCoeff() / kCells;
  const auto place = [&](int x, int y, int z) {
    return std::size_t(x) + (kCells + 3) * (y + (kCells + 3) * std::size_t(z));
  };
  const auto cell_of = [&](int v) {
    return Index3(((mesh.V.row(v).transpose() - box.min()) / cell).cast<int>().array() + 1);
  };
  std::vector<char> near(place(0, 0, kCells + 3), 0);
  for (int v = 0; v < int(vertices.size()); ++v) {
    if (!vertices[v]) continue;
    const Index3 at = cell_of(v);
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) near[place(at.x() + x, at.y() + y, at.z() + z)] = 1;
  }
  std::vector<char> in(vertices.size());
  for (int v = 0; v < int(vertices.size()); ++v) {
    const Index3 at = cell_of(v);
    in[v] = near[place(at.x(), at.y(), at.z())];
  }
  std::vector<int> faces;
  for (int f = 0; f < mesh.F.rows(); ++f)
    if (in[mesh.F(f, 0)] || in[mesh.F(f, 1)] || in[mesh.F(f, 2)]) faces.push_back(f);
  auto pairs = self_intersections({mesh.V, mesh.F(faces, Eigen::all)});
  for (auto& [f, g] : pairs) f = faces[f], g = faces[g];
  return pairs;
}

// Where moving the vertices folded the surface or made it pass through itself, they go back toward
// their places on the lattice, where it does neither: the wider around, the longer it takes.
void back_to_lattice(const Points3& lattice, Mesh& skin) {
  constexpr int kRounds = 6;
  constexpr double kShare = 0.5;  // of the way, per round
  const FaceNeighbours beside_face = face_neighbours(skin.F);
  Adjacency beside;
  auto crossings = self_intersections(skin);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<std::pair<int, int>> wrong = folds(skin, beside_face);
    wrong.insert(wrong.end(), crossings.begin(), crossings.end());
    if (wrong.empty()) return;
    if (round == 0) beside = vertex_adjacency(skin);
    std::vector<char> back(skin.V.rows(), 0);
    for (const auto& [f, g] : wrong)
      for (int c = 0; c < 3; ++c) back[skin.F(f, c)] = back[skin.F(g, c)] = 1;
    for (int ring = 0; ring < round; ++ring) {
      const std::vector<char> before = back;
      for (int v = 0; v < int(before.size()); ++v)
        if (before[v])
          for (const int u : beside.of(v)) back[u] = 1;
    }
    for (int v = 0; v < int(back.size()); ++v)
      if (back[v]) skin.V.row(v) += kShare * (lattice.row(v) - skin.V.row(v));
    crossings = self_intersections_near(skin, back);
  }
}

}  // namespace

Result<Mesh> consolidate(const Document& document, std::span<const PartSurface> parts,
                         const ConsolidateOptions& options, std::vector<std::string>& warnings,
                         Run& run) {
  return consolidated(document, parts, options, kSmoothVertices, warnings, run);
}

Result<Mesh> consolidated(const Document& document, std::span<const PartSurface> parts,
                          const ConsolidateOptions& options, int vertices,
                          std::vector<std::string>& warnings, Run& run, SphereUse use) {
  const PartTree tree = part_tree(document, parts);
  if (std::none_of(tree.nodes.begin(), tree.nodes.end(), [](const auto& n) { return n.solid; }))
    return bad_input("no part has a body: draw a closed contour for at least one joint");
  std::vector<JointSphere> spheres;
  if (options.blend) spheres = joint_spheres(document, parts, tree);
  const std::vector<Capsule> balls = balls_of(document, parts, tree, spheres, use);
  const double cell = cell_size(tree, parts, balls, options.triangles, vertices);
  Body body(parts, tree, spheres, kLatticeGap * cell);
  body.capsules = balls;
  Body::Sampled sampled;
  Surface surface;
  for (const bool bridged : {false, true}) {
    Result<Surface> closed = closed_surface(body, cell, spheres, parts, sampled, run);
    if (!closed) return closed.error();
    surface = std::move(*closed);
    run.report(bridged ? 0.4 : 0.3);
    const auto solid = [](double volume) { return volume > 0; };
    const std::vector<double>& volume = surface.found.volume;
    if (bridged || std::count_if(volume.begin(), volume.end(), solid) < 2) break;
    const std::vector<Capsule> bridges = bridge_parts(
        document, parts, tree, spheres, pieces_of_parts(body, tree, surface), cell, warnings);
    if (bridges.empty()) break;
    body.capsules.insert(body.capsules.end(), bridges.begin(), bridges.end());
  }
  run.report(0.5);
  QuadMesh mesh = only(surface.mesh, surface.found, surface.found.largest);
  if (mesh.V.rows() == 0) return bad_input("the parts are too thin to make a surface of");
  const Points3 lattice = mesh.V;
  body.set_gap(kFinalGap * cell);
  const SurfaceProjection projection = project_to_surface(body, sampled, mesh);
  if (run.cancelled()) return cancelled();
  name_the_fused(document, parts, tree, mesh, projection, warnings);
  run.report(0.7);
  if (use == SphereUse::united)
    fair_inside(balls, sampled.grid.cell, mesh);
  else
    fair(body, sampled, spheres, projection, mesh);
  Mesh skin{mesh.V, split_quads(mesh.V, mesh.Q)};
  back_to_lattice(lattice, skin);
  if (const int left = mend_surface(skin).crossings; left > 0)
    warnings.push_back("the surface passes through itself in " + counted(left, "place") +
                       " where parts crowd together");
  run.report(1);
  return skin;
}

Result<Mesh> consolidated_by_paper(const Document& document, std::span<const PartSurface> parts,
                                   const ConsolidateOptions& options,
                                   std::vector<std::string>& warnings, Run& run) {
  return consolidated(document, parts, options, kSmoothVertices, warnings, run, SphereUse::united);
}

}  // namespace artisketch
