#include "files/gltf_compress.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <set>
#include <vector>

#include <Eigen/Core>
#include <meshoptimizer.h>

#include "base/mesh.h"
#include "files/gltf_data.h"

namespace artisketch {
namespace {

constexpr const char* kPacked = "EXT_meshopt_compression";
constexpr const char* kQuantized = "KHR_mesh_quantization";
constexpr int kNormalBits = 8;     // a degree or so
constexpr int kRotationBits = 14;  // a hundredth of a degree
constexpr int kPlaceBits = 20;     // of a root's way, as single precision nearly
constexpr int kVertexTarget = TINYGLTF_TARGET_ARRAY_BUFFER;
constexpr int kIndexTarget = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;

// The codecs' versions are the library's state: newer libraries write what the extension lacks.
void write_as_the_extension_says() {
  static const bool once = [] {
    meshopt_encodeVertexVersion(0);
    meshopt_encodeIndexVersion(1);
    return true;
  }();
  (void)once;
}

// What is packed: `count` elements of `stride` bytes each.
struct Stream {
  std::vector<unsigned char> bytes;
  std::size_t stride = 4;
  const char* filter = nullptr;
  std::size_t count() const { return bytes.size() / stride; }
};

template <class T>
Stream stream_of(const std::vector<T>& values, std::size_t stride) {
  Stream stream;
  stream.stride = stride;
  stream.bytes.resize(values.size() * sizeof(T));
  std::memcpy(stream.bytes.data(), values.data(), stream.bytes.size());
  return stream;
}

class Compressor {
 public:
  explicit Compressor(GlbParts from)
      : from_(std::move(from)), json_(from_.json), views_(Json::array()) {}

  std::string run() {
    write_as_the_extension_says();
    for (Json& mesh : json_["meshes"])
      for (Json& primitive : mesh["primitives"]) compress(primitive);
    compress_clips();
    keep_the_rest();
    json_["bufferViews"] = views_;
    json_["buffers"] = Json::array(
        {{{"byteLength", bin_.size()}},
         {{"byteLength", unpacked_}, {"extensions", {{kPacked, {{"fallback", true}}}}}}});
    for (const char* list : {"extensionsUsed", "extensionsRequired"})
      for (const char* extension : {kQuantized, kPacked}) json_[list].push_back(extension);
    return glb_of({json_, bin_});
  }

 private:
  Json& accessor(int index) { return json_["accessors"][std::size_t(index)]; }

  // The elements of an accessor as glb_bytes writes them: alone in its view, one after the other.
  template <class T>
  std::vector<T> values(int index) const {
    const Json& view =
        from_.json["bufferViews"]
                  [from_.json["accessors"][std::size_t(index)].at("bufferView").get<std::size_t>()];
    std::vector<T> all(view.at("byteLength").get<std::size_t>() / sizeof(T));
    std::memcpy(all.data(), from_.bin.data() + view.value("byteOffset", std::size_t(0)),
                all.size() * sizeof(T));
    return all;
  }
  std::vector<unsigned> indices(int index) {
    if (accessor(index)["componentType"] == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT)
      return values<std::uint32_t>(index);
    const std::vector<std::uint16_t> narrow = values<std::uint16_t>(index);
    return {narrow.begin(), narrow.end()};
  }

  std::size_t append(const void* data, std::size_t bytes) {
    bin_.resize((bin_.size() + 3) / 4 * 4);
    bin_.append(static_cast<const char*>(data), bytes);
    return bin_.size() - bytes;
  }

