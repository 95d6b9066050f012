// What Skeleton's tool and keys do to the rest pose.
#pragma once

#include "editor/session/app.h"

namespace artisketch {

// Where a pixel of the drawing lies in the world, as deep as a joint.
Vec3 as_deep_as(const Transform& joint, const FrameCamera& camera, const Vec2& pixel);
// The joint to a pixel of the drawing, in every drawing; the root takes the body along in this one
// alone. The next piece of a gesture.
void move_joint(App& app, int joint, const Vec2& pixel);

}  // namespace artisketch
