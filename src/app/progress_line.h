// Progress on a terminal: one line that is drawn over, "surfaces: forearm.L (7 of 15) ████░░ 46 %,
// 12 s left".
#pragma once

#include <chrono>
#include <string>

#include "model/run.h"

namespace artisketch {

class ProgressLine {
 public:
  // Draws to standard error; silent where `enabled` is false.
  explicit ProgressLine(bool enabled);
  ~ProgressLine();  // wipes the line
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void show(const Progress& progress);  // at most ten times a second
  void wipe();

 private:
  using Clock = std::chrono::steady_clock;
  bool enabled_;
  bool drawn_ = false;
  Clock::time_point began_, last_;
};

// The line's words, for `seconds` gone since the start; bar of `width` cells.
std::string progress_text(const Progress& progress, double seconds, int width);

}  // namespace artisketch
