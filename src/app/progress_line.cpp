#include "app/progress_line.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace artisketch {

std::string progress_text(const Progress& progress, double seconds, int width) {
  const double fraction = std::clamp(progress.fraction, 0.0, 1.0);
  std::string text = progress.stage;
  if (!progress.item.empty()) text += ": " + progress.item;
  if (progress.parts > 1)
    text +=
        " (" + std::to_string(progress.part + 1) + " of " + std::to_string(progress.parts) + ")";
  text += " ";
  for (int i = 0; i < width; ++i) text += i < std::lround(fraction * width) ? "█" : "░";
  text += " " + std::to_string(int(fraction * 100)) + " %";
  // A guess from the first twentieth on; before that it would jump about.
  if (fraction > 0.05 && seconds > 1) {
    const double left = seconds * (1 - fraction) / fraction;
    text += ", " + std::to_string(int(std::ceil(left))) + " s left";
  }
  return text;
}

ProgressLine::ProgressLine(bool enabled) : enabled_(enabled), began_(Clock::now()), last_() {}

ProgressLine::~ProgressLine() {
  wipe();
}

void ProgressLine::show(const Progress& progress) {
  const Clock::time_point now = Clock::now();
  if (!enabled_ || (drawn_ && now - last_ < std::chrono::milliseconds(100))) return;
  const double seconds = std::chrono::duration<double>(now - began_).count();
  std::fprintf(stderr, "\r\033[K%s", progress_text(progress, seconds, 24).c_str());
  std::fflush(stderr);
  drawn_ = true;
  last_ = now;
}

void ProgressLine::wipe() {
  if (!drawn_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  drawn_ = false;
}

}  // namespace artisketch
