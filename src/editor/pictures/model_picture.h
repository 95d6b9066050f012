// A model as the panels show it: posed, coloured, and painted into pictures where these changed.
#pragma once

#include <memory>
#include <vector>

#include "editor/pictures/graphics.h"
#include "editor/pictures/view_projection.h"
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

// A picture to paint into, shown as a texture with premultiplied alpha.
class RenderTarget {
 public:
  explicit RenderTarget(Graphics& graphics)  // which outlives it
      : graphics_(graphics), picture_(graphics.make_picture()) {}
  Graphics& graphics() const { return graphics_; }
  unsigned texture() const { return picture_->texture(); }
  void paint(const CardMesh& mesh, const MeshLook& look, const Scene& scene);
  bool shows(const Scene& scene) const { return texture() && shown_ == scene; }

 private:
  Graphics& graphics_;
  std::unique_ptr<CardPicture> picture_;
  Scene shown_;  // painted last
};

class ModelPicture {
 public:
  ModelPicture() = default;
  ModelPicture(const ModelPicture&) = delete;
  ModelPicture& operator=(const ModelPicture&) = delete;
  ~ModelPicture();

  // Once; it reaches the card when it is painted first.
  void load(const Model& model);
  // Poses the model for what is painted next; `shift` moves it, in units.
  void pose(const Pose& pose, const Vec3& shift);
  // Leaves the picture alone where it shows just that already.
  void paint(const Model& model, const ViewProjection& projection, const PaintOptions& options,
             RenderTarget& picture, float pixel_ratio);

 private:
  void hand_over(const Model& model, Graphics& graphics);  // to the card, once
  void move_vertices(const Model& model, const Scene& scene);
  void colour_vertices(const Model& model, const PaintOptions& options);
  void load_edges(const Model& model);
  Graphics* graphics_ = nullptr;  // the mesh's and the texture's
  std::unique_ptr<CardMesh> mesh_;
  unsigned texture_ = 0;
  bool has_edges_ = false;
  std::vector<int> first_;  // first_at_place: vertices at the same place share a normal
  Scene next_, posed_;      // what is wanted, and as the card has it
  Surface coloured_for_ = Surface::textured;
  int coloured_joint_ = -2;
};

// Draws a texture with premultiplied alpha into the panel under way.
void show_picture(unsigned texture, const Rect& place, float opacity, ImVec2 uv0 = {0, 0},
                  ImVec2 uv1 = {1, 1}, ImU32 tint = IM_COL32_WHITE, float radius = 0);

}  // namespace artisketch
