// Clips that come with the program: keys made for a skeleton, not recorded.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/stages.h"

namespace artisketch {

// 1 is as usual; each from 0.1 to 4.
struct ClipStyle {
  double speed = 1;   // how fast it plays
  double stride = 1;  // how far legs and arms go
  double bounce = 1;  // how much the figure goes up and down
  double weight = 1;  // how heavy it is: it sinks, sways and leans more
};

struct LibraryClip {
  const char* name;   // "walk"
  const char* about;  // in the words of a menu
};

// Those that fit: people's for two legs, animals' for four and more; standing for all.
std::vector<LibraryClip> library_clips(const Skeleton& skeleton);

// A clip of that name, 24 keys a second, in place, its feet on the ground at y = 0; the last pose
// is the first. Fails where no clip of that name fits the skeleton, naming those that do.
Result<Clip> library_clip(const Skeleton& skeleton, std::string_view name, const ClipStyle& style);

// The clip as keys of the document's, fewer of them where those between say nothing: joints turn
// less than a quarter of a degree off, the root moves less than 0.2 % of its height.
Animation animation_of(const Clip& clip);

// "walk", "walk:stride=1.2,bounce=0.5".
struct ClipWish {
  std::string name;
  ClipStyle style;
};
Result<ClipWish> clip_wish(const std::string& words);

}  // namespace artisketch
