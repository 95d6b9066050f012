#include "base/rotation.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace artisketch {
namespace {

TEST(Rotation, TheLeastTurnTakesOneDirectionToTheOther) {
  const Vec3 from(1, -2, 0.5);
  for (const Vec3& to : {Vec3(0, 0, 3), Vec3(-4, 1, 1), Vec3(1, -2, 0.5), Vec3(-1, 2, -0.5),
                         Vec3(-1, 2, -0.5 + 1e-9)}) {
    const Quat turn = least_turn(from, to);
    EXPECT_NEAR(turn.norm(), 1, 1e-12);
    EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 1e-7) << to.transpose();
    const double between = std::acos(std::clamp(from.normalized().dot(to.normalized()), -1., 1.));
    EXPECT_NEAR(Quat::Identity().angularDistance(turn), between, 1e-6) << "no further";
  }
}

}  // namespace
}  // namespace artisketch
