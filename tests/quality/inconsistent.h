// What the pipeline makes of drawings that disagree, as people's do: the same figure longer here
// and wider there, whole drawings of other sizes, poses guessed.
#pragma once

#include <vector>

#include "figures/measure.h"

namespace artisketch::quality {

struct InconsistentOptions {
  std::vector<int> frames = {2, 3, 4};
  std::vector<double> baselines = {15, 30, 60, 90, 180};  // degrees that the drawings span
  std::vector<double> errors = {10, 20};                  // degrees, of the poses
  int figures = 6;
  bool poses = false;  // calibration alone
  PipelineOptions pipeline;
};

struct InconsistentCell {
  figures::PoseErrors before, after;  // joints in pixels and angles, means
  // Silhouettes in poses and from sides that nobody drew, and volume in the rest pose: with
  // calibration, without, and from the first drawing alone.
  double novel[3] = {0, 0, 0}, volume[3] = {0, 0, 0};
};

// Means over the cast for one number of drawings, one baseline, one error.
InconsistentCell inconsistent_cell(int frames, double baseline, double error, int figures,
                                   bool poses, const PipelineOptions& pipeline);

// The table of all cells, printed as it grows.
void print_inconsistent(const InconsistentOptions& options);

}  // namespace artisketch::quality
