// What Pose's tools and insets do to the pose of the drawing in view, each as the next piece of a
// gesture. A calibrated pose that waits is given up where the person poses on.
#pragma once

#include "editor/canvas/pointer.h"

namespace artisketch {

// The joint to a pixel of the drawing; its limb follows.
void drag_joint(App& app, int joint, const Vec2& pixel);
void turn_body(App& app, const Quat& turn);
// The chosen joint's bone about itself; radians.
void twist_bone(App& app, double angle);
inline constexpr double kTwistPerNotch = 5, kTwistPerPoint = 0.5;  // degrees: wheel, pointer

}  // namespace artisketch
