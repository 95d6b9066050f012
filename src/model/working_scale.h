// What the model's stages mean in pixels they mean of figures drawn some hundred pixels high: a
// smaller one is worked on as if it had been drawn larger.
#pragma once

#include "model/stages.h"

namespace artisketch {

// How many times a document's drawings are enlarged for the work, a power of two: until the largest
// figure, by its outlines, is kWorkingSize pixels wide or high. 1 where nothing is outlined.
int working_scale(const Document& document);
inline constexpr double kWorkingSize = 300;
inline constexpr int kMostEnlarged = 16;

// The document, a part's views or a picture, as if drawn `times` times as large: the same poses and
// units, more pixels. Pictures by repeating pixels: their edges stay as sharp as they are.
Document enlarged(Document document, int times);
Part enlarged(Part part, int times);  // mirrors as they are
Image enlarged(const Image& picture, int times);

}  // namespace artisketch
