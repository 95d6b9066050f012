#include "editor/pictures/drawings.h"

#include "files/bytes.h"
#include "files/inside_images.h"

namespace artisketch {
namespace {

constexpr const char* kKey = "drawing:";

unsigned textured(Graphics& graphics, const Image& image) {
  std::vector<std::uint8_t> pixels = image.rgba;
  for (std::size_t i = 0; i < pixels.size(); i += 4)
    for (int c = 0; c < 3; ++c)
      pixels[i + c] = std::uint8_t((pixels[i + c] * pixels[i + 3] + 127) / 255);
  return graphics.add_texture(image.width, image.height, pixels, Graphics::Beyond::stretches);
}

}  // namespace

Drawings::~Drawings() {
  for (auto& [key, drawing] : kept_) graphics_.remove_texture(drawing.texture);
}

Result<std::string> Drawings::add(std::string bytes, const std::string& name) {
  Result<Image> image = decode_image(bytes, name);
  if (!image) return image.error();
  const std::string key = kKey + std::to_string(kept_.size());
  const unsigned texture = textured(graphics_, *image);
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
