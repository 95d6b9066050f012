// How warnings name places in a document, and how a person is shown them.
#pragma once

#include <string>

#include "document/document.h"

namespace artisketch {

// "frame 3 'side'". Joints stand in quotes: "'upper_arm.L'".
std::string frame_words(const Document& document, int frame);

// Words as frames, joints and fields are called in the editor ("Side", "Upper arm L", "Figure's
// size"), and the first frame and joint that they name; −1: none.
struct PlacedWords {
  std::string words;
  int frame = -1, joint = -1;
};
PlacedWords placed_words(const Document& document, const std::string& words);

}  // namespace artisketch
