// The clips that a document's poses make.
#include "model/stages.h"

namespace artisketch {

// Clip `frames`: one key a second, at the poses that the reconstruction used; then the document's
// own.
std::vector<Clip> clips_of(const Document& document) {
  std::vector<Clip> clips(1);
  clips[0].name = "frames";
  for (std::size_t f = 0; f < document.frames.size(); ++f) {
    clips[0].times.push_back(double(f));
    clips[0].poses.push_back(document.frames[f].pose);
  }
  for (const Animation& animation : document.animations) {
    Clip clip{animation.name, {}, {}};
    for (const Key& key : animation.keys) {
      clip.times.push_back(key.time);
      clip.poses.push_back(key.pose);
    }
    clips.push_back(std::move(clip));
  }
  return clips;
}

}  // namespace artisketch
