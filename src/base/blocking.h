// Eigen cuts a large product to fit the machine's caches, so that sums are taken in another order
// on each machine, and last bits differ. One size for all gives the same bytes everywhere.
#pragma once

#include <cstddef>

#include <Eigen/Core>

namespace artisketch {

// Called before the first product of a run. The sizes are the process's, and a run that was
// cancelled may still be reading them on its thread: they are set once.
inline void fix_blocking() {
  static const bool set = [] {
    constexpr std::ptrdiff_t kKilobyte = 1024;
    Eigen::setCpuCacheSizes(32 * kKilobyte, 512 * kKilobyte, 2048 * kKilobyte);
    return true;
  }();
  (void)set;
}

}  // namespace artisketch
