#include "files/sprites.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "files/render.h"

namespace artisketch {
namespace {

// A box that leans more and more to its side, on one joint, and is upright again at the end.
Model leaning() {
  Model model;
  model.skeleton.joints = {{"box", -1, Vec3::Zero(), -1, ""}};
  model.mesh.V.resize(8, 3);
  for (int v = 0; v < 8; ++v)
    model.mesh.V.row(v) << (v & 1 ? 0.2 : -0.2), (v & 2 ? 1.0 : 0.0), (v & 4 ? 0.1 : -0.1);
  model.mesh.F.resize(12, 3);
  model.mesh.F << 0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2,
      2, 4, 6, 1, 3, 5, 3, 7, 5;
  model.weights.joints.setZero(8, 4);
  model.weights.weights.setZero(8, 4);
  model.weights.weights.col(0).setOnes();
  Clip clip{"lean", {}, {}};
  for (const double degrees_ : {0.0, 30.0, 0.0}) {
    Pose pose = rest_pose(model.skeleton);
    pose.rotations[0] = Quat(Eigen::AngleAxisd(radians(-degrees_), Vec3::UnitZ()));
    clip.times.push_back(0.5 * double(clip.times.size()));
    clip.poses.push_back(pose);
  }
  model.clips = {clip};
  return model;
}

SpriteOptions options() {
  SpriteOptions some;
  some.clip = "lean";
  some.directions = 4;
  some.size = 40;
  some.rate = 4;
  some.padding = 3;
  return some;
}

Image cut(const Image& sheet, const nlohmann::json& at) {
  const int left = at["x"].get<int>(), top = at["y"].get<int>();
  Image out(at["w"].get<int>(), at["h"].get<int>(), 0);
  for (int y = 0; y < out.height; ++y)
    std::copy_n(sheet.at(left, top + y), 4 * out.width, out.at(0, y));
  return out;
}

long inked(const Image& image) {
  long pixels = 0;
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) pixels += image.rgba[i] > 0;
  return pixels;
}

TEST(Sprites, TheSheetsJsonSaysWhereEachOneIs) {
  const Result<SpriteSheet> sheet = sprite_sheet(leaning(), options(), "lean.png");
  ASSERT_TRUE(sheet) << sheet.error().text();
  const auto json = nlohmann::json::parse(sheet->json);
  EXPECT_EQ(json["meta"]["image"], "lean.png");
  EXPECT_EQ(json["meta"]["size"]["w"], sheet->image.width);
  EXPECT_EQ(json["meta"]["size"]["h"], sheet->image.height);
  // A second at four pictures a second; the last pose is the first and is not drawn again.
  ASSERT_EQ(json["frames"].size(), 4u * 4u);
  ASSERT_EQ(json["meta"]["frameTags"].size(), 4u);
  EXPECT_EQ(json["meta"]["frameTags"][1]["from"], 4);
  EXPECT_EQ(json["meta"]["frameTags"][1]["to"], 7);
  long all = 0;
  for (const auto& frame : json["frames"]) {
    EXPECT_EQ(frame["duration"], 250);
    EXPECT_LE(std::max(frame["frame"]["w"].get<int>(), frame["frame"]["h"].get<int>()), 44);
    const long pixels = inked(cut(sheet->image, frame["frame"]));
    EXPECT_GT(pixels, 50);
    all += pixels;
  }
  EXPECT_EQ(all, inked(sheet->image));  // nothing lies between them
}

TEST(Sprites, OneDirectionIsTheFirstOfMany) {
  SpriteOptions one = options();
  const Result<SpriteSheet> many = sprite_sheet(leaning(), one, "s.png");
  one.padding = 0;
  const Result<SpriteSheet> unpadded = sprite_sheet(leaning(), one, "s.png");
  ASSERT_TRUE(many && unpadded);
  const auto a = nlohmann::json::parse(many->json)["frames"],
             b = nlohmann::json::parse(unpadded->json)["frames"];
  for (std::size_t i = 0; i < a.size(); ++i)
    EXPECT_EQ(cut(many->image, a[i]["frame"]).rgba, cut(unpadded->image, b[i]["frame"]).rgba) << i;
  // It moves, and the sides differ.
  EXPECT_NE(cut(many->image, a[0]["frame"]).rgba, cut(many->image, a[2]["frame"]).rgba);
  EXPECT_NE(cut(many->image, a[0]["frame"]).rgba, cut(many->image, a[4]["frame"]).rgba);
}

TEST(Sprites, WhatCannotBeDrawnIsSaid) {
  SpriteOptions some = options();
  some.clip = "walk";
  const Result<SpriteSheet> none = sprite_sheet(leaning(), some, "s.png");
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().text().find("there are lean"), std::string::npos);
  some = options();
  some.directions = 1;
  some.rate = 60;
  some.size = 1024;
  EXPECT_FALSE(sprite_sheet(leaning(), some, "s.png"));
}

}  // namespace
}  // namespace artisketch
