#include "editor/gl/open_gl.h"

#include <algorithm>
#include <utility>

#include <GLES3/gl3.h>

#include "editor/gl/shader.h"

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

template <class T>
void fill(GLenum target, GLuint buffer, std::span<const T> data, GLenum usage) {
  glBindBuffer(target, buffer);
  glBufferData(target, GLsizeiptr(data.size_bytes()), data.data(), usage);
}

void attribute(GLuint index, GLuint buffer, int count, GLenum type, bool normalised) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, count, type, normalised, 0, nullptr);
}

class GlMesh : public CardMesh {
 public:
  GlMesh() {
    for (unsigned* array : {&triangles_, &edges_, &ground_}) glGenVertexArrays(1, array);
    for (unsigned* buffer :
         {&positions_, &normals_, &uvs_, &colours_, &corners_, &edge_ends_, &ground_ends_})
      glGenBuffers(1, buffer);
    for (const unsigned array : {triangles_, edges_}) {
      glBindVertexArray(array);
      attribute(0, positions_, 3, GL_FLOAT, false);
      attribute(1, normals_, 3, GL_FLOAT, false);
      attribute(2, uvs_, 2, GL_FLOAT, false);
      attribute(3, colours_, 4, GL_UNSIGNED_BYTE, true);
    }
    glBindVertexArray(ground_);
    attribute(0, ground_ends_, 3, GL_FLOAT, false);
    glBindVertexArray(0);
  }
  ~GlMesh() override {
    for (unsigned array : {triangles_, edges_, ground_}) glDeleteVertexArrays(1, &array);
    for (unsigned buffer :
         {positions_, normals_, uvs_, colours_, corners_, edge_ends_, ground_ends_})
      glDeleteBuffers(1, &buffer);
  }
  GlMesh(const GlMesh&) = delete;
  GlMesh& operator=(const GlMesh&) = delete;

  void set_faces(std::span<const unsigned> corners, std::span<const float> uvs) override {
    load_indices(triangles_, corners_, corners, corner_count_);
    fill(GL_ARRAY_BUFFER, uvs_, uvs, GL_STATIC_DRAW);
  }
  void set_edges(std::span<const unsigned> ends) override {
    load_indices(edges_, edge_ends_, ends, edge_end_count_);
  }
  void set_ground(std::span<const float> ends) override {
    ground_end_count_ = GLsizei(ends.size() / 3);
    fill(GL_ARRAY_BUFFER, ground_ends_, ends, GL_STATIC_DRAW);
  }
  void move(std::span<const float> positions, std::span<const float> normals) override {
    fill(GL_ARRAY_BUFFER, positions_, positions, GL_DYNAMIC_DRAW);
    fill(GL_ARRAY_BUFFER, normals_, normals, GL_DYNAMIC_DRAW);
  }
  void colour(std::span<const std::uint8_t> rgba) override {
    fill(GL_ARRAY_BUFFER, colours_, rgba, GL_STATIC_DRAW);
  }

  void draw_faces() const {
    glBindVertexArray(triangles_);
    glDrawElements(GL_TRIANGLES, corner_count_, GL_UNSIGNED_INT, nullptr);
  }
  void draw_edges() const {
    glBindVertexArray(edges_);
    glDrawElements(GL_LINES, edge_end_count_, GL_UNSIGNED_INT, nullptr);
  }
  void draw_ground(float fade) const {
    glBindVertexArray(ground_);
    glVertexAttrib2f(2, fade, 0);
    glDrawArrays(GL_LINES, 0, ground_end_count_);
  }

 private:
  static void load_indices(unsigned array, unsigned buffer, std::span<const unsigned> indices,
                           GLsizei& count) {
    count = GLsizei(indices.size());
    glBindVertexArray(array);
    fill(GL_ELEMENT_ARRAY_BUFFER, buffer, indices, GL_STATIC_DRAW);
    glBindVertexArray(0);
  }
  unsigned triangles_ = 0, edges_ = 0, ground_ = 0;               // vertex arrays
  unsigned positions_ = 0, normals_ = 0, uvs_ = 0, colours_ = 0;  // buffers
  unsigned corners_ = 0, edge_ends_ = 0, ground_ends_ = 0;
  GLsizei corner_count_ = 0, edge_end_count_ = 0, ground_end_count_ = 0;
};

}  // namespace

// ---------------------------------------------------------------- pictures

