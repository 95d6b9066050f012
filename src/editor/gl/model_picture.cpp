#include "editor/gl/model_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include <GLES3/gl3.h>
#include <imgui.h>

#include "editor/gl/shader.h"
#include "files/marks.h"

namespace artisketch {
namespace {

constexpr int kSamples = 4;

constexpr const char* kVertex = R"(#version 300 es
uniform mat4 clip;
uniform mat3 turn;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 colour;
out vec3 n;
out vec2 at;
out vec3 tint;
out vec3 place;
void main() {
  n = turn * normal;
  at = uv;
  tint = colour.rgb;
  place = position;
  gl_Position = clip * vec4(position, 1.0);
})";

// The lights of files/render: a soft key over the left shoulder, light from all round, fill and
// rim.
constexpr const char* kFragment = R"(#version 300 es
precision highp float;
uniform sampler2D picture;
uniform int use;        // 0 texture, 1 vertex colours, 2 plain line, 3 ground
uniform vec4 line;
in vec3 n;
in vec2 at;
in vec3 tint;
in vec3 place;
out vec4 result;
vec3 linear(vec3 c) { return pow(c, vec3(2.2)); }
float wrapped(float c, float wrap) { return max((c + wrap) / (1.0 + wrap), 0.0); }
void main() {
  if (use == 2) { result = vec4(line.rgb * line.a, line.a); return; }
  if (use == 3) {
    float a = line.a * clamp(1.0 - length(place.xz) * at.x, 0.0, 1.0);
    result = vec4(line.rgb * a, a);
    return;
  }
  vec3 albedo = linear(use == 0 ? texture(picture, at).rgb : tint);
  vec3 m = normalize(n);
  float up = 0.5 + 0.5 * m.y;
  vec3 ambient = mix(vec3(0.17, 0.14, 0.13), vec3(0.34, 0.38, 0.44), up);
  vec3 key = normalize(vec3(-0.48, 0.72, 0.55));
  vec3 light = ambient * 0.9 + wrapped(dot(m, key), 0.12) * vec3(0.98, 0.92, 0.84) +
               wrapped(dot(m, normalize(vec3(0.80, 0.10, 0.55))), 0.4) * vec3(0.10, 0.12, 0.15);
  float grazing = 1.0 - clamp(m.z, 0.0, 1.0);
  float rim = grazing * grazing * grazing * wrapped(dot(m, normalize(vec3(0.45, 0.65, -0.62))), 0.5);
  vec3 lit = albedo * light + rim * vec3(0.22, 0.23, 0.25);
  result = vec4(pow(clamp(lit, 0.0, 1.0), vec3(1.0 / 2.2)), 1.0);
})";

struct Program {
  GLuint id = 0;
  GLint clip, turn, use, line;
};

const Program& program() {
  static const Program made = [] {
    Program p;
    p.id = linked(kVertex, kFragment);
    p.clip = glGetUniformLocation(p.id, "clip");
    p.turn = glGetUniformLocation(p.id, "turn");
    p.use = glGetUniformLocation(p.id, "use");
    p.line = glGetUniformLocation(p.id, "line");
    return p;
  }();
  return made;
}

template <class T>
void fill(GLenum target, GLuint buffer, const std::vector<T>& data, GLenum usage) {
  glBindBuffer(target, buffer);
  glBufferData(target, GLsizeiptr(data.size() * sizeof(T)), data.data(), usage);
}

void attribute(GLuint index, GLuint buffer, int count, GLenum type, bool normalised) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, count, type, normalised, 0, nullptr);
}

std::vector<float> floats(const Points3& points) {
  std::vector<float> result(std::size_t(points.size()));
  for (Eigen::Index i = 0; i < points.size(); ++i) result[std::size_t(i)] = float(points.data()[i]);
  return result;
}

std::vector<unsigned> painted_lately;

constexpr unsigned kClay = 0xC9CDD3;

}  // namespace

// ---------------------------------------------------------------- pictures

RenderTarget::~RenderTarget() {
  release();
}

void RenderTarget::release() {
  if (!texture_) return;
  glDeleteTextures(1, &texture_);
  for (const unsigned* buffer : {&flat_, &smooth_}) glDeleteFramebuffers(1, buffer);
  for (const unsigned* buffer : {&colour_, &depth_}) glDeleteRenderbuffers(1, buffer);
  texture_ = flat_ = smooth_ = colour_ = depth_ = 0;
}

