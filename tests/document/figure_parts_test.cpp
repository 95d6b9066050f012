#include "document/figure_parts.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include <gtest/gtest.h>

#include "base/raster.h"
#include "document/edit.h"
#include "figures/examples.h"
#include "files/document_file.h"
#include "files/image_file.h"

namespace artisketch {
namespace {

struct Figured {
  Document document;  // at the true poses, with the figure's own outlines
  SegmentedImage image;
};

Figured drawn(const std::string& name, int frame) {
  const std::string assets = ARTISKETCH_SOURCE_DIR "/assets/",
                    file = "/" + name + "/" + name + ".artisketch",
                    first = assets + "examples" + file,
                    path = std::filesystem::exists(first) ? first : assets + "gallery" + file;
  Figured made;
  made.document = with_poses_of(*read_document(path), figures::example(name).sketches.truth);
  made.image = segmented(*load_frame_image(made.document.frames[std::size_t(frame)], path));
  return made;
}

Document without_outlines(Document document) {
  for (Frame& frame : document.frames) frame.contours.clear();
  return document;
}

Mask area(const Frame& frame, int joint) {
  Mask mask(frame.width, frame.height);
  add_polygons(closed_contours(frame, joint), mask);
  return mask;
}

Mask whole(const Figured& drawn, const Frame& frame) {
  std::vector<std::uint8_t> pixels;
  for (const std::uint8_t paper : drawn.image.paper) pixels.push_back(!paper);
  const std::optional<RegionOutline> outline = outline_of_pixels(drawn.image, pixels);
  std::vector<Polyline> lines = outline->holes;
  lines.push_back(outline->outline);
  Mask mask(frame.width, frame.height);
  add_polygons(closed_polygons(lines), mask);
  return mask;
}

bool has(const std::vector<int>& joints, int joint) {
  return std::find(joints.begin(), joints.end(), joint) != joints.end();
}

// Every part of a figure whose parts all show, against the outline that is known.
TEST(FigureParts, AreAboutWhatWasDrawnRoundEachPart) {
  double sum = 0, count = 0;
  for (const std::string name : {"hero", "fox", "alien", "ballerina"}) {
    const Figured made = drawn(name, 0);
    const FigureParts found = with_figure_parts(without_outlines(made.document), 0, made.image);
    const Frame &mine = found.document.frames[0], &truth = made.document.frames[0];
    double of_figure = 0;
    for (const int joint : found.outlined)
      of_figure += intersection_over_union(area(mine, joint), area(truth, joint));
    sum += of_figure;
    count += double(found.outlined.size());
    std::printf("%s: %d parts, mean IoU %.3f\n", name.c_str(), int(found.outlined.size()),
                of_figure / double(found.outlined.size()));
  }
  std::printf("mean IoU %.3f\n", sum / count);
  EXPECT_GT(sum / count, 0.80);
}

TEST(FigureParts, CoverTheFigureTogether) {
  for (const std::string name : {"hero", "fox", "gnome", "knight", "bear"}) {
    const Figured made = drawn(name, 0);
    const FigureParts found = with_figure_parts(without_outlines(made.document), 0, made.image);
    const Frame& frame = found.document.frames[0];
    const Mask figure = whole(made, frame);
    Mask parts(frame.width, frame.height);
    for (const int joint : found.outlined) {
      const Mask part = area(frame, joint);
      for (std::size_t i = 0; i < part.in.size(); ++i) parts.in[i] |= part.in[i];
    }
    double all = 0, covered = 0, beyond = 0;
    for (std::size_t i = 0; i < parts.in.size(); ++i) {
      all += figure.in[i];
      covered += figure.in[i] && parts.in[i];
      beyond += parts.in[i] && !figure.in[i];
    }
    EXPECT_GT(covered / all, 0.97) << name;
    EXPECT_LT(beyond / all, 0.02) << name;
  }
}

TEST(FigureParts, MeetInAnOverlapAboutTheirJoint) {
  const Figured made = drawn("hero", 0);
  const Document next = with_figure_parts(without_outlines(made.document), 0, made.image).document;
  const Skeleton& skeleton = next.skeleton;
  const std::vector<Transform> posed = posed_joints(skeleton, next.frames[0].pose);
  for (const char* name : {"forearm.L", "forearm.R", "shin.L", "shin.R", "foot.L"}) {
    const int joint = skeleton.find(name);
    const Vec2 at = frame_camera(next, 0).project(posed[std::size_t(joint)].translation());
    for (const int part : {joint, skeleton.joints[std::size_t(joint)].parent})
      EXPECT_EQ(area(next.frames[0], part).at(int(at.x()), int(at.y())), 1)
          << name << " of " << skeleton.joints[std::size_t(part)].name;
  }
}

TEST(FigureParts, NeverCrossThemselves) {
  for (const std::string name : {"hero", "fox", "gnome", "knight", "bear", "parrot"}) {
    const Figured made = drawn(name, 1);
    const FigureParts found = with_figure_parts(without_outlines(made.document), 1, made.image);
    EXPECT_GT(found.outlined.size(), 4u) << name;
    for (const Contour& contour : found.document.frames[1].contours)
      EXPECT_FALSE(self_crossing(contour.line)) << name << " " << contour.joint;
  }
}

TEST(FigureParts, LeaveFinishedOutlinesAsTheyAre) {
  const Figured made = drawn("hero", 0);
  Document bare = without_outlines(made.document);
  const int head = bare.skeleton.find("head"), hand = bare.skeleton.find("hand.L");
  for (const Contour& contour : made.document.frames[0].contours)
    if (contour.joint == head) bare = with_contour(std::move(bare), 0, contour);
  bare = with_hidden(std::move(bare), 0, hand, true);
  const FigureParts found = with_figure_parts(bare, 0, made.image);
  EXPECT_EQ(found.had_outline, std::vector<int>{head});
  EXPECT_FALSE(has(found.outlined, head));
  EXPECT_FALSE(has(found.outlined, hand)) << "hidden, as somebody said";
  const std::vector<Polyline> before = contours_of(bare.frames[0], head),
                              after = contours_of(found.document.frames[0], head);
  ASSERT_EQ(after.size(), before.size());
  EXPECT_EQ(after[0].points, before[0].points);
  const FigureParts again = with_figure_parts(found.document, 0, made.image);
  EXPECT_TRUE(again.outlined.empty());
}

TEST(FigureParts, LeaveOutWhatTheFigureDoesNotReach) {
  const Figured made = drawn("hero", 0);
  Document off = without_outlines(made.document);
  const int forearm = off.skeleton.find("forearm.L"), hand = off.skeleton.find("hand.L");
  off.frames[0].pose.rotations[std::size_t(forearm)] =
      Quat(Eigen::AngleAxisd(-1.2, Vec3::UnitZ())) *
      off.frames[0].pose.rotations[std::size_t(forearm)];
  const FigureParts found = with_figure_parts(off, 0, made.image);
  EXPECT_TRUE(has(found.off_figure, hand));
  EXPECT_FALSE(has(found.outlined, hand));
}

TEST(FigureParts, LimbsBehindTheBodyAreSaidToBe) {
  const Figured made = drawn("alien", 1);  // from its side
  const FigureParts found = with_figure_parts(without_outlines(made.document), 1, made.image);
  EXPECT_TRUE(has(found.behind, made.document.skeleton.find("upper_arm.L")));
  EXPECT_TRUE(has(found.outlined, made.document.skeleton.find("upper_arm.R")));
}

TEST(FigureParts, NothingComesOfAnEmptyPicture) {
  const Figured made = drawn("hero", 0);
  const FigureParts found =
      with_figure_parts(without_outlines(made.document), 0, segmented(Image(50, 50)));
  EXPECT_TRUE(found.outlined.empty());
  EXPECT_TRUE(found.document.frames[0].contours.empty());
}

}  // namespace
}  // namespace artisketch
