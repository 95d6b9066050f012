// Where the visual hull holds a smooth surface back.
#pragma once

#include <vector>

#include "base/grid.h"

namespace artisketch {

// Points of the hull's surface that lie inside another, where that bulges out of the hull; none
// where it hardly does. The hull would cut it off there along a crease. Through these points too it
// comes to lie inside the hull by itself, and a tip of an outline (a tuft of hair, a nose) stays a
// tip, where the hull has a ridge right across the part. The farthest inside come first, and none
// lies near another.
//   surface, hull  signed distances in units on one grid, to first order, true near the hull
//   radius         units: of the part
std::vector<Vec3> held_back(const Grid3<float>& surface, const Grid3<float>& hull, double radius);

}  // namespace artisketch
