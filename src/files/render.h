// A software renderer: shaded, anti-aliased, outlined pictures of a mesh, with no display. Light
// comes from all round (ambient occlusion leaves hollows dark), from a soft key light over the
// viewer's left shoulder, and from a fill and a rim light.
#pragma once

#include <vector>

#include "document/camera.h"
#include "files/image_file.h"
#include "model/stages.h"

namespace artisketch {

// A mesh in the place where it is to be shown, and what its surface looks like.
struct Shape {
  Mesh mesh;                    // world space; triangles counter-clockwise from outside
  Points3 normals;              // #V×3, shared by vertices at the same place
  Points3 tint;                 // #V×3 linear colours
  Eigen::VectorXd ambient;      // #V, ambient occlusion: 1 where nothing hides the vertex, 0 … 1
  std::vector<Vec2> texcoords;  // one per vertex, or empty
  const Image* texture = nullptr;  // in place of the tint, where there are texcoords
};

// The model in a pose, or in the rest pose where `pose` is null. by_joint: tinted by its joints'
// colours, mixed by the weights, in place of texture or clay. The shape refers to model.texture.
Shape shape_of(const Model& model, const Pose* pose, bool by_joint);

// How the shape looks to a camera after `view` moved it (FrameCamera looks along −z): on a clear
// background, straight alpha. Triangles that reach behind a perspective camera are left out.
Image render_shape(const Shape& shape, const Transform& view, const FrameCamera& camera, int width,
                   int height);

}  // namespace artisketch