void RenderTarget::begin(int width, int height, bool rough) {
  width = std::max(width, 1);
  height = std::max(height, 1);
  if (!texture_ || width != width_ || height != height_ || rough != rough_) {
    release();
    width_ = width;
    height_ = height;
    rough_ = rough;
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glGenFramebuffers(1, &flat_);
    glBindFramebuffer(GL_FRAMEBUFFER, flat_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
    if (!rough) {
      glGenFramebuffers(1, &smooth_);
      glBindFramebuffer(GL_FRAMEBUFFER, smooth_);
      glGenRenderbuffers(1, &colour_);
      glBindRenderbuffer(GL_RENDERBUFFER, colour_);
      glRenderbufferStorageMultisample(GL_RENDERBUFFER, kSamples, GL_RGBA8, width, height);
      glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
    }
    glGenRenderbuffers(1, &depth_);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, rough ? 0 : kSamples, GL_DEPTH_COMPONENT24,
                                     width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, rough_ ? flat_ : smooth_);
  glViewport(0, 0, width, height);
  glDisable(GL_SCISSOR_TEST);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void RenderTarget::end() {
  if (!rough_) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, smooth_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, flat_);
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  painted_lately.push_back(texture_);
}

std::vector<unsigned> RenderTarget::take_painted() {
  return std::exchange(painted_lately, {});
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

// ---------------------------------------------------------------- the model

ModelPicture::~ModelPicture() {
  if (!triangles_) return;
  for (unsigned array : {triangles_, edges_, ground_}) glDeleteVertexArrays(1, &array);
  for (unsigned buffer : {positions_, normals_, uvs_, colours_, faces_, lines_, ground_points_})
    glDeleteBuffers(1, &buffer);
  if (texture_) glDeleteTextures(1, &texture_);
}

void ModelPicture::load(const Model& model) {
  static long loaded = 0;
  next_.model = ++loaded;
  if (!triangles_) {
    for (unsigned* array : {&triangles_, &edges_, &ground_}) glGenVertexArrays(1, array);
    for (unsigned* buffer :
         {&positions_, &normals_, &uvs_, &colours_, &faces_, &lines_, &ground_points_})
      glGenBuffers(1, buffer);
  }
  first_ = first_at_place(model.mesh);

  const std::vector<unsigned> faces(model.mesh.F.data(), model.mesh.F.data() + model.mesh.F.size());
  triangle_count_ = int(faces.size());
  edge_count_ = -1;  // not there yet

  std::vector<float> uvs(std::size_t(model.mesh.V.rows()) * 2, 0.0f);
  for (std::size_t i = 0; i < model.texcoords.size(); ++i) {
    uvs[2 * i] = float(model.texcoords[i].x());
    uvs[2 * i + 1] = float(model.texcoords[i].y());
  }
  for (const unsigned array : {triangles_, edges_}) {
    glBindVertexArray(array);
    attribute(0, positions_, 3, GL_FLOAT, false);
    attribute(1, normals_, 3, GL_FLOAT, false);
    attribute(2, uvs_, 2, GL_FLOAT, false);
    attribute(3, colours_, 4, GL_UNSIGNED_BYTE, true);
    if (array == triangles_) fill(GL_ELEMENT_ARRAY_BUFFER, faces_, faces, GL_STATIC_DRAW);
  }
  fill(GL_ARRAY_BUFFER, uvs_, uvs, GL_STATIC_DRAW);
  glBindVertexArray(0);

  if (texture_) glDeleteTextures(1, &texture_);
  texture_ = 0;
  if (model.texture) {
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, model.texture->width, model.texture->height, 0,
                 GL_RGBA, GL_UNSIGNED_BYTE, model.texture->rgba.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  }
  coloured_joint_ = -2;

  // The ground, as wide as twelve times the model.
  const Box3 box = bounds(model.mesh.V);
  const double size = std::max(1e-6, box.sizes().maxCoeff()), step = size / 4;
  constexpr int kLines = 12;
  std::vector<float> ground;
  for (int i = -kLines; i <= kLines; ++i)
    for (int along = 0; along < 2; ++along)
      for (int k = -kLines; k < kLines; ++k)  // short pieces, so that they fade smoothly
        for (int end = 0; end < 2; ++end) {
          const float a = float(i * step), b = float((k + end) * step);
          ground.insert(ground.end(), {along ? a : b, 0.0f, along ? b : a});
        }
  ground_count_ = int(ground.size() / 3);
  glBindVertexArray(ground_);
  fill(GL_ARRAY_BUFFER, ground_points_, ground, GL_STATIC_DRAW);
  attribute(0, ground_points_, 3, GL_FLOAT, false);
  glVertexAttrib2f(2, float(1 / (kLines * step)), 0);
  glBindVertexArray(0);
}

void ModelPicture::load_edges(const Model& model) {
  if (edge_count_ >= 0) return;
  std::vector<unsigned> lines;
  for (Eigen::Index f = 0; f < model.mesh.F.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = model.mesh.F(f, k), b = model.mesh.F(f, (k + 1) % 3);
      // Each edge once: its two triangles run through it in opposite directions.
      if (first_[a] < first_[b]) lines.insert(lines.end(), {unsigned(a), unsigned(b)});
    }
  edge_count_ = int(lines.size());
  glBindVertexArray(edges_);
  fill(GL_ELEMENT_ARRAY_BUFFER, lines_, lines, GL_STATIC_DRAW);
  glBindVertexArray(0);
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
  fill(GL_ARRAY_BUFFER, positions_, places, GL_DYNAMIC_DRAW);
  fill(GL_ARRAY_BUFFER, normals_, normals, GL_DYNAMIC_DRAW);
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
  std::vector<unsigned char> colours(4 * count, 255);
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
      colours[4 * i + c] = static_cast<unsigned char>(std::clamp(mixed[c], 0.0f, 255.0f));
  }
  fill(GL_ARRAY_BUFFER, colours_, colours, GL_STATIC_DRAW);
}

void ModelPicture::paint(const Model& model, const Eye& eye, const PaintOptions& options,
                         RenderTarget& picture, float pixel_ratio) {
  next_.clip = eye.clip;
  next_.turn = eye.turn;
  next_.options = options;
  next_.width = int(std::lround(eye.place.w * pixel_ratio));
  next_.height = int(std::lround(eye.place.h * pixel_ratio));
  if (picture.texture() && picture.shows == next_) return;
  picture.shows = next_;
  move_vertices(model, next_);
  colour_vertices(model, options);
  if (options.surface == Surface::wireframe) load_edges(model);
  picture.begin(next_.width, next_.height, options.rough);
  const Program& p = program();
  glUseProgram(p.id);
  const Eigen::Matrix4f clip = eye.clip.cast<float>();
  const Eigen::Matrix3f turn = eye.turn.cast<float>();
  glUniformMatrix4fv(p.clip, 1, GL_FALSE, clip.data());
  glUniformMatrix3fv(p.turn, 1, GL_FALSE, turn.data());
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_CULL_FACE);  // surfaces are closed
  glDisable(GL_BLEND);
  const auto line = [&](ImU32 colour) {
    const ImVec4 c = ImGui::ColorConvertU32ToFloat4(colour);
    glUniform4f(p.line, c.x, c.y, c.z, c.w);
  };
  if (options.surface == Surface::wireframe) {
    // The faces hide what lies behind, and show nothing themselves.
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1, 1);
  }
  const bool textured = options.surface == Surface::textured && texture_;
  glUniform1i(p.use, textured ? 0 : 1);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glBindVertexArray(triangles_);
  glDrawElements(GL_TRIANGLES, triangle_count_, GL_UNSIGNED_INT, nullptr);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_POLYGON_OFFSET_FILL);
  if (options.surface == Surface::wireframe) {
    glUniform1i(p.use, 2);
    line(options.dark ? IM_COL32(0xA3, 0xA9, 0xB2, 255) : IM_COL32(0x59, 0x61, 0x6B, 255));
    glBindVertexArray(edges_);
    glDrawElements(GL_LINES, edge_count_, GL_UNSIGNED_INT, nullptr);
  }
  if (options.ground) {
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glUniform1i(p.use, 3);
    line(options.dark ? IM_COL32(255, 255, 255, 44) : IM_COL32(28, 32, 37, 44));
    glBindVertexArray(ground_);
    const Box3 box = bounds(model.mesh.V);
    glVertexAttrib2f(2, float(1 / (3 * std::max(1e-6, box.sizes().maxCoeff()))), 0);
    glDrawArrays(GL_LINES, 0, ground_count_);
  }
  glBindVertexArray(0);
  glUseProgram(0);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  picture.end();
}

void show_picture(unsigned texture, const Rect& place, float opacity, ImVec2 uv0, ImVec2 uv1,
                  ImU32 tint, float radius) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddCallback(
      [](const ImDrawList*, const ImDrawCmd*) { glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA); },
      nullptr);
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
