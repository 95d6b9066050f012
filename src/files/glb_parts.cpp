#include "files/glb_parts.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "files/gltf_data.h"

namespace artisketch {
namespace {

constexpr std::size_t kHead = 20;  // of the file, and of its first chunk

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

void put(std::string& out, std::size_t value) {
  for (int i = 0; i < 4; ++i) out += char(value >> (8 * i) & 255);
}

std::string padded(std::string chunk, char with) {
  while (chunk.size() % 4) chunk += with;
  return chunk;
}

}  // namespace

GlbParts glb_parts(std::string_view bytes) {
  require(bytes.size() >= kHead && bytes.substr(0, 4) == "glTF", "is no binary glTF");
  require(number_at(bytes, 4) == 2, "is not glTF version 2");
  require(number_at(bytes, 8) == bytes.size(), "is cut off, or longer than it says");
  const std::size_t json_size = number_at(bytes, 12);
  require(json_size <= bytes.size() - kHead && bytes.substr(16, 4) == "JSON", "has no JSON chunk");
  GlbParts parts;
  Faults faults("its JSON");
  std::optional<Json> json = parse_json(bytes.substr(kHead, json_size), faults);
  if (!faults.none()) throw Refused{"is damaged: " + faults.error().faults.front()};
  require(json->is_object(), "has a JSON chunk that is no object");
  parts.json = std::move(*json);
  if (const std::size_t at = kHead + json_size; bytes.size() >= at + 8)
    parts.bin = bytes.substr(at + 8, number_at(bytes, at));
  return parts;
}

std::string glb_of(const GlbParts& parts) {
  const std::string json = padded(parts.json.dump(), ' '), bin = padded(parts.bin, '\0');
  std::string out = "glTF";
  put(out, 2);
  put(out, kHead + json.size() + 8 + bin.size());
  put(out, json.size());
  out += "JSON" + json;
  put(out, bin.size());
  out += std::string("BIN\0", 4) + bin;
  return out;
}

}  // namespace artisketch
