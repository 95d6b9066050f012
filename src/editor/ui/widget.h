#pragma once

#include <string>

namespace artisketch {

// A control of the frame drawn last, in points from the window's top left. Tests click by label;
// the page mirrors the list for screen readers.
struct Widget {
  std::string label;  // "Reconstruct"; unique within a frame
  float x = 0, y = 0, width = 0, height = 0;
  bool enabled = true;
  bool active = false;  // pressed in, ticked or chosen
};

}  // namespace artisketch
