// The one image of drawings, textures and pictures.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace artisketch {

struct Image {
  int width = 0, height = 0;       // pixels
  std::vector<std::uint8_t> rgba;  // 4 · width · height: rows from the top, sRGB, straight alpha

  Image() = default;
  // White and opaque, or `value` in every byte.
  Image(int width, int height, std::uint8_t value = 255)
      : width(width), height(height), rgba(std::size_t(width) * height * 4, value) {}

  bool empty() const { return rgba.empty(); }
  std::uint8_t* at(int x, int y) { return &rgba[4 * (std::size_t(y) * width + x)]; }
  const std::uint8_t* at(int x, int y) const { return &rgba[4 * (std::size_t(y) * width + x)]; }
};

}  // namespace artisketch