  // The view of what was packed.
  std::size_t add_packed(const std::vector<unsigned char>& packed, const char* mode,
                         const Stream& stream, int target) {
    unpacked_ = (unpacked_ + 3) / 4 * 4;
    Json view = {{"buffer", 1}, {"byteOffset", unpacked_}, {"byteLength", stream.bytes.size()}};
    unpacked_ += stream.bytes.size();
    if (target == kVertexTarget) view["byteStride"] = stream.stride;
    if (target) view["target"] = target;
    Json how = {{"buffer", 0},
                {"byteOffset", append(packed.data(), packed.size())},
                {"byteLength", packed.size()},
                {"byteStride", stream.stride},
                {"count", stream.count()},
                {"mode", mode}};
    if (stream.filter) how["filter"] = stream.filter;
    view["extensions"][kPacked] = std::move(how);
    views_.push_back(std::move(view));
    return views_.size() - 1;
  }
  std::size_t add_elements(const Stream& stream, int target) {
    std::vector<unsigned char> packed(
        meshopt_encodeVertexBufferBound(stream.count(), stream.stride));
    packed.resize(meshopt_encodeVertexBuffer(packed.data(), packed.size(), stream.bytes.data(),
                                             stream.count(), stream.stride));
    return add_packed(packed, "ATTRIBUTES", stream, target);
  }

  void now_in(int index, std::size_t view, std::size_t offset, int component, bool normalized) {
    Json& one = accessor(index);
    one["bufferView"] = view;
    if (offset) one["byteOffset"] = offset;
    one["componentType"] = component;
    if (normalized) one["normalized"] = true;
    done_.insert(index);
  }

  // `values`, `width` of them for each vertex, as those vertices that are used, in their new order.
  template <class T>
  std::vector<T> reordered(const std::vector<T>& values, std::size_t width) const {
    std::vector<T> out(used_ * width);
    for (std::size_t v = 0; v < order_.size(); ++v)
      if (order_[v] < used_) std::copy_n(&values[v * width], width, &out[order_[v] * width]);
    return out;
  }

  void compress(Json& primitive) {
    compress_triangles(primitive);
    for (const auto& [name, index_] : primitive["attributes"].items()) {
      const int index = index_.get<int>();
      accessor(index)["count"] = used_;
      if (name == "POSITION") compress_positions(index);
      if (name == "NORMAL") compress_normals(index);
      if (name == "TEXCOORD_0") compress_texcoords(index);
      if (name == "JOINTS_0") compress_joints(index);
      if (name == "WEIGHTS_0") compress_weights(index);
    }
  }

  // Triangles in strips and vertices as these first name them: so both pack best.
  void compress_triangles(Json& primitive) {
    const int index = primitive["indices"].get<int>();
    const std::vector<unsigned> given = indices(index);
    const std::size_t vertices =
        accessor(primitive["attributes"]["POSITION"].get<int>())["count"].get<std::size_t>();
    std::vector<unsigned> corners(given.size());
    meshopt_optimizeVertexCacheStrip(corners.data(), given.data(), given.size(), vertices);
    order_.resize(vertices);
    used_ =
        meshopt_optimizeVertexFetchRemap(order_.data(), corners.data(), corners.size(), vertices);
    meshopt_remapIndexBuffer(corners.data(), corners.data(), corners.size(), order_.data());
    std::vector<unsigned char> packed(meshopt_encodeIndexBufferBound(corners.size(), used_));
    packed.resize(
        meshopt_encodeIndexBuffer(packed.data(), packed.size(), corners.data(), corners.size()));
    Stream stream;
    const int component = accessor(index)["componentType"].get<int>();
    stream.stride = component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT ? 4 : 2;
    stream.bytes.resize(corners.size() * stream.stride);
    now_in(index, add_packed(packed, "TRIANGLES", stream, kIndexTarget), 0, component, false);
  }

