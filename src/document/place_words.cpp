#include "document/place_words.h"

#include "document/edit.h"

namespace artisketch {
namespace {

void replace_all(std::string& words, const std::string& from, const std::string& to) {
  for (std::size_t at = words.find(from); at != words.npos; at = words.find(from, at + to.size()))
    words.replace(at, from.size(), to);
}

}  // namespace

std::string frame_words(const Document& document, int frame) {
  return "frame " + std::to_string(frame + 1) + " '" + document.frames[frame].name + "'";
}

PlacedWords placed_words(const Document& document, const std::string& words) {
  PlacedWords placed{words};
  const auto each = [&](int count, int& named, const auto& from, const auto& to) {
    std::size_t nearest = words.npos;
    for (int i = 0; i < count; ++i) {
      const std::size_t at = words.find(from(i));
      if (at < nearest) nearest = at, named = i;
      replace_all(placed.words, from(i), to(i));
    }
  };
  each(
      int(document.frames.size()), placed.frame, [&](int f) { return frame_words(document, f); },
      [&](int f) { return drawing_words(document, f); });
  each(
      document.skeleton.size(), placed.joint,
      [&](int j) { return "'" + document.skeleton.joints[j].name + "'"; },
      [&](int j) { return joint_words(document.skeleton.joints[j].name).whole(); });
  // Fields of the file, as controls or plain words.
  for (int f = 0; f < int(document.frames.size()); ++f)
    replace_all(placed.words, "frames[" + std::to_string(f) + "].scale", "Figure's size");
  for (const char* limit : {"calibration.max_rotation", "calibration.max_translation"})
    replace_all(placed.words, limit, "the document's limit");
  placed.words = capitalised(std::move(placed.words));
  return placed;
}

}  // namespace artisketch
