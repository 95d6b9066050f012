#include "model/consolidate/unfold.h"

#include <gtest/gtest.h>

namespace artisketch {
namespace {

TEST(Unfold, AVertexThatWasPulledOverItsNeighboursGoesBack) {
  const Mesh ball = icosphere(Vec3::Zero(), 1, 4);
  Mesh dented = ball;
  for (const int v : {100, 700, 1500}) {  // two edges aside
    const Adjacency beside = vertex_adjacency(ball);
    const int u = beside.of(v)[0];
    dented.V.row(v) += 2.5 * (ball.V.row(u) - ball.V.row(v));
  }
  ASSERT_FALSE(folds(dented, face_neighbours(dented.F)).empty());
  EXPECT_EQ(unfold(dented), 0);
  EXPECT_TRUE(folds(dented, face_neighbours(dented.F)).empty());
  EXPECT_TRUE(topology(dented).manifold());
  EXPECT_EQ(topology(dented).genus(), 0);
  EXPECT_NEAR(signed_volume(dented), signed_volume(ball), 0.01 * signed_volume(ball));
}

TEST(Unfold, WhatHasNoFoldStaysAsItIs) {
  Mesh box = icosphere(Vec3::Zero(), 1, 3);
  for (int v = 0; v < box.V.rows(); ++v) box.V.row(v) /= box.V.row(v).cwiseAbs().maxCoeff();
  const Mesh before = box;
  EXPECT_EQ(unfold(box), 0);
  EXPECT_EQ(box.V, before.V);
  EXPECT_EQ(box.F, before.F);
}

}  // namespace
}  // namespace artisketch
