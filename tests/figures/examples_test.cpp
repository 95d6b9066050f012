#include "figures/examples.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "files/document_file.h"
#include "files/image_file.h"

namespace artisketch::figures {
namespace {

std::string path_of(const std::string& name) {
  const std::string assets = ARTISKETCH_SOURCE_DIR "/assets/",
                    file = "/" + name + "/" + name + ".artisketch",
                    first = assets + "examples" + file;
  return std::filesystem::exists(first) ? first : assets + "gallery" + file;
}

// Machines may round a point's last digit differently, and so keep another one of the outline.
void expect_same_outline(const Polyline& a, const Polyline& b, const std::string& where) {
  EXPECT_NEAR(signed_area(a), signed_area(b), 0.2 * length(a)) << where;
  const Box2 box = artisketch::bounds(std::span(&a, 1)),
             other = artisketch::bounds(std::span(&b, 1));
  EXPECT_LT((box.min() - other.min()).norm() + (box.max() - other.max()).norm(), 1) << where;
}

TEST(Examples, AreWhatTheGeneratorMakes) {
  for (const std::string& name : example_names()) {
    const std::string path = path_of(name);
    const Result<Document> read = read_document(path);
    ASSERT_TRUE(read.ok()) << read.error().text();
    const Document &a = *read, b = example(name).sketches.given;
    ASSERT_EQ(a.frames.size(), b.frames.size()) << path;
    ASSERT_EQ(a.skeleton.size(), b.skeleton.size()) << path;
    for (std::size_t f = 0; f < a.frames.size(); ++f) {
      EXPECT_LT((a.frames[f].pose.root_position - b.frames[f].pose.root_position).norm(), 1e-3);
      for (int j = 0; j < a.skeleton.size(); ++j) {
        const Quat &p = a.frames[f].pose.rotations[j], &q = b.frames[f].pose.rotations[j];
        EXPECT_LT(p.normalized().angularDistance(q.normalized()), 1e-4) << path;
      }
      ASSERT_EQ(a.frames[f].contours.size(), b.frames[f].contours.size()) << path;
      for (std::size_t c = 0; c < a.frames[f].contours.size(); ++c) {
        const Contour &here = a.frames[f].contours[c], &there = b.frames[f].contours[c];
        EXPECT_EQ(here.joint, there.joint) << path;
        expect_same_outline(
            here.line, there.line,
            path + " " + a.frames[f].name + " " + a.skeleton.joints[here.joint].name);
      }
    }
  }
}

constexpr int kPencil = 190;  // darker than any paper

TEST(Examples, HaveDrawingsThatLieInsideTheirContours) {
  for (const std::string& name : example_names()) {
    const std::string path = path_of(name);
    const Result<Document> read = read_document(path);
    ASSERT_TRUE(read.ok()) << read.error().text();
    for (const Frame& frame : read->frames) {
      const Result<Image> image = load_frame_image(frame, path);
      ASSERT_TRUE(image.ok()) << image.error().text();
      Box2 inked, outlined;
      const bool paper = image->at(0, 0)[3] > 128;  // else the sheet is transparent
      for (int y = 0; y < image->height; ++y)
        for (int x = 0; x < image->width; ++x)
          if (paper ? image->at(x, y)[2] < kPencil : image->at(x, y)[3] > 128)
            inked.extend(Vec2(x + 0.5, y + 0.5));
      for (const Contour& contour : frame.contours)
        for (const Vec2& p : contour.line.points) outlined.extend(p);
      // The pen is a few pixels wide and strays a little.
      EXPECT_LT((inked.min() - outlined.min()).norm(), 4) << path << " " << frame.name;
      EXPECT_LT((inked.max() - outlined.max()).norm(), 4) << path << " " << frame.name;
    }
  }
}

}  // namespace
}  // namespace artisketch::figures
