#include <cmath>
#include <cstring>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "document/templates.h"
#include "files/gltf.h"
#include "files/motion_file.h"
#include "files/sample_models.h"
#include "fuzz/mutations.h"
#include "model/rig/actor.h"
#include "model/rig/library.h"
#include "model/rig/retarget.h"

namespace artisketch {
namespace {

using nlohmann::json;

// How a program may have written a motion as glTF.
struct Manner {
  const char* name;
  bool own_axes = false;  // joints turned at rest, as Blender's bones are
  bool armature = false;  // below a node that is scaled to metres and turns z up to y
  bool skin = false;      // the bind pose in a skin, the nodes left as the first pose has them
  const char* way = "LINEAR";
  bool shorts = false;  // rotations as normalized 16-bit numbers
};
constexpr Manner kManners[] = {
    {.name = "plain"},
    {.name = "own axes", .own_axes = true},
    {.name = "armature", .armature = true},
    {.name = "skin", .skin = true},
    {.name = "all", .own_axes = true, .armature = true, .skin = true},
    {.name = "steps", .way = "STEP"},
    {.name = "splines", .own_axes = true, .way = "CUBICSPLINE"},
    {.name = "shorts", .own_axes = true, .shorts = true},
};

// A GLB in the making: accessors of floats or shorts over one buffer.
class GlbText {
 public:
  json root = {{"asset", {{"version", "2.0"}}},
               {"nodes", json::array()},
               {"accessors", json::array()},
               {"bufferViews", json::array()}};
  template <class T>
  int add(const std::vector<T>& values, const char* type, int width) {
    while (bin_.size() % 4) bin_ += '\0';
    root["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", bin_.size()}, {"byteLength", values.size() * sizeof(T)}});
    bin_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    const bool floats = sizeof(T) == 4;
    root["accessors"].push_back({{"bufferView", root["bufferViews"].size() - 1},
                                 {"componentType", floats ? 5126 : 5122},
                                 {"normalized", !floats},
                                 {"count", values.size() / width},
                                 {"type", type}});
    return int(root["accessors"].size()) - 1;
  }
  std::string bytes() {
    while (bin_.size() % 4) bin_ += '\0';
    root["buffers"] = {{{"byteLength", bin_.size()}}};
    std::string text = root.dump();
    while (text.size() % 4) text += ' ';
    std::string all = "glTF";
    const auto put = [&](std::size_t value) {
      for (int i = 0; i < 4; ++i) all += char(value >> (8 * i) & 255);
    };
    put(2);
    put(28 + text.size() + bin_.size());
    put(text.size());
    all += "JSON" + text;
    put(bin_.size());
    all += std::string("BIN\0", 4) + bin_;
    return all;
  }

 private:
  std::string bin_;
};

Quat axes_of(int joint, const Manner& manner) {
  if (!manner.own_axes) return Quat::Identity();
  return Quat(1 + joint % 3, std::sin(joint), std::cos(3 * joint), 0.3 * joint).normalized();
}

Transform armature_turn() {
  return Transform(Eigen::AngleAxisd(-kPi / 2, Vec3::UnitX()));
}

template <class V>
std::vector<double> numbers_of(const V& v) {
  return {v.data(), v.data() + v.size()};
}

