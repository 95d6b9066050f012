// A run of the command line: shows its progress on the terminal, and Ctrl-C asks it to stop.
#pragma once

#include <functional>
#include <optional>

#include "app/progress_line.h"
#include "model/run.h"

namespace artisketch {

class CommandRun {
 public:
  explicit CommandRun(bool shows_progress);
  ~CommandRun();
  CommandRun(const CommandRun&) = delete;
  void finish() { line_.wipe(); }
  static bool asked_to_stop();
  Run run;

 private:
  ProgressLine line_;
};

// The status of `work`; what it throws is said in words. `grid` is that of a run, for want of
// memory.
int guarded(const std::optional<int>& grid, const std::function<int()>& work);

}  // namespace artisketch
