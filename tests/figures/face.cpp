#include "figures/face.h"

namespace artisketch::figures {

std::vector<Blob> painted_eye(const Vec3& centre, int side, double size, unsigned iris,
                              unsigned lash) {
  constexpr unsigned kWhite = 0xfffdf6;
  const auto spot = [&](double x, double y, double wide, double high, double deep, unsigned rgb) {
    return ellipsoid(centre + size * Vec3(x, y, 0), {size * wide, size * high, deep}).in(rgb);
  };
  // Each reaches farther out of the head than the one below it.
  return {spot(0, 0.006, 0.052, 0.071, 0.08, lash), spot(0, -0.003, 0.045, 0.062, 0.09, kWhite),
          spot(-0.008 * side, -0.004, 0.034, 0.052, 0.1, iris),
          spot(-0.008 * side, -0.002, 0.022, 0.036, 0.11, lash),
          spot(0.008, 0.024, 0.013, 0.015, 0.12, kWhite)};
}

}  // namespace artisketch::figures
