#include "base/process_use.h"

#include <ctime>

#include <sys/resource.h>

namespace artisketch {

ProcessUse process_use() {
  ProcessUse use;
  use.cpu_seconds = double(std::clock()) / CLOCKS_PER_SEC;
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return use;
#ifdef __APPLE__
  constexpr double kUnit = 1;
#else
  constexpr double kUnit = 1024;
#endif
  use.peak_bytes = double(usage.ru_maxrss) * kUnit;
  return use;
}

}  // namespace artisketch
