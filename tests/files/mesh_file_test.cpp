#include "files/mesh_file.h"

#include <cstring>
#include <sstream>

#include <gtest/gtest.h>

#include "files/sample_models.h"

namespace artisketch {
namespace {

template <class T>
T value_at(const std::string& bytes, std::size_t at) {
  T value;
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

// A closed surface again, of the sphere's volume, whatever seams the texture had.
void expect_whole(const Mesh& mesh, const Model& model) {
  const Topology t = topology(mesh);
  EXPECT_TRUE(t.manifold());
  EXPECT_EQ(t.components, 1);
  EXPECT_EQ(mesh.F.rows(), model.mesh.F.rows());
  EXPECT_NEAR(signed_volume(mesh), signed_volume(model.mesh), 1e-5);
}

TEST(MeshFile, ObjReadsBackAsOneClosedSurface) {
  const Model model = textured_model();
  std::istringstream text(obj_text(model));
  std::vector<Vec3> V;
  std::vector<Index3> F;
  std::string line;
  while (std::getline(text, line)) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") words >> V.emplace_back()[0] >> V.back()[1] >> V.back()[2];
    if (kind == "f") words >> F.emplace_back()[0] >> F.back()[1] >> F.back()[2];
    ASSERT_FALSE(words.fail()) << line;
  }
  Mesh mesh;
  mesh.V.resize(Eigen::Index(V.size()), 3);
  mesh.F.resize(Eigen::Index(F.size()), 3);
  for (std::size_t v = 0; v < V.size(); ++v) mesh.V.row(v) = V[v].transpose();
  for (std::size_t f = 0; f < F.size(); ++f) mesh.F.row(f) = F[f].transpose().array() - 1;
  expect_whole(mesh, model);
}

TEST(MeshFile, StlReadsBackAsOneClosedSurfaceWithOutwardNormals) {
  const Model model = textured_model();
  const std::string bytes = stl_bytes(model);
  const std::size_t faces = value_at<std::uint32_t>(bytes, 80);
  ASSERT_EQ(bytes.size(), 84 + 50 * faces);
  EXPECT_NE(bytes.substr(0, 5), "solid");
  Mesh soup;
  soup.V.resize(Eigen::Index(3 * faces), 3);
  soup.F.resize(Eigen::Index(faces), 3);
  for (std::size_t f = 0; f < faces; ++f) {
    Vec3 normal, middle = Vec3::Zero();
    for (int c = 0; c < 3; ++c) normal[c] = value_at<float>(bytes, 84 + 50 * f + 4 * c);
    for (int k = 0; k < 3; ++k)
      for (int c = 0; c < 3; ++c) {
        const double x = value_at<float>(bytes, 84 + 50 * f + 12 + 12 * k + 4 * c);
        soup.V(3 * f + k, c) = x;
        middle[c] += x / 3;
        soup.F(f, k) = int(3 * f) + k;
      }
    EXPECT_GT(normal.dot(middle.normalized()), 0.9);  // of a sphere about the origin
  }
  expect_whole(welded(soup), model);
}

TEST(MeshFile, PlyHasTheTexturesColours) {
  const Model model = textured_model();
  const std::string bytes = ply_bytes(model);
  const std::size_t body = bytes.find("end_header\n") + 11;
  const std::size_t vertices = std::size_t(welded(model.mesh).V.rows());
  ASSERT_EQ(bytes.size(), body + vertices * 15 + std::size_t(model.mesh.F.rows()) * 13);
  for (std::size_t v = 0; v < vertices; ++v) {
    EXPECT_EQ(std::uint8_t(bytes[body + 15 * v + 13]), 90);  // green is 90 all over
    EXPECT_EQ(std::uint8_t(bytes[body + 15 * v + 14]), 60);
  }
  EXPECT_EQ(ply_bytes(two_joint_model()).find("red"), std::string::npos);
}

TEST(MeshFile, TheEndingDecides) {
  EXPECT_EQ(model_ending("a/b.glb"), ".glb");
  EXPECT_EQ(model_ending("b.STL"), ".stl");
  EXPECT_EQ(model_ending("b.Ply"), ".ply");
  EXPECT_EQ(model_ending("b.fbx"), "");
  EXPECT_EQ(model_ending(".obj"), "");
  EXPECT_EQ(model_ending(""), "");
}

TEST(MeshFile, ABadModelIsRefusedInEveryFormat) {
  Model model = two_joint_model();
  model.mesh.V(3, 1) = NAN;
  for (const char* ending : {".glb", ".obj", ".stl", ".ply"})
    EXPECT_FALSE(model_bytes_for(ending, model)) << ending;
}

}  // namespace
}  // namespace artisketch
