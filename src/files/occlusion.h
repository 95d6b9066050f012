// How much light reaches a mesh past itself, and the ground beneath it, by depth maps from the
// directions that light comes from.
#pragma once

#include <vector>

#include "base/mesh.h"

namespace artisketch {

// The ball about the middle of a mesh's box that holds all of the mesh.
struct Ball {
  Vec3 centre = Vec3::Zero();
  double radius = 1;  // > 0
};
Ball surrounding(const Points3& V);

// #V, 0 … 1, as glTF has it (1: nothing hides the vertex): the share of the light from all round,
// brighter above than below, that the mesh itself doesn't block. mesh: closed; N #V×3 unit normals.
Eigen::VectorXd ambient_occlusion(const Mesh& mesh, const Points3& N);

// #V, 0 … 1: the share of a round lamp that each vertex sees. direction: toward the lamp, unit
// length; lamp: its radius, one unit away.
Eigen::VectorXd lamp_light(const Mesh& mesh, const Points3& N, const Vec3& direction, double lamp);

// The shadow that a mesh in light from all above casts on the level ground at its lowest point. It
// fades out where it ends.
struct GroundShadow {
  Box2 box;                 // x and z of the ground that it covers, units
  double height = 0;        // y of the ground
  int size = 0;             // samples along both sides
  std::vector<float> dark;  // rows along z: 0 all light … 1 none
  double at(double x, double z) const;
};
GroundShadow ground_shadow(const Mesh& mesh);

}  // namespace artisketch
