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
// hollows: ambient occlusion is worked out, which soft light alone asks for.
Shape shape_of(const Model& model, const Pose* pose, bool by_joint, bool hollows = true);

inline constexpr unsigned kInkColour = 0x2A211D;  // sRGB

enum class Light {
  soft,   // as above
  plain,  // none: the surface's own colours
  toon    // two tones, parted where the key light ends
};

struct RenderLook {
  Light light = Light::soft;
  bool ink = true;          // along the outline and along steps in depth
  double line_width = 1.5;  // of it, pixels
  int samples = 3;          // along a pixel's side; 1: hard edges
  // What else is drawn, to the same pixels: unit normals n in view space (x right, y up, z toward
  // the viewer) as (n + 1) / 2, and depth, 1 at z = `nearest` to 0 at `farthest`.
  bool normals = false, depth = false;
  double nearest = 1, farthest = 0;
};

struct Pictures {
  Image colours, normals, depth;  // straight alpha; empty where not asked for
};

// How the shape looks to a camera after `view` moved it (FrameCamera looks along −z): on a clear
// background, straight alpha. Triangles that reach behind a perspective camera are left out.
Image render_shape(const Shape& shape, const Transform& view, const FrameCamera& camera, int width,
                   int height);
Pictures render_pictures(const Shape& shape, const Transform& view, const FrameCamera& camera,
                         int width, int height, const RenderLook& look);

}  // namespace artisketch
