#include "editor/pictures/model_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include <imgui.h>

#include "files/marks.h"

namespace artisketch {
namespace {

std::vector<float> floats(const Points3& points) {
  std::vector<float> result(std::size_t(points.size()));
  for (Eigen::Index i = 0; i < points.size(); ++i) result[std::size_t(i)] = float(points.data()[i]);
  return result;
}

constexpr unsigned kClay = 0xC9CDD3;

double size_of(const Model& model) {
  return std::max(1e-6, bounds(model.mesh.V).sizes().maxCoeff());
}

}  // namespace

void RenderTarget::paint(const CardMesh& mesh, const MeshLook& look, const Scene& scene) {
  shown_ = scene;
  picture_->paint(mesh, look, scene.width, scene.height, scene.options.rough);
}

bool Scene::stands_as(const Scene& other) const {
  return shift == other.shift && same_pose(pose, other.pose);
}

bool Scene::operator==(const Scene& other) const {
  const auto key = [](const Scene& s) {
    return std::tuple(s.model, s.options.surface, s.options.joint, s.options.ground, s.options.dark,
                      s.options.rough, s.width, s.height);
  };
  return key(*this) == key(other) && clip == other.clip && turn == other.turn && stands_as(other);
}

ModelPicture::~ModelPicture() {
  if (texture_) graphics_->remove_texture(texture_);
}

void ModelPicture::load(const Model& model) {
  static long loaded = 0;
  next_.model = ++loaded;
  first_ = first_at_place(model.mesh);
}

namespace {

// Lines of a grid as wide as six times the model: x y z of their ends.
std::vector<float> ground_under(const Model& model) {
  const double step = size_of(model) / 4;
  constexpr int kLines = 12;
  std::vector<float> ends;
  for (int i = -kLines; i <= kLines; ++i)
    for (int along = 0; along < 2; ++along)
      for (int k = -kLines; k < kLines; ++k)  // short pieces, so that they fade smoothly
        for (int end = 0; end < 2; ++end) {
          const float a = float(i * step), b = float((k + end) * step);
          ends.insert(ends.end(), {along ? a : b, 0.0f, along ? b : a});
        }
  return ends;
}

}  // namespace

void ModelPicture::hand_over(const Model& model, Graphics& graphics) {
  if (mesh_) return;
  graphics_ = &graphics;
  mesh_ = graphics.make_mesh();
  std::vector<float> uvs(std::size_t(model.mesh.V.rows()) * 2, 0.0f);
  for (std::size_t i = 0; i < model.texcoords.size(); ++i) {
    uvs[2 * i] = float(model.texcoords[i].x());
    uvs[2 * i + 1] = float(model.texcoords[i].y());
  }
  mesh_->set_faces(
      std::vector<unsigned>(model.mesh.F.data(), model.mesh.F.data() + model.mesh.F.size()), uvs);
  mesh_->set_ground(ground_under(model));
  if (model.texture)
    texture_ = graphics.add_texture(model.texture->width, model.texture->height,
                                    model.texture->rgba, Graphics::Beyond::repeats);
}

void ModelPicture::load_edges(const Model& model) {
  if (std::exchange(has_edges_, true)) return;
  std::vector<unsigned> ends;
  for (Eigen::Index f = 0; f < model.mesh.F.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = model.mesh.F(f, k), b = model.mesh.F(f, (k + 1) % 3);
      // Each edge once: its two triangles run through it in opposite directions.
      if (first_[a] < first_[b]) ends.insert(ends.end(), {unsigned(a), unsigned(b)});
    }
  mesh_->set_edges(ends);
}

void ModelPicture::pose(const Pose& pose, const Vec3& shift) {
  next_.pose = pose;
  next_.shift = shift;
}

void ModelPicture::move_vertices(const Model& model, const Scene& scene) {
  if (posed_.model == scene.model && posed_.stands_as(scene)) return;
  posed_ = scene;
  Points3 V = posed_vertices(model.mesh.V, model.weights, model.skeleton, scene.pose);
  V.rowwise() += scene.shift.transpose();
  // Plain numbers: this runs each frame, for two poses where two pictures show them.
  const std::vector<float> places = floats(V);
  // Weighted by area: cheap, and the mesh is even.
  std::vector<float> sums(places.size(), 0.0f), normals(places.size());
  const int* face = model.mesh.F.data();
  for (Eigen::Index f = 0; f < model.mesh.F.rows(); ++f, face += 3) {
    const float *a = &places[3 * std::size_t(face[0])], *b = &places[3 * std::size_t(face[1])],
                *c = &places[3 * std::size_t(face[2])];
    const float u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
    const float v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
    const float normal[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                             u[0] * v[1] - u[1] * v[0]};
    for (int corner = 0; corner < 3; ++corner)
      for (int k = 0; k < 3; ++k)
        sums[3 * std::size_t(first_[std::size_t(face[corner])]) + std::size_t(k)] += normal[k];
  }
  for (std::size_t i = 0; i < first_.size(); ++i) {
    const float* sum = &sums[3 * std::size_t(first_[i])];
    const float length = std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    for (std::size_t k = 0; k < 3; ++k) normals[3 * i + k] = length > 0 ? sum[k] / length : 0;
  }
  mesh_->move(places, normals);
}

void ModelPicture::colour_vertices(const Model& model, const PaintOptions& options) {
  if (coloured_for_ == options.surface && coloured_joint_ == options.joint) return;
  coloured_for_ = options.surface;
  coloured_joint_ = options.joint;
  using Colour = std::array<float, 3>;
  const auto colour_of = [](unsigned rrggbb) {
    return Colour{float(rrggbb >> 16 & 255), float(rrggbb >> 8 & 255), float(rrggbb & 255)};
  };
  const bool weights = options.surface == Surface::weights, all = options.joint < 0;
  std::vector<Colour> of_joint;
  for (int joint = 0; joint < model.skeleton.size(); ++joint)
    of_joint.push_back(colour_of(joint_colour(joint)));
  Colour ground = all && weights ? Colour{} : colour_of(kClay);
  if (weights && !all)
    for (float& c : ground) c *= 0.55f;
  const std::size_t count = std::size_t(model.mesh.V.rows());
  std::vector<std::uint8_t> colours(4 * count, 255);
  const int* joint = model.weights.joints.data();
  const double* weight = model.weights.weights.data();
  for (std::size_t i = 0; i < count; ++i) {
    Colour mixed = ground;
    for (std::size_t k = 4 * i; weights && k < 4 * i + 4; ++k) {
      if (weight[k] == 0 || (!all && joint[k] != options.joint)) continue;
      const Colour& own = of_joint[std::size_t(joint[k])];
      for (std::size_t c = 0; c < 3; ++c)
        mixed[c] += float(weight[k]) * (own[c] - (all ? 0 : ground[c]));
    }
    for (std::size_t c = 0; c < 3; ++c)
      colours[4 * i + c] = std::uint8_t(std::clamp(mixed[c], 0.0f, 255.0f));
  }
  mesh_->colour(colours);
}

void ModelPicture::paint(const Model& model, const ViewProjection& projection,
                         const PaintOptions& options, RenderTarget& picture, float pixel_ratio) {
  next_.clip = projection.clip;
  next_.turn = projection.turn;
  next_.options = options;
  next_.width = int(std::lround(projection.place.w * pixel_ratio));
  next_.height = int(std::lround(projection.place.h * pixel_ratio));
  if (picture.shows(next_)) return;
  hand_over(model, picture.graphics());
  move_vertices(model, next_);
  colour_vertices(model, options);
  MeshLook look;
  look.clip = projection.clip.cast<float>();
  look.turn = projection.turn.cast<float>();
  look.texture = options.surface == Surface::textured ? texture_ : 0;
  look.edges_alone = options.surface == Surface::wireframe;
  if (look.edges_alone) load_edges(model);
  look.edge_colour = ImGui::ColorConvertU32ToFloat4(options.dark ? IM_COL32(0xA3, 0xA9, 0xB2, 255)
                                                                 : IM_COL32(0x59, 0x61, 0x6B, 255));
  look.ground = options.ground;
  look.ground_colour = ImGui::ColorConvertU32ToFloat4(options.dark ? IM_COL32(255, 255, 255, 44)
                                                                   : IM_COL32(28, 32, 37, 44));
  if (look.ground) look.ground_fade = float(1 / (3 * size_of(model)));
  picture.paint(*mesh_, look, next_);
}

void blend_premultiplied(const ImDrawList*, const ImDrawCmd*) {}

void show_picture(unsigned texture, const Rect& place, float opacity, ImVec2 uv0, ImVec2 uv1,
                  ImU32 tint, float radius) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCallback(blend_premultiplied, nullptr);
  // All four channels fade together: the colours carry their alpha already.
  const auto channel = [&](int shift) { return int(float(tint >> shift & 255) * opacity + 0.5f); };
  list.AddImageRounded(reinterpret_cast<ImTextureID>(std::uintptr_t(texture)), place.min(),
                       place.max(), uv0, uv1,
                       IM_COL32(channel(IM_COL32_R_SHIFT), channel(IM_COL32_G_SHIFT),
                                channel(IM_COL32_B_SHIFT), channel(IM_COL32_A_SHIFT)),
                       radius);
  list.AddCallback(ImDrawCallback_ResetRenderState, nullptr);
}

}  // namespace artisketch
