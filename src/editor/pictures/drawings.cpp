#include "editor/pictures/drawings.h"

#include <cstdlib>

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

constexpr int kClear = 128;  // alpha below which nothing is drawn

// Of the pixels beside clear ones more than a quarter are as light as paper: on white they are
// lost.
bool is_pale(const Image& image) {
  constexpr int kPale = 215;  // each channel
  const auto alpha = [&](int x, int y) {
    return image.rgba[4 * (std::size_t(y) * image.width + x) + 3];
  };
  int edge = 0, pale = 0;
  for (int y = 1; y + 1 < image.height; ++y)
    for (int x = 1; x + 1 < image.width; ++x) {
      if (alpha(x, y) < kClear || (alpha(x - 1, y) >= kClear && alpha(x + 1, y) >= kClear &&
                                   alpha(x, y - 1) >= kClear && alpha(x, y + 1) >= kClear))
        continue;
      const std::uint8_t* c = &image.rgba[4 * (std::size_t(y) * image.width + x)];
      ++edge;
      pale += c[0] > kPale && c[1] > kPale && c[2] > kPale;
    }
  return 4 * pale > edge;
}

// Pixels along the border unlike the first corner's.
bool is_full(const Image& image) {
  constexpr int kUnlike = 32;  // in any channel
  const auto unlike = [&](int x, int y) {
    const std::uint8_t* c = &image.rgba[4 * (std::size_t(y) * image.width + x)];
    if (c[3] < kClear || image.rgba[3] < kClear) return (c[3] < kClear) != (image.rgba[3] < kClear);
    for (int k = 0; k < 3; ++k)
      if (std::abs(int(c[k]) - int(image.rgba[k])) > kUnlike) return true;
    return false;
  };
  for (int x = 0; x < image.width; ++x)
    if (unlike(x, 0) || unlike(x, image.height - 1)) return true;
  for (int y = 0; y < image.height; ++y)
    if (unlike(0, y) || unlike(image.width - 1, y)) return true;
  return false;
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
  const bool pale = is_pale(*image), full = is_full(*image);
  kept_[key] = {std::move(*image), data_uri(bytes), texture, pale, full};
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
