#include "files/image_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <optional>

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

// The most that stb may take at once while it decodes, set from the size that an image says it has:
// a few bytes may inflate to gigabytes of rows that no image has.
thread_local std::size_t most_at_once = 0;

// Zeroed: tables that a JPEG refers to and doesn't give are read all the same.
void* taken(std::size_t size) {
  return size <= most_at_once ? std::calloc(1, size) : nullptr;
}
void* taken_again(void* old, std::size_t size) {
  return size <= most_at_once ? std::realloc(old, std::max<std::size_t>(size, 1)) : nullptr;
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
#define STBI_MALLOC(size) taken(size)
#define STBI_REALLOC(old, size) taken_again(old, size)
#define STBI_FREE(old) std::free(old)
// Where nothing is left to read stb copies nothing from nowhere: harmless, though C forbids it.
#ifdef __clang__
#pragma clang attribute push(__attribute__((no_sanitize("nonnull-attribute"))), apply_to = function)
#endif
#include <stb/stb_image.h>
#ifdef __clang__
#pragma clang attribute pop
#endif
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBIW_ZLIB_COMPRESS compressed
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

#include "base/ensure.h"
#include "files/bytes.h"
#include "model/working_scale.h"

namespace artisketch {
namespace {

constexpr int kLargestSide = 16384;                  // as a frame may be
constexpr long long kMostPixels = 100'000'000;       // 400 MB, five times a good camera's picture
constexpr long long kMostPixelsInAll = 250'000'000;  // of a document's drawings: 1 GB

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

Error too_large(const std::string& name, std::uint32_t width, std::uint32_t height) {
  return bad_input(name + ": has " + size_words(width, height) +
                   " pixels, too many (16384 a side, 100 million in all): make it smaller");
}

std::uint32_t big_endian(std::string_view bytes, std::size_t at, int count) {
  std::uint32_t value = 0;
  for (int i = 0; i < count; ++i)
    value = value << 8 | (at + i < bytes.size() ? std::uint8_t(bytes[at + i]) : 0u);
  return value;
}

bool is_png(std::string_view bytes) {
  return bytes.starts_with("\x89PNG\r\n\x1a\n");
}
bool is_jpeg(std::string_view bytes) {
  return bytes.starts_with("\xff\xd8\xff");
}

std::optional<std::array<std::uint32_t, 2>> png_size(std::string_view bytes) {
  constexpr std::size_t kHeader = 24;  // bytes, up to the size
  if (bytes.size() < kHeader || !is_png(bytes) || bytes.substr(12, 4) != "IHDR")
    return std::nullopt;
  return std::array{big_endian(bytes, 16, 4), big_endian(bytes, 20, 4)};
}

// What a PNG keeps in the first chunk of that name; empty where there is none.
std::string_view png_chunk(std::string_view bytes, std::string_view kind) {
  for (std::size_t at = 8; at + 8 <= bytes.size();) {
    const std::size_t length = big_endian(bytes, at, 4);
    if (bytes.substr(at + 4, 4) == kind) return bytes.substr(at + 8, length);
    at += 12 + length;
  }
  return {};
}

// What stands behind `begins` in the first of a JPEG's segments of that kind that begins so.
std::string_view jpeg_segment(std::string_view bytes, std::uint8_t kind, std::string_view begins) {
  constexpr std::uint8_t kScan = 0xDA;
  for (std::size_t at = 2; at + 4 <= bytes.size() && std::uint8_t(bytes[at]) == 0xFF;) {
    const std::uint8_t found = std::uint8_t(bytes[at + 1]);
    if (found == 0xFF) {  // one that fills
      ++at;
      continue;
    }
    const std::size_t length = big_endian(bytes, at + 2, 2);  // with itself
    if (found == kScan || length < 2) break;
    const std::string_view body = bytes.substr(at + 4, length - 2);
    if (found == kind && body.starts_with(begins)) return body.substr(begins.size());
    at += 2 + length;
  }
  return {};
}

// Which way up a camera or a program says that its picture is to be seen: 1 to 8 as of Exif 2.3,
// section 4.6.4 A; 1 is as stored.
int orientation(std::string_view bytes) {
  using namespace std::string_view_literals;
  const std::string_view exif = is_png(bytes)    ? png_chunk(bytes, "eXIf")
                                : is_jpeg(bytes) ? jpeg_segment(bytes, 0xE1, "Exif\0\0"sv)
                                                 : std::string_view();
  const bool little = exif.starts_with("II*\0"sv);
  if (!little && !exif.starts_with("MM\0*"sv)) return 1;
  const auto number = [&](std::size_t at, int count) {
    std::uint32_t value = 0;
    for (int i = 0; i < count; ++i) {
      const std::size_t byte = at + std::size_t(little ? count - 1 - i : i);
      value = value << 8 | (byte < exif.size() ? std::uint8_t(exif[byte]) : 0u);
    }
    return value;
  };
  constexpr std::uint32_t kOrientation = 0x0112;
  const std::size_t directory = number(4, 4);
  const std::uint32_t entries = number(directory, 2);
  for (std::uint32_t e = 0; e < entries; ++e) {
    const std::size_t at = directory + 2 + 12 * std::size_t(e);
    if (at + 12 > exif.size()) break;
    if (number(at, 2) != kOrientation) continue;
    const std::uint32_t value = number(at + 8, 2);
    return value >= 1 && value <= 8 ? int(value) : 1;
  }
  return 1;
}

Image upright(Image image, int orientation) {
  if (orientation == 1) return image;
  const bool lies = orientation >= 5;  // rows become columns
  Image out(lies ? image.height : image.width, lies ? image.width : image.height);
  const int right = image.width - 1, bottom = image.height - 1;
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      int u = lies ? y : x, v = lies ? x : y;
      if (orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8)
        u = right - u;
      if (orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7)
        v = bottom - v;
      std::copy_n(image.at(u, v), 4, out.at(x, y));
    }
  return out;
}

// The size of an image that can be read; `pictures` of it are wanted.
struct Sides {
  int width = 0, height = 0;
};
Result<Sides> sides_of(std::string_view bytes, const std::string& name, long long pictures) {
  constexpr std::size_t kToReadHeaders = 1 << 20;
  most_at_once = kToReadHeaders;
  if (bytes.size() > std::size_t(INT32_MAX)) return unreadable(name, "is larger than 2 GB");
  if (!is_png(bytes) && !is_jpeg(bytes) && !is_gif(bytes))  // stb takes more for one of them
    return unreadable(name, "is no PNG or JPEG image");
  Sides sides;
  int channels = 0;
  // stb takes a PNG of a size that it can't hold for none at all.
  if (const std::optional<std::array<std::uint32_t, 2>> png = png_size(bytes))
    if (std::max((*png)[0], (*png)[1]) > std::uint32_t(kLargestSide))
      return too_large(name, (*png)[0], (*png)[1]);
  if (!stbi_info_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), int(bytes.size()),
                             &sides.width, &sides.height, &channels))
    return unreadable(name, "is no PNG or JPEG image");
  if (sides.width > kLargestSide || sides.height > kLargestSide ||
      pictures * sides.width * sides.height > kMostPixels)
    return too_large(name, sides.width, sides.height);
  // 16 bits a channel inflate to 8 bytes a pixel, in buffers that grow by doubling; as many again
  // for what is small beside its own tables.
  constexpr std::size_t kLeast = 16 << 20, kPerPixel = 17;
  most_at_once = kLeast + kPerPixel * std::size_t(pictures * sides.width * sides.height);
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

namespace {

// Whether Huffman tables fill their segment, with 256 codes each at most.
bool whole_tables(std::string_view body) {
  constexpr std::size_t kLengths = 16, kMostCodes = 256;
  while (!body.empty()) {
    if (body.size() < 1 + kLengths) return false;
    std::size_t codes = 0;
    for (std::size_t i = 1; i <= kLengths; ++i) codes += std::uint8_t(body[i]);
    if (codes > kMostCodes || body.size() < 1 + kLengths + codes) return false;
    body.remove_prefix(1 + kLengths + codes);
  }
  return true;
}

// A JPEG of the same pixels, of nothing but what they need: whole segments one after the other.
// stb writes beyond its memory where a Huffman table has more codes than there are, and looks for
// tables in other places than we would in a file that is damaged. Nothing where a table is broken.
std::optional<std::string> plain_jpeg(std::string_view bytes) {
  constexpr unsigned kScan = 0xDA, kEnd = 0xD9, kTables = 0xC4, kComment = 0xFE;
  const auto byte = [&](std::size_t at) { return unsigned(std::uint8_t(bytes[at])); };
  // What may stand behind 0xFF without a segment: in a scan a byte 0xFF, or where it goes on.
  const auto bare = [](unsigned kind) { return kind == 0 || (kind >= 0xD0 && kind <= 0xD7); };
  std::string plain(bytes.substr(0, 2));
  for (std::size_t at = 2; at + 4 <= bytes.size();) {
    const unsigned kind = byte(at + 1);
    if (byte(at) != 0xFF || kind == 0xFF || bare(kind)) {
      ++at;
      continue;
    }
    if (kind == kEnd) break;
    const std::size_t length = 2 + big_endian(bytes, at + 2, 2);
    if (length < 4 || at + length > bytes.size()) break;  // cut off
    const std::string_view segment = bytes.substr(at, length);
    if (kind == kTables && !whole_tables(segment.substr(4))) return std::nullopt;
    constexpr unsigned kJfif = 0xE0, kAdobe = 0xEE, kLastOfPrograms = 0xEF;
    const bool of_program =
        kind >= kJfif && kind <= kLastOfPrograms && kind != kJfif && kind != kAdobe;
    if (!of_program && kind != kComment) plain += segment;
    at += length;
    if (kind != kScan) continue;
    std::size_t end = at;
    while (end + 1 < bytes.size() && (byte(end) != 0xFF || bare(byte(end + 1)))) ++end;
    plain += bytes.substr(at, end - at);
    at = end;
  }
  return plain + "\xff\xd9";
}

// What a file holds, as it is stored.
struct Decoded {
  StbBytes rgba;
  int width = 0, height = 0, orientation = 1;

  Sides sides() const { return orientation < 5 ? Sides{width, height} : Sides{height, width}; }
  // As it is to be seen, every side by side pixels as one.
  Image image(int side = 1) const {
    // Blocks are counted from the corner that is seen at the top left.
    if (side > 1 && orientation == 1) return mean_of_blocks(rgba.get(), width, height, side);
    Image whole(width, height);
    std::copy_n(rgba.get(), whole.rgba.size(), whole.rgba.begin());
    whole = upright(std::move(whole), orientation);
    return side > 1 ? scaled(whole, 1.0 / side) : whole;
  }
};

Result<Decoded> decoded(std::string_view bytes, const std::string& name) {
  const int turned = orientation(bytes);
  std::optional<std::string> plain;
  if (is_jpeg(bytes)) {
    plain = plain_jpeg(bytes);
    if (!plain) return unreadable(name, "is damaged (a table of codes that is too long)");
    bytes = *plain;
  }
  const Result<Sides> sides = sides_of(bytes, name, 1);
  if (!sides) return sides.error();
  int width = 0, height = 0, channels = 0;
  StbBytes pixels(stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                                        int(bytes.size()), &width, &height, &channels, 4),
                  stbi_image_free);
  if (!pixels) return unreadable(name, "is damaged (" + std::string(stbi_failure_reason()) + ")");
  return Decoded{std::move(pixels), width, height, turned};
}

}  // namespace

