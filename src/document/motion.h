// A recorded motion: another skeleton than the document's, and its poses at even steps of time.
#pragma once

#include <string>
#include <vector>

#include "document/skeleton.h"

namespace artisketch {

struct Motion {
  std::string name;
  Skeleton skeleton;        // ends of chains are joints too, their names empty
  double step = 0;          // seconds from one pose to the next, > 0
  std::vector<Pose> poses;  // one or more
};

}  // namespace artisketch
