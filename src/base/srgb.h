// The sRGB transfer function (IEC 61966-2-1): between what images store and amounts of light.
#pragma once

#include <cmath>

namespace artisketch {

// Both take and give 0 … 1.
inline float to_linear(float s) {
  return s <= 0.04045f ? s / 12.92f : std::pow((s + 0.055f) / 1.055f, 2.4f);
}
inline float to_srgb(float l) {
  return l <= 0.0031308f ? 12.92f * l : 1.055f * std::pow(l, 1 / 2.4f) - 0.055f;
}

}  // namespace artisketch
