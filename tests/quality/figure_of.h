// The figure that a seed stands for in tables: every third a quadruped, every third a robot.
#pragma once

#include "figures.h"

namespace artisketch::figures {

inline Figure figure_of(int seed) {
  switch (seed % 3) {
    case 1:
      return quadruped(seed);
    case 2:
      return robot(seed);
    default:
      return human(seed);
  }
}

}  // namespace artisketch::figures
