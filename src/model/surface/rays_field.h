// The surface of a part as a signed distance, from its contour rays: the visual hull, trimmed to
// the smooth surface that touches every contour's rays. Measured against the paper's level set and
// bi-Laplacian it keeps the silhouettes better, is nearer to the true volume, and faster.
#pragma once

#include "model/surface/carving.h"
#include "model/surface/ray_rims.h"

namespace artisketch {

struct RaysFieldOptions {
  int cells = 100;              // along the longest side of the finest grid
  double rays_per_cell = 0.64;  // rays per view and `cells` on which rims are sought, 16 … 96;
                                // of more than three views as many as of three
  int refits = 2;               // times that the rims are sought again on the surface they gave,
                                // and that the hull may hold it back
  HermiteOptions surface;
};

// Cells from which on only the hull is carved more finely: the smooth surface that trims it has
// nothing more to show, and parts as fine as that make a skin of a million vertices.
inline constexpr int kSmoothCells = 200;

struct RaysField {
  Grid3<float> distance;  // signed, in units, near the surface to first order; a bound elsewhere;
                          // on kSmoothCells at most
  Grid3<float> fine;      // the same where more cells are asked for; empty otherwise
  std::vector<RayRim> rims;     // none where the part is seen from one direction only
  std::vector<int> rim_frames;  // the frame of each rim
  std::vector<std::string> warnings;
};

Result<RaysField> rays_field(const Part& part, const RaysFieldOptions& options, Run& run);

}  // namespace artisketch
