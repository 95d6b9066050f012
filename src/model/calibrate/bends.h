// Parts that bend from drawing to drawing: no rigid part is what they show.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/stages.h"

namespace artisketch {

struct Bend {
  int joint = 0;
  int bent = 0, straighter = 0;  // frames
  double angle = 0;              // radians, between what the two show
};

// The parts whose outlines, at their poses, bend by much more in some drawings than one rigid bent
// shape seen from those sides would, in the order given: long ones alone, for the others have no
// middle line to speak of.
std::vector<Bend> bends_of(std::span<const Part> parts);

// What to do about it, in words.
std::string bend_words(const Document& document, const Bend& bend);

}  // namespace artisketch
