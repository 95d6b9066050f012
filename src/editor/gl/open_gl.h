// Textures, meshes and their pictures in OpenGL ES 3 (WebGL2).
#pragma once

#include <optional>
#include <vector>

#include "editor/pictures/graphics.h"

namespace artisketch {

class OpenGl : public Graphics {
 public:
  // While the context is there, from the first call on to the last.
  ~OpenGl() override;
  unsigned add_texture(int width, int height, std::span<const std::uint8_t> rgba,
                       Beyond edge) override;
  void remove_texture(unsigned texture) override;
  std::unique_ptr<CardMesh> make_mesh() override;
  std::unique_ptr<CardPicture> make_picture() override;

  // Textures of pictures that were painted since this was asked last.
  std::vector<unsigned> take_painted();

 private:
  class Picture;
  struct Program {
    unsigned id = 0;
    int clip = 0, turn = 0, use = 0, line = 0;  // uniforms
  };
  const Program& program();
  std::optional<Program> program_;
  std::vector<unsigned> painted_;
};

}  // namespace artisketch
