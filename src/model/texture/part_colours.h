// Which colours are whose: told by the pixels that lie inside the outline of one part alone.
#pragma once

#include "base/raster.h"
#include "model/texture/drawn_surface.h"

namespace artisketch {

// The pixels inside one joint's outlines in a frame.
class PartMask {
 public:
  PartMask(int width, int height) : mask_(width, height) {}
  void show(const Frame& frame, int joint);  // in place of what it showed before
  bool in(std::size_t pixel) const { return mask_.in[pixel] != 0; }
  int left() const { return left_; }  // all lie in these columns and rows, the last ones left out
  int right() const { return right_; }
  int top() const { return top_; }
  int bottom() const { return bottom_; }

 private:
  Mask mask_;
  int left_ = 0, right_ = 0, top_ = 0, bottom_ = 0;
};

// Joints with a closed outline in a frame, ascending.
std::vector<int> outlined_joints(const Frame& frame);

class PartColours {
 public:
  explicit PartColours(const Skeleton& skeleton);
  // Learns from a drawing of its frame's size.
  void learn(const Frame& frame, const Image& picture);
  // Whether a colour inside the outlines of both is `other`'s, and none of a triangle's own:
  // common there, and hardly ever seen in any of its holders' parts or their mirror images. False
  // where too little is known of one of them.
  bool is_foreign(const Pixel& colour, const Holders& holders, int other) const;

 private:
  static constexpr int kBins = 16;  // a channel
  double share(int twin, const Pixel& colour) const;
  std::vector<int> twin_;  // of each joint, itself and its mirror image as one
  std::vector<std::vector<std::uint32_t>> count_;  // by twin, then by colour; empty: none
  std::vector<std::uint32_t> all_;                 // by twin
};

}  // namespace artisketch
