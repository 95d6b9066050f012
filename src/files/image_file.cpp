#include "files/image_file.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <memory>
#include <mutex>

#include <zlib.h>

namespace {

// In place of stb's own compressor, whose files are a third larger. The caller frees.
unsigned char* compressed(unsigned char* data, int size, int* out_size, int quality) {
  uLongf room = compressBound(uLong(size));
  auto* out = static_cast<unsigned char*>(std::malloc(room));
  if (out && compress2(out, &room, data, uLong(size), quality) != Z_OK) {
    std::free(out);
    return nullptr;
  }
  *out_size = int(room);
  return out;
}

}  // namespace

// The one place that holds stb's code, for itself alone.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_GIF
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_FAILURE_USERMSG
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBIW_ZLIB_COMPRESS compressed
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

#include "files/bytes.h"

namespace artisketch {
namespace {

constexpr int kLargestSide = 16384;             // as a frame may be
constexpr long long kMostPixels = 100'000'000;  // 400 MB, five times a good camera's picture

// stb's numbers for how a row is predicted from the one before.
constexpr int kBestOfFilters = -1, kNoFilter = 0;
constexpr int kCompression = 6;  // 8 takes twice as long for a hundredth of the size

// A PNG of rows of `channels` bytes a pixel.
std::string png_of_rows(const std::uint8_t* rows, int width, int height, int channels, int filter) {
  static std::mutex one_at_a_time;  // what stb is told is global
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  stbi_write_force_png_filter = filter;
  stbi_write_png_compression_level = kCompression;
  const auto append = [](void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), std::size_t(size));
  };
  std::string bytes;
  stbi_write_png_to_func(append, &bytes, width, height, channels, rows, width * channels);
  return bytes;
}

std::string size_words(int width, int height) {
  return std::to_string(width) + " × " + std::to_string(height);
}

// The bytes that a frame's `image` stands for.
Result<std::string> image_bytes(const std::string& image, const std::string& document_path) {
  if (image.rfind("data:", 0) == 0) {
    const std::size_t comma = image.find(',');
    if (comma == image.npos) return bad_input("the data: URI has no comma");
    return from_base64(std::string_view(image).substr(comma + 1));
  }
  const std::size_t slash = document_path.rfind('/');
  return read_file(slash == document_path.npos ? image
                                               : document_path.substr(0, slash + 1) + image);
}

}  // namespace

namespace {

using StbBytes = std::unique_ptr<stbi_uc, void (*)(void*)>;

Error unreadable(const std::string& name, const std::string& why) {
  return bad_input(name + ": " + why + "; save it again as PNG or JPEG");
}

// The size of an image that can be read; `pictures` of it are wanted.
struct Sides {
  int width = 0, height = 0;
};
Result<Sides> sides_of(std::string_view bytes, const std::string& name, long long pictures) {
  if (bytes.size() > std::size_t(INT32_MAX)) return unreadable(name, "is larger than 2 GB");
  Sides sides;
  int channels = 0;
  if (!stbi_info_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), int(bytes.size()),
                             &sides.width, &sides.height, &channels))
    return unreadable(name, "is no PNG or JPEG image");
  if (sides.width > kLargestSide || sides.height > kLargestSide ||
      pictures * sides.width * sides.height > kMostPixels)
    return unreadable(name, "has " + size_words(sides.width, sides.height) +
                                " pixels, too many (16384 a side, 100 million in "
                                "all): make it smaller");
  return sides;
}

// Pictures in a GIF, at most: its blocks are walked without decoding them.
long long gif_pictures(std::string_view bytes) {
  const auto byte = [&](std::size_t i) { return i < bytes.size() ? std::uint8_t(bytes[i]) : 0; };
  const auto table = [](int flags) { return flags & 0x80 ? 3u << ((flags & 7) + 1) : 0u; };
  long long pictures = 0;
  std::size_t at = 13 + table(byte(10));
  while (at < bytes.size()) {
    const int kind = byte(at);
    if (kind == 0x2C) {  // a picture
      ++pictures;
      at += 11 + table(byte(at + 9));
    } else if (kind == 0x21) {  // an extension
      at += 2;
    } else {
      break;
    }
    while (byte(at)) at += 1 + std::size_t(byte(at));
    ++at;
  }
  return std::max(1LL, pictures);
}

}  // namespace

Result<Image> decode_image(std::string_view bytes, const std::string& name) {
  const Result<Sides> sides = sides_of(bytes, name, 1);
  if (!sides) return sides.error();
  int width = 0, height = 0, channels = 0;
  const StbBytes pixels(stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                                              int(bytes.size()), &width, &height, &channels, 4),
                        stbi_image_free);
  if (!pixels) return unreadable(name, "is damaged (" + std::string(stbi_failure_reason()) + ")");
  Image image(width, height);
  std::copy_n(pixels.get(), image.rgba.size(), image.rgba.begin());
  return image;
}