class OpenGl::Picture : public CardPicture {
 public:
  explicit Picture(OpenGl& owner) : owner_(owner) {}
  ~Picture() override { release(); }
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;

  unsigned texture() const override { return texture_; }
  void paint(const CardMesh& mesh, const MeshLook& look, int width, int height,
             bool rough) override {
    begin(std::max(width, 1), std::max(height, 1), rough);
    draw(static_cast<const GlMesh&>(mesh), look);
    end();
  }

 private:
  void release();
  void make(int width, int height, bool rough);
  void begin(int width, int height, bool rough);  // clears it
  void draw(const GlMesh& mesh, const MeshLook& look);
  void end();
  OpenGl& owner_;
  int width_ = 0, height_ = 0;
  bool rough_ = false;
  // Painted into `smooth_`, several samples a pixel, and from there into `flat_`, or there at once.
  unsigned texture_ = 0, flat_ = 0, smooth_ = 0, colour_ = 0, depth_ = 0;
};

void OpenGl::Picture::release() {
  if (!texture_) return;
  glDeleteTextures(1, &texture_);
  for (const unsigned* buffer : {&flat_, &smooth_}) glDeleteFramebuffers(1, buffer);
  for (const unsigned* buffer : {&colour_, &depth_}) glDeleteRenderbuffers(1, buffer);
  texture_ = flat_ = smooth_ = colour_ = depth_ = 0;
}

void OpenGl::Picture::make(int width, int height, bool rough) {
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

void OpenGl::Picture::begin(int width, int height, bool rough) {
  if (!texture_ || width != width_ || height != height_ || rough != rough_)
    make(width, height, rough);
  glBindFramebuffer(GL_FRAMEBUFFER, rough_ ? flat_ : smooth_);
  glViewport(0, 0, width, height);
  glDisable(GL_SCISSOR_TEST);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void OpenGl::Picture::draw(const GlMesh& mesh, const MeshLook& look) {
  const Program& p = owner_.program();
  glUseProgram(p.id);
  glUniformMatrix4fv(p.clip, 1, GL_FALSE, look.clip.data());
  glUniformMatrix3fv(p.turn, 1, GL_FALSE, look.turn.data());
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_CULL_FACE);  // surfaces are closed
  glDisable(GL_BLEND);
  const auto line = [&](const ImVec4& c) { glUniform4f(p.line, c.x, c.y, c.z, c.w); };
  if (look.edges_alone) {
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(1, 1);
  }
  glUniform1i(p.use, look.texture ? 0 : 1);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, look.texture);
  mesh.draw_faces();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_POLYGON_OFFSET_FILL);
  if (look.edges_alone) {
    glUniform1i(p.use, 2);
    line(look.edge_colour);
    mesh.draw_edges();
  }
  if (look.ground) {
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glUniform1i(p.use, 3);
    line(look.ground_colour);
    mesh.draw_ground(look.ground_fade);
  }
  glBindVertexArray(0);
  glUseProgram(0);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
}

void OpenGl::Picture::end() {
  if (!rough_) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, smooth_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, flat_);
    glBlitFramebuffer(0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  owner_.painted_.push_back(texture_);
}

// ---------------------------------------------------------------- the card

OpenGl::~OpenGl() {
  if (program_) glDeleteProgram(program_->id);
}

const OpenGl::Program& OpenGl::program() {
  if (!program_) {
    Program& p = program_.emplace(Program{});
    p.id = linked(kVertex, kFragment);
    p.clip = glGetUniformLocation(p.id, "clip");
    p.turn = glGetUniformLocation(p.id, "turn");
    p.use = glGetUniformLocation(p.id, "use");
    p.line = glGetUniformLocation(p.id, "line");
  }
  return *program_;
}

unsigned OpenGl::add_texture(int width, int height, std::span<const std::uint8_t> rgba,
                             Beyond edge) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               rgba.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  if (edge == Beyond::stretches) {
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  }
  return texture;
}

void OpenGl::remove_texture(unsigned texture) {
  glDeleteTextures(1, &texture);
}

std::unique_ptr<CardMesh> OpenGl::make_mesh() {
  return std::make_unique<GlMesh>();
}

std::unique_ptr<CardPicture> OpenGl::make_picture() {
  return std::make_unique<Picture>(*this);
}

std::vector<unsigned> OpenGl::take_painted() {
  return std::exchange(painted_, {});
}

}  // namespace artisketch
