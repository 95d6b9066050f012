// Documents one after the other: nothing of the one before may show in the next.
#include <cmath>

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

TEST(Opening, TheGalleryShowsEveryExample) {
  Harness h({"hero", "heart", "monster", "horse-three"});
  EXPECT_EQ(h.find("Example Monster"), nullptr) << "the first screen stays calm";
  h.click("Gallery");
  for (const char* name : {"Hero", "Heart", "Monster", "Horse three"})
    EXPECT_NE(h.find(std::string("Example ") + name), nullptr) << name;
  EXPECT_EQ(h.find("Turn the model"), nullptr);
  h.key(ImGuiKey_Escape);
  EXPECT_EQ(h.find("Example Monster"), nullptr);
  EXPECT_NE(h.find("Turn the model"), nullptr);
}

TEST(Opening, WhatGreetsRestsBehindTheGallery) {
  Harness h({"hero", "monster"});
  h.wait(0.5);
  h.click("Gallery");
  h.frames(2);
  EXPECT_GT(h.editor().next_frame_in(), 1) << "nothing moves";
  h.key(ImGuiKey_Escape);
  h.frames(2);
  EXPECT_LT(h.editor().next_frame_in(), 0.1) << "it plays on";
}

TEST(Opening, WhoJustDrawsHasABlankSheet) {
  Harness h;
  h.start_over();
  h.click("Outline mode");
  ASSERT_EQ(h.state().frames, 0);
  std::vector<Vec2> round;
  for (int i = 0; i <= 40; ++i)
    round.push_back(Vec2(300, 700) + 60 * Vec2(std::cos(i * 0.16), std::sin(i * 0.16)));
  h.draw(round);
  h.frames(2);
  ASSERT_EQ(h.state().frames, 1);
  h.key(ImGuiKey_Enter);
  ASSERT_EQ(h.document().frames[0].contours.size(), 1u) << "the stroke is not lost";
  EXPECT_NEAR(bounds(std::span(&h.document().frames[0].contours[0].line, 1)).sizes().x(),
              120 / (h.on_screen(1, 0) - h.on_screen(0, 0)).norm(), 8);
}

TEST(Opening, AFigureOfTheGalleryIsMadeWhereItIsOpened) {
  Harness h({"hero", "monster"});
  h.click("Gallery");
  h.click("Example Monster");
  EXPECT_EQ(h.document().name, "monster");
  EXPECT_EQ(h.state().mode, "result");
  ASSERT_FALSE(h.jobs.started.empty());
  EXPECT_EQ(h.jobs.started.front(), JobRequest::Kind::reconstruct);
  h.settle();
  EXPECT_TRUE(h.state().has_model);
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

struct Armed {
  std::string mode, tool;
};

std::vector<Armed> all_armed() {
  std::vector<Armed> all;
  for (const std::string& mode : kModes)
    for (const std::string& tool : tools_of(mode)) all.push_back({mode, tool});
  return all;
}

class After : public testing::TestWithParam<Armed> {};
INSTANTIATE_TEST_SUITE_P(Tools, After, testing::ValuesIn(all_armed()),
                         [](const auto& info) { return info.param.mode + info.param.tool; });

// With the tool armed and used on the other's last drawing.
TEST_P(After, EachExampleOpensAfterEachOther) {
  constexpr ImGuiKey kKeys[] = {ImGuiKey_1, ImGuiKey_2, ImGuiKey_3, ImGuiKey_4};
  Harness h;
  const std::size_t count = kExamples.size();
  std::size_t at = 0;
  h.open_example(kExamples[at]);
  // Strides through a circle of a prime number of examples: each follows each other once.
  ASSERT_EQ(count, 5u);
  for (std::size_t stride = 1; stride < count; ++stride)
    for (std::size_t step = 0; step < count; ++step) {
      const std::string before = kExamples[at];
      at = (at + stride) % count;
      const std::string& next = kExamples[at];
      SCOPED_TRACE(before + ", then " + next);
      h.click(GetParam().mode + " mode");
      h.click(GetParam().tool + " tool");
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
      for (const ImGuiKey mode : kKeys) h.key(mode);
    }
}

}  // namespace
}  // namespace artisketch
