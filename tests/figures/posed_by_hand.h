// The poses that a hand gives: every joint where the drawing shows it, and what no picture shows of
// a bone, how far it turns about itself, wrong.
#pragma once

#include <cstdint>

#include "figures.h"

namespace artisketch::figures {

struct Hand {
  double bone_error = 0;      // share by which bones are taken for longer or shorter, at most
  double place_error_px = 0;  // by which joints lie beside where they are seen, each way
  double twist_degrees = 0;   // each bone about itself, to either side
};

// The document at other poses, on a skeleton of bones a little longer or shorter, as dragging
// joints in the picture leaves them: a bone leans out of the picture, to the true side, by as much
// as its length and its image tell. The first frame is where the skeleton was made: no twists
// there.
Document posed_by_hand(const Document& truth, const Hand& hand, std::uint64_t seed);

}  // namespace artisketch::figures
