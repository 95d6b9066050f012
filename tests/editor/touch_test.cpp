#include "editor/ui/touch.h"

#include <gtest/gtest.h>

namespace artisketch {
namespace {

TEST(Touch, OneFingerIsThePointer) {
  Touch touch;
  EXPECT_TRUE(touch.points());
  EXPECT_FALSE(touch.down(1, {100, 100}, 0));
  EXPECT_TRUE(touch.points());
  touch.move(1, {140, 100});
  const Fingers fingers = touch.take();
  EXPECT_EQ(fingers.count, 0);
  EXPECT_EQ(fingers.moved.x, 0);
  touch.up(1, 0.1);
  EXPECT_EQ(touch.take().tapped, 0);
}

TEST(Touch, TwoFingersMoveByTheirMiddleAndSpreadByTheirDistance) {
  Touch touch;
  touch.down(1, {100, 100}, 0);
  EXPECT_TRUE(touch.down(2, {200, 100}, 0.01)) << "the pointer no longer is one";
  EXPECT_FALSE(touch.points());
  Fingers fingers = touch.take();
  EXPECT_TRUE(fingers.began);
  EXPECT_EQ(fingers.count, 2);
  touch.move(1, {110, 130});
  touch.move(2, {210, 130});
  fingers = touch.take();
  EXPECT_FALSE(fingers.began);
  EXPECT_FLOAT_EQ(fingers.moved.x, 10);
  EXPECT_FLOAT_EQ(fingers.moved.y, 30);
  EXPECT_NEAR(fingers.spread, 1, 0.01);
  touch.move(1, {60, 130});
  touch.move(2, {260, 130});
  fingers = touch.take();
  EXPECT_FLOAT_EQ(fingers.spread, 2);
  EXPECT_FLOAT_EQ(fingers.at.x, 160);
}

TEST(Touch, AFingerMoreIsNoLeap) {
  Touch touch;
  touch.down(1, {100, 100}, 0);
  touch.down(2, {200, 100}, 0);
  touch.take();
  touch.down(3, {600, 700}, 0.5);
  const Fingers fingers = touch.take();
  EXPECT_EQ(fingers.count, 3);
  EXPECT_FALSE(fingers.began);
  EXPECT_EQ(fingers.moved.x, 0);
  EXPECT_EQ(fingers.spread, 1);
}

TEST(Touch, TapsAreShortAndStill) {
  for (const int count : {2, 3}) {
    Touch touch;
    for (int f = 0; f < count; ++f) touch.down(f, {100.0f + 60 * float(f), 100}, 0.01 * f);
    for (int f = 0; f < count; ++f) touch.up(f, 0.2);
    EXPECT_EQ(touch.take().tapped, count);
    EXPECT_EQ(touch.take().tapped, 0) << "once";
  }
  Touch slow;
  slow.down(1, {100, 100}, 0);
  slow.down(2, {160, 100}, 0);
  slow.up(1, 1);
  slow.up(2, 1);
  EXPECT_EQ(slow.take().tapped, 0);
  Touch moving;
  moving.down(1, {100, 100}, 0);
  moving.down(2, {160, 100}, 0);
  moving.move(1, {100, 180});
  moving.up(1, 0.1);
  moving.up(2, 0.1);
  EXPECT_EQ(moving.take().tapped, 0);
}

TEST(Touch, BesideAPenAFingerAlonePansAndItsTapIsAClick) {
  Touch touch;
  touch.pen_near(true);
  EXPECT_FALSE(touch.points());
  touch.down(1, {100, 100}, 0);
  EXPECT_FALSE(touch.points());
  touch.move(1, {130, 100});
  const Fingers fingers = touch.take();
  EXPECT_EQ(fingers.count, 1);
  EXPECT_FLOAT_EQ(fingers.moved.x, 30);
  touch.up(1, 0.1);
  EXPECT_EQ(touch.take().tapped, 0) << "it moved";
  touch.down(2, {50, 60}, 1);
  touch.up(2, 1.1);
  const Fingers tap = touch.take();
  EXPECT_EQ(tap.tapped, 1);
  EXPECT_FLOAT_EQ(tap.at.x, 50);
}

TEST(Touch, WhatIsUnknownIsNothing) {
  Touch touch;
  touch.move(9, {1, 1});
  touch.up(9, 0);
  EXPECT_EQ(touch.take().count, 0);
}

}  // namespace
}  // namespace artisketch
