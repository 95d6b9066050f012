// A test that begins with a document, and knows what it was.
#pragma once

#include <gtest/gtest.h>

#include "editor/harness.h"
#include "editor/reading.h"

namespace artisketch {

class WithDocument : public testing::Test {
 protected:
  explicit WithDocument(const std::string& example = "hero") {
    h.open_example(example);
    h.settle();
    begin();
  }
  // What follows is compared with the document as it is now.
  void begin() {
    before = text(h);
    was = h.document();
    undo_before = h.state().undo;
  }
  // Since then one step was made, of that name: undo takes it back, redo brings it again.
  void expect_step(const std::string& name) {
    const std::string after = text(h);
    EXPECT_TRUE(after != before) << "nothing changed";
    EXPECT_EQ(h.state().undo, name);
    h.key(ImGuiKey_Z, ImGuiMod_Ctrl);
    EXPECT_TRUE(text(h) == before) << "undone it is another";
    h.key(ImGuiKey_Z, ImGuiMod_Ctrl | ImGuiMod_Shift);
    EXPECT_TRUE(text(h) == after) << "redone it is another";
  }
  void expect_nothing_happened() {
    EXPECT_TRUE(text(h) == before) << "the document changed: " << h.state().undo;
    EXPECT_EQ(h.state().undo, undo_before);
  }

  Harness h;
  std::string before, undo_before;
  Document was;
};

}  // namespace artisketch
