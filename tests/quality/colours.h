// How right the colours of a model are from sides and in poses that nobody drew: figures whose
// colours are known, drawn in ink and colour, reconstructed, and posed anew.
#pragma once

#include <vector>

#include "figures.h"
#include "model/stages.h"

namespace artisketch::quality {

struct ColourOptions {
  std::vector<int> frames = {2, 3, 4};
  double error = 0;          // degrees that the given poses are off
  int size = 512;            // of each drawing, pixels
  int poses = 6;             // that nobody drew
  PipelineOptions pipeline;  // without drawings: they are made here
};

struct ColourCell {
  // Share of the pixels covered by both the figure and the model whose colour is neither the
  // figure's own nor its shaded tone: off by more than kWrongColour in any channel.
  double wrong = 0;
  double drawn_wrong = 0;  // the same in the poses that were drawn
};
inline constexpr double kWrongColour = 0.2;

// That share in one pose before one camera, in a square picture.
double wrong_colours(const figures::Figure& figure, const Model& model, const Pose& pose,
                     const FrameCamera& camera, int size);

ColourCell colour_cell(const figures::Figure& figure, int frames, std::uint64_t seed,
                       const ColourOptions& options);

// The table over the cast, printed as it grows.
void print_colours(const ColourOptions& options);

}  // namespace artisketch::quality