  // Positions are multiples of a step already, and no more of them than 16 bits count. The skin
  // takes them back to where they were.
  void compress_positions(int index) {
    const std::vector<float> places = reordered(values<float>(index), 3);
    const Points3 V = Eigen::Map<const Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>>(
                          places.data(), Eigen::Index(used_), 3)
                          .cast<double>();
    const Box3 box = bounds(V);
    constexpr double kMost = 65535;
    double step = std::max(position_step(V), 1e-30);
    while (box.sizes().maxCoeff() > kMost * step) step *= 2;
    std::vector<std::uint16_t> steps(4 * used_, 0);
    std::array<int, 3> most{};
    for (std::size_t v = 0; v < used_; ++v)
      for (int c = 0; c < 3; ++c) {
        const long k = std::lround((V(Eigen::Index(v), c) - box.min()[c]) / step);
        steps[4 * v + std::size_t(c)] = std::uint16_t(k);
        most[std::size_t(c)] = std::max(most[std::size_t(c)], int(k));
      }
    now_in(index, add_elements(stream_of(steps, 8), kVertexTarget), 0,
           TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, false);
    accessor(index)["min"] = {0, 0, 0};
    accessor(index)["max"] = most;
    for (Json& skin : json_["skins"])
      place_skin(skin["inverseBindMatrices"].get<int>(), step, box.min());
  }

  void place_skin(int index, double step, const Vec3& origin) {
    const std::vector<float> matrices = values<float>(index);
    std::vector<float> placed(matrices.size());
    for (std::size_t at = 0; at < matrices.size(); at += 16) {  // by columns
      Eigen::Matrix4d to = Eigen::Map<const Eigen::Matrix4f>(&matrices[at]).cast<double>();
      to.topRightCorner<3, 1>() += to.topLeftCorner<3, 3>() * origin;
      to.topLeftCorner<3, 3>() *= step;
      const Eigen::Matrix4f rounded = to.cast<float>();
      std::copy_n(rounded.data(), 16, &placed[at]);
    }
    const std::size_t bytes = placed.size() * sizeof(float);
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", append(placed.data(), bytes)}, {"byteLength", bytes}});
    now_in(index, views_.size() - 1, 0, TINYGLTF_COMPONENT_TYPE_FLOAT, false);
  }

  void compress_normals(int index) {
    const std::vector<float> normals = reordered(values<float>(index), 3);
    std::vector<float> rows(4 * used_, 0);
    for (std::size_t v = 0; v < used_; ++v) std::copy_n(&normals[3 * v], 3, &rows[4 * v]);
    Stream stream = stream_of(std::vector<std::int8_t>(4 * used_), 4);
    meshopt_encodeFilterOct(stream.bytes.data(), used_, stream.stride, kNormalBits, rows.data());
    stream.filter = "OCTAHEDRAL";
    now_in(index, add_elements(stream, kVertexTarget), 0, TINYGLTF_COMPONENT_TYPE_BYTE, true);
  }

  void compress_texcoords(int index) {
    std::vector<std::uint16_t> steps;
    for (const float t : reordered(values<float>(index), 2))
      steps.push_back(std::uint16_t(std::lround(std::clamp(t, 0.0f, 1.0f) * 65535)));
    now_in(index, add_elements(stream_of(steps, 4), kVertexTarget), 0,
           TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, true);
  }

  void compress_joints(int index) {
    const int component = accessor(index)["componentType"].get<int>();
    const Stream stream = component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE
                              ? stream_of(reordered(values<std::uint8_t>(index), 4), 4)
                              : stream_of(reordered(values<std::uint16_t>(index), 4), 8);
    now_in(index, add_elements(stream, kVertexTarget), 0, component, false);
  }

  void compress_weights(int index) {
    const std::vector<float> weights = reordered(values<float>(index), 4);
    std::vector<std::uint8_t> steps(weights.size());
    for (std::size_t at = 0; at < weights.size(); at += 4) {
      int left = 255;
      for (std::size_t k = at; k < at + 4; ++k)
        left -= steps[k] = std::uint8_t(std::floor(weights[k] * 255));
      // What rounding down left over is a few steps: the largest hardly notices.
      const auto largest = std::max_element(steps.begin() + std::ptrdiff_t(at),
                                            steps.begin() + std::ptrdiff_t(at + 4));
      *largest = std::uint8_t(*largest + left);
    }
    now_in(index, add_elements(stream_of(steps, 4), kVertexTarget), 0,
           TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, true);
  }

