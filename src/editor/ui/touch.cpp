#include "editor/ui/touch.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace artisketch {
namespace {

constexpr double kTap = 0.3;  // seconds
constexpr float kStill = 12;  // points that fingers may slip in a tap
constexpr float kClose = 24;  // points: fingers nearer than this say nothing of a spread

}  // namespace

void Touch::measure(ImVec2& middle, float& spread) const {
  middle = {0, 0};
  spread = 0;
  const float n = float(fingers_.size());
  for (const auto& [finger, at] : fingers_) {
    middle.x += at.x / n;
    middle.y += at.y / n;
  }
  for (const auto& [finger, at] : fingers_)
    spread += std::hypot(at.x - middle.x, at.y - middle.y) / n;
}

void Touch::begin_anew() {
  if (!fingers_.empty()) measure(middle_, spread_);
}

bool Touch::down(long long finger, ImVec2 at, double time) {
  if (fingers_.empty()) most_ = 0, began_ = time, way_ = 0;
  fingers_[finger] = at;
  most_ = std::max(most_, int(fingers_.size()));
  const bool second = fingers_.size() > 1 && !several_;
  if (second) since_.began = true;
  if (second || (fingers_.size() == 1 && pen_near_)) several_ = true;
  begin_anew();
  return second;
}

void Touch::move(long long finger, ImVec2 at) {
  const auto found = fingers_.find(finger);
  if (found == fingers_.end()) return;
  way_ += std::hypot(at.x - found->second.x, at.y - found->second.y);
  found->second = at;
  if (!several_) return;
  ImVec2 middle;
  float spread;
  measure(middle, spread);
  since_.moved.x += middle.x - middle_.x;
  since_.moved.y += middle.y - middle_.y;
  if (spread_ > kClose && spread > kClose) since_.spread *= spread / spread_;
  middle_ = middle;
  spread_ = spread;
}

void Touch::up(long long finger, double time) {
  if (fingers_.erase(finger) == 0) return;
  if (fingers_.empty()) {
    if (several_ && time - began_ < kTap && way_ < kStill * float(most_)) since_.tapped = most_;
    several_ = false;
  }
  begin_anew();
}

Fingers Touch::take() {
  Fingers now = std::exchange(since_, {});
  now.count = several_ ? int(fingers_.size()) : 0;
  now.at = middle_;
  return now;
}

}  // namespace artisketch
