#include "model/texture/part_colours.h"

#include <algorithm>
#include <set>

namespace artisketch {
namespace {

constexpr std::uint32_t kEnough = 60;  // pixels of one part alone, to know its colours by
constexpr double kRare = 0.004;        // share of a part's pixels: not its colour
constexpr double kCommon = 0.03;       // its colour

int bin_of(int value, int bins) {
  return value * bins / 256;
}

}  // namespace

void PartMask::show(const Frame& frame, int joint) {
  const std::vector<std::vector<Vec2>> polygons = closed_contours(frame, joint);
  Box2 box;
  for (const auto& polygon : polygons)
    for (const Vec2& p : polygon) box.extend(p);
  for (int y = top_; y < bottom_; ++y)
    std::fill_n(&mask_.in[std::size_t(y) * mask_.width + left_], right_ - left_, std::uint8_t(0));
  const auto clamped = [](double value, int most) {
    return int(std::clamp(value, 0.0, double(most)));
  };
  left_ = clamped(box.min().x() - 1, mask_.width);
  right_ = std::max(left_, clamped(box.max().x() + 2, mask_.width));
  top_ = clamped(box.min().y() - 1, mask_.height);
  bottom_ = std::max(top_, clamped(box.max().y() + 2, mask_.height));
  add_polygons(polygons, mask_);
}

std::vector<int> outlined_joints(const Frame& frame) {
  std::set<int> joints;
  for (const Contour& contour : frame.contours)
    if (contour.line.closed) joints.insert(contour.joint);
  return {joints.begin(), joints.end()};
}

PartColours::PartColours(const Skeleton& skeleton)
    : count_(skeleton.joints.size()), all_(skeleton.joints.size(), 0) {
  for (int j = 0; j < skeleton.size(); ++j) {
    const int mirror = skeleton.joints[j].mirror;
    twin_.push_back(mirror >= 0 ? std::min(j, mirror) : j);
  }
}

void PartColours::learn(const Frame& frame, const Image& picture) {
  constexpr int kNone = -1, kSeveral = -2;
  std::vector<int> only(std::size_t(frame.width) * frame.height, kNone);
  PartMask part(frame.width, frame.height);
  for (const int joint : outlined_joints(frame)) {
    part.show(frame, joint);
    for (int y = part.top(); y < part.bottom(); ++y)
      for (int x = part.left(); x < part.right(); ++x) {
        const std::size_t p = std::size_t(y) * frame.width + x;
        if (part.in(p)) only[p] = only[p] == kNone ? joint : kSeveral;
      }
  }
  for (std::size_t p = 0; p < only.size(); ++p) {
    const std::uint8_t* c = &picture.rgba[4 * p];
    if (only[p] < 0 || c[3] < 128) continue;
    const int twin = twin_[only[p]];
    count_[twin].resize(kBins * kBins * kBins, 0);
    const auto bin = [&](int k) { return bin_of(c[k], kBins); };
    ++count_[twin][(bin(0) * kBins + bin(1)) * kBins + bin(2)];
    ++all_[twin];
  }
}

// Of the part's pixels, those with a colour like this.
double PartColours::share(int twin, const Pixel& colour) const {
  std::uint32_t sum = 0;
  const auto range = [&](int k) {
    const int bin = bin_of(colour[k], kBins);
    return std::pair(std::max(bin - 1, 0), std::min(bin + 1, kBins - 1));
  };
  const auto [r0, r1] = range(0);
  const auto [g0, g1] = range(1);
  const auto [b0, b1] = range(2);
  for (int r = r0; r <= r1; ++r)
    for (int g = g0; g <= g1; ++g)
      for (int b = b0; b <= b1; ++b) sum += count_[twin][(r * kBins + g) * kBins + b];
  return double(sum) / all_[twin];
}

bool PartColours::is_foreign(const Pixel& colour, const Holders& holders, int other) const {
  if (holders.has(other) || all_[twin_[other]] < kEnough) return false;
  for (const int joint : holders.joints) {
    if (joint < 0) continue;
    const int twin = twin_[joint];
    if (twin == twin_[other] || all_[twin] < kEnough || share(twin, colour) >= kRare) return false;
  }
  return share(twin_[other], colour) >= kCommon;
}

}  // namespace artisketch
