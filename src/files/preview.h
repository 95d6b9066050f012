// Pictures without a display: a software renderer of models and sketches.
#pragma once

#include <optional>
#include <vector>

#include "files/image_file.h"
#include "model/stages.h"

namespace artisketch {

struct RenderOptions {
  int width = 800, height = 800;  // pixels
  double yaw = 0, pitch = 0;      // radians: the model turns about +y, then +x
  std::optional<int> frame;       // clip `frames`, key of that index; absent: the rest pose
  bool skeleton = false;
};

// The model, shaded, anti-aliased, outlined, fitted into the picture.
Image render_model(const Model& model, const RenderOptions& options);

// `count` pictures round the vertical axis, side by side.
Image render_turntable(const Model& model, const RenderOptions& options, int count);

// A contact sheet: per frame the sketch with its contours and skeleton, and the posed result over
// it (before and after calibration where that moved anything); then the rest pose from four sides.
Image contact_sheet(const Document& document, const std::vector<Image>& sketches,
                    const Reconstruction& result);

// The palette's colour of a joint (EDITOR.md), 0xRRGGBB.
unsigned joint_colour(int joint);

}  // namespace artisketch
