#include "base/at_once.h"

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace artisketch {
namespace {

TEST(AtOnce, EveryPieceIsDoneOnce) {
  for (const int threads : {1, 2, 3, 16})
    for (const int count : {0, 1, 2, 100}) {
      std::vector<std::atomic<int>> done(count);
      at_once(count, threads, [&](int i) { ++done[i]; });
      for (int i = 0; i < count; ++i) EXPECT_EQ(done[i], 1) << i << " of " << count;
    }
}

// Also where a later piece throws sooner.
TEST(AtOnce, TheFirstOfWhatIsThrownComesThrough) {
  for (const int threads : {1, 4}) {
    try {
      at_once(50, threads, [](int i) {
        if (i >= 10) throw std::runtime_error(std::to_string(i));
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& thrown) {
      EXPECT_STREQ(thrown.what(), "10");
    }
  }
}

TEST(AtOnce, ThereIsAtLeastOneThread) {
  EXPECT_GE(threads_here(), 1);
}

}  // namespace
}  // namespace artisketch
