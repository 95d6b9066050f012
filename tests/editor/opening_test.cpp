// Documents one after the other: nothing of the one before may show in the next.
#include <gtest/gtest.h>

#include "editor/harness.h"

namespace artisketch {
namespace {

const std::vector<std::string> kModes = {"Outline", "Skeleton", "Pose", "Result"};

// Of each mode, by the words on its button.
std::vector<std::string> tools_of(const std::string& mode) {
  if (mode == "Outline") return {"Edit", "Draw", "Points", "Trace", "Cut"};
  if (mode == "Skeleton") return {"Edit"};
  if (mode == "Pose") return {"Pose", "Turn", "Twist"};
  return {"Orbit", "Pose", "Joints", "Fatness"};
}

TEST(Opening, AnEmptyEditorWelcomes) {
  Harness h;
  EXPECT_EQ(h.state().mode, "welcome");
  EXPECT_EQ(h.platform.title, "ArtiSketch");
  EXPECT_FALSE(h.platform.unsaved_shown);
  EXPECT_FALSE(h.state().can_undo);
}

TEST(Opening, TheFirstExampleGreetsAndPlays) {
  Harness h({"hero", "circles"});
  EXPECT_EQ(h.state().mode, "welcome");
  EXPECT_TRUE(h.state().has_model);
  const int painted = h.graphics.painted;
  h.wait(0.5);
  EXPECT_GT(h.graphics.painted, painted) << "it doesn't move";
  EXPECT_NE(h.find("Example Circles"), nullptr);
}

TEST(Opening, ADocumentShowsWhatItHolds) {
  Harness h;
  h.open_example("hero");
  EXPECT_EQ(h.state().mode, "outline");
  EXPECT_EQ(h.state().frames, 3);
  EXPECT_EQ(h.document().skeleton.size(), int(h.state().joints.size()));
  EXPECT_FALSE(h.state().has_model);
  EXPECT_FALSE(h.state().can_undo);
  EXPECT_FALSE(h.editor().unsaved());
}

// What was derived of one document is not of the other, though both are untouched.
TEST(Opening, AnUntouchedDocumentAfterAnother) {
  Harness h;
  h.open_example("circles");
  h.settle();
  h.open_example("hero");
  h.settle();
  EXPECT_EQ(h.state().frames, 3);
  EXPECT_GT(h.state().live_parts, 10);
  EXPECT_NE(h.find("Hand L in 3"), nullptr);
}

class After : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Examples, After, testing::ValuesIn(kExamples),
                         [](const auto& info) { return info.param; });

// From every mode, with every tool armed and used, with the other's last part and outline chosen.
TEST_P(After, EachOtherExampleInEveryModeWithEveryTool) {
  Harness h;
  for (const std::string& mode : kModes)
    for (const std::string& tool : tools_of(mode))
      for (const std::string& next : kExamples) {
        if (next == GetParam()) continue;
        SCOPED_TRACE(mode + ", " + tool + ", then " + next);
        h.open_example(GetParam());
        h.click(mode + " mode");
        h.click(tool + " tool");
        h.key(ImGuiKey_Comma);  // the last drawing
        if (h.find("Sketch")) {
          const Vec2 middle = h.middle("Sketch");
          h.draw({middle, middle + Vec2(30, 0), middle + Vec2(30, 40)});
        }
        h.open_example(next);
        if (h.find("Don't save")) h.click("Don't save");
        EXPECT_EQ(h.state().mode, "outline");
        EXPECT_EQ(h.state().frame, 0);
        EXPECT_FALSE(h.state().can_undo);
        EXPECT_EQ(h.document().name, next);
        for (const std::string& other : kModes) h.click(other + " mode");
      }
}

}  // namespace
}  // namespace artisketch
