#include "base/dual_surface.h"

#include <algorithm>
#include <map>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include "base/well_composed.h"

namespace artisketch {
namespace {

// A lattice of up to three blocks a side of which some are stored, each sample of them inside or
// not by chance, on the borders of blocks and lattice too.
BlockGrid random_grid(std::mt19937& random) {
  const auto up_to = [&](int n) { return 1 + int(random() % unsigned(n)); };
  BlockGrid grid(Vec3(1, -2, 3), 0.25, Index3(up_to(3), up_to(3), up_to(3)));
  std::vector<char> wanted(grid.slot.size());
  for (char& w : wanted) w = random() % 2;
  grid.store(wanted);
  const unsigned of_eight = 1 + random() % 7;  // how many samples are inside
  for (float& v : grid.values)
    v = (random() % 8 < of_eight ? -1.0f : 1.0f) * float(up_to(100)) / 100;
  return grid;
}

Mesh triangles_of(const QuadMesh& quads) {
  return {quads.V, split_quads(quads.V, quads.Q)};
}

int inside_count(const BlockGrid& grid) {
  return int(std::count_if(grid.values.begin(), grid.values.end(), [](float v) { return v < 0; }));
}

TEST(DualSurface, NamesItsOwnVerticesAndClosesWhateverIsStored) {
  std::mt19937 random(1);
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    const BlockGrid grid = random_grid(random);
    const QuadMesh mesh = dual_surface(grid);
    EXPECT_EQ(mesh.Q.rows() > 0, inside_count(grid) > 0);
    std::map<std::pair<int, int>, int> runs;  // along an edge, less those against it
    for (int q = 0; q < mesh.Q.rows(); ++q)
      for (int c = 0; c < 4; ++c) {
        const int a = mesh.Q(q, c), b = mesh.Q(q, (c + 1) % 4);
        ASSERT_TRUE(a >= 0 && a < mesh.V.rows());
        ++runs[{a, b}];
        --runs[{b, a}];
      }
    for (const auto& [edge, count] : runs) ASSERT_EQ(count, 0);
    EXPECT_TRUE(mesh.V.allFinite());
  }
}

TEST(DualSurface, IsAManifoldRoundAnySolidThatIsWellComposed) {
  std::mt19937 random(2);
  for (int round = 0; round < 60; ++round) {
    SCOPED_TRACE(round);
    BlockGrid grid = random_grid(random);
    const int before = inside_count(grid);
    const std::vector<Turned> turned = make_well_composed(grid);
    EXPECT_EQ(inside_count(grid), before + int(turned.size()));
    const Mesh mesh = triangles_of(dual_surface(grid));
    if (before == 0) continue;
    const Topology t = topology(mesh);
    EXPECT_TRUE(t.manifold());
  }
}

// The least solid: one sample, at each place that a block has.
TEST(DualSurface, BoxesInASampleWhereverItStands) {
  for (int s = 0; s < BlockGrid::kSize; ++s) {
    BlockGrid grid(Vec3::Zero(), 1, Index3::Ones());
    grid.store({1});
    grid.values[s] = -1;
    const Vec3 sample = grid.sample_of(s).cast<double>();
    const Mesh mesh = triangles_of(dual_surface(grid));
    ASSERT_EQ(mesh.V.rows(), 8);
    EXPECT_TRUE(topology(mesh).manifold());
    EXPECT_LT((bounds(mesh.V).center() - sample).norm(), 1e-9);
  }
}

TEST(BlockGrid, ClosesByAddingOutsideAndMovesNothing) {
  std::mt19937 random(3);
  for (int round = 0; round < 100; ++round) {
    const BlockGrid before = random_grid(random);
    BlockGrid grid = before;
    EXPECT_EQ(grid.close() == 0, before.is_closed());
    EXPECT_TRUE(grid.is_closed());
    EXPECT_EQ(inside_count(grid), inside_count(before));
    for (std::size_t v = 0; v < before.values.size(); ++v) {
      const Index3 was = before.sample_of(std::ptrdiff_t(v)),
                   is = grid.sample_of(std::ptrdiff_t(v));
      ASSERT_EQ(grid.values[v], before.values[v]);
      ASSERT_EQ(grid.find(is.x(), is.y(), is.z()), std::ptrdiff_t(v));
      ASSERT_LT((before.position(was.x(), was.y(), was.z()) - grid.position(is.x(), is.y(), is.z()))
                    .norm(),
                1e-12);
    }
  }
}

}  // namespace
}  // namespace artisketch
