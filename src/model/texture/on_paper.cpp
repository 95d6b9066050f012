#include "model/texture/on_paper.h"

#include <algorithm>

namespace artisketch {
namespace {

constexpr int kNothing = 26;  // of 255: paper that isn't quite clear

bool shows_through(const Image& picture, int x, int y) {
  const int alpha = picture.at(x, y)[3];
  if (alpha < kNothing || alpha == 255) return false;
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, picture.height - 1); ++v)
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, picture.width - 1); ++u)
      if (2 * picture.at(u, v)[3] < alpha) return false;
  return true;
}

}  // namespace

bool half_transparent(const Image& picture) {
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      if (shows_through(picture, x, y)) return true;
  return false;
}

Image on_paper(const Image& picture) {
  Image laid = picture;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      if (!shows_through(picture, x, y)) continue;
      const int alpha = picture.at(x, y)[3];
      std::uint8_t* pixel = laid.at(x, y);
      for (int c = 0; c < 3; ++c)
        pixel[c] = std::uint8_t((pixel[c] * alpha + 255 * (255 - alpha) + 127) / 255);
      pixel[3] = 255;
    }
  return laid;
}

std::vector<Image> laid_on_paper(std::span<const Image> pictures) {
  std::vector<Image> laid;
  if (std::none_of(pictures.begin(), pictures.end(), half_transparent)) return laid;
  for (const Image& picture : pictures) laid.push_back(on_paper(picture));
  return laid;
}

}  // namespace artisketch
