#include "document/place_words.h"

#include <gtest/gtest.h>

namespace artisketch {
namespace {

Document two_drawings() {
  Document document;
  document.skeleton.joints = {{"body", -1, Vec3::Zero(), -1, ""},
                              {"upper_arm.L", 0, Vec3::UnitX(), -1, ""}};
  for (const char* name : {"front", "left side"}) {
    Frame frame;
    frame.name = name;
    frame.pose = rest_pose(document.skeleton);
    document.frames.push_back(frame);
  }
  return document;
}

TEST(PlaceWords, PlacesAreReadAsTheEditorCallsThem) {
  const Document document = two_drawings();
  const PlacedWords placed = placed_words(
      document, frame_words(document, 1) + ": 'upper_arm.L' turned as far as it may from 'body'");
  EXPECT_EQ(placed.words, "Left side: Upper arm L turned as far as it may from Body");
  EXPECT_EQ(placed.frame, 1);
  EXPECT_EQ(placed.joint, 1) << "the first that is named";
}

TEST(PlaceWords, FieldsOfTheFileAreReadAsControls) {
  const Document document = two_drawings();
  EXPECT_EQ(
      placed_words(document, "with frames[1].scale at 0.83 its parts would be as large").words,
      "With Figure's size at 0.83 its parts would be as large");
  EXPECT_EQ(placed_words(document, "as far as calibration.max_rotation allows (8°)").words,
            "As far as the document's limit allows (8°)");
}

TEST(PlaceWords, WordsOfNoPlaceStayAsTheyAre) {
  const PlacedWords placed = placed_words(two_drawings(), "the model has 500 triangles");
  EXPECT_EQ(placed.words, "The model has 500 triangles");
  EXPECT_EQ(placed.frame, -1);
  EXPECT_EQ(placed.joint, -1);
}

}  // namespace
}  // namespace artisketch
