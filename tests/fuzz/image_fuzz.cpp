// Any bytes at all are pictures of the size that they say, or are refused in words.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "files/image_file.h"

using namespace artisketch;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  (void)colour_profile(bytes);
  for (const Result<std::vector<Image>>& read : {decode_images(bytes, "fuzz")}) {
    if (!read) {
      if (read.error().faults.empty()) std::abort();
      continue;
    }
    if (read->empty()) std::abort();
    for (const Image& image : *read)
      if (image.width < 1 || image.rgba.size() != 4 * std::size_t(image.width) * image.height)
        std::abort();
  }
  return 0;
}
