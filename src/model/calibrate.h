// What the calibration methods share.
#pragma once

#include <vector>

#include "model/stages.h"

namespace artisketch {

// The document's limits, with our defaults where it sets none.
struct PoseLimits {
  double max_rotation = 0;     // radians from the user's local rotation
  double max_translation = 0;  // units from the user's root position
  std::vector<char> free;      // per joint: its rotation may change
};
PoseLimits pose_limits(const Document& document);

}  // namespace artisketch
