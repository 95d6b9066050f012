// Thousands of damaged files: whatever is read is whole, whatever is refused is refused in words.
// The fuzzers beside this file look further, for as long as one lets them.
#include <gtest/gtest.h>

#include "files/bytes.h"
#include "files/document_file.h"
#include "files/gltf.h"
#include "files/gltf_compress.h"
#include "files/sample_models.h"
#include "fuzz/mutations.h"

namespace artisketch {
namespace {

TEST(Mutation, DamagedDocumentsAreReadWholeOrRefusedInWords) {
  Mutator mutator(1);
  int read = 0, refused = 0;
  for (const char* name : {"version1.artisketch", "version1-perspective.artisketch"}) {
    const std::string good = *read_file(ARTISKETCH_SOURCE_DIR "/tests/golden/" + std::string(name));
    for (int i = 0; i < 2000; ++i) {
      const std::string bytes = i % 2 ? mutator.damaged(good) : mutator.scratched(good);
      const Result<Document> document = parse_document(bytes, "F");
      if (!document) {
        ++refused;
        ASSERT_FALSE(document.error().faults.empty()) << bytes;
        for (const std::string& fault : document.error().faults)
          ASSERT_TRUE(fault.rfind("F: ", 0) == 0 && fault.find('\n') == fault.npos) << fault;
        continue;
      }
      ++read;
      const std::string text = document_text(*document);
      const Result<Document> again = parse_document(text, "F");
      ASSERT_TRUE(again) << bytes << "\n" << text << "\n" << again.error().text();
      ASSERT_EQ(document_text(*again), text) << bytes;
    }
  }
  // Both outcomes are there to be tested.
  EXPECT_GT(read, 200);
  EXPECT_GT(refused, 2000);
}

TEST(Mutation, DamagedModelsAreReadWholeOrRefusedInWords) {
  Mutator mutator(2);
  int read = 0, refused = 0;
  std::vector<std::pair<std::string, std::string>> files;
  for (const auto& [name, model] : small_models()) {
    files.emplace_back(name, *glb_bytes(model));
    files.emplace_back(name + " packed", compressed_glb(files.back().second));
  }
  for (const auto& [name, good] : files) {
    const std::size_t bin = good.find(std::string_view("BIN\0", 4)) + 4;
    for (int i = 0; i < 1500; ++i) {
      // Mostly the JSON, which says what the rest means.
      std::string bytes = i % 5 == 0   ? mutator.damaged(good)
                          : i % 5 == 1 ? mutator.scratched(good)
                                       : mutator.scratched(good.substr(0, bin)) + good.substr(bin);
      const Result<Model> result = read_glb(bytes, name);
      if (!result) {
        ++refused;
        ASSERT_EQ(result.error().text().rfind(name + ": ", 0), 0u);
        continue;
      }
      ++read;
      const Result<std::string> again = glb_bytes(*result);
      ASSERT_TRUE(again || !again.error().faults.empty());
    }
  }
  EXPECT_GT(read, 100);
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace artisketch
