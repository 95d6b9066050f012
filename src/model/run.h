// What a slow computation is handed besides its input: how to tell how far it is, whether to stop,
// and where to leave what it found on the way.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "base/grid.h"
#include "base/mesh.h"

namespace artisketch {

struct Progress {
  std::string stage;  // as a person calls it: "level set"
  std::string item;   // what it works on, e.g. a joint's name; may be empty
  int part = 0;       // item `part` of `parts`, counted from 0
  int parts = 1;
  double fraction = 0;  // of the whole run, 0 … 1, never falling
};

using Curves = std::vector<std::vector<Vec3>>;  // polylines in rest space

// Named intermediate results, in the order they were made. `artisketch reconstruct --trace` writes
// them; when something looks wrong, the answer should be here.
struct Trace {
  struct Entry {
    std::string name;  // "forearm.L/hull"
    std::variant<Mesh, Grid3<float>, Curves> what;
  };
  std::vector<Entry> entries;
  void add(std::string name, auto what) { entries.push_back({std::move(name), std::move(what)}); }
};

struct Run {
  std::function<void(const Progress&)> on_progress;  // called by one thread at a time; may be empty
  const std::atomic<bool>* cancel = nullptr;  // set from elsewhere; polled at least every 0.2 s
  Trace* trace = nullptr;
  int threads = 1;  // at most; results are the same, to the bit, for any number

  bool cancelled() const { return cancel && cancel->load(std::memory_order_relaxed); }

  // The stage that is under way, set by the pipeline; a stage itself only calls report().
  Progress now;
  double from = 0, to = 1;  // the share of the whole run that the present piece of work is
  void report(double fraction) {
    now.fraction = from + (to - from) * fraction;
    if (on_progress) on_progress(now);
  }
};

}  // namespace artisketch
