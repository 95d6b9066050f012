#include "model/texture/drawn_details.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "model/texture/unlikeness.h"

namespace artisketch {
namespace {

constexpr float kOneStretch = 0.2f;  // colours of one stretch
constexpr float kStandsOut = 0.3f;   // from the ground round it
constexpr double kSmallest = 0.05;   // of the largest detail; what is smaller is grain
constexpr double kGap = 0.06;        // of the largest detail: soft edges between what is one

class Finder {
 public:
  // stretch: filled, of each pixel
  Finder(const Sketch& sketch, double largest, double step, std::vector<int>& stretch)
      : sketch_(sketch), largest_(largest), step_(step), stretch_(stretch) {
    stretch.assign(sketch.state.size(), -1);
  }
  std::vector<DrawnDetail> details() {
    find_stretches();
    // What is small and hangs together is one: an eye's white, its iris and its ring. So may an
    // eye, a brow and the line of the hair: where all is too large, each is one by itself.
    std::vector<DrawnDetail> out;
    const double most = std::max(sketch_.width, sketch_.height);
    const int gap = std::max(1, int(std::min(kGap * largest_, most) + 0.5));
    std::vector<std::uint8_t> done(cores_.size(), 0);
    for (std::size_t seed = 0; seed < cores_.size(); ++seed) {
      if (done[seed]) continue;
      std::vector<std::size_t> together = {seed};
      std::vector<std::size_t> all;
      done[seed] = 1;
      for (std::size_t head = 0; head < together.size(); ++head) {
        const auto round = grown_within(cores_[together[head]].pixels, gap);
        for (const std::size_t p : round) {
          const int other = core_at(p);
          if (other < 0 || done[other]) continue;
          done[other] = 1;
          together.push_back(std::size_t(other));
        }
        all.insert(all.end(), round.begin(), round.end());
      }
      std::sort(all.begin(), all.end());
      all.erase(std::unique(all.begin(), all.end()), all.end());
      if (extent(all) <= largest_)
        add(std::move(all), out);
      else
        for (const std::size_t one : together) add(grown_within(cores_[one].pixels, gap), out);
    }
    return out;
  }

 private:
  // A stretch that may be a detail, or of one. Slivers are the soft edges of something else.
  struct Core {
    int stretch = 0;
    std::vector<std::size_t> pixels;
  };
  bool shown(std::size_t p) const {
    return sketch_.state[p] != Sketch::nothing && sketch_.joint[p] >= 0;
  }
  void find_stretches() {
    std::vector<std::size_t> pixels;
    for (std::size_t seed = 0; seed < stretch_.size(); ++seed) {
      if (!shown(seed) || stretch_[seed] >= 0) continue;
      const int id = int(small_.size());
      pixels = {seed};
      stretch_[seed] = id;
      Rgb sum = Rgb::Zero();
      for (std::size_t head = 0; head < pixels.size(); ++head) {
        sum += rgb_of(sketch_.colour[pixels[head]]);
        const Rgb mean = sum / float(head + 1);
        each_beside(sketch_, pixels[head], [&](std::size_t q) {
          if (!shown(q) || stretch_[q] >= 0) return;
          const Rgb colour = rgb_of(sketch_.colour[q]);
          if ((colour - mean).squaredNorm() >= kOneStretch * kOneStretch &&
              unlikeness(colour, mean) >= kOneStretch)
            return;
          stretch_[q] = id;
          pixels.push_back(q);
        });
      }
      const double size = extent(pixels);
      small_.push_back(size <= largest_);
      if (size <= largest_ && size >= kSmallest * largest_ && is_thick(pixels))
        cores_.push_back({id, pixels});
    }
  }
  // Whether some pixel has all those round it with it.
  bool is_thick(const std::vector<std::size_t>& pixels) const {
    const std::size_t width = sketch_.width;
    return std::any_of(pixels.begin(), pixels.end(), [&](std::size_t p) {
      if (p < width + 1 || p + width + 1 >= stretch_.size()) return false;
      for (const std::size_t row : {p - width, p, p + width})
        for (const std::size_t q : {row - 1, row, row + 1})
          if (stretch_[q] != stretch_[p]) return false;
      return true;
    });
  }
  // Which core a pixel is of, −1: none.
  int core_at(std::size_t p) const {
    const auto found =
        std::lower_bound(cores_.begin(), cores_.end(), stretch_[p],
                         [](const Core& core, int stretch) { return core.stretch < stretch; });
    return found != cores_.end() && found->stretch == stretch_[p] ? int(found - cores_.begin())
                                                                  : -1;
  }
  double extent(const std::vector<std::size_t>& pixels) const {
    Box2 box;
    for (const std::size_t p : pixels) box.extend(place(p));
    return box.sizes().norm();
  }
  Vec2 place(std::size_t p) const {
    return Vec2(double(p % sketch_.width) + 0.5, double(p / sketch_.width) + 0.5);
  }
  // With what isn't ground within so many steps.
  std::vector<std::size_t> grown_within(const std::vector<std::size_t>& pixels, int steps) {
    std::vector<std::size_t> out = grown(sketch_, pixels, steps);
    std::erase_if(out, [&](std::size_t p) { return stretch_[p] < 0 || !small_[stretch_[p]]; });
    return out;
  }
  // pixels: ascending
  void add(std::vector<std::size_t> pixels, std::vector<DrawnDetail>& out) {
    DrawnDetail detail;
    std::map<int, int> joints;
    std::vector<Rgb> own;  // a soft edge has a colour that isn't its own
    for (const std::size_t p : pixels) {
      detail.middle += place(p);
      if (core_at(p) >= 0) own.push_back(rgb_of(sketch_.colour[p]));
      ++joints[sketch_.joint[p]];
    }
    detail.middle /= double(pixels.size());
    for (const Rgb& colour : own) detail.colour += colour / float(own.size());
    detail.joint = std::max_element(joints.begin(), joints.end(), [](const auto& a, const auto& b) {
                     return a.second < b.second;
                   })->first;
    for (const std::size_t p : pixels)
      each_beside(sketch_, p, [&](std::size_t q) {
        if (!(shown(q) && std::abs(sketch_.depth[q] - sketch_.depth[p]) <= step_) &&
            !std::binary_search(pixels.begin(), pixels.end(), q))
          detail.whole = false;
      });
    // The ground lies beyond the soft edge.
    Rgb ground = Rgb::Zero();
    int round = 0;
    const std::vector<std::size_t> near = grown(sketch_, pixels, 1);
    for (const std::size_t p : grown(sketch_, near, 2))
      if (shown(p) && !std::binary_search(near.begin(), near.end(), p)) {
        ground += rgb_of(sketch_.colour[p]);
        ++round;
      }
    if (round == 0) return;
    // Pixel by pixel: an eye's white and its pupil are together much like skin.
    float unlike = 0;
    for (const Rgb& colour : own) unlike += unlikeness(colour, ground / float(round));
    if (unlike < kStandsOut * float(own.size())) return;
    detail.pixels = std::move(pixels);
    out.push_back(std::move(detail));
  }