bool is_gif(std::string_view bytes) {
  return bytes.substr(0, 4) == "GIF8";
}

Result<std::vector<Image>> decode_images(std::string_view bytes, const std::string& name) {
  if (!is_gif(bytes)) {
    Result<Image> image = decode_image(bytes, name);
    if (!image) return image.error();
    return std::vector<Image>{std::move(*image)};
  }
  const Result<Sides> sides = sides_of(bytes, name, gif_pictures(bytes));
  if (!sides) return sides.error();
  int width = 0, height = 0, count = 0, channels = 0;
  int* delays = nullptr;
  const StbBytes pixels(
      stbi_load_gif_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), int(bytes.size()),
                                &delays, &width, &height, &count, &channels, 4),
      stbi_image_free);
  const StbBytes freed(reinterpret_cast<stbi_uc*>(delays), stbi_image_free);
  if (!pixels || count < 1)
    return unreadable(name, "is damaged (" + std::string(stbi_failure_reason()) + ")");
  std::vector<Image> images;
  for (int i = 0; i < count; ++i) {
    Image& image = images.emplace_back(width, height);
    std::copy_n(pixels.get() + i * image.rgba.size(), image.rgba.size(), image.rgba.begin());
  }
  return images;
}

std::string png_bytes(const Image& image) {
  assert(image.width > 0 && image.height > 0);
  const int pixels = image.width * image.height;
  bool opaque = true;
  for (int i = 0; opaque && i < pixels; ++i) opaque = image.rgba[4 * std::size_t(i) + 3] == 255;
  const int channels = opaque ? 3 : 4;
  std::vector<std::uint8_t> packed;
  if (opaque) {
    packed.reserve(3 * std::size_t(pixels));
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
      packed.insert(packed.end(), &image.rgba[i], &image.rgba[i] + 3);
  }
  const std::uint8_t* const rows = opaque ? packed.data() : image.rgba.data();
  const std::size_t stride = std::size_t(image.width) * std::size_t(channels);

  // Flat colours are smaller by up to a third without filters, shaded ones with them: bands of a
  // large picture, an eighth of it, tell which.
  constexpr int kBand = 8, kEvery = 8 * kBand, kLarge = 512;
  std::vector<std::uint8_t> bands;
  if (image.height >= kLarge)
    for (int y = kEvery / 2; y + kBand <= image.height; y += kEvery)
      bands.insert(bands.end(), rows + stride * y, rows + stride * (y + kBand));
  const std::uint8_t* const sample = bands.empty() ? rows : bands.data();
  const int sample_rows = bands.empty() ? image.height : int(bands.size() / stride);
  const bool filtered =
      png_of_rows(sample, image.width, sample_rows, channels, kBestOfFilters).size() <
      png_of_rows(sample, image.width, sample_rows, channels, kNoFilter).size();
  return png_of_rows(rows, image.width, image.height, channels,
                     filtered ? kBestOfFilters : kNoFilter);
}

Result<Image> load_frame_image(const Frame& frame, const std::string& document_path) {
  if (frame.image.empty()) return Image();
  const std::string whose = document_path + ": the image of frame '" + frame.name + "'";
  const Result<std::string> bytes = image_bytes(frame.image, document_path);
  if (!bytes)
    return bad_input(whose + ": " + bytes.error().text() +
                     "; put the drawing there, or leave the frame's \"image\" out");
  Result<Image> image = decode_image(*bytes, whose);
  if (image && (image->width != frame.width || image->height != frame.height))
    return bad_input(whose + ": has " + size_words(image->width, image->height) +
                     " pixels, but the frame's size is " + size_words(frame.width, frame.height) +
                     "; they should be the same: contours are drawn in the image's pixels");
  return image;
}

std::vector<Image> load_drawings(const Document& document, const std::string& document_path,
                                 std::vector<std::string>& warnings) {
  std::vector<Image> drawings;
  for (const Frame& frame : document.frames) {
    Result<Image> image = load_frame_image(frame, document_path);
    if (!image) warnings.push_back(image.error().text() + "; the model goes without its colours");
    drawings.push_back(image ? std::move(*image) : Image());
  }
  return drawings;
}

std::vector<Picture> pictures(const std::vector<Image>& drawings) {
  std::vector<Picture> all;
  bool any = false;
  for (const Image& drawing : drawings) {
    all.push_back({drawing.width, drawing.height, drawing.rgba});
    any = any || drawing.width > 0;
  }
  if (!any) all.clear();
  return all;
}

}  // namespace artisketch
