// What drawings tell of a body's depth by how far apart they see it: the same figure in one pose,
// turned by equal steps.
#pragma once

#include <vector>

#include "model/stages.h"

namespace artisketch::quality {

struct BaselineOptions {
  std::vector<int> frames = {1, 2, 3, 4};
  std::vector<double> baselines = {15, 30, 60, 90, 180};  // degrees that the drawings span
  int figures = 4;
  double wobble = 0;  // pixels
  PipelineOptions pipeline;
};

struct BaselineCell {
  double novel = 0;    // silhouettes in poses and from sides that nobody drew
  double volume = 0;   // intersection over union in the rest pose
  double depth = 0;    // of the parts, as the first drawing sees it, over the truth's: the mean
  double deepest = 0;  // and the largest
};

// The mean over the cast.
BaselineCell baseline_cell(int frames, double baseline, const BaselineOptions& options);

// The table of all cells, printed as it grows.
void print_baselines(const BaselineOptions& options);

}  // namespace artisketch::quality
