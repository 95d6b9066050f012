// Which ArtiSketch this is.
#pragma once

#include <string>

namespace artisketch {

// "ArtiSketch 0.2.0 (commit 0123456789)"; without the commit where its sources didn't say. Nothing
// that is written into models: the same document gives the same bytes whichever commit made them.
std::string version_words();

}  // namespace artisketch
