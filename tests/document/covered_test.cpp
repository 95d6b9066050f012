#include <gtest/gtest.h>

#include "document/edit.h"
#include "document/skeleton_edit.h"
#include "files/document_file.h"

namespace artisketch {
namespace {

Polyline box(double left, double top, double right, double bottom) {
  return {{{left, top}, {right, top}, {right, bottom}, {left, bottom}}, true};
}

// A body with an arm and a hand; nothing is outlined.
Document figure() {
  Document document;
  document.camera.pixels_per_unit = 100;
  document.skeleton.joints = {{"body", -1, {0, 1, 0}, -1, ""},
                              {"arm", 0, {0.5, 0, 0}, -1, ""},
                              {"hand", 1, {0.5, 0, 0}, -1, ""}};
  Frame frame;
  frame.width = frame.height = 400;
  frame.pose = rest_pose(document.skeleton);
  document.frames = {frame, frame};
  return document;
}

TEST(Hidden, IsSaidOfOnePartInOneDrawingAndTakenBack) {
  const Document document = with_hidden(with_hidden(figure(), 1, 2, true), 1, 1, true);
  EXPECT_TRUE(is_hidden(document.frames[1], 1));
  EXPECT_TRUE(is_hidden(document.frames[1], 2));
  EXPECT_FALSE(is_hidden(document.frames[0], 2));
  const Document shown = with_hidden(document, 1, 2, false);
  EXPECT_TRUE(is_hidden(shown.frames[1], 1));
  EXPECT_FALSE(is_hidden(shown.frames[1], 2));
}

TEST(Hidden, EndsWithAnOutline) {
  const Document hidden = with_hidden(figure(), 0, 2, true);
  const Document drawn = with_contour(hidden, 0, {2, box(10, 10, 50, 50), ""});
  EXPECT_FALSE(is_hidden(drawn.frames[0], 2));
  EXPECT_FALSE(is_hidden(without_contour(drawn, 0, 0).frames[0], 2));
  const Document given =
      with_contour_joint(with_contour(hidden, 0, {1, box(10, 10, 50, 50), ""}), 0, 0, 2);
  EXPECT_FALSE(is_hidden(given.frames[0], 2));
}

TEST(Hidden, SurvivesTheFileAndTheSkeleton) {
  const Document document = with_hidden(figure(), 1, 2, true);
  const Result<Document> read = parse_document(document_text(document), "test");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->frames[1].hidden, std::vector<int>{2});
  EXPECT_TRUE(read->frames[1].unknown.empty());
  EXPECT_EQ(document_text(figure()).find("hidden"), std::string::npos);
  // The hand is joint 1 once the arm is gone; what is gone is not hidden.
  const std::optional<Document> armless = without_joint(document, 1, false);
  ASSERT_TRUE(armless);
  EXPECT_EQ(armless->frames[1].hidden, std::vector<int>{1});
  const std::optional<Document> handless = without_joint(document, 2, false);
  ASSERT_TRUE(handless);
  EXPECT_TRUE(handless->frames[1].hidden.empty());
}

TEST(Hidden, NamesAJointThatThereIs) {
  std::string text = document_text(with_hidden(figure(), 1, 2, true));
  const std::size_t at = text.find("\"hand\"", text.find("\"hidden\""));
  ASSERT_NE(at, std::string::npos);
  text.replace(at, 6, "\"paw\"");
  const Result<Document> read = parse_document(text, "test");
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().text().find("/frames/1/hidden/0"), std::string::npos)
      << read.error().text();
}

TEST(InsideOtherParts, IsWhatLiesBehindThemAllTheWay) {
  Document document = with_contour(figure(), 0, {1, box(120, 120, 180, 180), ""});
  EXPECT_FALSE(inside_other_parts(document.frames[0], 1));
  document = with_contour(document, 0, {0, box(100, 100, 200, 200), ""});
  EXPECT_TRUE(inside_other_parts(document.frames[0], 1));
  EXPECT_FALSE(inside_other_parts(document.frames[0], 0));
  EXPECT_FALSE(inside_other_parts(document.frames[0], 2));  // has no outline
  // In front its edge shows.
  EXPECT_FALSE(inside_other_parts(with_contour_shifted(document, 0, 0, 1).frames[0], 1));
  // So does what sticks out, and what stands in a hole.
  const Document out = with_contour_points(document, 0, 0, box(120, 120, 180, 210).points);
  EXPECT_FALSE(inside_other_parts(out.frames[0], 1));
  const Document hole = with_contour(document, 0, {0, box(150, 90, 170, 210), ""});
  EXPECT_FALSE(inside_other_parts(hole.frames[0], 1));
}

TEST(InsideOtherParts, SeveralMayCoverOneTogether) {
  Document document = with_contour(figure(), 0, {2, box(120, 120, 180, 180), ""});
  document = with_contour(document, 0, {0, box(100, 100, 155, 200), ""});
  EXPECT_FALSE(inside_other_parts(document.frames[0], 2));
  document = with_contour(document, 0, {1, box(145, 100, 200, 200), ""});
  EXPECT_TRUE(inside_other_parts(document.frames[0], 2));
}

}  // namespace
}  // namespace artisketch
