#include "model/surface/bulge.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace artisketch {

Bulge::Bulge(const Curves& rims, double radius) : radius_(radius) {
  for (const std::vector<Vec3>& rim : rims)
    for (std::size_t i = 0; i + 1 < rim.size(); ++i) {
      const Vec3 way = rim[i + 1] - rim[i];
      const double length2 = way.squaredNorm();
      pieces_.push_back({rim[i], way, length2 > 0 ? 1 / length2 : 0});
    }
}

double Bulge::height(const Vec3& p) const {
  double least = std::numeric_limits<double>::infinity();
  for (const Piece& piece : pieces_) {
    const Vec3 to = p - piece.a;
    const double t = std::clamp(to.dot(piece.way) * piece.per_length2, 0.0, 1.0);
    least = std::min(least, (to - t * piece.way).squaredNorm());
  }
  constexpr double kMost = 0.3;  // R (1 − cos 45°)
  return kMost * radius_ * (1 - std::exp(-least / (2 * kMost * radius_ * radius_)));
}

}  // namespace artisketch
