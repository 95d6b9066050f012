#include "files/sprites.h"

#include <array>
#include <map>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "files/palette.h"

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

// The same in four colours, a quarter of the texture each, laid over x and y.
Model painted() {
  Model model = leaning();
  for (Eigen::Index v = 0; v < 8; ++v)
    model.texcoords.emplace_back(model.mesh.V(v, 0) > 0 ? 1 : 0, model.mesh.V(v, 1) > 0 ? 0 : 1);
  constexpr std::uint8_t kColours[4][3] = {
      {200, 40, 40}, {40, 160, 60}, {50, 60, 190}, {230, 200, 60}};
  Image texture(32, 32);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x)
      std::copy_n(kColours[(x > 15) + 2 * (y > 15)], 3, texture.at(x, y));
  model.texture = texture;
  return model;
}

std::set<Rgb> opaque_colours(const Image& image) {
  std::set<Rgb> colours;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    if (image.rgba[i + 3] == 255)
      colours.insert(Rgb(image.rgba[i]) << 16 | Rgb(image.rgba[i + 1]) << 8 | image.rgba[i + 2]);
  return colours;
}

TEST(Sprites, PlainLightShowsTheTexturesOwnColours) {
  SpriteOptions some = options();
  some.light = Light::plain;
  some.ink = false;
  const Image image = sprite_sheet(painted(), some, "s.png")->image;
  const std::set<Rgb> own{0xc82828, 0x28a03c, 0x323cbe, 0xe6c83c}, seen = opaque_colours(image);
  for (const Rgb c : own) EXPECT_TRUE(seen.contains(c)) << std::hex << c;
}

TEST(Sprites, PixelArtIsOfTheTexturesColoursAndWholePixels) {
  SpriteOptions some = options();
  some.pixels = 2;
  for (const Light light : {Light::soft, Light::plain, Light::toon}) {
    some.light = light;
    const Result<SpriteSheet> sheet = sprite_sheet(painted(), some, "s.png");
    ASSERT_TRUE(sheet);
    for (const Rgb c : opaque_colours(sheet->image))
      EXPECT_TRUE(c == kInkColour ||
                  (std::set<Rgb>{0xc82828, 0x28a03c, 0x323cbe, 0xe6c83c}).contains(c))
          << std::hex << c;
    const auto json = nlohmann::json::parse(sheet->json);
    for (const auto& frame : json["frames"]) {
      const Image one = cut(sheet->image, frame["frame"]);
      ASSERT_EQ(one.width % 2 + one.height % 2, 0);
      for (int y = 0; y < one.height; ++y)
        for (int x = 0; x < one.width; ++x) {
          ASSERT_TRUE(one.at(x, y)[3] == 0 || one.at(x, y)[3] == 255);
          ASSERT_TRUE(std::equal(one.at(x, y), one.at(x, y) + 4, one.at(x / 2 * 2, y / 2 * 2)));
        }
    }
  }
}

TEST(Sprites, InkIsLeftOutWhereItIsNotWanted) {
  SpriteOptions some = options();
  some.pixels = 1;
  some.light = Light::plain;
  EXPECT_TRUE(opaque_colours(sprite_sheet(painted(), some, "s.png")->image).contains(kInkColour));
  some.ink = false;
  EXPECT_FALSE(opaque_colours(sprite_sheet(painted(), some, "s.png")->image).contains(kInkColour));
}

TEST(Sprites, ToonLightHasTwoTones) {
  SpriteOptions some = options();
  some.light = Light::toon;
  some.ink = false;
  Model plain = leaning();  // of clay
  std::map<Rgb, int> count;
  const Image image = sprite_sheet(plain, some, "s.png")->image;
  long all = 0, two = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4)
    if (image.rgba[i + 3] == 255)
      ++count[Rgb(image.rgba[i]) << 16 | Rgb(image.rgba[i + 1]) << 8 | image.rgba[i + 2]], ++all;
  std::vector<int> most;
  for (const auto& [c, n] : count) most.push_back(n);
  std::sort(most.rbegin(), most.rend());
  two = most[0] + most[1];
  EXPECT_GT(most[1], all / 20);
  EXPECT_GT(two, 8 * all / 10);  // mixtures stand where the tones meet alone
}

