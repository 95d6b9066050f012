// A clip as pictures side by side: a sheet, and what says where each is.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "files/image_file.h"
#include "files/render.h"
#include "files/zip.h"
#include "model/run.h"
#include "model/stages.h"

namespace artisketch {

// How the JSON lists the sprites: `frames` as Aseprite's "Array" and TexturePacker's "JSON
// (Array)", or by name as Aseprite's and TexturePacker's "Hash", which game libraries load unasked.
enum class SheetLayout { array, hash };

struct SpriteOptions {
  std::string clip;    // by name
  int directions = 8;  // 1, 4, 8 or 16, from the front on, to the figure's right
  int size = 128;      // of a sprite's longer side, pixels, 8 … 1024
  double rate = 12;    // pictures a second, 1 … 60
  int padding = 0;     // pixels between and round the sprites, 0 … 64
  double pitch = 0;    // radians, seen from above
  Light light = Light::soft;
  bool ink = true;
  // Pixel art: every one of its pixels takes this many along each side, 1 … 16, in one colour of
  // the texture (the drawings' own), whole or not there at all; 0: smooth.
  int pixels = 0;
  bool normals = false, depth = false;  // sheets of them, too
  SheetLayout layout = SheetLayout::array;
};

struct SpriteSheet {
  Image image;           // a row per direction, straight alpha
  Image normals, depth;  // the same places; empty where not asked for
  std::string json;      // `image_name` stands in its meta.image
};

// All sprites at one scale, on one ground and about one axis, so that they replace each other in
// place. Clips that go round leave out their last pose, which is the first. Normals are as
// RenderLook has them; depth goes from the whole figure's farthest (0) to its nearest (255) over
// all the sprites. Fails where there is no such clip or the sheet would be larger than 16384 pixels
// a side. `run`, where it is given, hears how far it is, and may stop it.
Result<SpriteSheet> sprite_sheet(const Model& model, const SpriteOptions& options,
                                 const std::string& image_name, Run* run = nullptr);

// The same as files: NAME.png, NAME.json, and NAME_n.png, NAME_d.png where asked for.
Result<std::vector<FileInside>> sprite_files(const Model& model, const SpriteOptions& options,
                                             const std::string& name, Run* run = nullptr);
// And in one archive.
Result<std::string> sprite_zip(const Model& model, const SpriteOptions& options,
                               const std::string& name, Run* run = nullptr);

}  // namespace artisketch
