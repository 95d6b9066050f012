// Slips of the pen, and specks in a picture that was traced.
#pragma once

#include "document/document.h"

namespace artisketch {

// Without closed contours of a pixel or two beside a larger one of the same part: taken for a hole
// it would pierce the part from front to back. Pixels are the document's: ask before it is scaled.
Document without_specks(Document document);

}  // namespace artisketch