TEST(Sprites, MapsLieWhereTheSpritesDo) {
  SpriteOptions some = options();
  some.ink = false;
  some.normals = some.depth = true;
  const Result<SpriteSheet> sheet = sprite_sheet(leaning(), some, "s.png");
  ASSERT_TRUE(sheet);
  for (const Image* map : {&sheet->normals, &sheet->depth})
    for (std::size_t i = 3; i < sheet->image.rgba.size(); i += 4)
      ASSERT_EQ(map->rgba[i], sheet->image.rgba[i]);
  const auto json = nlohmann::json::parse(sheet->json);
  EXPECT_EQ(json["meta"]["normal_map"], "s_n.png");
  EXPECT_EQ(json["meta"]["depth_map"], "s_d.png");
  // The box is 0.4 wide and 0.2 deep: its front is nearer than its axis, its side nearer still.
  // What is seen of both faces the viewer, but for corners, whose normals are shared.
  const auto middle = [&](const Image& map, int frame) {
    const Image one = cut(map, json["frames"][frame]["frame"]);
    const std::uint8_t* p = one.at(one.width / 2, one.height / 2);
    return std::array<int, 3>{p[0], p[1], p[2]};
  };
  const auto front = middle(sheet->depth, 0), side = middle(sheet->depth, 4);
  EXPECT_GT(front[0], 128);
  EXPECT_GT(side[0], front[0] + 15);
  EXPECT_EQ(front[0], front[1]);
  const auto normal = middle(sheet->normals, 0);
  EXPECT_GT(normal[2], 220);
  EXPECT_NEAR(normal[0], 128, 40);
}

TEST(Sprites, BothLayoutsSayTheSame) {
  SpriteOptions some = options();
  const auto array = nlohmann::json::parse(sprite_sheet(leaning(), some, "s.png")->json);
  some.layout = SheetLayout::hash;
  const auto hash = nlohmann::json::parse(sprite_sheet(leaning(), some, "s.png")->json);
  EXPECT_EQ(array["meta"], hash["meta"]);
  ASSERT_EQ(array["frames"].size(), hash["frames"].size());
  for (auto frame : array["frames"]) {
    const std::string name = frame["filename"];
    frame.erase("filename");
    EXPECT_EQ(hash["frames"][name], frame) << name;
  }
  for (const auto& tag : array["meta"]["frameTags"]) {
    const auto& names = hash["animations"][tag["name"].get<std::string>()];
    ASSERT_EQ(names.size(), std::size_t(int(tag["to"]) - int(tag["from"]) + 1));
    EXPECT_EQ(names[0], array["frames"][int(tag["from"])]["filename"]);
  }
}

TEST(Sprites, TheFilesAreTheSheetsOwn) {
  SpriteOptions some = options();
  some.normals = some.depth = true;
  const Result<SpriteSheet> sheet = sprite_sheet(painted(), some, "lean.png");
  const Result<std::vector<FileInside>> files = sprite_files(painted(), some, "lean");
  ASSERT_TRUE(sheet && files);
  ASSERT_EQ(files->size(), 4u);
  const std::vector<std::string> names{"lean.png", "lean.json", "lean_n.png", "lean_d.png"};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ((*files)[i].name, names[i]);
  EXPECT_EQ(decode_image((*files)[0].bytes, "")->rgba, sheet->image.rgba);
  EXPECT_EQ((*files)[1].bytes, sheet->json);
  EXPECT_EQ(decode_image((*files)[2].bytes, "")->rgba, sheet->normals.rgba);
  EXPECT_EQ(decode_image((*files)[3].bytes, "")->rgba, sheet->depth.rgba);
  EXPECT_EQ(*sprite_zip(painted(), some, "lean"), zip_bytes(*files));
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
