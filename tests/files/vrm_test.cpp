#include "files/vrm.h"

#include <cstring>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "files/gltf.h"
#include "files/sample_models.h"

namespace artisketch {
namespace {

nlohmann::json json_of(const std::string& glb) {
  std::uint32_t size = 0;
  std::memcpy(&size, &glb[12], 4);
  return nlohmann::json::parse(glb.substr(20, size));
}

VrmMeta somebodys() {
  VrmMeta meta;
  meta.name = "person";
  meta.authors = {"Ann", "Bo"};
  return meta;
}

TEST(Vrm, NamesTheHumanoidsBonesByTheirNodes) {
  const Result<std::string> bytes = vrm_bytes(person_with_tail_model(), somebodys());
  ASSERT_TRUE(bytes) << bytes.error().text();
  const nlohmann::json json = json_of(*bytes), vrm = json["extensions"]["VRMC_vrm"];
  EXPECT_EQ(vrm["specVersion"], "1.0");
  EXPECT_EQ(vrm["meta"]["authors"], (std::vector<std::string>{"Ann", "Bo"}));
  EXPECT_EQ(vrm["meta"]["licenseUrl"], "https://vrm.dev/licenses/1.0/");
  std::set<std::string> needed{"hips", "spine", "head"};
  for (const std::string side : {"left", "right"})
    for (const char* bone : {"UpperArm", "LowerArm", "Hand", "UpperLeg", "LowerLeg", "Foot"})
      needed.insert(side + bone);
  std::set<int> nodes;
  for (const auto& [bone, where] : vrm["humanoid"]["humanBones"].items()) {
    needed.erase(bone);
    EXPECT_EQ(json["nodes"][int(where["node"])]["name"], bone);
    EXPECT_TRUE(nodes.insert(int(where["node"])).second) << bone;
  }
  EXPECT_TRUE(needed.empty()) << *needed.begin();
  const auto& shown = vrm["firstPerson"]["meshAnnotations"][0];
  EXPECT_TRUE(json["nodes"][int(shown["node"])].contains("mesh"));
  EXPECT_EQ(shown["type"], "auto");
  // It is a GLB of ours besides.
  const Result<Model> read = read_glb(*bytes, "person.vrm");
  ASSERT_TRUE(read) << read.error().text();
  EXPECT_EQ(read->clips.size(), 2u);
}

TEST(Vrm, HairAndTailsSwingEachJointInOneSpring) {
  const Result<std::string> bytes = vrm_bytes(person_with_tail_model(), somebodys());
  ASSERT_TRUE(bytes);
  const nlohmann::json json = json_of(*bytes);
  std::set<std::set<std::string>> springs;
  std::set<int> nodes;
  for (const auto& spring : json["extensions"]["VRMC_springBone"]["springs"]) {
    std::set<std::string> names;
    for (const auto& joint : spring["joints"]) {
      names.insert(json["nodes"][int(joint["node"])]["name"]);
      EXPECT_TRUE(nodes.insert(int(joint["node"])).second);
    }
    springs.insert(names);
  }
  EXPECT_EQ(springs, (std::set<std::set<std::string>>{{"hair", "hair_2", "hair_tip"},
                                                      {"tail", "tail_2", "tail_tip"},
                                                      {"tuft", "tuft_tip"}}));
}

TEST(Vrm, WhatIsNoPersonIsSaid) {
  const Result<std::string> ball = vrm_bytes(two_joint_model(), somebodys());
  ASSERT_FALSE(ball);
  EXPECT_NE(ball.error().text().find("no person"), std::string::npos);
}

TEST(Vrm, TheDocumentSaysWhoMadeIt) {
  Document document;
  document.name = "Ann's";
  const auto about = [&](const std::string& fields) {
    document.unknown = fields;
    return vrm_meta(document, "a.artisketch");
  };
  const Result<VrmMeta> good = about(
      R"({"about": {"authors": ["Ann"], "creditNotation": "required", "allowRedistribution": true}})");
  ASSERT_TRUE(good) << good.error().text();
  EXPECT_EQ(good->name, "Ann's");
  EXPECT_EQ(good->authors, std::vector<std::string>{"Ann"});
  EXPECT_EQ(nlohmann::json::parse(good->more),
            (nlohmann::json{{"creditNotation", "required"}, {"allowRedistribution", true}}));
  const struct {
    const char *fields, *words;
  } kWrong[] = {{"", "/about: is missing"},
                {R"({"about": 3})", "/about: is missing"},
                {R"({"about": {"licenseUrl": "x"}})", "/about/authors: names nobody"},
                {R"({"about": {"authors": []}})", "/about/authors: names nobody"},
                {R"({"about": {"authors": [""]}})", "/about/authors: wanted a list of names"},
                {R"({"about": {"authors": "Ann"}})", "/about/authors: wanted a list of names"},
                {R"({"about": {"authors": ["A"], "name": 1}})", "/about/name: wanted words"},
                {R"({"about": {"authors": ["A"], "modification": "no"}})",
                 "/about/modification: wanted one of prohibited"},
                {R"({"about": {"authors": ["A"], "allowRedistribution": "yes"}})",
                 "/about/allowRedistribution: wanted true or false"},
                {R"({"about": {"authors": ["A"], "licence": "x"}})",
                 "/about/licence: is no field that a .vrm has"}};
  for (const auto& wrong : kWrong) {
    const Result<VrmMeta> meta = about(wrong.fields);
    ASSERT_FALSE(meta) << wrong.fields;
    EXPECT_NE(meta.error().text().find(wrong.words), std::string::npos) << meta.error().text();
  }
}

}  // namespace
}  // namespace artisketch
