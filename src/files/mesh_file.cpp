#include "files/mesh_file.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <iterator>

#include "base/words.h"
#include "files/gltf.h"

namespace artisketch {
namespace {

constexpr const char* kEndings[] = {".glb", ".vrm", ".obj", ".stl", ".ply"};
constexpr const char* kProgram = "ArtiSketch " ARTISKETCH_VERSION;

template <class T>
void append(std::string& out, const T& value) {  // little-endian, as all that we run on
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  out.append(bytes, sizeof(T));
}

void append_vector(std::string& out, const Vec3& v) {
  for (int c = 0; c < 3; ++c) append(out, float(v[c]));
}

// The texture's colour at a vertex of the model.
std::array<std::uint8_t, 3> colour_at(const Model& model, int vertex) {
  const Image& t = *model.texture;
  const Vec2 p = model.texcoords[vertex].cwiseProduct(Vec2(t.width, t.height));
  const int x = std::clamp(int(p.x()), 0, t.width - 1), y = std::clamp(int(p.y()), 0, t.height - 1);
  const std::uint8_t* c = t.at(x, y);
  return {c[0], c[1], c[2]};
}

// Per vertex of `whole`, the welded model, a vertex of the model at the same place: the faces of
// both are the same.
std::vector<int> first_of(const Mesh& model, const Mesh& whole) {
  std::vector<int> first(whole.V.rows(), -1);
  for (Eigen::Index i = 0; i < whole.F.size(); ++i)
    if (int& v = first[whole.F.data()[i]]; v < 0) v = model.F.data()[i];
  return first;
}

}  // namespace

std::string obj_text(const Model& model) {
  const Mesh mesh = welded(model.mesh);
  std::string out = std::string("# ") + kProgram + "\no surface\n";
  char line[128];
  for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
    std::snprintf(line, sizeof line, "v %.17g %.17g %.17g\n", mesh.V(v, 0), mesh.V(v, 1),
                  mesh.V(v, 2));
    out += line;
  }
  for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
    std::snprintf(line, sizeof line, "f %d %d %d\n", mesh.F(f, 0) + 1, mesh.F(f, 1) + 1,
                  mesh.F(f, 2) + 1);
    out += line;
  }
  return out;
}

std::string stl_bytes(const Model& model) {
  const Mesh mesh = welded(model.mesh);
  constexpr std::size_t kHeader = 80;  // must not begin with "solid", which means text
  std::string out = kProgram;
  out.resize(kHeader, ' ');
  append(out, std::uint32_t(mesh.F.rows()));
  for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
    const Vec3 a = mesh.V.row(mesh.F(f, 0)).transpose(), b = mesh.V.row(mesh.F(f, 1)).transpose(),
               c = mesh.V.row(mesh.F(f, 2)).transpose();
    append_vector(out, (b - a).cross(c - a).normalized());
    for (const Vec3& corner : {a, b, c}) append_vector(out, corner);
    append(out, std::uint16_t(0));
  }
  return out;
}

namespace {

using Colour = std::array<std::uint8_t, 3>;

// colours: one per vertex, or none.
std::string ply_of(const Mesh& mesh, const std::vector<Colour>& colours) {
  std::string out = std::string("ply\nformat binary_little_endian 1.0\ncomment ") + kProgram +
                    "\nelement vertex " + std::to_string(mesh.V.rows()) +
                    "\nproperty float x\nproperty float y\nproperty float z\n";
  if (!colours.empty()) out += "property uchar red\nproperty uchar green\nproperty uchar blue\n";
  out += "element face " + std::to_string(mesh.F.rows()) +
         "\nproperty list uchar int vertex_indices\nend_header\n";
  for (Eigen::Index v = 0; v < mesh.V.rows(); ++v) {
    append_vector(out, mesh.V.row(v).transpose());
    if (!colours.empty()) append(out, colours[v]);
  }
  for (Eigen::Index f = 0; f < mesh.F.rows(); ++f) {
    append(out, std::uint8_t(3));
    for (int k = 0; k < 3; ++k) append(out, std::int32_t(mesh.F(f, k)));
  }
  return out;
}

}  // namespace

std::string ply_bytes(const Model& model) {
  const Mesh mesh = welded(model.mesh);
  std::vector<Colour> colours;
  if (model.texture && !model.texcoords.empty())
    for (const int v : first_of(model.mesh, mesh)) colours.push_back(colour_at(model, v));
  return ply_of(mesh, colours);
}

std::string ply_bytes(const Mesh& mesh) {
  return ply_of(mesh, {});
}

std::string model_ending(const std::string& path) {
  for (const char* ending : kEndings)
    if (path.size() > std::strlen(ending) && lower_case(path).ends_with(ending)) return ending;
  return "";
}

std::string model_endings() {
  std::string words = kEndings[0];
  const std::size_t count = std::size(kEndings);
  for (std::size_t i = 1; i < count; ++i)
    words += (i + 1 < count ? ", " : " or ") + std::string(kEndings[i]);
  return words;
}

Result<std::string> model_bytes_for(const std::string& ending, const Model& model) {
  Result<std::string> glb = glb_bytes(model);  // which also finds what is wrong with a model
  if (!glb || ending == ".glb") return glb;
  if (ending == ".obj") return obj_text(model);
  if (ending == ".stl") return stl_bytes(model);
  return ply_bytes(model);
}

}  // namespace artisketch
