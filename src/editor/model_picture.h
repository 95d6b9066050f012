// A model on the graphics card: posed, lit, and painted into pictures that the panels show.
#pragma once

#include <vector>

#include "editor/eye.h"
#include "model/stages.h"

namespace artisketch {

// A picture to paint into, kept as an OpenGL texture with premultiplied alpha.
class Picture {
 public:
  Picture() = default;
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;
  ~Picture();
  void begin(int width, int height);  // clears it
  void end();
  unsigned texture() const { return texture_; }

 private:
  void release();
  int width_ = 0, height_ = 0;
  unsigned texture_ = 0, resolve_ = 0, smooth_ = 0, colour_ = 0, depth_ = 0;
};

enum class Surface { textured, shaded, wireframe, weights };

struct PaintOptions {
  Surface surface = Surface::textured;
  int joint = -1;       // weights of this joint alone; −1: all, in their colours
  bool ground = false;  // a grid at y = 0
  bool dark = true;
};

class ModelPicture {
 public:
  ModelPicture() = default;
  ModelPicture(const ModelPicture&) = delete;
  ModelPicture& operator=(const ModelPicture&) = delete;
  ~ModelPicture();

  void load(const Model& model);
  // Poses the model; `shift` moves it, in units.
  void pose(const Model& model, const Pose& pose, const Vec3& shift);
  void paint(const Model& model, const Eye& eye, const PaintOptions& options, Picture& picture,
             float pixel_ratio);

 private:
  void colour_vertices(const Model& model, const PaintOptions& options);
  unsigned triangles_ = 0, edges_ = 0, ground_ = 0, ground_points_ = 0;  // vertex arrays
  unsigned positions_ = 0, normals_ = 0, uvs_ = 0, colours_ = 0, faces_ = 0, lines_ = 0;  // buffers
  unsigned texture_ = 0;
  int triangle_count_ = 0, edge_count_ = 0, ground_count_ = 0;
  std::vector<int> welded_;  // vertices at the same place share a normal
  int welded_count_ = 0;
  Surface coloured_for_ = Surface::textured;
  int coloured_joint_ = -2;
};

// Draws a texture with premultiplied alpha into the panel under way.
void show_picture(unsigned texture, const Rect& place, float opacity, ImVec2 uv0 = {0, 0},
                  ImVec2 uv1 = {1, 1}, ImU32 tint = IM_COL32_WHITE, float radius = 0);

}  // namespace artisketch
