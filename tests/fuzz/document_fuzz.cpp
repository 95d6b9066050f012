// Any bytes at all are a document or faults in words, and a document survives being written.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "files/document_file.h"

using namespace artisketch;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const Result<Document> document = parse_document(bytes, "fuzz");
  if (!document) {
    if (document.error().faults.empty()) std::abort();
    return 0;
  }
  const std::string text = document_text(*document);
  const Result<Document> again = parse_document(text, "again");
  if (!again || document_text(*again) != text) std::abort();
  return 0;
}