  // Of all clips together: times, rotations and ways, each in one view. Small views pack badly.
  void compress_clips() {
    if (!json_.contains("animations")) return;
    std::vector<int> times, rotations, ways;
    std::set<int> met;
    for (const Json& animation : json_["animations"])
      for (const Json& channel : animation["channels"]) {
        const Json& sampler = animation["samplers"][channel["sampler"].get<std::size_t>()];
        const int input = sampler["input"].get<int>(), output = sampler["output"].get<int>();
        if (met.insert(input).second) times.push_back(input);
        const bool turns = channel["target"]["path"] == "rotation";
        if (met.insert(output).second) (turns ? rotations : ways).push_back(output);
      }
    compress_keys(times, 1);
    compress_keys(rotations, 4);
    compress_keys(ways, 3);
  }

  void compress_keys(const std::vector<int>& accessors, std::size_t width) {
    std::vector<float> all;
    for (const int index : accessors) {
      const std::vector<float> some = values<float>(index);
      all.insert(all.end(), some.begin(), some.end());
    }
    if (all.empty()) return;
    const std::size_t count = all.size() / width;
    const bool rotations = width == 4;
    Stream stream = stream_of(all, width * sizeof(float));
    if (rotations) {
      stream = stream_of(std::vector<std::int16_t>(4 * count), 8);
      meshopt_encodeFilterQuat(stream.bytes.data(), count, stream.stride, kRotationBits,
                               all.data());
      stream.filter = "QUATERNION";
    } else if (width == 3) {
      meshopt_encodeFilterExp(stream.bytes.data(), count, stream.stride, kPlaceBits, all.data());
      stream.filter = "EXPONENTIAL";
    }
    const std::size_t view = add_elements(stream, 0);
    std::size_t offset = 0;
    for (const int index : accessors) {
      now_in(index, view, offset,
             rotations ? TINYGLTF_COMPONENT_TYPE_SHORT : TINYGLTF_COMPONENT_TYPE_FLOAT, rotations);
      offset += accessor(index)["count"].get<std::size_t>() * stream.stride;
    }
  }

  std::size_t add_copy(std::size_t view) {
    Json copy = from_.json["bufferViews"][view];
    const std::size_t offset = copy.value("byteOffset", std::size_t(0));
    copy["byteOffset"] =
        append(from_.bin.data() + offset, copy.at("byteLength").get<std::size_t>());
    views_.push_back(std::move(copy));
    return views_.size() - 1;
  }
  void keep_the_rest() {
    for (int i = 0; i < int(json_["accessors"].size()); ++i)
      if (!done_.contains(i))
        accessor(i)["bufferView"] = add_copy(accessor(i)["bufferView"].get<std::size_t>());
    if (!json_.contains("images")) return;
    for (Json& image : json_["images"])
      if (image.contains("bufferView"))
        image["bufferView"] = add_copy(image["bufferView"].get<std::size_t>());
  }

