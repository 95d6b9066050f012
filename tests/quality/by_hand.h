// What the pipeline makes of poses as a hand gives them: joints where they are seen, bones turned
// about themselves by guess, on a skeleton whose bones are a little too long or too short.
#pragma once

#include <utility>
#include <vector>

#include "figures/measure.h"
#include "figures/posed_by_hand.h"
#include "model/stages.h"

namespace artisketch::quality {

struct ByHandOptions {
  std::vector<int> frames = {2, 3, 4};
  // Degrees of twist, and shares by which bones are too long or too short.
  std::vector<std::pair<double, double>> hands = {{0, 0}, {20, 0.05}, {40, 0.05}};
  std::vector<double> part_sizes = {0, 0.1};  // shares, by which drawings disagree
  int figures = 6;
  PipelineOptions pipeline;
};

// Silhouettes in poses and from sides that nobody drew, and volume in the rest pose: with
// calibration, and without.
struct ByHandCell {
  figures::PoseErrors before, after;  // means over the frames after the first
  double novel[2] = {0, 0}, volume[2] = {0, 0};
};

// Means over the cast. part_size: see figures::Noise.
ByHandCell by_hand_cell(int frames, const figures::Hand& hand, double part_size, int figures,
                        const PipelineOptions& pipeline);

// The table of all cells, printed as it grows.
void print_by_hand(const ByHandOptions& options);

}  // namespace artisketch::quality