std::string glb_text(const Motion& motion, const Manner& manner) {
  GlbText out;
  const Skeleton& skeleton = motion.skeleton;
  const int count = skeleton.size();
  const auto world_axes = [&](int j) {
    return j < 0 ? Quat(Quat::Identity()) : axes_of(j, manner);
  };
  // A joint's local turn in a pose, in its own axes.
  const auto local = [&](int j, const Pose& pose) {
    const int parent = skeleton.joints[j].parent;
    return Quat(world_axes(parent).conjugate() * pose.rotations[j] * world_axes(j)).normalized();
  };
  const Pose at_rest = rest_pose(skeleton);
  const Pose& seen = manner.skin ? motion.poses[0] : at_rest;
  std::vector<float> inverse_bind;
  const std::vector<Vec3> rest = rest_positions(skeleton);
  for (int j = 0; j < count; ++j) {
    const int parent = skeleton.joints[j].parent;
    const Vec3 offset = parent < 0
                            ? seen.root_position
                            : Vec3(world_axes(parent).conjugate() * skeleton.joints[j].offset);
    json node = {{"translation", numbers_of(offset)},
                 {"rotation", numbers_of(local(j, seen).coeffs())}};
    if (!skeleton.joints[j].name.empty()) node["name"] = skeleton.joints[j].name;
    if (const auto children = skeleton.children(j); !children.empty()) node["children"] = children;
    out.root["nodes"].push_back(node);
    Transform bound = Transform::Identity();
    bound.translation() = rest[j];
    bound.linear() = world_axes(j).toRotationMatrix();
    const Eigen::Matrix4f inverse = bound.inverse().matrix().cast<float>();
    inverse_bind.insert(inverse_bind.end(), inverse.data(), inverse.data() + 16);
  }
  if (manner.armature)
    out.root["nodes"].push_back(
        {{"name", "Armature"},
         {"children", {0}},
         {"scale", {0.01, 0.01, 0.01}},
         {"rotation", numbers_of(Quat(armature_turn().linear()).coeffs())}});
  out.root["scenes"] = {{{"nodes", {manner.armature ? count : 0}}}};
  if (manner.skin) {
    json joints = json::array();
    for (int j = 0; j < count; ++j) joints.push_back(j);
    out.root["skins"] = {
        {{"joints", joints}, {"inverseBindMatrices", out.add(inverse_bind, "MAT4", 16)}}};
  }
  std::vector<float> times;
  for (std::size_t k = 0; k < motion.poses.size(); ++k) times.push_back(float(k * motion.step));
  const int input = out.add(times, "SCALAR", 1);
  json animation = {{"name", "walk"}, {"channels", json::array()}, {"samplers", json::array()}};
  const auto add_channel = [&](int node, const char* path, int output) {
    animation["channels"].push_back(
        {{"sampler", animation["samplers"].size()}, {"target", {{"node", node}, {"path", path}}}});
    animation["samplers"].push_back(
        {{"input", input}, {"output", output}, {"interpolation", manner.way}});
  };
  const bool spline = std::string(manner.way) == "CUBICSPLINE";
  const auto keyed = [&](auto value_at, int width) {
    std::vector<float> values;
    for (const Pose& pose : motion.poses) {
      if (spline) values.insert(values.end(), std::size_t(width), 0);  // tangents
      for (int c = 0; c < width; ++c) values.push_back(float(value_at(pose)[c]));
      if (spline) values.insert(values.end(), std::size_t(width), 0);
    }
    return values;
  };
  add_channel(0, "translation",
              out.add(keyed([](const Pose& pose) { return pose.root_position; }, 3), "VEC3", 3));
  for (int j = 0; j < count; ++j) {
    if (skeleton.joints[j].name.empty()) continue;
    const std::vector<float> values =
        keyed([&](const Pose& pose) { return local(j, pose).coeffs().eval(); }, 4);
    std::vector<std::int16_t> shorts;
    for (const float v : values) shorts.push_back(std::int16_t(std::lround(v * 32767)));
    add_channel(j, "rotation",
                manner.shorts ? out.add(shorts, "VEC4", 4) : out.add(values, "VEC4", 4));
  }
  out.root["animations"] = {animation};
  return out.bytes();
}

std::vector<Vec3> places_at(const Motion& motion, int k) {
  std::vector<Vec3> at;
  for (const Transform& joint : posed_joints(motion, k)) at.push_back(joint.translation());
  return at;
}

const Vocabulary& vocabulary(const std::string& name) {
  for (const Vocabulary& one : vocabularies())
    if (one.name == name) return one;
  return vocabularies()[0];
}

TEST(GltfMotion, JointsStandWhereTheFileHasThemHoweverItIsWritten) {
  const Actor actor = walking_person();
  const Motion truth = recorded(actor, vocabulary("Mixamo"), Rest::t_pose, false);
  for (const Manner& manner : kManners) {
    SCOPED_TRACE(manner.name);
    const std::string bytes = glb_text(truth, manner);
    ASSERT_TRUE(is_motion(bytes));
    const auto read = parse_motions(bytes, "file", "file.glb");
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->size(), 1u);
    const Motion& motion = (*read)[0];
    EXPECT_EQ(motion.name, "walk");
    EXPECT_NEAR(motion.step, truth.step, 1e-6);
    ASSERT_EQ(motion.poses.size(), truth.poses.size());
    ASSERT_EQ(motion.skeleton.size(), truth.skeleton.size());
    const double unit = manner.armature ? 0.01 : 1;
    const Transform turn = manner.armature ? armature_turn() : Transform::Identity();
    for (int k = 0; k < int(truth.poses.size()); k += 7) {
      const std::vector<Vec3> wanted = places_at(truth, k), got = places_at(motion, k);
      for (int j = 0; j < truth.skeleton.size(); ++j) {
        const int found = motion.skeleton.find(truth.skeleton.joints[j].name);
        if (truth.skeleton.joints[j].name.empty()) continue;
        ASSERT_GE(found, 0);
        EXPECT_LT((turn * Vec3(unit * wanted[j]) - got[found]).norm(), unit * 0.05)  // 0.5 mm
            << truth.skeleton.joints[j].name << ", pose " << k;
      }
    }
    // At rest as bound, whatever the nodes show.
    const std::vector<Vec3> rest = rest_positions(motion.skeleton),
                            wanted = rest_positions(truth.skeleton);
    const int hand = motion.skeleton.find("mixamorig:LeftHand"),
              hips = motion.skeleton.find("mixamorig:Hips");
    const int their_hand = truth.skeleton.find("mixamorig:LeftHand");
    ASSERT_GE(std::min({hand, hips, their_hand}), 0);
    EXPECT_NEAR((rest[hand] - rest[hips]).norm(), unit * (wanted[their_hand] - wanted[0]).norm(),
                unit * 0.1);
  }
}

