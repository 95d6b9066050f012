// Sketch documents as JSON (FORMAT.md).
//
// Where FORMAT.md is silent: lengths stay within ±1e9 units and pixels within ±1e6, so that squares
// and glTF's single precision hold them; a rotation may be off unit length by 1e-3 (it is kept as
// given within 1e-6, else normalised); a point that repeats the one before it is dropped; at most
// 1000 joints, 1000 frames, 10 000 animation keys and 20 000 points in a contour.
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "document/document.h"

namespace artisketch {

// Limits that keep a hostile document affordable, far above what a character needs.
inline constexpr int kMostJoints = 1000, kMostFrames = 1000;
inline constexpr int kFewestCells = 16, kMostCells = 512;  // of a grid

// Reads what FORMAT.md says a document is, half drawn as it may be (whether it can be worked on
// asks files/document_check); all faults come in one Error, one line each: "FILE: JSON-POINTER:
// what is wrong; what would be right", the first hundred of them. `file` is used in those lines
// only.
Result<Document> parse_document(std::string_view json, const std::string& file);
Result<Document> read_document(const std::string& path);

// Unknown fields are kept, after the known ones; coordinates survive a round trip bit for bit; a
// text that this function made comes back the same. Fields at their defaults are left out.
std::string document_text(const Document& document);
Result<Done> write_document(const std::string& path, const Document& document);

}  // namespace artisketch