  const GlbParts from_;
  Json json_, views_;
  std::string bin_;
  std::size_t unpacked_ = 0, used_ = 0;
  std::vector<unsigned> order_;  // by old vertex: the new one; none: used_ or more
  std::set<int> done_;           // accessors
};

// ---------------------------------------------------------------- back

std::size_t whole_number(const Json& of, const char* field, std::optional<std::size_t> otherwise) {
  const auto found = of.find(field);
  if (found == of.end() && otherwise) return *otherwise;
  require(found != of.end() && found->is_number_unsigned(), "has a damaged compressed view");
  return found->get<std::size_t>();
}

std::string words_of(const Json& of, const char* field) {
  const auto found = of.find(field);
  return found != of.end() && found->is_string() ? found->get<std::string>() : std::string();
}

void unfilter(const std::string& filter, std::string& data, std::size_t count, std::size_t stride) {
  if (filter.empty() || filter == "NONE") return;
  const auto fits = [&](bool holds) { require(holds, "has a damaged compressed view"); };
  if (filter == "OCTAHEDRAL") {
    fits(stride == 4 || stride == 8);
    meshopt_decodeFilterOct(data.data(), count, stride);
  } else if (filter == "QUATERNION") {
    fits(stride == 8);
    meshopt_decodeFilterQuat(data.data(), count, stride);
  } else if (filter == "EXPONENTIAL") {
    meshopt_decodeFilterExp(data.data(), count, stride);
  } else {
    throw Refused{"is packed in a way that ArtiSketch does not read"};
  }
}

// One view's bytes; `room` is what all views together may still take.
std::string unpacked(const Json& how, const std::string& bin, std::size_t& room) {
  const std::size_t offset = whole_number(how, "byteOffset", 0),
                    length = whole_number(how, "byteLength", {}),
                    stride = whole_number(how, "byteStride", {}),
                    count = whole_number(how, "count", {});
  require(whole_number(how, "buffer", {}) == 0 && offset <= bin.size() &&
              length <= bin.size() - offset && stride > 0 && stride <= 256 && count > 0 &&
              count <= room / stride,
          "has a damaged compressed view");
  room -= count * stride;
  std::string data(count * stride, '\0');
  const auto* from = reinterpret_cast<const unsigned char*>(bin.data()) + offset;
  const std::string mode = words_of(how, "mode");
  int failed = 1;
  if (mode == "ATTRIBUTES" && stride % 4 == 0)
    failed = meshopt_decodeVertexBuffer(data.data(), count, stride, from, length);
  else if (mode == "TRIANGLES" && count % 3 == 0 && (stride == 2 || stride == 4))
    failed = meshopt_decodeIndexBuffer(data.data(), count, stride, from, length);
  else if (mode == "INDICES" && (stride == 2 || stride == 4))
    failed = meshopt_decodeIndexSequence(data.data(), count, stride, from, length);
  require(failed == 0, "has a damaged compressed view");
  if (mode == "ATTRIBUTES") unfilter(words_of(how, "filter"), data, count, stride);
  return data;
}

const Json* packed_in(const Json& view) {
  if (!view.is_object()) return nullptr;
  const auto extensions = view.find("extensions");
  if (extensions == view.end() || !extensions->is_object()) return nullptr;
  const auto found = extensions->find(kPacked);
  return found != extensions->end() && found->is_object() ? &*found : nullptr;
}

}  // namespace

std::string compressed_glb(const std::string& glb) {
  return Compressor(glb_parts(glb)).run();
}

bool is_compressed(const GlbParts& parts) {
  const auto views = parts.json.find("bufferViews");
  if (views == parts.json.end() || !views->is_array()) return false;
  return std::any_of(views->begin(), views->end(),
                     [](const Json& view) { return packed_in(view); });
}

GlbParts decompressed(GlbParts parts) {
  // No codec packs an element into less than a 64th of it: more is no honest file.
  constexpr std::size_t kMostGain = 64;
  std::size_t room = kMostGain * parts.bin.size();
  std::string bin;
  for (Json& view : parts.json["bufferViews"]) {
    require(view.is_object(), "has a damaged buffer view");
    bin.resize((bin.size() + 3) / 4 * 4);
    const std::size_t at = bin.size();
    if (const Json* how = packed_in(view)) {
      bin += unpacked(*how, parts.bin, room);
      view.erase("extensions");
    } else {
      const std::size_t offset = whole_number(view, "byteOffset", 0),
                        length = whole_number(view, "byteLength", {});
      require(whole_number(view, "buffer", 0) == 0 && offset <= parts.bin.size() &&
                  length <= parts.bin.size() - offset && length <= room,
              "has a buffer view outside its data");
      room -= length;
      bin.append(parts.bin, offset, length);
    }
    view["buffer"] = std::size_t(0);
    view["byteOffset"] = at;
    view["byteLength"] = bin.size() - at;
  }
  parts.json["buffers"] = Json::array({{{"byteLength", bin.size()}}});
  for (const char* list : {"extensionsUsed", "extensionsRequired"})
    if (const auto names = parts.json.find(list); names != parts.json.end() && names->is_array())
      names->erase(std::remove(names->begin(), names->end(), kPacked), names->end());
  parts.bin = std::move(bin);
  return parts;
}

}  // namespace artisketch
