// What the editor asks of the graphics card. The window paints with OpenGL (gl/open_gl.h); where
// there is no window, as in tests, nothing is painted and all else goes on.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <imgui.h>

#include "base/types.h"

namespace artisketch {

// How a mesh is painted.
struct MeshLook {
  Eigen::Matrix4f clip;      // world → clip space
  Eigen::Matrix3f turn;      // world → view directions: x right, y up, z toward the viewer
  unsigned texture = 0;      // 0: the vertices' own colours
  bool edges_alone = false;  // the faces hide what lies behind them, and show nothing themselves
  ImVec4 edge_colour{};
  bool ground = false;
  ImVec4 ground_colour{};
  float ground_fade = 0;  // 1 / the distance from the middle at which it has vanished; units
};

// Triangles on the card, loaded once and painted in many poses.
class CardMesh {
 public:
  virtual ~CardMesh() = default;
  // Three corners a triangle; two texture coordinates a vertex.
  virtual void set_faces(std::span<const unsigned> corners, std::span<const float> uvs) = 0;
  virtual void set_edges(std::span<const unsigned> ends) = 0;   // two vertices each
  virtual void set_ground(std::span<const float> ends) = 0;     // of lines; x y z each
  virtual void move(std::span<const float> positions,           // x y z a vertex
                    std::span<const float> normals) = 0;        // likewise, of length 1
  virtual void colour(std::span<const std::uint8_t> rgba) = 0;  // a vertex
};

// What a mesh is painted into, to be shown as a texture with premultiplied alpha.
class CardPicture {
 public:
  virtual ~CardPicture() = default;
  virtual unsigned texture() const = 0;  // 0 until something was painted
  // The mesh is of the same Graphics. Size in pixels; rough: with jagged edges, which is faster.
  virtual void paint(const CardMesh& mesh, const MeshLook& look, int width, int height,
                     bool rough) = 0;
};

class Graphics {
 public:
  virtual ~Graphics() = default;
  enum class Beyond { repeats, stretches };  // what lies beyond a texture's edge
  // RGBA, four bytes a pixel, row by row from the top, shown smaller without flicker. Gives its
  // name, never 0.
  virtual unsigned add_texture(int width, int height, std::span<const std::uint8_t> rgba,
                               Beyond edge) = 0;
  virtual void remove_texture(unsigned texture) = 0;
  virtual std::unique_ptr<CardMesh> make_mesh() = 0;
  virtual std::unique_ptr<CardPicture> make_picture() = 0;
};

// In a draw list: what follows has premultiplied alpha, until ImDrawCallback_ResetRenderState. The
// painter of the list knows it by its address.
void blend_premultiplied(const ImDrawList*, const ImDrawCmd*);

}  // namespace artisketch
