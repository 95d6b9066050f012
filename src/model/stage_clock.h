// Times the pipeline's stages, and tells the run which one is under way.
#pragma once

#include <chrono>

#include "base/process_use.h"
#include "model/stages.h"

namespace artisketch {

// Times the stages and tells the run which one is under way and what share of the whole it has.
class StageClock {
 public:
  StageClock(Run& run, std::vector<StageTime>& times) : run_(run), times_(times) {}

  void start(const char* name, double from, double to) {
    run_.now.stage = name;
    run_.now.item.clear();
    run_.now.part = 0;
    run_.now.parts = 1;
    run_.from = from;
    run_.to = to;
    run_.report(0);
    times_.push_back({name, 0, 0, 0, {}});
    cpu_ = process_use().cpu_seconds;
    began_ = std::chrono::steady_clock::now();
  }
  void finish(std::vector<std::pair<std::string, double>> sizes) {
    times_.back().seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
    const ProcessUse use = process_use();
    times_.back().cpu_seconds = use.cpu_seconds - cpu_;
    times_.back().peak_bytes = use.peak_bytes;
    times_.back().sizes = std::move(sizes);
  }

 private:
  Run& run_;
  std::vector<StageTime>& times_;
  std::chrono::steady_clock::time_point began_;
  double cpu_ = 0;  // the process's, when the stage began
};

}  // namespace artisketch
