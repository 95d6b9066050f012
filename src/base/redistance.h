// Distances to the zero set of a sampled field.
#pragma once

#include "base/grid.h"

namespace artisketch {

// Replaces a field, whose sign tells inside (−) from outside, by the signed distance to its zero
// set as the lines between neighbouring samples cross it, in units: to a hundredth of a cell on
// average within `band` cells of a smooth zero set, a few tenths at creases; never beyond ±band,
// which all other samples get.
void redistance(double band, Grid3<float>& field);

}  // namespace artisketch
