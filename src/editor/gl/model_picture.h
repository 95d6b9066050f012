// A model on the graphics card: posed, lit, and painted into pictures that the panels show.
#pragma once

#include <vector>

#include "editor/gl/eye.h"
#include "model/stages.h"

namespace artisketch {

enum class Surface { textured, shaded, wireframe, weights };

struct PaintOptions {
  Surface surface = Surface::textured;
  int joint = -1;       // weights of this joint alone; −1: all, in their colours
  bool ground = false;  // a grid at y = 0
  bool rough = false;   // with jagged edges, for machines that paint slowly
  bool dark = true;
};

// All that a picture of a model depends on: while it stays, the picture does.
struct Scene {
  long model = 0;  // which one was loaded
  Pose pose;
  Vec3 shift = Vec3::Zero();
  Eigen::Matrix4d clip = Eigen::Matrix4d::Identity();
  Mat3 turn = Mat3::Identity();
  PaintOptions options;
  int width = 0, height = 0;

  bool stands_as(const Scene& other) const;
  bool operator==(const Scene& other) const;
};

// A picture to paint into, kept as an OpenGL texture with premultiplied alpha.
class RenderTarget {
 public:
  RenderTarget() = default;
  RenderTarget(const RenderTarget&) = delete;
  RenderTarget& operator=(const RenderTarget&) = delete;
  ~RenderTarget();
  void begin(int width, int height, bool rough);  // clears it
  void end();
  unsigned texture() const { return texture_; }

  Scene shows;  // painted last

  // Textures painted since this was asked last.
  static std::vector<unsigned> take_painted();

 private:
  void release();
  int width_ = 0, height_ = 0;
  bool rough_ = false;
  // Painted into `smooth_`, several samples a pixel, and from there into `flat_`, or there at once.
  unsigned texture_ = 0, flat_ = 0, smooth_ = 0, colour_ = 0, depth_ = 0;
};

class ModelPicture {
 public:
  ModelPicture() = default;
  ModelPicture(const ModelPicture&) = delete;
  ModelPicture& operator=(const ModelPicture&) = delete;
  ~ModelPicture();

  void load(const Model& model);
  // Poses the model for what is painted next; `shift` moves it, in units.
  void pose(const Pose& pose, const Vec3& shift);
  // Leaves the picture alone where it shows just that already.
  void paint(const Model& model, const Eye& eye, const PaintOptions& options, RenderTarget& picture,
             float pixel_ratio);

 private:
  void move_vertices(const Model& model, const Scene& scene);
  void colour_vertices(const Model& model, const PaintOptions& options);
  void load_edges(const Model& model);
  unsigned triangles_ = 0, edges_ = 0, ground_ = 0, ground_points_ = 0;  // vertex arrays
  unsigned positions_ = 0, normals_ = 0, uvs_ = 0, colours_ = 0, faces_ = 0, lines_ = 0;  // buffers
  unsigned texture_ = 0;
  int triangle_count_ = 0, edge_count_ = 0, ground_count_ = 0;
  std::vector<int> first_;  // first_at_place: vertices at the same place share a normal
  Scene next_, posed_;      // what is wanted, and as the card has it
  Surface coloured_for_ = Surface::textured;
  int coloured_joint_ = -2;
};

// Draws a texture with premultiplied alpha into the panel under way.
void show_picture(unsigned texture, const Rect& place, float opacity, ImVec2 uv0 = {0, 0},
                  ImVec2 uv1 = {1, 1}, ImU32 tint = IM_COL32_WHITE, float radius = 0);

}  // namespace artisketch
