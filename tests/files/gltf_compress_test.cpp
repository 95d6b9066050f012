#include "files/gltf_compress.h"

#include <algorithm>
#include <array>
#include <numeric>

#include <gtest/gtest.h>

#include "files/gltf.h"
#include "files/gltf_data.h"
#include "files/sample_models.h"

namespace artisketch {
namespace {

using Corner = std::array<double, 3>;

// The triangles as places, each from its least corner on, all sorted: the surface in no order.
std::vector<std::array<Corner, 3>> triangles_in_order(const Mesh& mesh) {
  std::vector<std::array<Corner, 3>> all;
  for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
    std::array<Corner, 3> one;
    for (int c = 0; c < 3; ++c) {
      const Eigen::Index v = mesh.F(f, c);
      one[std::size_t(c)] = {mesh.V(v, 0), mesh.V(v, 1), mesh.V(v, 2)};
    }
    std::rotate(one.begin(), std::min_element(one.begin(), one.end()), one.end());
    all.push_back(one);
  }
  std::sort(all.begin(), all.end());
  return all;
}

double posed_apart(const Model& a, const Model& b, const Pose& pose, const Pose& other) {
  Model one = a, two = b;
  one.mesh.V = posed_vertices(a.mesh.V, a.weights, a.skeleton, pose);
  two.mesh.V = posed_vertices(b.mesh.V, b.weights, b.skeleton, other);
  // Vertices stand in another order: a box and a middle tell enough of where they went.
  const Box3 here = bounds(one.mesh.V), there = bounds(two.mesh.V);
  return std::max({(here.min() - there.min()).norm(), (here.max() - there.max()).norm(),
                   (one.mesh.V.colwise().mean() - two.mesh.V.colwise().mean()).norm()});
}

TEST(GltfCompress, TheSurfaceIsTheSameAndMovesAlike) {
  for (const auto& [name, model] : sample_models()) {
    SCOPED_TRACE(name);
    const std::string glb = *glb_bytes(model), small = compressed_glb(glb);
    EXPECT_EQ(small, compressed_glb(glb));
    EXPECT_LT(small.size(), glb.size());
    const Result<Model> whole = read_glb(glb, name), read = read_glb(small, name);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(triangles_in_order(read->mesh), triangles_in_order(whole->mesh));
    for (Eigen::Index v = 0; v < read->mesh.V.rows(); ++v)
      ASSERT_NEAR(read->weights.weights.row(v).sum(), 1, 1e-6);
    EXPECT_EQ(bool(read->texture), bool(whole->texture));
    EXPECT_EQ(read->texcoords.empty(), whole->texcoords.empty());
    ASSERT_EQ(read->clips.size(), whole->clips.size());
    const double size = bounds(whole->mesh.V).sizes().norm();
    for (std::size_t c = 0; c < read->clips.size(); ++c) {
      EXPECT_EQ(read->clips[c].name, whole->clips[c].name);
      ASSERT_EQ(read->clips[c].times, whole->clips[c].times);
      for (std::size_t k = 0; k < read->clips[c].poses.size(); ++k) {
        const Pose &there = read->clips[c].poses[k], &here = whole->clips[c].poses[k];
        EXPECT_LT((there.root_position - here.root_position).norm(), 1e-5 * size);
        for (std::size_t j = 0; j < here.rotations.size(); ++j)
          EXPECT_LT(there.rotations[j].angularDistance(here.rotations[j]), radians(0.03));
        EXPECT_LT(posed_apart(*whole, *read, here, there), 5e-3 * size);
      }
    }
  }
}

TEST(GltfCompress, PlacesOnTheTextureStay) {
  const Model model = textured_model();
  const Model read = *read_glb(compressed_glb(*glb_bytes(model)), "small");
  // textured_model() lays the texture over x and y.
  for (Eigen::Index v = 0; v < read.mesh.V.rows(); ++v) {
    EXPECT_NEAR(read.texcoords[std::size_t(v)].x(), (read.mesh.V(v, 0) + 1) / 2, 1e-4);
    EXPECT_NEAR(read.texcoords[std::size_t(v)].y(), (1 - read.mesh.V(v, 1)) / 2, 1e-4);
  }
}

TEST(GltfCompress, ADetailedModelTakesLessThanAThird) {
  const std::string glb = *glb_bytes(two_joint_model(4));
  EXPECT_LT(compressed_glb(glb).size(), glb.size() / 3);
}

TEST(GltfCompress, ItSaysWhatReadersNeed) {
  const std::string small = compressed_glb(*glb_bytes(person_with_tail_model()));
  const Json json = glb_parts(small).json;
  const std::vector<std::string> both{"KHR_mesh_quantization", "EXT_meshopt_compression"};
  EXPECT_EQ(json["extensionsUsed"].get<std::vector<std::string>>(), both);
  EXPECT_EQ(json["extensionsRequired"].get<std::vector<std::string>>(), both);
  const Json plain = decompressed(glb_parts(small)).json;
  EXPECT_EQ(plain["extensionsRequired"], Json::array({"KHR_mesh_quantization"}));
  EXPECT_EQ(plain["buffers"].size(), 1u);
}

// Whatever a view says of itself: an error in words, and no more memory than its bytes can hold.
TEST(GltfCompress, DamagedViewsAreRefused) {
  const GlbParts good = glb_parts(compressed_glb(*glb_bytes(textured_model())));
  const auto refused = [&](const char* field, const Json& value) {
    GlbParts bad = good;
    for (Json& view : bad.json["bufferViews"])
      if (view.contains("extensions")) view["extensions"]["EXT_meshopt_compression"][field] = value;
    const Result<Model> read = read_glb(glb_of(bad), "bad");
    EXPECT_FALSE(read) << field << " " << value;
  };
  refused("count", 0);
  refused("count", 3000000000u);
  refused("count", -1);
  refused("byteStride", 0);
  refused("byteStride", 3);
  refused("byteStride", 1000);
  refused("byteLength", 1);
  refused("byteOffset", 4000000000u);
  refused("buffer", 1);
  refused("mode", "TRIANGLES");
  refused("mode", "DOUBLE");
  refused("filter", "QUATERNION");
  refused("filter", "SHARPEN");
}

}  // namespace
}  // namespace artisketch
