#include "model/texture/drawn_details.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "model/texture/unlikeness.h"

namespace artisketch {
namespace {

constexpr float kOneStretch = 0.2f;  // colours of one stretch
constexpr float kStandsOut = 0.3f;   // from the ground round it
constexpr double kGap = 0.06;        // of the largest detail: soft edges between what is one

class Finder {
 public:
  Finder(const Sketch& sketch, double largest, double step, std::vector<int>& label)
      : sketch_(sketch),
        largest_(largest),
        step_(step),
        label_(label),
        stretch_(sketch.state.size(), -1) {
    label.assign(sketch.state.size(), -1);
  }
  std::vector<DrawnDetail> details() {
    find_stretches();
    // What is small and hangs together is one: an eye's white, its iris and its ring. So may an
    // eye, a brow and the line of the hair: where all is too large, each is one by itself.
    std::vector<DrawnDetail> out;
    const int gap = std::max(1, int(kGap * largest_ + 0.5));
    std::vector<std::uint8_t> done(stretches_.size(), 0);
    for (std::size_t seed = 0; seed < stretches_.size(); ++seed) {
      if (done[seed] || !is_core(seed)) continue;
      std::vector<std::size_t> together = {seed};
      std::vector<std::size_t> all;
      done[seed] = 1;
      for (std::size_t head = 0; head < together.size(); ++head) {
        const auto round = grown_within(stretches_[together[head]], gap);
        for (const std::size_t p : round) {
          const std::size_t other = std::size_t(stretch_[p]);
          if (done[other] || !is_core(other)) continue;
          done[other] = 1;
          together.push_back(other);
        }
        all.insert(all.end(), round.begin(), round.end());
      }
      std::sort(all.begin(), all.end());
      all.erase(std::unique(all.begin(), all.end()), all.end());
      if (extent(all) <= largest_)
        add(std::move(all), out);
      else
        for (const std::size_t one : together) add(grown_within(stretches_[one], gap), out);
    }
    return out;
  }

 private:
  bool shown(std::size_t p) const {
    return sketch_.state[p] != Sketch::nothing && sketch_.joint[p] >= 0;
  }
  void find_stretches() {
    for (std::size_t seed = 0; seed < stretch_.size(); ++seed) {
      if (!shown(seed) || stretch_[seed] >= 0) continue;
      const int id = int(stretches_.size());
      std::vector<std::size_t> pixels = {seed};
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
      small_.push_back(extent(pixels) <= largest_);
      stretches_.push_back(std::move(pixels));
    }
    core_.assign(stretches_.size(), 0);
    const std::size_t width = sketch_.width;
    for (std::size_t p = width + 1; p + width + 1 < stretch_.size(); ++p) {
      if (stretch_[p] < 0 || core_[stretch_[p]]) continue;
      bool all = true;
      for (const std::size_t row : {p - width, p, p + width})
        for (const std::size_t q : {row - 1, row, row + 1}) all = all && stretch_[q] == stretch_[p];
      if (all) core_[stretch_[p]] = 1;
    }
  }
  // Slivers are the soft edges of something else.
  bool is_core(std::size_t stretch) const { return small_[stretch] && core_[stretch]; }
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
  void add(std::vector<std::size_t> pixels, std::vector<DrawnDetail>& out) {
    const int id = int(out.size());
    DrawnDetail detail;
    std::map<int, int> joints;
    int own = 0;
    for (const std::size_t p : pixels) {
      label_[p] = id;
      detail.middle += place(p);
      if (core_[stretch_[p]]) {  // a soft edge has a colour of its own
        detail.colour += rgb_of(sketch_.colour[p]);
        ++own;
      }
      ++joints[sketch_.joint[p]];
    }
    detail.middle /= double(pixels.size());
    detail.colour /= float(own);
    detail.joint = std::max_element(joints.begin(), joints.end(), [](const auto& a, const auto& b) {
                     return a.second < b.second;
                   })->first;
    for (const std::size_t p : pixels)
      each_beside(sketch_, p, [&](std::size_t q) {
        if (label_[q] != id &&
            !(shown(q) && std::abs(sketch_.depth[q] - sketch_.depth[p]) <= step_))
          detail.whole = false;
      });
    // The ground lies beyond the soft edge.
    Rgb ground = Rgb::Zero();
    int round = 0;
    std::vector<std::size_t> near = grown(sketch_, pixels, 1), beyond = grown(sketch_, near, 2);
    for (const std::size_t p : beyond)
      if (shown(p) && !std::binary_search(near.begin(), near.end(), p)) {
        ground += rgb_of(sketch_.colour[p]);
        ++round;
      }
    // Pixel by pixel: an eye's white and its pupil are together much like skin.
    float unlike = 0;
    for (const std::size_t p : pixels)
      if (core_[stretch_[p]])
        unlike += unlikeness(rgb_of(sketch_.colour[p]), ground / float(round));
    detail.pixels = std::move(pixels);
    if (round > 0 && unlike >= kStandsOut * float(own)) {
      out.push_back(std::move(detail));
    } else {
      for (const std::size_t p : detail.pixels) label_[p] = -1;
    }
  }

  const Sketch& sketch_;
  double largest_, step_;
  std::vector<int>& label_;
  std::vector<int> stretch_;  // of each pixel; −1: none
  std::vector<std::vector<std::size_t>> stretches_;
  std::vector<std::uint8_t> small_, core_;  // by stretch; core: thicker than a soft edge
};

}  // namespace

std::vector<DrawnDetail> drawn_details(const Sketch& sketch, double largest, double step,
                                       std::vector<int>& label) {
  return Finder(sketch, largest, step, label).details();
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
