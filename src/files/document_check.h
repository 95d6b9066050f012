// Whether a document can be worked on. Reading asks only whether it is one: what an artist has half
// drawn is kept and opened again, with its faults.
#pragma once

#include <string>
#include <vector>

#include "base/result.h"
#include "document/document.h"

namespace artisketch {

// Closed contours go round an area once without crossing themselves; those of a part in one drawing
// don't cancel out by the even-odd rule; at least one is closed; what is drawn stands before a
// perspective camera. All faults in one Error, a line each, as parse_document's.
Result<Done> check_document(const Document& document, const std::string& file);

// Warnings: which open contours shape nothing, and where a part has no others.
std::vector<std::string> open_contour_words(const Document& document);

}  // namespace artisketch
