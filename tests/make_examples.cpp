// artisketch_examples FOLDER [NAME …]: writes the example documents and their drawings, as assets
// has them.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <set>

#include "figures/examples.h"
#include "files/bytes.h"
#include "files/document_file.h"

using namespace artisketch;

namespace {

bool written(const Result<Done>& result) {
  if (!result) std::fprintf(stderr, "%s\n", result.error().text().c_str());
  return result.ok();
}

bool write_example(const figures::Example& example, const std::string& folder) {
  const std::string place = folder + "/" + example.folder + "/" + example.name;
  std::filesystem::create_directories(place);
  if (!written(write_document(place + "/" + example.name + ".artisketch", example.sketches.given)))
    return false;
  const Document& truth = example.sketches.truth;
  for (int f = 0; f < int(truth.frames.size()); ++f) {
    const Frame& frame = truth.frames[f];
    const Image image = figures::ink_drawing(example.figure, frame.pose, frame_camera(truth, f),
                                             frame.width, frame.height, example.ink);
    if (!written(write_file(place + "/" + frame.image, png_bytes(image)))) return false;
  }
  return true;
}

}  // namespace

int main(int count, char** words) {
  if (count < 2) {
    std::fprintf(stderr, "usage: artisketch_examples FOLDER [NAME ...]\n");
    return 2;
  }
  const std::set<std::string> wanted(words + 2, words + count);
  for (const std::string& name : figures::example_names())
    if (wanted.empty() || wanted.count(name))
      if (!write_example(figures::example(name), words[1])) return 3;
  return 0;
}
