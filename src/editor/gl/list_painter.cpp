#include "editor/gl/list_painter.h"

#include <cstddef>
#include <cstdint>
#include <utility>

#include <GLES3/gl3.h>

#include "editor/gl/shader.h"
#include "editor/pictures/graphics.h"

namespace artisketch {
namespace {

constexpr const char* kVertex = R"(#version 300 es
uniform mat4 projection;
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 colour;
out vec2 at;
out vec4 tint;
void main() {
  at = uv;
  tint = colour;
  gl_Position = projection * vec4(position, 0.0, 1.0);
})";

// Seen from near, from twice its size on, a picture shows its pixels as squares with soft edges:
// what is outlined is the pixel, not a blur of it. Smaller ones are filtered as usual. Letters and
// shapes, most of what is painted, go without: they would be slower where no graphics card is.
constexpr const char* kFragment = R"(#version 300 es
precision highp float;
uniform sampler2D picture;
uniform bool squares;
in vec2 at;
in vec4 tint;
out vec4 result;
void main() {
  if (!squares) {
    result = tint * texture(picture, at);
    return;
  }
  vec2 size = vec2(textureSize(picture, 0));
  vec2 texel = at * size;
  vec2 edge = floor(texel + 0.5);
  vec2 width = clamp(2.0 * fwidth(texel), 1e-4, 1.0);  // of the soft edge, in texels
  texel = edge + clamp((texel - edge) / width, -0.5, 0.5);
  result = tint * texture(picture, texel / size);
})";

static_assert(sizeof(ImDrawIdx) == 4);

void field(GLuint index, int count, GLenum type, bool normalised, std::size_t offset) {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, count, type, normalised, sizeof(ImDrawVert),
                        reinterpret_cast<const void*>(offset));
}

}  // namespace

ListPainter::ListPainter(ListPainter&& other) noexcept
    : program_(std::exchange(other.program_, 0)),
      array_(std::exchange(other.array_, 0)),
      vertices_(std::exchange(other.vertices_, 0)),
      indices_(std::exchange(other.indices_, 0)),
      fonts_(std::exchange(other.fonts_, 0)),
      projection_(other.projection_),
      squares_(other.squares_) {}

ListPainter::~ListPainter() {
  release();
}

void ListPainter::release() {
  drop_fonts();
  if (!program_) return;
  glDeleteProgram(std::exchange(program_, 0));
  glDeleteVertexArrays(1, &array_);
  for (const unsigned buffer : {vertices_, indices_}) glDeleteBuffers(1, &buffer);
}

void ListPainter::make() {
  program_ = linked(kVertex, kFragment);
  projection_ = glGetUniformLocation(program_, "projection");
  squares_ = glGetUniformLocation(program_, "squares");
  glGenVertexArrays(1, &array_);
  glGenBuffers(1, &vertices_);
  glGenBuffers(1, &indices_);
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
  field(0, 2, GL_FLOAT, false, offsetof(ImDrawVert, pos));
  field(1, 2, GL_FLOAT, false, offsetof(ImDrawVert, uv));
  field(2, 4, GL_UNSIGNED_BYTE, true, offsetof(ImDrawVert, col));
  glBindVertexArray(0);
}

void ListPainter::load_fonts() {
  if (fonts_) return;
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  fonts.GetTexDataAsRGBA32(&pixels, &width, &height);
  glGenTextures(1, &fonts_);
  glBindTexture(GL_TEXTURE_2D, fonts_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
  fonts.SetTexID(reinterpret_cast<ImTextureID>(std::uintptr_t(fonts_)));
}

void ListPainter::drop_fonts() {
  if (fonts_) glDeleteTextures(1, &fonts_);
  fonts_ = 0;
}

void ListPainter::begin(const ImDrawData& data, int pixels_wide, int pixels_high) const {
  glEnable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  glDisable(GL_CULL_FACE);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_SCISSOR_TEST);
  glViewport(0, 0, pixels_wide, pixels_high);
  glUseProgram(program_);
  // Points from the upper left corner to the card's −1 … 1 from the lower left one.
  const float x = 2 / data.DisplaySize.x, y = -2 / data.DisplaySize.y;
  const float projection[16] = {
      x, 0, 0, 0, 0, y, 0, 0, 0, 0, -1, 0, -1 - x * data.DisplayPos.x, 1 - y * data.DisplayPos.y,
      0, 1};
  glUniformMatrix4fv(projection_, 1, GL_FALSE, projection);
  glActiveTexture(GL_TEXTURE0);
  glBindVertexArray(array_);
  glBindBuffer(GL_ARRAY_BUFFER, vertices_);
}

void ListPainter::paint(const ImDrawData& data, int pixels_wide, int pixels_high) {
  if (!program_) make();
  begin(data, pixels_wide, pixels_high);
  const ImVec2 scale = data.FramebufferScale, from = data.DisplayPos;
  for (const ImDrawList* list : data.CmdLists) {
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(list->VtxBuffer.size_in_bytes()), list->VtxBuffer.Data,
                 GL_STREAM_DRAW);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, GLsizeiptr(list->IdxBuffer.size_in_bytes()),
                 list->IdxBuffer.Data, GL_STREAM_DRAW);
    for (const ImDrawCmd& command : list->CmdBuffer) {
      if (command.UserCallback == ImDrawCallback_ResetRenderState) {
        begin(data, pixels_wide, pixels_high);
        continue;
      }
      if (command.UserCallback == blend_premultiplied) {
        glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        continue;
      }
      if (command.UserCallback) {
        command.UserCallback(list, &command);
        continue;
      }
      const float left = (command.ClipRect.x - from.x) * scale.x;
      const float top = (command.ClipRect.y - from.y) * scale.y;
      const float right = (command.ClipRect.z - from.x) * scale.x;
      const float bottom = (command.ClipRect.w - from.y) * scale.y;
      if (right <= left || bottom <= top) continue;
      glScissor(int(left), int(float(pixels_high) - bottom), int(right - left), int(bottom - top));
      const GLuint texture = GLuint(reinterpret_cast<std::uintptr_t>(command.GetTexID()));
      glUniform1i(squares_, texture != fonts_);
      glBindTexture(GL_TEXTURE_2D, texture);
      glDrawElements(
          GL_TRIANGLES, GLsizei(command.ElemCount), GL_UNSIGNED_INT,
          reinterpret_cast<const void*>(std::uintptr_t(command.IdxOffset) * sizeof(ImDrawIdx)));
    }
  }
  glBindVertexArray(0);
  glUseProgram(0);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_BLEND);
}

}  // namespace artisketch
