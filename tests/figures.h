// Posable figures with a known truth: rigid solids on a skeleton, drawn from any side in any pose.
// Everything is a function of its arguments and its seed.
//
//   const Figure figure = human(1);
//   const Camera camera = fitting_camera(figure, Camera::Type::perspective, 640, 800);
//   const Sketches s = draw(figure, random_views(figure, 3, 1), camera, 640, 800,
//                           {.pose_error_degrees = 8}, 1);
//   reconstruct(s.given, ...), and compare with figure and s.truth.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/rotation.h"
#include "document/document.h"
#include "figures/solid.h"

namespace artisketch::figures {

struct Figure {
  std::string name;
  Skeleton skeleton;
  std::vector<Solid> parts;     // one per joint, in rest space; empty where the joint has no part
  std::vector<double> freedom;  // radians per joint: how far random poses bend it
};

// ---------------------------------------------------------------- the cast

Figure ball_figure(double radius = 0.5);   // one joint, one ball
Figure two_balls();                        // one joint, two balls that melt into one another
Figure heart();                            // one joint, a plump heart, kHeartHeight high
inline constexpr double kHeartHeight = 1;  // units
// A chain along +x of an upper arm, a forearm and a hand; each part is a limb with round ends.
Figure capsule_arm();
// 15 parts and the tips of head, hands and feet; 1.8 units or so high, facing +z, its left hand
// (".L") toward +x, arms stretched out. The seed varies proportions and dress.
Figure human(std::uint64_t seed = 0);
// 16 parts: body, chest, head, tail and three per leg; facing +z.
Figure quadruped(std::uint64_t seed = 0);
Figure hero();                   // of the first example: joints as human's, every one mirrored
Figure fox();                    // joints as quadruped's
Figure prince();                 // joints as human's, and a cape
Figure ballerina();              // joints as human's, and a tutu
Figure climber();                // joints as human's
Figure alien();                  // joints as human's
Figure monster();                // arms and legs on a body that is its head
Figure legs();                   // a dancer's, with the hips
Figure parrot();                 // joints as the bird's of document/templates.h, without a beak
Figure horse(bool three_parts);  // joints as quadruped's, a neck, and a torso of one part or three
Figure robot(std::uint64_t seed = 0);  // boxes and tubes, its left unlike its right

// ---------------------------------------------------------------- poses and views

using artisketch::about_x;
using artisketch::about_y;
using artisketch::about_z;

using Turns = std::vector<std::pair<std::string, Quat>>;  // joint name → local rotation

// The root's rotation is the side that the figure is seen from; the joints named are turned, the
// rest extended. Every name must be a joint's.
struct View {
  std::string name;
  Pose pose;
};
View view(const Figure& figure, std::string name, const Quat& side, const Turns& turns = {},
          const Vec3& root_position = Vec3::Zero());

// Turned by steps all round, tilted a little, limbs bent within the figure's freedom. The first is
// seen from the front.
std::vector<View> random_views(const Figure& figure, int count, std::uint64_t seed);

// Turned by equal steps from the front to `baseline` radians, tilted and bent as random_views are:
// how far apart drawings show a body is what says how much they tell of its depth.
std::vector<View> spread_views(const Figure& figure, int count, double baseline,
                               std::uint64_t seed);

// A camera that has the whole figure in the picture whatever its pose, its root in the middle.
Camera fitting_camera(const Figure& figure, Camera::Type type, int width, int height);

// ---------------------------------------------------------------- sketches

struct Noise {
  double contour_wobble_px = 0;    // root mean square of the hand's wobble along the normal
  double pose_error_degrees = 0;   // every joint that carries a part, frames after the first
  double root_error = 0;           // units across the view, frames after the first
  double shortest_wobble_px = 40;  // wavelength
  // What people draw otherwise each time: up to so much larger or smaller, as shares. Every
  // outline is stretched about its middle along its bone's image and across it, each drawing as a
  // whole about its principal point.
  double part_size = 0;
  double drawing_size = 0;
};

struct Sketches {
  Document given;  // the poses as a user would have set them
  Document truth;  // the same drawing at the true poses
};

// One frame per view. Contours are the exact outlines of each part's own solid, simplified by at
// most kOutlineTolerance, never crossing themselves; at least kLeastPoints points where the outline
// is long enough, pixels rounded to 0.01. Frame 1's pose is always true. Calibration limits hold
// the errors asked for.
inline constexpr double kOutlineTolerance = 0.3;  // pixels
inline constexpr int kLeastPoints = 40;
Sketches draw(const Figure& figure, std::span<const View> views, const Camera& camera, int width,
              int height, const Noise& noise = {}, std::uint64_t seed = 0);

// ---------------------------------------------------------------- the truth

// Negative inside the union of the parts, in rest space.
double distance(const Figure& figure, const Vec3& p);
// The figure in rest space as one closed manifold surface.
Mesh rest_mesh(const Figure& figure, double cell);
// The parts in a pose; one closed mesh each, in joint order, joints without a part empty.
std::vector<Mesh> posed_parts(const Figure& figure, const Pose& pose, double cell);

}  // namespace artisketch::figures
