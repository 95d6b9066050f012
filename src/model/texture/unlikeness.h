// How unlike two colours are, whatever light falls on them.
#pragma once

#include <algorithm>

#include "model/texture/drawn_surface.h"

namespace artisketch {

// Their distance (0 … √3) where one may be the other in shade.
inline float unlikeness(const Rgb& a, const Rgb& b) {
  constexpr float kShades[] = {0.85f, 0.7f};
  float least = (a - b).norm();
  for (const float shade : kShades)
    least = std::min({least, (shade * a - b).norm(), (a - shade * b).norm()});
  return least;
}

}  // namespace artisketch
