#include "files/gltf.h"

#include <cstring>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "files/sample_models.h"

namespace artisketch {
namespace {

// A GLB taken apart.
struct Glb {
  nlohmann::json json;
  std::string bin;
  explicit Glb(const std::string& bytes) {
    std::uint32_t size = 0;
    std::memcpy(&size, &bytes[12], 4);
    json = nlohmann::json::parse(bytes.substr(20, size));
    bin = bytes.substr(20 + size + 8);
  }
  template <class T>
  std::vector<T> values(int accessor) const {
    const auto& a = json["accessors"][accessor];
    const auto& view = json["bufferViews"][int(a["bufferView"])];
    std::vector<T> all(view["byteLength"].get<std::size_t>() / sizeof(T));
    std::memcpy(all.data(), &bin[view.value("byteOffset", 0)], all.size() * sizeof(T));
    return all;
  }
  const nlohmann::json& primitive() const { return json["meshes"][0]["primitives"][0]; }
};

double distance(const Pose& a, const Pose& b) {
  double most = (a.root_position - b.root_position).norm();
  for (std::size_t j = 0; j < a.rotations.size(); ++j)
    most = std::max(most, a.rotations[j].angularDistance(b.rotations[j]));
  return most;
}

void expect_same(const Model& model, const Model& read) {
  EXPECT_EQ(read.name, model.name);
  ASSERT_EQ(read.skeleton.size(), model.skeleton.size());
  for (int j = 0; j < model.skeleton.size(); ++j) {
    EXPECT_EQ(read.skeleton.joints[j].name, model.skeleton.joints[j].name);
    EXPECT_EQ(read.skeleton.joints[j].parent, model.skeleton.joints[j].parent);
    EXPECT_EQ(read.skeleton.joints[j].offset, model.skeleton.joints[j].offset);
  }
  // Vertices are rounded to a hundredth of a pixel or so.
  ASSERT_EQ(read.mesh.V.rows(), model.mesh.V.rows());
  EXPECT_LT((read.mesh.V - model.mesh.V).cwiseAbs().maxCoeff(),
            2e-5 * bounds(model.mesh.V).sizes().maxCoeff());
  EXPECT_EQ(read.mesh.F, model.mesh.F);
  // What each vertex owes to each joint, in whatever order it is named.
  for (int v = 0; v < int(model.mesh.V.rows()); ++v) {
    std::vector<double> owed(std::size_t(model.skeleton.size()), 0);
    for (int k = 0; k < 4; ++k) {
      owed[std::size_t(model.weights.joints(v, k))] += model.weights.weights(v, k);
      owed[std::size_t(read.weights.joints(v, k))] -= read.weights.weights(v, k);
    }
    for (const double rest : owed) ASSERT_NEAR(rest, 0, 3e-4) << v;
  }
  ASSERT_EQ(read.texcoords.size(), model.texture ? model.texcoords.size() : 0u);
  ASSERT_EQ(bool(read.texture), bool(model.texture));
  if (model.texture) {
    EXPECT_EQ(read.texture->rgba, model.texture->rgba);
  }
  ASSERT_EQ(read.clips.size(), model.clips.size());
  for (std::size_t c = 0; c < model.clips.size(); ++c) {
    EXPECT_EQ(read.clips[c].name, model.clips[c].name);
    ASSERT_EQ(read.clips[c].times.size(), model.clips[c].times.size());
    for (std::size_t k = 0; k < model.clips[c].times.size(); ++k) {
      EXPECT_EQ(read.clips[c].times[k], double(float(model.clips[c].times[k])));
      EXPECT_LT(distance(read.clips[c].poses[k], model.clips[c].poses[k]), 1e-3);
    }
  }
}

TEST(Gltf, WhatIsWrittenIsRead) {
  for (const auto& [name, model] : sample_models()) {
    SCOPED_TRACE(name);
    const Result<std::string> glb = glb_bytes(model);
    ASSERT_TRUE(glb) << glb.error().text();
    const Result<Model> read = read_glb(*glb, name);
    ASSERT_TRUE(read) << read.error().text();
    expect_same(model, *read);
    EXPECT_EQ(*glb_bytes(model), *glb);  // the same bytes on every run
  }
}

TEST(Gltf, NodesAreTheDocumentsJointsAndTheMeshStandsBesideThem) {
  const Model model = two_joint_model();
  const Glb glb(*glb_bytes(model));
  ASSERT_EQ(glb.json["nodes"].size(), 3u);
  EXPECT_EQ(glb.json["nodes"][0]["name"], "hips");
  EXPECT_EQ(glb.json["nodes"][0]["children"], nlohmann::json::array({1}));
  EXPECT_EQ(glb.json["nodes"][1]["name"], "chest.üp");
  EXPECT_EQ(glb.json["nodes"][1]["translation"], nlohmann::json::array({0.1, 0.5, 0.0}));
  EXPECT_FALSE(glb.json["nodes"][1].contains("rotation"));
  EXPECT_EQ(glb.json["scenes"][0]["nodes"], nlohmann::json::array({0, 2}));
  EXPECT_EQ(glb.json["nodes"][2]["skin"], 0);
  EXPECT_EQ(glb.json["skins"][0]["joints"], nlohmann::json::array({0, 1}));
  EXPECT_EQ(glb.json["skins"][0]["skeleton"], 0);
  const std::string generator = glb.json["asset"]["generator"];
  EXPECT_EQ(generator.rfind("ArtiSketch ", 0), 0u);

  const auto inverse = glb.values<float>(glb.json["skins"][0]["inverseBindMatrices"]);
  ASSERT_EQ(inverse.size(), 32u);
  const Vec3 rest = rest_positions(model.skeleton)[1];
  for (int c = 0; c < 3; ++c) EXPECT_EQ(inverse[16 + 12 + c], -float(rest[c]));
}

TEST(Gltf, AModelWithoutJointsIsAMeshAlone) {
  Model model = two_joint_model();
  model.skeleton = {};
  model.weights = {};
  model.clips.clear();
  const Result<std::string> bytes = glb_bytes(model);
  ASSERT_TRUE(bytes.ok()) << bytes.error().text();
  const Glb glb(*bytes);
  EXPECT_EQ(glb.json["nodes"].size(), 1u);
  EXPECT_FALSE(glb.json["nodes"][0].contains("skin"));
  EXPECT_EQ(glb.json["scenes"][0]["nodes"], nlohmann::json::array({0}));
  EXPECT_FALSE(glb.json.contains("skins"));
  EXPECT_FALSE(glb.json.contains("animations"));
  EXPECT_FALSE(glb.primitive()["attributes"].contains("JOINTS_0"));
  EXPECT_EQ(glb.json["accessors"][int(glb.primitive()["attributes"]["POSITION"])]["count"],
            int(model.mesh.V.rows()));
}

TEST(Gltf, WeightsSumToExactlyOneAndNameEachJointOnce) {
  for (const auto& [name, model] : sample_models()) {
    const Glb glb(*glb_bytes(model));
    const auto weights = glb.values<float>(glb.primitive()["attributes"]["WEIGHTS_0"]);
    ASSERT_EQ(weights.size(), std::size_t(4 * model.mesh.V.rows()));
    const Model read = *read_glb(*glb_bytes(model), name);
    for (int v = 0; v < int(read.mesh.V.rows()); ++v) {
      const float* w = &weights[4 * std::size_t(v)];
      ASSERT_EQ(w[0] + w[1] + w[2] + w[3], 1.0f);
      for (int k = 0; k < 4; ++k) {
        ASSERT_TRUE(w[k] > 0 || read.weights.joints(v, k) == 0);
        for (int l = 0; l < k; ++l)
          ASSERT_TRUE(w[k] == 0 || w[l] == 0 ||
                      read.weights.joints(v, k) != read.weights.joints(v, l));
      }
    }
  }
}

TEST(Gltf, RotationKeysTakeTheShortWay) {
  Model model = two_joint_model();
  Clip& clip = model.clips[0];
  clip.poses[1].rotations[1].coeffs() *= -1;  // the same rotation
  const Glb glb(*glb_bytes(model));
  for (const auto& channel : glb.json["animations"][0]["channels"]) {
    if (channel["target"]["path"] != "rotation") continue;
    const auto& sampler = glb.json["animations"][0]["samplers"][int(channel["sampler"])];
    const auto q = glb.values<float>(sampler["output"]);
    for (std::size_t k = 4; k < q.size(); k += 4)
      EXPECT_GE(q[k] * q[k - 4] + q[k + 1] * q[k - 3] + q[k + 2] * q[k - 2] + q[k + 3] * q[k - 1],
                0);
  }
}

TEST(Gltf, BoundsAreThoseOfTheVertices) {
  const Model model = two_joint_model();
  const Glb glb(*glb_bytes(model));
  const auto& position = glb.json["accessors"][int(glb.primitive()["attributes"]["POSITION"])];
  const Box3 box = bounds(model.mesh.V);
  for (int c = 0; c < 3; ++c) {
    EXPECT_EQ(float(position["min"][c]), float(box.min()[c]));
    EXPECT_EQ(float(position["max"][c]), float(box.max()[c]));
  }
}

TEST(Gltf, TextureSeamsDoNotShowInTheNormals) {
  const Model model = textured_model();
  const Glb glb(*glb_bytes(model));
  const auto normals = glb.values<float>(glb.primitive()["attributes"]["NORMAL"]);
  for (int v = 0; v < int(model.mesh.V.rows()); ++v) {
    const Vec3 n(normals[3 * v], normals[3 * v + 1], normals[3 * v + 2]);
    EXPECT_NEAR(n.norm(), 1, 5e-4);
    EXPECT_GT(n.dot(model.mesh.V.row(v).normalized()), 0.99);  // of a sphere
  }
}

// A texture of few colours is pixel art: its texels are to be seen as squares.
TEST(Gltf, PixelArtIsNotBlurred) {
  constexpr int kLinear = 9729, kNearest = 9728;
  Model model = textured_model();
  model.texture = Image(64, 64);
  for (const bool squares : {true, false}) {
    for (int i = 0; i < 64 * 64; ++i) {
      model.texture->rgba[4 * i] = std::uint8_t(squares ? i % 2 * 200 : i % 256);
      model.texture->rgba[4 * i + 1] = std::uint8_t(squares ? 0 : i / 256);
    }
    const Glb glb(*glb_bytes(model));
    EXPECT_EQ(int(glb.json["samplers"][0]["magFilter"]), squares ? kNearest : kLinear);
  }
}

TEST(Gltf, ManyJointsTakeWiderIndices) {
  const Model model = many_joints_model();
  const Glb glb(*glb_bytes(model));
  const int joints = glb.primitive()["attributes"]["JOINTS_0"];
  EXPECT_EQ(glb.json["accessors"][joints]["componentType"], 5123);
  const auto indices = glb.values<std::uint16_t>(joints);
  EXPECT_EQ(*std::max_element(indices.begin(), indices.end()), 299);
}

TEST(Gltf, ManyVerticesTakeWiderIndices) {
  Model model = two_joint_model();
  const Mesh ball = icosphere(Vec3::Zero(), 1, 6), other = icosphere({3, 0, 0}, 1, 6);
  const int n = int(ball.V.rows());
  model.mesh.V.resize(2 * n, 3);
  model.mesh.V << ball.V, other.V;
  model.mesh.F.resize(2 * ball.F.rows(), 3);
  model.mesh.F << ball.F, (other.F.array() + n).matrix();
  ASSERT_GT(model.mesh.V.rows(), 65535);
  model.weights.joints.setZero(model.mesh.V.rows(), 4);
  model.weights.weights.setZero(model.mesh.V.rows(), 4);
  model.weights.weights.col(0).setOnes();
  const Glb glb(*glb_bytes(model));
  EXPECT_EQ(glb.json["accessors"][int(glb.primitive()["indices"])]["componentType"], 5125);
}

TEST(Gltf, WhatCannotBeShownIsRefusedInWords) {
  Model empty = two_joint_model();
  empty.mesh.F.resize(0, 3);
  EXPECT_EQ(glb_bytes(empty).error().text(), "the model has no surface: nothing can be written");
  Model far = two_joint_model();
  far.mesh.V(3, 1) = 1e300;
  EXPECT_NE(glb_bytes(far).error().text().find("not finite"), std::string::npos);
  Model turned = two_joint_model();
  turned.clips[0].poses[1].rotations[0].coeffs().setConstant(std::nan(""));
  EXPECT_NE(glb_bytes(turned).error().text().find("'frames'"), std::string::npos);
  Model still = two_joint_model();
  still.clips[0].times[1] = still.clips[0].times[0];
  EXPECT_NE(glb_bytes(still).error().text().find("do not increase"), std::string::npos);
}

TEST(Gltf, OtherFilesAreRefusedInWords) {
  const std::string glb = *glb_bytes(two_joint_model());
  const auto words = [](const std::string& bytes) {
    const Result<Model> read = read_glb(bytes, "x.glb");
    return read ? std::string("read") : read.error().text();
  };
  const auto starts = [&](const std::string& bytes, const std::string& start) {
    EXPECT_EQ(words(bytes).substr(0, start.size()), start);
  };
  starts("", "x.glb: is no binary glTF; give a .glb");
  starts("{\"asset\":{\"version\":\"2.0\"}}", "x.glb: is no binary glTF");
  starts(glb.substr(0, glb.size() - 1), "x.glb: is cut off");
  starts(glb.substr(0, 100), "x.glb: is cut off");
  // The same model without its skin, and one that keeps its data elsewhere: same lengths.
  std::string plain = glb;
  plain.replace(plain.find("\"skin\":0"), 8, "\"skim\":0");
  starts(plain, "x.glb: holds no skinned mesh");
  std::string elsewhere = glb;
  elsewhere.replace(elsewhere.find("\"byteLength\":", elsewhere.find("\"buffers\"")), 13,
                    "\"uri\":\"\",\"q\":");
  starts(elsewhere, "x.glb: does not hold all its data");
}

std::string glb_of_json(std::string json) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto word = [](std::size_t n) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += char(n >> 8 * i & 255);
    return bytes;
  };
  return "glTF" + word(2) + word(20 + json.size()) + word(json.size()) + "JSON" + json;
}

TEST(Gltf, NestedExtrasDoNotOverflowTheStack) {
  const Result<Model> read =
      read_glb(glb_of_json(R"({"asset":{"version":"2.0"},"extras":)" + std::string(200000, '[') +
                           std::string(200000, ']') + "}"),
               "x");
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().text().find("nested"), std::string::npos);
}

// Each is looked for among all before it: so many would take minutes.
TEST(Gltf, ObjectsOfVeryManyFieldsAreRefused) {
  std::string json = R"({"asset":{"version":"2.0"},"extras":{"a":0)";
  for (int i = 0; i < 300000; ++i) json += ",\"f" + std::to_string(i) + "\":0";
  const Result<Model> read = read_glb(glb_of_json(json + "}}"), "x");
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().text().find("more than 1000 fields"), std::string::npos);
}

}  // namespace
}  // namespace artisketch