  const Sketch& sketch_;
  double largest_, step_;
  std::vector<int>& stretch_;        // of each pixel; −1: none
  std::vector<std::uint8_t> small_;  // by stretch
  std::vector<Core> cores_;          // by stretch, ascending
};

}  // namespace

std::vector<DrawnDetail> drawn_details(const Sketch& sketch, double largest, double step,
                                       std::vector<int>& label) {
  std::vector<DrawnDetail> details = Finder(sketch, largest, step, label).details();
  std::fill(label.begin(), label.end(), -1);
  for (std::size_t i = 0; i < details.size(); ++i)
    for (const std::size_t p : details[i].pixels) label[p] = int(i);
  return details;
}

std::vector<std::size_t> grown(const Sketch& sketch, const std::vector<std::size_t>& pixels,
                               int steps) {
  const int w = sketch.width, h = sketch.height;
  int left = w, top = h, right = 0, bottom = 0;  // the last ones left out
  for (const std::size_t p : pixels) {
    const int x = int(p % w), y = int(p / w);
    left = std::min(left, std::max(x - steps, 0));
    top = std::min(top, std::max(y - steps, 0));
    right = std::max(right, std::min(x + steps + 1, w));
    bottom = std::max(bottom, std::min(y + steps + 1, h));
  }
  std::vector<std::size_t> out, front = pixels, next;
  std::vector<std::uint8_t> in(std::size_t(std::max(right - left, 0)) * std::max(bottom - top, 0),
                               0);
  const auto mark = [&](std::size_t p) -> std::uint8_t& {
    return in[(p / w - top) * (right - left) + (p % w - left)];
  };
  for (const std::size_t p : pixels) mark(p) = 1;
  for (int step = 0; step < steps; ++step) {
    next.clear();
    for (const std::size_t p : front)
      each_beside(sketch, p, [&](std::size_t q) {
        if (mark(q)) return;
        mark(q) = 1;
        next.push_back(q);
      });
    std::swap(front, next);
  }
  for (int y = top; y < bottom; ++y)
    for (int x = left; x < right; ++x)
      if (const std::size_t p = std::size_t(y) * w + x; mark(p)) out.push_back(p);
  return out;
}

}  // namespace artisketch
