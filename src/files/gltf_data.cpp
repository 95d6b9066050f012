#include "files/gltf_data.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "files/glb_parts.h"
#include "files/gltf_compress.h"

namespace artisketch {
namespace {

// What tinygltf reads into looks through an object's fields for each of them: thousands would take
// minutes.
void check_fields(const Json& json) {
  constexpr std::size_t kMost = 1000;
  std::vector<const Json*> open{&json};
  while (!open.empty()) {
    const Json& value = *open.back();
    open.pop_back();
    require(!value.is_object() || value.size() <= kMost,
            "has an object of more than " + std::to_string(kMost) + " fields");
    if (value.is_structured())
      for (const Json& inner : value) open.push_back(&inner);
  }
}

// tinygltf trusts its input in places: it recurses into nested values, and takes the address of an
// image's bytes before looking whether they are there. What would trip it is refused here.
void check_container(const GlbParts& parts) {
  const Json& json = parts.json;
  const std::size_t bin_size = parts.bin.size();
  check_fields(json);
  if (const auto buffers = json.find("buffers"); buffers != json.end())
    require(buffers->is_array() && buffers->size() == 1 && (*buffers)[0].is_object() &&
                !(*buffers)[0].contains("uri"),
            "does not hold all its data");
  if (const auto views = json.find("bufferViews"); views != json.end())
    for (const Json& view : *views) {
      require(view.is_object(), "has a damaged buffer view");
      const auto number = [&](const char* field) {
        const auto found = view.find(field);
        if (found == view.end()) return std::size_t(0);
        require(found->is_number_unsigned(), "has a damaged buffer view");
        return found->get<std::size_t>();
      };
      const std::size_t offset = number("byteOffset"), length = number("byteLength");
      require(offset < bin_size && length <= bin_size - offset && number("buffer") == 0,
              "has a buffer view outside its data");
    }
}

// Images stay encoded until they are asked for.
bool leave_image(tinygltf::Image*, const int, std::string*, std::string*, int, int,
                 const unsigned char*, int, void*) {
  return true;
}

tinygltf::Model parse(std::string_view bytes) {
  GlbParts parts = glb_parts(bytes);
  std::string whole;
  if (is_compressed(parts)) {
    parts = decompressed(std::move(parts));
    bytes = whole = glb_of(parts);
  }
  check_container(parts);
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(leave_image, nullptr);
  loader.SetFsCallbacks({});
  tinygltf::Model gltf;
  std::string error, warning;
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  if (!loader.LoadBinaryFromMemory(&gltf, &error, &warning, data, unsigned(bytes.size()))) {
    std::replace(error.begin(), error.end(), '\n', ' ');
    throw Refused{"is damaged: " + error};
  }
  return gltf;
}

// One component, as the number that it stands for.
double component_at(const char* from, int component, bool normalized) {
  const auto as = [&](auto value, double most) {
    std::memcpy(&value, from, sizeof value);  // glTF and we are little-endian
    return normalized ? std::max(double(value) / most, -1.0) : double(value);
  };
  switch (component) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return as(std::int8_t(), 127);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return as(std::uint8_t(), 255);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return as(std::int16_t(), 32767);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return as(std::uint16_t(), 65535);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return as(std::uint32_t(), 1);
    default:
      return as(float(), 1);
  }
}

}  // namespace

GltfData::GltfData(std::string_view bytes) : gltf_(parse(bytes)) {}

std::string_view GltfData::view_bytes(int index) const {
  const tinygltf::BufferView& view = at(gltf_.bufferViews, index, "buffer view");
  const std::vector<unsigned char>& data = at(gltf_.buffers, view.buffer, "buffer").data;
  require(view.byteOffset <= data.size() && view.byteLength <= data.size() - view.byteOffset,
          "has a buffer view outside its data");
  return {reinterpret_cast<const char*>(data.data()) + view.byteOffset, view.byteLength};
}

GltfRows GltfData::rows(int index, int type) const {
  const tinygltf::Accessor& accessor = at(gltf_.accessors, index, "accessor");
  const int component = accessor.componentType;
  const bool known = component == TINYGLTF_COMPONENT_TYPE_FLOAT ||
                     (component >= TINYGLTF_COMPONENT_TYPE_BYTE &&
                      component <= TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) ||
                     component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  const bool whole = component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  require(accessor.type == type && known && !accessor.sparse.isSparse &&
              !(accessor.normalized && whole) && accessor.count > 0,
          "has an accessor of a kind that ArtiSketch does not read");
  const std::string_view bytes = view_bytes(accessor.bufferView);
  const std::size_t part = std::size_t(tinygltf::GetComponentSizeInBytes(unsigned(component)));
  const std::size_t width = std::size_t(tinygltf::GetNumComponentsInType(unsigned(type)));
  const std::size_t given = gltf_.bufferViews[std::size_t(accessor.bufferView)].byteStride;
  const std::size_t stride = given ? given : part * width;
  require(stride >= part * width && accessor.byteOffset <= bytes.size() &&
              bytes.size() - accessor.byteOffset >= part * width &&
              (bytes.size() - accessor.byteOffset - part * width) / stride >= accessor.count - 1,
          "has an accessor outside its data");
  GltfRows values(Eigen::Index(accessor.count), Eigen::Index(width));
  for (std::size_t i = 0; i < accessor.count; ++i)
    for (std::size_t k = 0; k < width; ++k)
      values(Eigen::Index(i), Eigen::Index(k)) =
          component_at(bytes.data() + accessor.byteOffset + i * stride + k * part, component,
                       accessor.normalized);
  require(values.allFinite(), "has a number that is not finite");
  return values;
}

}  // namespace artisketch
