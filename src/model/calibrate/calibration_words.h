// What a calibration has to say for itself.
#pragma once

#include <span>

#include "model/calibrate/calibrate.h"
#include "model/calibrate/ray_residuals.h"

namespace artisketch {

// Fills in the largest changes against the user's poses and the angles that silhouettes leave open
// at the poses found; adds warnings about limits that were reached and about parts whose drawings
// cannot agree. rays: of the document, which is enlarged `scale` times: words speak of the drawings
// as they are. after: at the poses found.
void explain(const Document& document, const RayResiduals& rays, std::span<const Coverage> after,
             double scale, Calibration& result);

}  // namespace artisketch