TEST(GltfMotion, MovesADocumentAsABvhDoes) {
  const Actor actor = walking_person();
  Document document;
  document.skeleton = template_skeleton(Template::human);
  const Motion truth = recorded(actor, vocabulary("Mixamo"), Rest::t_pose, false);
  const Result<Retargeted> wanted = retargeted(document, truth, {});
  ASSERT_TRUE(wanted);
  for (const Manner& manner : kManners) {
    SCOPED_TRACE(manner.name);
    // Below an armature z is up, which its turn makes y.
    const Motion written = recorded(actor, vocabulary("Mixamo"), Rest::t_pose, manner.armature);
    const auto read = parse_motions(glb_text(written, manner), "file", "file.glb");
    ASSERT_TRUE(read);
    const Result<Retargeted> got = retargeted(document, (*read)[0], {});
    ASSERT_TRUE(got) << got.error().text();
    EXPECT_EQ(got->map.matches.size(), wanted->map.matches.size());
    EXPECT_FALSE(got->z_up);
    for (std::size_t k = 0; k < wanted->clip.poses.size(); k += 9) {
      const auto a = posed_joints(document.skeleton, wanted->clip.poses[k]),
                 b = posed_joints(document.skeleton, got->clip.poses[k]);
      for (int j = 0; j < document.skeleton.size(); ++j)
        EXPECT_LT((a[j].translation() - b[j].translation()).norm(), 0.01)
            << document.skeleton.joints[j].name << ", pose " << k;
    }
  }
}

TEST(GltfMotion, OursComeBackClipByClip) {
  Model model = two_joint_model();
  Clip second = model.clips[0];
  second.name = "nod";
  second.poses.pop_back(), second.times.pop_back();
  model.clips.push_back(second);
  const Result<std::string> bytes = glb_bytes(model);
  ASSERT_TRUE(bytes);
  const auto read = parse_motions(*bytes, "ball", "ball.glb");
  ASSERT_TRUE(read) << read.error().text();
  ASSERT_EQ(read->size(), 2u);
  EXPECT_EQ((*read)[0].name, "frames");
  EXPECT_EQ((*read)[1].name, "nod");
  for (const Motion& motion : *read) {
    ASSERT_EQ(motion.skeleton.size(), 2);
    const Clip& clip = model.clips[motion.name == "nod"];
    EXPECT_NEAR(motion.step * double(motion.poses.size() - 1), clip.times.back(), 1e-6);
    EXPECT_LT((motion.poses.back().root_position - clip.poses.back().root_position).norm(), 1e-6);
    EXPECT_LT(motion.poses.back().rotations[1].angularDistance(clip.poses.back().rotations[1]),
              1e-3);
  }
}

TEST(GltfMotion, WhatIsNoneIsSaid) {
  Model model = two_joint_model();
  model.clips.clear();
  const Result<std::string> still = glb_bytes(model);
  ASSERT_TRUE(still);
  const auto none = parse_motions(*still, "m", "m.glb");
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().text().find("m.glb: holds no animation"), std::string::npos);

  GlbText ring;
  ring.root["nodes"] = {{{"children", {1}}}, {{"children", {0}}}};
  ring.root["animations"] = {{{"channels", json::array()}, {"samplers", json::array()}}};
  ring.add(std::vector<float>{0, 1}, "SCALAR", 1);
  const auto looped = parse_motions(ring.bytes(), "m", "m.glb");
  ASSERT_FALSE(looped);
  EXPECT_NE(looped.error().text().find("hang in a ring"), std::string::npos);
}

TEST(GltfMotion, KeysNamedAgainAndAgainAreTooMany) {
  // 100 kB of keys that 30,000 channels name: gigabytes, if each were kept.
  GlbText out;
  const int values = out.add(std::vector<float>(30000, 0), "VEC3", 3);
  std::vector<float> times(10000);
  for (std::size_t k = 0; k < times.size(); ++k) times[k] = float(k);
  const int input = out.add(times, "SCALAR", 1);
  out.root["nodes"] = {json::object()};
  json channels = json::array();
  for (int i = 0; i < 30000; ++i)
    channels.push_back({{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}});
  out.root["animations"] = {
      {{"channels", channels}, {"samplers", {{{"input", input}, {"output", values}}}}}};
  const auto read = parse_motions(out.bytes(), "m", "m.glb");
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().text().find("more keys"), std::string::npos);
}

TEST(GltfMotion, DamagedFilesAreRefusedInWords) {
  const Motion truth = recorded(walking_person(), vocabulary("Mixamo"), Rest::t_pose, false);
  Motion brief = truth;
  brief.poses.resize(3);
  const std::string whole = glb_text(brief, kManners[4]);
  Mutator mutator(7);
  for (int i = 0; i < 500; ++i) {
    const auto read = parse_motions(mutator.damaged(whole), "m", "m.glb");
    if (!read) {
      EXPECT_FALSE(read.error().faults.empty());
    }
  }
}

}  // namespace
}  // namespace artisketch
