// Result: posing the model, its clips and keys, its joints' spheres, its parts' fatness, export.
#include <cstdio>
#include <filesystem>
#include <random>

#include <gtest/gtest.h>

#include "app/cli.h"
#include "document/edit.h"
#include "document/templates.h"
#include "editor/step.h"
#include "files/bytes.h"
#include "files/gltf.h"
#include "files/gltf_compress.h"
#include "model/rig/library.h"

namespace artisketch {
namespace {

class ResultMode : public WithDocument {
 protected:
  ResultMode() {
    h.key(ImGuiKey_R);
    h.settle();
    h.key(ImGuiKey_4);
    h.frames(2);
  }
  void expect_view_moved(const std::string& label, const Vec2& from) {
    EXPECT_GT((h.middle(label) - from).norm(), 2);
  }
};

TEST_F(ResultMode, ReconstructMakesTheModelAndSaysSo) {
  EXPECT_TRUE(h.state().has_model);
  EXPECT_TRUE(h.says("The model is ready."));
  EXPECT_EQ(h.state().mode, "result");
  expect_nothing_happened();
}

TEST(ResultAlone, BesideADrawingItSaysHowMuchOfThatTheModelFills) {
  Harness h;
  h.open_example("circles");
  h.key(ImGuiKey_R);
  h.settle();
  h.key(ImGuiKey_1);
  h.frames(2);
  int share = 0;
  for (const std::string& label : h.labels())
    std::sscanf(label.c_str(), "Fills %d %% of this drawing", &share);
  EXPECT_GT(share, 90);
  EXPECT_LE(share, 100);
}

TEST_F(ResultMode, OrbitLooksAroundAndChangesNothing) {
  h.click("Pose tool");
  const Vec2 hand = h.middle("Pose Hand L");
  h.key(ImGuiKey_O);
  EXPECT_TRUE(h.active("Orbit tool"));
  h.drag(h.middle("Turn the model"), {80, 20});
  h.click("Pose tool");
  expect_view_moved("Pose Hand L", hand);
  expect_nothing_happened();
  h.key(ImGuiKey_Home);
  EXPECT_LT((h.middle("Pose Hand L") - hand).norm(), 1);
}

TEST_F(ResultMode, TheWheelComesNearerAndShiftPans) {
  h.click("Pose tool");
  const Vec2 top = h.middle("Pose Head tip"), foot = h.middle("Pose Foot L");
  h.point_at(h.middle("Turn the model"));
  h.wheel(3);
  EXPECT_GT((h.middle("Pose Head tip") - h.middle("Pose Foot L")).norm(),
            1.2 * (top - foot).norm());
  h.key(ImGuiKey_Home);
  const Vec2 home = h.middle("Pose Foot L");
  h.click("Orbit tool");
  h.hold(ImGuiMod_Shift, true);
  h.drag(h.middle("Turn the model"), {50, 0});
  h.hold(ImGuiMod_Shift, false);
  h.click("Pose tool");
  // Nearly: perspective shows what is nearer larger.
  EXPECT_NEAR((h.middle("Pose Foot L") - home).x(), 50, 5);
}

TEST_F(ResultMode, PoseDragsTheModelsJointsUntilReset) {
  h.click("Pose tool");
  EXPECT_FALSE(h.enabled("Reset tool"));
  const Vec2 hand = h.middle("Pose Hand L");
  h.drag(hand, {0, -40});
  EXPECT_GT((h.middle("Pose Hand L") - hand).norm(), 10);
  expect_nothing_happened();
  h.click("Reset tool");
  EXPECT_LT((h.middle("Pose Hand L") - hand).norm(), 1);
}

TEST_F(ResultMode, SetKeyOfADraggedPoseBeginsAClip) {
  h.click("Pose tool");
  h.drag(h.middle("Pose Hand L"), {0, -40});
  h.key(ImGuiKey_I);
  ASSERT_EQ(h.document().animations.size(), 1u);
  EXPECT_EQ(h.document().animations[0].keys.size(), 1u);
  expect_step("New clip");
}

TEST_F(ResultMode, KeysOfOnesOwnClip) {
  h.click("New clip");
  EXPECT_EQ(h.state().undo, "New clip");
  const std::string clip = h.document().animations[0].name;
  EXPECT_TRUE(h.active("Clip " + clip));
  // Another pose, half a second later.
  const Widget& ruler = h.widget("Playhead");
  h.click(Vec2(ruler.x + 0.3 * ruler.width, ruler.y + 6));
  h.click("Pose tool");
  h.drag(h.middle("Pose Hand L"), {0, -40});
  begin();
  h.key(ImGuiKey_I);
  ASSERT_EQ(h.document().animations[0].keys.size(), 2u);
  expect_step("Set key of " + clip);

  // It moves in time.
  const double time = h.document().animations[0].keys[1].time;
  begin();
  h.drag(h.middle("Key 2 of " + clip), {40, 0});
  EXPECT_GT(h.document().animations[0].keys[1].time, time);
  expect_step("Move key of " + clip);

  // Deleted, the first remains.
  h.click("Key 2 of " + clip);
  EXPECT_TRUE(h.active("Key 2 of " + clip));
  begin();
  h.key(ImGuiKey_Delete);
  EXPECT_EQ(h.document().animations[0].keys.size(), 1u);
  expect_step("Delete key of " + clip);
  begin();
  h.right_click("Clip " + clip);
  h.click("Remove clip");
  EXPECT_TRUE(h.document().animations.empty());
  expect_step("Remove " + clip);
}

TEST_F(ResultMode, AClipOfTheLibraryIsPlayedAtOnceAndKeyed) {
  h.click("Library");
  h.click("Add walk");
  ASSERT_EQ(h.document().animations.size(), 1u);
  EXPECT_EQ(h.document().animations[0].name, "walk");
  EXPECT_GT(h.document().animations[0].keys.size(), 8u);
  EXPECT_TRUE(h.active("Clip walk"));
  EXPECT_TRUE(h.enabled("Pause"));
  expect_step("Add walk");
  // A second of the same name is another.
  begin();
  h.click("Library");
  h.click("Add walk");
  EXPECT_EQ(h.document().animations[1].name, "walk 2");
  expect_step("Add walk");
}

TEST_F(ResultMode, AMotionDroppedOnTheWindowBecomesAClip) {
  h.open("hello.bvh", waving());
  ASSERT_EQ(h.document().animations.size(), 1u);
  EXPECT_EQ(h.document().animations[0].name, "hello");
  EXPECT_EQ(h.document().animations[0].keys.size(), 3u);
  EXPECT_TRUE(h.active("Clip hello"));
  expect_step("Add hello");
  begin();
  h.open("broken.bvh", waving().substr(0, 200));
  expect_nothing_happened();
}

TEST_F(ResultMode, AMotionIsOpenedIntoUnsavedWorkWithoutAQuestion) {
  h.key(ImGuiKey_1);
  h.click("Hand R in 1");
  h.key(ImGuiKey_Delete);
  h.platform.to_open.push_back(std::vector<NamedBytes>{{"hello.bvh", waving(), ""}});
  h.key(ImGuiKey_O, ImGuiMod_Ctrl);
  EXPECT_EQ(h.find("Don't save"), nullptr) << "nothing of it is lost";
  EXPECT_EQ(h.document().animations.size(), 1u);
}

TEST_F(ResultMode, WhatAMotionMovesIsListedAndChanged) {
  // An arm whose names mean nothing, beside one that does.
  const std::string joint = "CHANNELS 3 Zrotation Xrotation Yrotation\n";
  const auto arm = [&](const char* upper, const char* lower, int side) {
    const std::string x = std::to_string(30 * side);
    return "JOINT " + std::string(upper) + "\n{\nOFFSET " + x + " 50 0\n" + joint + "JOINT " +
           lower + "\n{\nOFFSET " + x + " 0 0\n" + joint + "End Site\n{\nOFFSET " + x +
           " 0 0\n}\n}\n}\n";
  };
  const std::string bvh =
      "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation "
      "Xrotation Yrotation\n" +
      arm("LeftArm", "LeftForeArm", 1) + arm("Foo", "Bar", -1) +
      "}\nMOTION\nFrames: 2\nFrame Time: 0.5\n"
      "0 90 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0 0\n0 90 0 0 0 0 45 0 0 0 0 0 30 0 0 0 0 0\n";
  h.open("hello.bvh", bvh);
  ASSERT_EQ(h.document().animations.size(), 1u);
  begin();
  h.click("Change");
  ASSERT_NE(h.find("Mover of upper_arm.R"), nullptr) << h.said();
  h.click("Mover of upper_arm.R");
  h.click("Bar");
  ASSERT_EQ(h.document().motion.joints.size(), 1u);
  EXPECT_EQ(h.document().motion.joints[0].first, "Bar");
  EXPECT_EQ(h.document().skeleton.joints[std::size_t(h.document().motion.joints[0].second)].name,
            "upper_arm.R");
  expect_step("Map upper_arm.R");
  h.click("Mover of upper_arm.R");
  h.click("Bar");
  h.click("Mover of upper_arm.R");
  h.click("As found");
  EXPECT_TRUE(h.document().motion.joints.empty());
  h.click("Mover of upper_arm.L");
  h.click("Nobody");
  expect_step("Map upper_arm.L");
  const int left = h.document().skeleton.find("upper_arm.L");
  EXPECT_EQ(h.document().motion.joints, (std::vector{std::pair(std::string(), left)}));
  for (const Key& key : h.document().animations[0].keys)
    EXPECT_LT(key.pose.rotations[std::size_t(left)].angularDistance(Quat::Identity()), 1e-9);
  h.click("Mover of upper_arm.L");
  h.click("As found");
  EXPECT_TRUE(h.document().motion.joints.empty());
  h.click("In place");
  h.key(ImGuiKey_Escape);
  EXPECT_EQ(h.find("Mover of upper_arm.R"), nullptr);
  h.click("Motion");
  EXPECT_TRUE(h.active("In place"));
}

TEST_F(ResultMode, TheTimelineScrollsToAClipJustChosen) {
  for (const char* name : {"idle", "walk", "run", "jump", "wave", "sit"}) {
    h.click("Library");
    h.click(std::string("Add ") + name);
    EXPECT_TRUE(h.active(std::string("Clip ") + name)) << name;
  }
  EXPECT_EQ(h.find("Clip idle"), nullptr) << "there isn't room for all";
  h.point_at(h.middle("Clip sit"));
  h.wheel(10);
  EXPECT_NE(h.find("Clip idle"), nullptr);
  EXPECT_EQ(h.find("Clip sit"), nullptr);
}

TEST_F(ResultMode, EveryAnimationOfAGlbDroppedOnTheWindowBecomesAClip) {
  Model other;
  other.skeleton = template_skeleton(Template::human);
  other.mesh = icosphere(Vec3::Zero(), 1, 0);
  other.weights.joints.setZero(other.mesh.V.rows(), 4);
  other.weights.weights.setZero(other.mesh.V.rows(), 4);
  other.weights.weights.col(0).setOnes();
  for (const char* name : {"walk", "jump"})
    other.clips.push_back(*library_clip(other.skeleton, name, {}));
  const Result<std::string> glb = glb_bytes(other);
  ASSERT_TRUE(glb);
  h.open("moves.glb", *glb);
  ASSERT_EQ(h.document().animations.size(), 2u);
  EXPECT_EQ(h.document().animations[0].name, "walk");
  EXPECT_EQ(h.document().animations[1].name, "jump");
  expect_step("Add moves");
  begin();
  h.open("cut.glb", glb->substr(0, 500));
  expect_nothing_happened();
}

TEST_F(ResultMode, DeleteWithoutAKeyDeletesNothing) {
  h.key(ImGuiKey_Delete);
  expect_nothing_happened();
}

TEST_F(ResultMode, PlayMovesTheModelAndStops) {
  h.click("Pose tool");
  const Vec2 hand = h.middle("Pose Hand L");
  h.key(ImGuiKey_P);
  EXPECT_NE(h.find("Pause"), nullptr);
  h.wait(0.5);
  EXPECT_GT((h.middle("Pose Hand L") - hand).norm(), 2);
  EXPECT_TRUE(h.editor().wants_frame() || h.editor().next_frame_in() < 0.02);
  h.click("Pause");
  const Vec2 there = h.middle("Pose Hand L");
  h.wait(0.5);
  EXPECT_EQ(h.middle("Pose Hand L"), there);
}

TEST_F(ResultMode, WithoutLoopItStopsAtTheEnd) {
  h.click("Loop");
  h.click("Play");
  h.wait(8);
  EXPECT_NE(h.find("Play"), nullptr);
  h.click("Play");  // from the beginning
  h.wait(0.3);
  EXPECT_EQ(h.state().frame, 0);
}

TEST_F(ResultMode, WithLoopItBeginsAgain) {
  h.click("Play");
  bool came_to_last = false, came_back = false;
  for (int i = 0; i < 100; ++i) {
    h.wait(0.1);
    came_to_last = came_to_last || h.state().frame == 2;
    came_back = came_back || (came_to_last && h.state().frame == 0);
  }
  EXPECT_TRUE(came_back);
}

TEST_F(ResultMode, TheKeysBesideThePlayhead) {
  h.click("Next key");
  h.click("Pose tool");
  const Vec2 second = h.middle("Pose Hand L");
  h.click("Next key");
  const Vec2 third = h.middle("Pose Hand L");
  EXPECT_NE(second, third);
  h.click("Previous key");
  EXPECT_EQ(h.middle("Pose Hand L"), second);
}

TEST_F(ResultMode, JointsChangesASpheresSizeAndPlace) {
  h.key(ImGuiKey_J);
  EXPECT_TRUE(h.active("Joints tool"));
  h.settle();
  h.drag(h.middle("Sphere rim Head"), {10, 0});
  const int head = joint(h, "head");
  ASSERT_TRUE(h.document().spheres.contains(head));
  EXPECT_TRUE(h.document().spheres.at(head).radius.has_value());
  EXPECT_LT(h.document().spheres.at(head).offset.norm(), 1e-9);
  expect_step("Joint of Head");
  const double radius = *h.document().spheres.at(head).radius;
  h.drag(h.middle("Sphere Head"), {6, 0});
  EXPECT_NEAR(*h.document().spheres.at(head).radius, radius, 1e-9);
  EXPECT_GT(h.document().spheres.at(head).offset.norm(), 1e-3);
}

TEST_F(ResultMode, FatnessDragsAPart) {
  h.key(ImGuiKey_W);
  EXPECT_TRUE(h.active("Fatness tool"));
  h.drag(h.middle("Fatness of Head"), {75, 0});
  const int head = joint(h, "head");
  ASSERT_TRUE(h.document().parts.contains(head));
  EXPECT_NEAR(h.document().parts.at(head).fatness, std::exp2(0.5), 0.02);
  expect_step("Fatness of Head");
  h.settle();
  h.drag(h.middle("Fatness of Head"), {-75, 0});
  h.settle();
}

TEST_F(ResultMode, ThePreviewsSurfaces) {
  for (const std::string surface : {"Weights", "Wireframe", "Shaded", "Textured"}) {
    const int painted = h.graphics.painted;
    h.click(surface);
    EXPECT_TRUE(h.active(surface));
    EXPECT_GT(h.graphics.painted, painted - (surface == "Textured")) << surface;
    EXPECT_EQ(h.graphics.look.edges_alone, surface == "Wireframe");
    EXPECT_EQ(h.graphics.look.texture != 0, surface == "Textured");
  }
  EXPECT_FALSE(h.active("Model skeleton"));
  h.click("Model skeleton");
  EXPECT_TRUE(h.active("Model skeleton"));
}

TEST_F(ResultMode, AChangedDocumentIsSaidToBeAhead) {
  h.key(ImGuiKey_1);
  h.click("Hand R in 1");
  h.key(ImGuiKey_Delete);
  h.key(ImGuiKey_4);
  EXPECT_TRUE(h.state().has_model) << "the old one stays";
  h.key(ImGuiKey_E, ImGuiMod_Ctrl);
  h.click("Export hero.glb");
  EXPECT_EQ(std::ranges::count(h.jobs.started, JobRequest::Kind::reconstruct), 2)
      << "it is made again first";
  h.settle();
  EXPECT_TRUE(h.says("Exported hero.glb."));
}

// ---------------------------------------------------------------- export

TEST_F(ResultMode, EachFormatIsAFile) {
  h.key(ImGuiKey_E, ImGuiMod_Ctrl);
  const std::vector<std::pair<std::string, std::string>> formats = {
      {"GLB", "glTF"}, {"OBJ", "#"}, {"STL", ""}, {"PLY", "ply"}, {"PNG", "\x89PNG"}};
  for (const auto& [format, begin] : formats) {
    std::string name = "hero." + format;
    std::transform(name.begin(), name.end(), name.begin(), ::tolower);
    h.click("Format " + format);
    EXPECT_TRUE(h.active("Format " + format));
    h.click("Export " + name);
    ASSERT_TRUE(h.platform.files.contains("/kept/" + name)) << name;
    EXPECT_TRUE(h.platform.files["/kept/" + name].starts_with(begin)) << name;
    EXPECT_GT(h.platform.files["/kept/" + name].size(), 1000u) << name;
    EXPECT_TRUE(h.says("Exported " + name + "."));
  }
  h.key(ImGuiKey_Escape);
  EXPECT_EQ(h.find("Format GLB"), nullptr);
  expect_nothing_happened();
}

TEST_F(ResultMode, AnAvatarAsksOnceWhoMadeIt) {
  h.key(ImGuiKey_E, ImGuiMod_Ctrl);
  h.click("Format VRM");
  h.click("Export hero.vrm");
  EXPECT_TRUE(h.platform.files.empty());
  h.frames(3);
  h.type("Ann");
  h.key(ImGuiKey_Enter);
  ASSERT_TRUE(h.platform.files.contains("/kept/hero.vrm"));
  EXPECT_NE(h.platform.files["/kept/hero.vrm"].find("VRMC_vrm"), std::string::npos);
  EXPECT_NE(h.platform.files["/kept/hero.vrm"].find("\"Ann\""), std::string::npos);
  expect_step("Name the author");
  h.platform.files.clear();
  h.click("Export hero.vrm");
  EXPECT_TRUE(h.platform.files.contains("/kept/hero.vrm")) << "the document keeps it";
}

TEST_F(ResultMode, JointsAreNamedAsAnEngineHasThem) {
  h.key(ImGuiKey_E, ImGuiMod_Ctrl);
  h.click("Joints' names");
  h.click("Mixamo");
  h.click("Export hero.glb");
  const Result<Model> model = read_glb(h.platform.files["/kept/hero.glb"], "hero");
  ASSERT_TRUE(model) << model.error().text();
  EXPECT_EQ(model->skeleton.joints[0].name, "mixamorig:Hips");
  h.click("Joints' names");
  h.click("As drawn");
  h.click("Export hero.glb");
  EXPECT_EQ(read_glb(h.platform.files["/kept/hero.glb"], "hero")->skeleton.joints[0].name,
            h.document().skeleton.joints[0].name);
  expect_nothing_happened();
}

TEST_F(ResultMode, OnlyThePoseThatIsShownIsAMeshWithoutSkeleton) {
  h.key(ImGuiKey_E, ImGuiMod_Ctrl);
  EXPECT_NE(h.find("frames"), nullptr);
  h.click("Joints' names");
  h.click("Only this pose, no skeleton");
  EXPECT_EQ(h.find("frames"), nullptr) << "nothing moves";
  h.click("Export hero.glb");
  const std::string& glb = h.platform.files["/kept/hero.glb"];
  EXPECT_EQ(glb.substr(0, 4), "glTF");
  EXPECT_EQ(glb.find("\"skins\""), glb.npos);
  EXPECT_EQ(glb.find("\"animations\""), glb.npos);
  EXPECT_NE(glb.find("\"TEXCOORD_0\""), glb.npos);
  h.click("Joints' names");
  h.click("As drawn");
  EXPECT_NE(h.find("frames"), nullptr);
  expect_nothing_happened();
}

TEST_F(ResultMode, CompressedIsTheSameModelInFewerBytes) {
  h.key(ImGuiKey_E, ImGuiMod_Ctrl);
  h.click("Export hero.glb");
  const std::string whole = h.platform.files["/kept/hero.glb"];
  h.click("Compressed (not for Godot)");
  h.click("Export hero.glb");
  const std::string small = h.platform.files["/kept/hero.glb"];
  EXPECT_EQ(small, compressed_glb(whole));
  EXPECT_LT(small.size(), whole.size() * 7 / 10);
}

// What the command line writes of the exported model with these choices.
TEST_F(ResultMode, SpritesAreTheCommandLinesByteForByte) {
  h.click("Library");
  h.click("Add walk");
  h.key(ImGuiKey_E, ImGuiMod_Ctrl);
  h.click("Export hero.glb");
  h.click("Format Sprites");
  for (const char* choice : {"Sides 4", "Size 64", "A second 8", "Padding 1", "Light Toon",
                             "Pixels 2", "JSON By name", "Normals", "Depth"})
    h.click(choice);
  h.jobs.held = true;
  h.click("Export hero.zip");
  h.frame();
  EXPECT_FALSE(h.find("Export hero.zip")->enabled);
  EXPECT_TRUE(h.state().busy);
  h.click("Cancel");
  EXPECT_FALSE(h.state().busy);
  EXPECT_FALSE(h.platform.files.contains("/kept/hero.zip"));
  h.jobs.held = false;
  h.frame();
  h.click("Export hero.zip");
  ASSERT_TRUE(h.platform.files.contains("/kept/hero.zip"));

  const auto folder = std::filesystem::temp_directory_path() /
                      ("artisketch_sprites_" + std::to_string(std::random_device()()));
  std::filesystem::create_directory(folder);
  const std::string glb = (folder / "model.glb").string(), zip = (folder / "hero.zip").string();
  ASSERT_TRUE(write_file(glb, h.platform.files["/kept/hero.glb"]));
  EXPECT_EQ(
      run_cli({"sprites",  glb,  "-o",       zip,    "--clip",    "walk",   "--directions", "4",
               "--size",   "64", "--rate",   "8",    "--padding", "1",      "--light",      "toon",
               "--pixels", "2",  "--layout", "hash", "--normals", "--depth"}),
      0);
  EXPECT_EQ(h.platform.files["/kept/hero.zip"], *read_file(zip));
  std::filesystem::remove_all(folder);
}

TEST_F(ResultMode, ASmallerTextureMakesASmallerFile) {
  h.key(ImGuiKey_E, ImGuiMod_Ctrl);
  h.click("Export hero.glb");
  const std::size_t whole = h.platform.files["/kept/hero.glb"].size();
  std::vector<std::string> sizes;
  for (const std::string& label : h.labels())
    if (label.starts_with("Texture ")) sizes.push_back(label);
  ASSERT_EQ(sizes.size(), 3u);
  h.click(sizes[0]);
  h.click("Export hero.glb");
  const std::size_t less = h.platform.files["/kept/hero.glb"].size();
  EXPECT_LT(less, whole);
  h.click("None");
  h.click("Export hero.glb");
  EXPECT_LT(h.platform.files["/kept/hero.glb"].size(), less);
}

TEST_F(ResultMode, AClipMayStayBehind) {
  h.key(ImGuiKey_E, ImGuiMod_Ctrl);
  h.click("Export hero.glb");
  EXPECT_NE(h.platform.files["/kept/hero.glb"].find("\"frames\""), std::string::npos);
  h.click("frames");
  EXPECT_FALSE(h.active("frames"));
  h.click("Export hero.glb");
  EXPECT_EQ(h.platform.files["/kept/hero.glb"].find("\"frames\""), std::string::npos);
  h.click("frames");
  h.click("Export hero.glb");
  EXPECT_NE(h.platform.files["/kept/hero.glb"].find("\"frames\""), std::string::npos);
}

TEST_F(ResultMode, SpritesFromEightSides) {
  h.key(ImGuiKey_E, ImGuiMod_Ctrl);
  h.click("Format PNG");
  h.click("Export hero.png");
  const std::string one = h.platform.files["/kept/hero.png"];
  h.click("From 8 sides");
  h.click("Export hero.png");
  EXPECT_NE(h.platform.files["/kept/hero.png"], one);
}

TEST_F(ResultMode, MoreOrFewerTrianglesAreAnotherModel) {
  h.key(ImGuiKey_E, ImGuiMod_Ctrl);
  h.drag(h.middle("Triangles"), {-60, 0});
  ASSERT_TRUE(h.document().settings.triangles.has_value());
  EXPECT_LT(*h.document().settings.triangles, 15000);
  expect_step("Set triangles");
}

TEST_F(ResultMode, WhatCantBeSavedIsSaid) {
  h.platform.no_saving = io_error("the disk is full");
  h.key(ImGuiKey_E, ImGuiMod_Ctrl);
  h.click("Export hero.glb");
  EXPECT_TRUE(h.says("the disk is full"));
  h.wait(10);
  EXPECT_TRUE(h.says("the disk is full")) << "an error stays";
  h.click("Dismiss");
  EXPECT_FALSE(h.says("the disk is full"));
}

TEST_F(ResultMode, WithoutDialogsThePathIsTyped) {
  h.platform.dialogs = false;
  h.key(ImGuiKey_E, ImGuiMod_Ctrl);
  h.click("Format OBJ");
  h.click("Export hero.obj");
  h.frames(3);
  h.key(ImGuiKey_A, ImGuiMod_Ctrl);
  h.type("/tmp/shape.obj");
  h.key(ImGuiKey_Enter);
  EXPECT_TRUE(h.platform.files.contains("/tmp/shape.obj"));
}

TEST(ResultAlone, AClipOfAnOlderModelHasTheSkeletonsJoints) {
  Harness h;
  h.open_example("circles");
  h.key(ImGuiKey_R);
  h.settle();
  ASSERT_TRUE(h.state().has_model);
  h.key(ImGuiKey_2);
  h.click("Template Human");
  h.key(ImGuiKey_4);
  h.click("New clip");
  ASSERT_EQ(h.document().animations.size(), 1u);
  EXPECT_EQ(int(h.document().animations[0].keys[0].pose.rotations.size()),
            h.document().skeleton.size());
  h.key(ImGuiKey_R);
  h.settle();
}

TEST(ResultAlone, ExportSaysWhatItLacks) {
  Harness h;
  h.click("Blank paper");
  EXPECT_FALSE(h.enabled("Export"));
  h.key(ImGuiKey_E, ImGuiMod_Ctrl);
  EXPECT_TRUE(h.says("Outline a part first."));
  h.open_example("circles");
  if (h.find("Don't save")) h.click("Don't save");
  h.key(ImGuiKey_E, ImGuiMod_Ctrl);
  EXPECT_TRUE(h.says("Reconstruct makes the model to export."));
}

// ---------------------------------------------------------------- jobs

TEST_F(WithDocument, ProgressTakesThePlaceOfReconstruct) {
  h.jobs.held = true;
  h.jobs.shown.stage = "consolidating";
  h.jobs.shown.fraction = 0.4;
  h.key(ImGuiKey_R);
  EXPECT_TRUE(h.state().busy);
  EXPECT_EQ(h.state().stage, "consolidating");
  EXPECT_EQ(h.state().progress, 0.4);
  EXPECT_EQ(h.find("Reconstruct"), nullptr);
  h.click("Cancel");
  EXPECT_FALSE(h.state().busy);
  h.frame();
  EXPECT_TRUE(h.says("Stopped."));
  EXPECT_FALSE(h.state().has_model);
  h.key(ImGuiKey_R);
  h.key(ImGuiKey_Escape);
  EXPECT_FALSE(h.state().busy);
}

TEST_F(WithDocument, AFailedJobOffersAnotherTry) {
  h.jobs.ends = Result<JobResult>(bad_input("frame 2: the contour of 'hand.L' crosses itself"));
  h.key(ImGuiKey_R);
  h.settle();
  EXPECT_TRUE(h.says("crosses itself"));
  EXPECT_FALSE(h.state().has_model);
  h.click("Try again");
  h.settle();
  EXPECT_TRUE(h.state().has_model);
}

TEST_F(WithDocument, SeeItMoveGoesThere) {
  h.key(ImGuiKey_R);
  h.settle();
  h.click("See it move");
  EXPECT_EQ(h.state().mode, "result");
  EXPECT_NE(h.find("Pause"), nullptr);
}

TEST(ResultAlone, ReconstructSaysWhatItLacks) {
  Harness h;
  h.start_over();
  h.key(ImGuiKey_R);
  EXPECT_TRUE(h.says("Add a drawing first."));
  h.click("Blank paper");
  h.key(ImGuiKey_R);
  EXPECT_TRUE(h.says("Outline a part first."));
  EXPECT_FALSE(h.state().busy);
}

}  // namespace
}  // namespace artisketch
