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
  std::optional<Pose> pose;       // in place of a frame's
  bool skeleton = false;          // drawn over the model
  bool by_joint = false;          // tinted by the joints, mixed by the weights, untextured
  bool clear = false;             // nothing behind the model, straight alpha
};

// The model, shaded, anti-aliased, outlined, standing on soft ground. It is fitted into the picture
// by a scale that no yaw changes. Just the background where the model has no faces. options.frame:
// a key that the clip has not is the rest pose.
Image render_model(const Model& model, const RenderOptions& options);

// `count` such pictures round the vertical axis, side by side, from options.yaw on in equal turns.
Image render_turntable(const Model& model, const RenderOptions& options, int count);

// A contact sheet, at most `width` pixels wide (400 or more): per frame the sketch with its
// contours and skeleton (before and after calibration where that moved anything), and the posed
// result over it through that frame's own camera; then the rest pose from four sides.
//   document  with the user's poses; the calibrated ones are in the result
//   sketches  one per frame; plain paper where one is empty or missing
Image contact_sheet(const Document& document, const std::vector<Image>& sketches,
                    const Reconstruction& result, int width = 1800);

}  // namespace artisketch
