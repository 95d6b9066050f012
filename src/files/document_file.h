// Sketch documents as JSON (FORMAT.md).
#pragma once

#include <string>
#include <string_view>

#include "base/result.h"
#include "document/document.h"

namespace artisketch {

// Reads and checks every rule of FORMAT.md; all faults come in one Error, one line each:
// "FILE: JSON-POINTER: what is wrong; what would be right". `file` is used in those lines only.
Result<Document> parse_document(std::string_view json, const std::string& file);
Result<Document> read_document(const std::string& path);

// Unknown fields are kept; coordinates survive a round trip bit for bit.
std::string document_text(const Document& document);
Result<Done> write_document(const std::string& path, const Document& document);

}  // namespace artisketch
