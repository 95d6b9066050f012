#include "editor/gl/drawings.h"

#include <GLES3/gl3.h>

#include "files/bytes.h"
#include "files/inside_images.h"

namespace artisketch {
namespace {

constexpr const char* kKey = "drawing:";

unsigned textured(const Image& image) {
  std::vector<std::uint8_t> pixels = image.rgba;
  for (std::size_t i = 0; i < pixels.size(); i += 4)
    for (int c = 0; c < 3; ++c)
      pixels[i + c] = std::uint8_t((pixels[i + c] * pixels[i + 3] + 127) / 255);
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               pixels.data());
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace

Drawings::~Drawings() {
  for (auto& [key, drawing] : kept_) glDeleteTextures(1, &drawing.texture);
}

Result<std::string> Drawings::add(std::string bytes, const std::string& name) {
  Result<Image> image = decode_image(bytes, name);
  if (!image) return image.error();
  const std::string key = kKey + std::to_string(kept_.size());
  const unsigned texture = textured(*image);
  kept_[key] = {std::move(*image), data_uri(bytes), texture};
  return key;
}

Result<Done> Drawings::take(Document& document) {
  for (Frame& frame : document.frames) {
    const std::size_t comma = frame.image.find(',');
    if (!frame.image.starts_with("data:") || comma == std::string::npos) {
      frame.image.clear();
      continue;
    }
    const Result<std::string> bytes = from_base64(std::string_view(frame.image).substr(comma + 1));
    if (!bytes) return bytes.error();
    Result<std::string> key = add(*bytes, "the drawing of '" + frame.name + "'");
    if (!key) return key.error();
    frame.image = std::move(*key);
  }
  return Done{};
}

Document Drawings::whole(Document document) const {
  for (Frame& frame : document.frames)
    if (const Drawing* drawing = of(frame)) frame.image = drawing->uri;
  return document;
}

const Drawing* Drawings::at(const std::string& key) const {
  const auto found = kept_.find(key);
  return found == kept_.end() ? nullptr : &found->second;
}

}  // namespace artisketch
