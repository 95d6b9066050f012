// What the program noticed about the drawings, for the person to read.
#pragma once

#include <vector>

#include "document/place_words.h"
#include "editor/session/app.h"

namespace artisketch {

// Of the poses that are proposed, where such are, else of the model; in the editor's words.
struct Note : PlacedWords {
  std::vector<PlacedWords> follow;  // of the same drawing: gone, perhaps, once this is mended
};
std::vector<Note> notes_of(const App& app);
int count_notes(const App& app);  // for every frame: no words are looked at

// Where drawings show the figure in other sizes: the drawing and the scale that makes up for it.
struct ScaleOffer {
  int frame = 0;
  double scale = 1;
};
std::vector<ScaleOffer> scale_offers(const App& app);

}  // namespace artisketch
