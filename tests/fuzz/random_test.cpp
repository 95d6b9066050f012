// What holds of every document, at random ones: the fuzzers beside this file look further, for as
// long as one lets them.
#include <optional>

#include <gtest/gtest.h>

#include "document/history.h"
#include "files/document_file.h"
#include "files/gltf.h"
#include "fuzz/random_bytes.h"
#include "fuzz/random_document.h"
#include "fuzz/random_edits.h"
#include "model/stages.h"

namespace artisketch {
namespace {

// Nothing where a contour has too few points for a document.
std::optional<Document> random_document(fuzz::RandomBytes& bytes) {
  Result<Document> document = parse_document(document_text(fuzz::document_from(bytes)), "random");
  if (!document) return std::nullopt;
  return std::move(*document);
}

TEST(AnyDocument, EndsInAValidModelOrAnErrorInWords) {
  int models = 0;
  for (int seed = 0; seed < 8; ++seed) {
    SCOPED_TRACE(seed);
    fuzz::RandomBytes bytes(seed);
    PipelineOptions options;
    options.method = seed % 4 ? Method::rays : Method::paper;
    options.calibrate = seed % 2;
    options.grid = 16;
    options.triangles = 500;
    const std::optional<Document> document = random_document(bytes);
    if (!document) continue;
    artisketch::Run run;
    const Result<Reconstruction> result = reconstruct(*document, options, run);
    if (!result) {
      ASSERT_FALSE(result.error().text().empty());
      continue;
    }
    ++models;
    EXPECT_TRUE(topology(result->model.mesh).closed());
    const Result<std::string> glb = glb_bytes(result->model);
    ASSERT_TRUE(glb);
    const Result<Model> read = read_glb(*glb, "x");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->mesh.F.rows(), result->model.mesh.F.rows());
  }
  EXPECT_GT(models, 3);
}

TEST(AnyDocument, ComesBackByteForByte) {
  for (int seed = 0; seed < 200; ++seed) {
    SCOPED_TRACE(seed);
    fuzz::RandomBytes bytes(seed);
    const std::optional<Document> document = random_document(bytes);
    if (!document) continue;
    const std::string text = document_text(*document);
    const Result<Document> again = parse_document(text, "again");
    ASSERT_TRUE(again) << again.error().text();
    ASSERT_EQ(document_text(*again), text);
  }
}

TEST(AnyEdits, CanBeSavedAndUndone) {
  for (int seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    fuzz::RandomBytes bytes(seed);
    const std::optional<Document> document = random_document(bytes);
    if (!document) continue;
    History history(*document);
    std::vector<std::string> texts{document_text(history.now())};
    for (int step = 0; step < 30; ++step) {
      history.commit("edit", fuzz::edited(history.now(), bytes));
      texts.push_back(document_text(history.now()));
      const Result<Document> again = parse_document(texts.back(), "again");
      ASSERT_TRUE(again) << again.error().text();
      ASSERT_EQ(document_text(*again), texts.back());
    }
    for (std::size_t step = texts.size(); step-- > 0;) {
      ASSERT_EQ(document_text(history.now()), texts[step]);
      if (history.can_undo()) history.undo();
    }
  }
}

}  // namespace
}  // namespace artisketch
