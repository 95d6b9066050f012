// Sequences of edits: whatever a person does can be saved and opened again, byte for byte, and be
// undone to what was there before.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include <fuzzer/FuzzedDataProvider.h>

#include "document/history.h"
#include "files/document_file.h"
#include "fuzz/random_edits.h"

using namespace artisketch;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::vector<Document> starts = {
      *read_document(ARTISKETCH_SOURCE_DIR "/tests/golden/version1.artisketch"),
      *read_document(ARTISKETCH_SOURCE_DIR "/tests/golden/version1-perspective.artisketch")};
  FuzzedDataProvider bytes(data, size);
  History history(starts[bytes.ConsumeIntegralInRange(0, 1)]);
  std::vector<std::string> texts{document_text(history.now())};
  for (int step = 0; step < 30 && bytes.remaining_bytes() > 0; ++step) {
    history.commit("edit", fuzz::edited(history.now(), bytes));
    texts.push_back(document_text(history.now()));
    const Result<Document> again = parse_document(texts.back(), "again");
    const std::string read = again ? document_text(*again) : again.error().text();
    if (read == texts.back()) continue;
    std::fprintf(stderr, "%s\nwas read as\n%s\n", texts.back().c_str(), read.c_str());
    std::abort();
  }
  for (std::size_t step = texts.size(); step-- > 0;) {
    if (document_text(history.now()) != texts[step]) std::abort();
    if (history.can_undo()) history.undo();
  }
  return 0;
}
