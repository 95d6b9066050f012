#include "document/derived.h"

#include <gtest/gtest.h>

#include "document/history.h"

namespace artisketch {
namespace {

Document with_frames(int count) {
  Document document;
  document.frames.resize(std::size_t(count));
  return document;
}

// How many frames a document has, and how often that was counted.
struct Counter {
  Derived<std::size_t, int> frames;
  int counted = 0;
  std::size_t of(const History& history, int also = 0) {
    return frames.of(history.state(), also, [&] {
      ++counted;
      return history.now().frames.size() + std::size_t(also);
    });
  }
};

TEST(Derived, IsMadeOnceForEachStateOfTheDocument) {
  History history(with_frames(1));
  Counter counter;
  EXPECT_EQ(counter.of(history), 1u);
  EXPECT_EQ(counter.of(history), 1u);
  EXPECT_EQ(counter.counted, 1);
  history.commit("Add", with_frames(2));
  EXPECT_EQ(counter.of(history), 2u);
  history.amend(with_frames(3));
  EXPECT_EQ(counter.of(history), 3u);
  history.undo();
  EXPECT_EQ(counter.of(history), 1u);
}

// Two documents that were just opened have both no edits, at the same time of change: what was
// derived from the one had been taken for the other's.
TEST(Derived, TellsDocumentsApartThatNobodyEdited) {
  Counter counter;
  History history(with_frames(2));
  EXPECT_EQ(counter.of(history), 2u);
  history = History(with_frames(5));
  EXPECT_EQ(counter.of(history), 5u);
  // Nor is it fooled by a document at the same address: it keeps its own alive.
  for (int count = 6; count < 30; ++count) {
    history = History(with_frames(count));
    EXPECT_EQ(counter.of(history), std::size_t(count));
  }
}

TEST(Derived, DependsOnWhateverElseItWasMadeOf) {
  History history(with_frames(1));
  Counter counter;
  EXPECT_EQ(counter.of(history, 1), 2u);
  EXPECT_EQ(counter.of(history, 2), 3u);
  EXPECT_EQ(counter.of(history, 2), 3u);
  EXPECT_EQ(counter.counted, 2);
  counter.frames.forget();
  EXPECT_EQ(counter.of(history, 2), 3u);
  EXPECT_EQ(counter.counted, 3);
}

}  // namespace
}  // namespace artisketch