Result<Image> decode_image(std::string_view bytes, const std::string& name) {
  const Result<Decoded> file = decoded(bytes, name);
  if (!file) return file.error();
  return file->image();
}

std::string colour_profile(std::string_view bytes) {
  using namespace std::string_view_literals;
  std::string name;
  if (is_png(bytes)) {
    const std::string_view profile = png_chunk(bytes, "iCCP");
    name = profile.substr(0, std::min<std::size_t>(profile.find('\0'), 79));
  } else if (is_jpeg(bytes)) {
    const std::string_view profile = jpeg_segment(bytes, 0xE2, "ICC_PROFILE\0"sv);
    if (profile.empty() || profile.find("sRGB") != profile.npos) return "";
    // In UTF-16, as profiles since version 4 keep their names.
    if (profile.find("s\0R\0G\0B"sv) != profile.npos) return "";
    name = "of its own";
  }
  return name.find("sRGB") == name.npos ? name : "";
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
  // Picture by picture: stb's own loop reads before its memory for a picture that is to be undone
  // once seen.
  struct Gif : stbi__gif {
    Gif() : stbi__gif{} {}
    ~Gif() {
      for (stbi_uc* one : {out, background, history}) stbi_image_free(one);
    }
  } gif;
  stbi__context context;
  stbi__start_mem(&context, reinterpret_cast<const stbi_uc*>(bytes.data()), int(bytes.size()));
  std::vector<Image> images;
  for (;;) {
    int channels = 0;
    stbi_uc* const two_back = images.size() < 2 ? nullptr : images[images.size() - 2].rgba.data();
    const stbi_uc* const pixels = stbi__gif_load_next(&context, &gif, &channels, 4, two_back);
    if (!pixels || pixels == reinterpret_cast<const stbi_uc*>(&context))
      break;  // damage, or the end
    if (gif.w != sides->width || gif.h != sides->height) break;
    Image& image = images.emplace_back(gif.w, gif.h);
    std::copy_n(pixels, image.rgba.size(), image.rgba.begin());
  }
  if (images.empty()) {
    const char* const why = stbi_failure_reason();
    return unreadable(name, std::string("is damaged (") + (why ? why : "no picture in it") + ")");
  }
  return images;
}

