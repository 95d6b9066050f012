// How far a part bulges between its rims, for the document's `fatness` to scale.
#pragma once

#include <vector>

#include "model/run.h"

namespace artisketch {

// At a point as far from the rims as ρ, the height over the chords between them that a ball of the
// part's radius R would have: ρ²/2R near the rims, where it must not disturb the silhouettes, and
// no more than the 0.3 R of a ball with two rims.
class Bulge {
 public:
  // rims: polylines that end where they begin.
  Bulge(const Curves& rims, double radius);
  double height(const Vec3& p) const;  // ≥ 0, units

 private:
  struct Piece {
    Vec3 a, way;
    double per_length2;
  };
  std::vector<Piece> pieces_;
  double radius_;
};

}  // namespace artisketch
