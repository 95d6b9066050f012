// How well the examples come out, given as the artist gives them: poses that are some degrees off,
// drawings in ink and colour.
#pragma once

#include "figures/examples.h"
#include "model/stages.h"

namespace artisketch::quality {

struct GalleryCell {
  double joint_px = 0, drawn_joint_px = 0;  // joints' mean distance: calibrated, and as posed
  double drawn = 0;                         // silhouettes in the poses that were drawn
  double novel = 0;                         // in poses that nobody drew
  double volume = 0;                        // intersection over union, in the rest pose
  double wrong = 0;  // share of pixels wrongly coloured, in poses that nobody drew
  int folds = 0;     // pairs of faces folded over their common edge
  int genus = 0, components = 0;
  double seconds = 0;  // of the reconstruction
};

struct GalleryOptions {
  int poses = 6;             // that nobody drew
  int size = 320;            // of the pictures in which they are compared, pixels
  PipelineOptions pipeline;  // with a drawing for each frame
};

// A model that cannot be made is all zeros, everything wrongly coloured.
GalleryCell gallery_cell(const figures::Example& example, const GalleryOptions& options);

// The table over the examples named, or all, printed as it grows.
void print_gallery(const PipelineOptions& pipeline, const std::vector<std::string>& names);

}  // namespace artisketch::quality