std::string png_bytes(const Image& image) {
  ensure(image.width > 0 && image.height > 0 &&
             image.rgba.size() == 4 * std::size_t(image.width) * image.height,
         "a picture has pixels");
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

bool leaves_folder(const std::string& image) {
  if (image.starts_with("data:")) return false;
  int depth = 0;
  for (std::size_t at = 0; at <= image.size();) {
    const std::size_t end = std::min(image.find('/', at), image.size());
    const std::string_view step = std::string_view(image).substr(at, end - at);
    depth += step == ".." ? -1 : step == "." || step.empty() ? 0 : 1;
    if (depth < 0) return true;
    at = end + 1;
  }
  return image.starts_with('/');
}

std::vector<std::string> drawing_words(const Document& document, const std::string& path) {
  std::vector<std::string> words;
  for (const Frame& frame : document.frames) {
    if (frame.image.empty()) continue;
    const std::string whose = path + ": the image of frame '" + frame.name + "' ";
    if (leaves_folder(frame.image)) continue;  // not read: load_frame_image says so
    const Result<std::string> bytes = image_bytes(frame.image, path);
    if (const std::string profile = bytes ? colour_profile(*bytes) : ""; !profile.empty())
      words.push_back(whose + "has a colour profile (" + profile +
                      "), which is not used: its colours are taken as sRGB");
  }
  return words;
}

std::string size_words(long long width, long long height) {
  return std::to_string(width) + " × " + std::to_string(height);
}

Result<Image> load_frame_image(const Frame& frame, const std::string& document_path, int side) {
  if (frame.image.empty()) return Image();
  const std::string whose = document_path + ": the image of frame '" + frame.name + "'";
  // Documents come from anybody, and what they name goes into models that are shown to anybody.
  if (leaves_folder(frame.image))
    return bad_input(whose + " lies outside the document's folder: " + frame.image +
                     "; put the drawing beside the document, or a link to it");
  const Result<std::string> bytes = image_bytes(frame.image, document_path);
  if (!bytes)
    return bad_input(whose + ": " + bytes.error().text() +
                     "; put the drawing there, or leave the frame's \"image\" out");
  const Result<Decoded> file = decoded(*bytes, whose);
  if (!file) return file.error();
  if (const auto [width, height] = file->sides(); width != frame.width || height != frame.height)
    return bad_input(whose + ": has " + size_words(width, height) +
                     " pixels, but the frame's size is " + size_words(frame.width, frame.height) +
                     "; they should be the same: contours are drawn in the image's pixels");
  return file->image(side);
}

std::vector<Image> load_drawings(const Document& document, const std::string& document_path,
                                 std::vector<std::string>& warnings) {
  std::vector<Image> drawings;
  long long pixels = 0;
  const double scale = std::min(1.0, working_scale(with_shaping_contours(document)));
  const int side = int(std::lround(1 / scale));
  for (std::size_t f = 0; f < document.frames.size(); ++f) {
    const Frame& frame = document.frames[f];
    drawings.emplace_back();
    if (frame.image.empty()) continue;
    // Frames say their drawings' sizes: what is too much isn't even read.
    pixels += (long long)frame.width * frame.height;
    if (pixels > kMostPixelsInAll) {
      warnings.push_back(document_path + ": the image of frame '" + frame.name +
                         "': the drawings have more than 250 million pixels in all; make them "
                         "smaller; the model goes without its colours");
      continue;
    }
    std::size_t same = 0;
    while (same < f && (document.frames[same].image != frame.image || drawings[same].rgba.empty()))
      ++same;
    const Frame& other = document.frames[same];
    if (same < f && other.width == frame.width && other.height == frame.height) {
      drawings.back() = drawings[same];
      continue;
    }
    Result<Image> image = load_frame_image(frame, document_path, side);
    if (!image) warnings.push_back(image.error().text() + "; the model goes without its colours");
    if (image) drawings.back() = std::move(*image);
  }
  return drawings;
}

}  // namespace artisketch
