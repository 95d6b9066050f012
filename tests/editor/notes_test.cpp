// What was noticed about the drawings, in its list.
#include <algorithm>

#include <gtest/gtest.h>

#include "editor/step.h"
#include "files/document_file.h"

namespace artisketch {
namespace {

int said(const Harness& h, const std::string& words) {
  const std::vector<std::string> labels = h.labels();
  return int(std::count_if(labels.begin(), labels.end(), [&](const std::string& label) {
    return label.find(words) != label.npos;
  }));
}

// A figure in the second drawing as small as no other drawing shows it.
Document drawn_smaller(Document document) {
  constexpr double kSmaller = 0.7;
  Frame& frame = document.frames[1];
  const Vec2 middle(frame.width / 2.0, frame.height / 2.0);
  for (Contour& contour : frame.contours)
    for (Vec2& point : contour.line.points) point = middle + kSmaller * (point - middle);
  frame.pose.root_position.head<2>() *= kSmaller;
  return document;
}

TEST(Notes, WhatFollowsFromADrawingsSizeIsFoldedUnderIt) {
  Harness h;
  h.open_example("fox");
  h.settle();
  h.open("small.artisketch", document_text(drawn_smaller(h.document())));
  h.key(ImGuiKey_R);
  h.settle();
  h.click("Read");
  EXPECT_EQ(said(h, "seems drawn"), 1);
  EXPECT_EQ(said(h, "cannot agree"), 0) << "they are drawn in other sizes: that is why";
  const std::vector<std::string> labels = h.labels();
  const auto fold = std::find_if(labels.begin(), labels.end(), [](const std::string& label) {
    return label.ends_with(" more that may follow from it");
  });
  ASSERT_NE(fold, labels.end());
  const std::string words = *fold;
  const int follow = std::stoi(words);
  EXPECT_GT(follow, 3);
  h.click(words);
  EXPECT_TRUE(h.active(words));
  EXPECT_EQ(said(h, "cannot agree") + said(h, "as far as"), follow);
  h.click(words);
  EXPECT_EQ(said(h, "cannot agree"), 0);
}

// Parts that do not touch, that fuse, a skin that passes through itself: all come one way.
TEST(Notes, WhatTheCommandLineSaysOfTheSurfaceIsListed) {
  Harness h;
  h.open_example("hero");
  h.settle();
  Document document = h.document();
  const int hand = document.skeleton.find("hand.R");
  for (Frame& frame : document.frames)
    for (Contour& contour : frame.contours)
      if (contour.joint == hand)
        for (Vec2& point : contour.line.points) point += Vec2(0, 160);
  h.open("apart.artisketch", document_text(document));
  h.key(ImGuiKey_R);
  h.settle();
  h.click("Read");
  EXPECT_EQ(said(h, "Hand R does not touch Forearm R"), 1);
  EXPECT_EQ(said(h, "hand.R"), 0) << "it is called as in the editor";
}

}  // namespace
}  // namespace artisketch
