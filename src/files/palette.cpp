#include "files/palette.h"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "base/oklab.h"
#include "base/srgb.h"

namespace artisketch {
namespace {

constexpr std::size_t kMostColours = 48;
constexpr float kNear = 0.045f;         // OKLab: side by side hardly told apart
constexpr double kLeastShare = 0.0003;  // of all pixels, that a colour must have

Rgb colour_at(const std::uint8_t* p) {
  return Rgb(p[0]) << 16 | Rgb(p[1]) << 8 | p[2];
}

Eigen::Vector3f lab_of(Rgb c) {
  const auto part = [&](int shift) { return to_linear(float(c >> shift & 255) / 255); };
  return oklab(part(16), part(8), part(0));
}

// Looks colours up in a palette; the same few come again and again.
class Nearest {
 public:
  explicit Nearest(const std::vector<Rgb>& palette) {
    for (const Rgb c : palette) labs_.push_back(lab_of(c));
  }
  int operator()(Rgb colour) {
    const auto [known, is_new] = known_.try_emplace(colour, 0);
    if (!is_new) return known->second;
    const Eigen::Vector3f lab = lab_of(colour);
    float least = 1e9f;
    for (std::size_t i = 0; i < labs_.size(); ++i)
      if (const float d = (labs_[i] - lab).squaredNorm(); d < least)
        least = d, known->second = int(i);
    return known->second;
  }

 private:
  std::vector<Eigen::Vector3f> labs_;
  std::unordered_map<Rgb, int> known_;
};

Image enlarged(const Image& small, int scale) {
  Image large(small.width * scale, small.height * scale, 0);
  for (int y = 0; y < large.height; ++y)
    for (int x = 0; x < large.width; ++x)
      std::copy_n(small.at(x / scale, y / scale), 4, large.at(x, y));
  return large;
}

// The pixels that each `fine` by `fine` come to, by what paint(block, pixel) makes of the opaque
// ones.
template <class Paint>
Image by_blocks(const Image& drawn, int fine, Paint paint) {
  Image small(drawn.width / fine, drawn.height / fine, 0);
  std::vector<const std::uint8_t*> block;
  for (int y = 0; y < small.height; ++y)
    for (int x = 0; x < small.width; ++x) {
      block.clear();
      for (int s = 0; s < fine * fine; ++s)
        if (const std::uint8_t* p = drawn.at(x * fine + s % fine, y * fine + s / fine); p[3] >= 128)
          block.push_back(p);
      if (2 * int(block.size()) < fine * fine) continue;
      std::uint8_t* pixel = small.at(x, y);
      pixel[3] = 255;
      paint(block, pixel);
    }
  return small;
}

void paint_mean(const std::vector<const std::uint8_t*>& block, std::uint8_t* pixel) {
  for (int c = 0; c < 3; ++c) {
    int sum = 0;
    for (const std::uint8_t* p : block) sum += p[c];
    pixel[c] = std::uint8_t(sum / int(block.size()));
  }
}

}  // namespace

std::vector<Rgb> palette_of(const Image& image) {
  std::map<Rgb, long> count;
  long all = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    if (image.rgba[i + 3] == 255) ++count[colour_at(&image.rgba[i])], ++all;
  std::vector<std::pair<long, Rgb>> common;
  for (const auto& [colour, n] : count) common.emplace_back(-n, colour);
  std::sort(common.begin(), common.end());
  std::vector<Rgb> palette;
  std::vector<Eigen::Vector3f> labs;
  for (const auto& [minus, colour] : common) {
    if (palette.size() == kMostColours || double(-minus) < kLeastShare * double(all)) break;
    const Eigen::Vector3f lab = lab_of(colour);
    if (std::any_of(labs.begin(), labs.end(),
                    [&](const Eigen::Vector3f& other) { return (other - lab).norm() < kNear; }))
      continue;
    palette.push_back(colour);
    labs.push_back(lab);
  }
  return palette;
}

Image in_pixels(const Image& drawn, int fine, int scale, const std::vector<Rgb>& palette) {
  if (palette.empty()) return in_pixels(drawn, fine, scale);
  Nearest nearest(palette);
  std::vector<int> votes(palette.size());
  const auto paint = [&](const std::vector<const std::uint8_t*>& block, std::uint8_t* pixel) {
    std::fill(votes.begin(), votes.end(), 0);
    for (const std::uint8_t* p : block) ++votes[std::size_t(nearest(colour_at(p)))];
    const Rgb c =
        palette[std::size_t(std::max_element(votes.begin(), votes.end()) - votes.begin())];
    pixel[0] = std::uint8_t(c >> 16), pixel[1] = std::uint8_t(c >> 8), pixel[2] = std::uint8_t(c);
  };
  return enlarged(by_blocks(drawn, fine, paint), scale);
}

Image in_pixels(const Image& drawn, int fine, int scale) {
  return enlarged(by_blocks(drawn, fine, paint_mean), scale);
}

}  // namespace artisketch
