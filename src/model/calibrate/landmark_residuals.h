// A weaker, wider-reaching view of the same silhouettes: the centroid of each outline is about
// where its frame sees one point of the part, and that point lies about in the middle of the part's
// bone. It leads poses that are far off into the rays' reach, and says what silhouettes leave open:
// the depth at which a part sits on its bone, where just two frames show it.
#pragma once

#include "model/calibrate/ray_residuals.h"

namespace artisketch {

struct LandmarkLoss {
  double centroid = 0;  // weight of centroids' squared distances, in the outlines' sizes
  double bone = 0;      // weight of landmarks' squared distances from the bone, in parts' radii
};

// Energy of all parts' landmarks, each at its best place (which is projected out of the
// derivatives); adds to systems, where not null, as RayResiduals::evaluate does.
double landmark_energy(const RayResiduals& residuals, const Document& document,
                       const Placement& placement, const LandmarkLoss& loss,
                       MotionSystems* systems);

}  // namespace artisketch
