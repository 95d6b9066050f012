// How well a model will hold from sides that nobody drew. How well it fits the drawings doesn't say
// that: what was drawn can always be met, and turning parts until it is may make all else worse.
#pragma once

#include <string>
#include <vector>

#include "document/document.h"

namespace artisketch {

enum class Trust { good, doubtful, guess };
const char* trust_word(Trust trust);  // "good", "doubtful", "guess"

struct PartTrust {
  int joint = 0;
  Trust trust = Trust::guess;
  // Radians, 0 … 90°: the widest angle between lines along which the part is seen. Opposite views
  // lie on one line: both show the same outline, and neither tells how deep it is.
  double spread = 0;
  // How far views are off that are predicted from the others, in the part's sizes (the root of its
  // largest outline's area): 0 where they agree exactly, or there is nothing to predict from.
  double disagreement = 0;
};

struct UnseenSides {
  Trust whole = Trust::guess;
  std::vector<PartTrust> parts;  // drawn ones, in joint order
};

// At the document's poses; the calibrated ones, where they are what the model was made at.
UnseenSides unseen_sides(const Document& document);

// "from sides not drawn: doubtful (good: 'head'; guess: 'arm.L', 'arm.R')".
std::string unseen_sides_words(const Document& document, const UnseenSides& sides);

}  // namespace artisketch
