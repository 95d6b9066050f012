// A clip as pictures side by side: a sheet, and what says where each is (Aseprite's and
// TexturePacker's JSON, frames as an array).
#pragma once

#include <string>

#include "base/result.h"
#include "files/image_file.h"
#include "model/stages.h"

namespace artisketch {

struct SpriteOptions {
  std::string clip;    // by name
  int directions = 8;  // 1, 4, 8 or 16, from the front on, to the figure's right
  int size = 128;      // of a sprite's longer side, pixels, 8 … 1024
  double rate = 12;    // pictures a second, 1 … 60
  int padding = 0;     // pixels between and round the sprites, 0 … 64
  double pitch = 0;    // radians, seen from above
};

struct SpriteSheet {
  Image image;       // a row per direction, straight alpha
  std::string json;  // `image_name` stands in its meta.image
};

// All sprites at one scale, on one ground and about one axis, so that they replace each other in
// place. Clips that go round leave out their last pose, which is the first. Fails where there is no
// such clip or the sheet would be larger than 16384 pixels a side.
Result<SpriteSheet> sprite_sheet(const Model& model, const SpriteOptions& options,
                                 const std::string& image_name);

}  // namespace artisketch
