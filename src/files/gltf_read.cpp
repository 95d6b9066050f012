#include <algorithm>
#include <cstring>
#include <optional>

#include "files/gltf.h"
#include "files/image_file.h"
#include "files/json.h"
#include "files/tinygltf_setup.h"

namespace artisketch {
namespace {

// Keys times joints of one clip: a small file can name the same keys for many joints.
constexpr std::size_t kMostRotations = 10'000'000;

// Why a file is refused. Thrown and caught in this file alone: the checks are many and deep.
struct Refused {
  std::string why;
};

void require(bool holds, const std::string& otherwise) {
  if (!holds) throw Refused{otherwise};
}

std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

// tinygltf trusts its input in places: it recurses into nested values, and takes the address of an
// image's bytes before looking whether they are there. What would trip it is refused here.
void check_container(std::string_view bytes) {
  require(bytes.size() >= 20 && bytes.substr(0, 4) == "glTF", "is no binary glTF");
  require(little_endian(bytes, 4) == 2, "is not glTF version 2");
  require(little_endian(bytes, 8) == bytes.size(), "is cut off, or longer than it says");
  const std::size_t json_size = little_endian(bytes, 12);
  require(json_size <= bytes.size() - 20 && bytes.substr(16, 4) == "JSON", "has no JSON chunk");
  std::size_t bin_size = 0;
  if (const std::size_t at = 20 + json_size; bytes.size() >= at + 8)
    bin_size = std::min<std::size_t>(little_endian(bytes, at), bytes.size() - at - 8);

  Faults faults("its JSON");
  const std::optional<Json> json = parse_json(bytes.substr(20, json_size), faults);
  if (!faults.none()) throw Refused{"is damaged: " + faults.error().faults.front()};
  require(json->is_object(), "has a JSON chunk that is no object");
  if (const auto buffers = json->find("buffers"); buffers != json->end())
    require(buffers->is_array() && buffers->size() == 1 && (*buffers)[0].is_object() &&
                !(*buffers)[0].contains("uri"),
            "does not hold all its data");
  if (const auto views = json->find("bufferViews"); views != json->end())
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
  check_container(bytes);
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

template <class List>
const auto& at(const List& list, int index, const char* what) {
  require(index >= 0 && std::size_t(index) < list.size(),
          std::string("names a ") + what + " that is not there");
  return list[std::size_t(index)];
}

class Reader {
 public:
  explicit Reader(std::string_view bytes) : gltf_(parse(bytes)) {}
  Model read(const std::string& name);

 private:
  std::string_view view_bytes(int view) const;
  // The accessor's elements, one row each, whatever the component type; floats are finite.
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows(int accessor,
                                                                              int type) const;
  void skeleton(const tinygltf::Skin& skin);
  void mesh(const tinygltf::Primitive& primitive);
  void texture(int material, const std::string& name);
  void clip(const tinygltf::Animation& animation);

  const tinygltf::Model gltf_;
  std::vector<int> joint_of_;  // by node; −1: none
  Model model_;
};

std::string_view Reader::view_bytes(int index) const {
  const tinygltf::BufferView& view = at(gltf_.bufferViews, index, "buffer view");
  const std::vector<unsigned char>& data = at(gltf_.buffers, view.buffer, "buffer").data;
  require(view.byteOffset <= data.size() && view.byteLength <= data.size() - view.byteOffset,
          "has a buffer view outside its data");
  return {reinterpret_cast<const char*>(data.data()) + view.byteOffset, view.byteLength};
}

Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> Reader::rows(
    int index, int type) const {
  const tinygltf::Accessor& accessor = at(gltf_.accessors, index, "accessor");
  const int component = accessor.componentType;
  const bool known = component == TINYGLTF_COMPONENT_TYPE_FLOAT ||
                     component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                     component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
                     component == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
  require(accessor.type == type && known && !accessor.sparse.isSparse && !accessor.normalized &&
              accessor.count > 0,
          "has an accessor of a kind that ArtiSketch does not write");
  const std::string_view bytes = view_bytes(accessor.bufferView);
  const std::size_t part = std::size_t(tinygltf::GetComponentSizeInBytes(unsigned(component)));
  const std::size_t width = std::size_t(tinygltf::GetNumComponentsInType(unsigned(type)));
  const std::size_t given = gltf_.bufferViews[std::size_t(accessor.bufferView)].byteStride;
  const std::size_t stride = given ? given : part * width;
  require(stride >= part * width && accessor.byteOffset <= bytes.size() &&
              bytes.size() - accessor.byteOffset >= part * width &&
              (bytes.size() - accessor.byteOffset - part * width) / stride >= accessor.count - 1,
          "has an accessor outside its data");
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> values(
      Eigen::Index(accessor.count), Eigen::Index(width));
  for (std::size_t i = 0; i < accessor.count; ++i)
    for (std::size_t c = 0; c < width; ++c) {
      const char* from = bytes.data() + accessor.byteOffset + i * stride + c * part;
      float real = 0;
      std::uint32_t whole = 0;
      if (component == TINYGLTF_COMPONENT_TYPE_FLOAT)
        std::memcpy(&real, from, part);
      else
        std::memcpy(&whole, from, part);  // glTF and we are little-endian
      require(std::isfinite(real), "has a number that is not finite");
      values(Eigen::Index(i), Eigen::Index(c)) = double(real) + double(whole);
    }
  return values;
}

void Reader::skeleton(const tinygltf::Skin& skin) {
  std::vector<Joint>& joints = model_.skeleton.joints;
  require(!skin.joints.empty(), "has a skin without joints");
  joints.resize(skin.joints.size());
  joint_of_.assign(gltf_.nodes.size(), -1);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    const tinygltf::Node& node = at(gltf_.nodes, skin.joints[j], "joint");
    require(joint_of_[std::size_t(skin.joints[j])] < 0, "names a joint twice");
    require(node.rotation.empty() && node.scale.empty() && node.matrix.empty(),
            "has joints that are turned or scaled at rest");
    joint_of_[std::size_t(skin.joints[j])] = int(j);
    joints[j].name = node.name;
    if (node.translation.size() == 3)
      joints[j].offset = {node.translation[0], node.translation[1], node.translation[2]};
    require(joints[j].offset.array().isFinite().all(), "has a number that is not finite");
  }
  for (std::size_t n = 0; n < gltf_.nodes.size(); ++n)
    for (const int child : gltf_.nodes[n].children) {
      at(gltf_.nodes, child, "child");
      const int parent_joint = joint_of_[n], joint = joint_of_[std::size_t(child)];
      if (joint < 0) continue;
      // So every joint has one parent at most, and no loop can be.
      require(parent_joint >= 0 && parent_joint < joint && joints[std::size_t(joint)].parent < 0,
              "has joints in another order than ArtiSketch writes them");
      joints[std::size_t(joint)].parent = parent_joint;
    }
  for (std::size_t j = 0; j < joints.size(); ++j)
    require((joints[j].parent < 0) == (j == 0), "has joints without a common root");
}

void Reader::mesh(const tinygltf::Primitive& primitive) {
  require(primitive.mode == TINYGLTF_MODE_TRIANGLES, "is not made of triangles");
  const auto attribute = [&](const char* name, int type) {
    const auto found = primitive.attributes.find(name);
    require(found != primitive.attributes.end(), std::string("has a mesh without ") + name);
    return rows(found->second, type);
  };
  model_.mesh.V = attribute("POSITION", TINYGLTF_TYPE_VEC3);
  const Eigen::Index vertices = model_.mesh.V.rows();
  const auto indices = rows(primitive.indices, TINYGLTF_TYPE_SCALAR);
  require(indices.rows() % 3 == 0 && indices.minCoeff() >= 0 && indices.maxCoeff() < vertices,
          "has triangles of vertices that are not there");
  model_.mesh.F = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>>(
                      indices.data(), indices.rows() / 3, 3)
                      .cast<int>();
  const auto joints = attribute("JOINTS_0", TINYGLTF_TYPE_VEC4);
  const auto weights = attribute("WEIGHTS_0", TINYGLTF_TYPE_VEC4);
  require(joints.rows() == vertices && weights.rows() == vertices,
          "has a mesh whose vertices are not all weighted");
  require(joints.minCoeff() >= 0 && joints.maxCoeff() < model_.skeleton.size(),
          "has weights for joints that are not there");
  require(weights.minCoeff() >= 0 && (weights.rowwise().sum().array() - 1).abs().maxCoeff() < 1e-3,
          "has weights that do not sum to 1");
  model_.weights.joints = joints.cast<int>();
  model_.weights.weights = weights;
  if (primitive.attributes.count("TEXCOORD_0")) {
    const auto uv = attribute("TEXCOORD_0", TINYGLTF_TYPE_VEC2);
    require(uv.rows() == vertices, "has a mesh whose vertices are not all on its texture");
    for (Eigen::Index v = 0; v < vertices; ++v) model_.texcoords.emplace_back(uv(v, 0), uv(v, 1));
  }
}

void Reader::texture(int index, const std::string& name) {
  if (index < 0 || model_.texcoords.empty()) return;
  const tinygltf::Material& material = at(gltf_.materials, index, "material");
  const int base = material.pbrMetallicRoughness.baseColorTexture.index;
  if (base < 0) return;
  const int source = at(gltf_.textures, base, "texture").source;
  const tinygltf::Image& image = at(gltf_.images, source, "image");
  Result<Image> picture = decode_image(view_bytes(image.bufferView), name + ": its texture");
  if (!picture) throw Refused{"has a damaged texture: " + picture.error().text()};
  model_.texture = std::move(*picture);
}

void Reader::clip(const tinygltf::Animation& animation) {
  Clip& clip = model_.clips.emplace_back();
  clip.name = animation.name;
  require(!animation.channels.empty(), "has an animation without channels");
  const int input = at(animation.samplers, animation.channels[0].sampler, "sampler").input;
  const auto times = rows(input, TINYGLTF_TYPE_SCALAR);
  const std::size_t joints = model_.skeleton.joints.size();
  require(std::size_t(times.rows()) <= kMostRotations / joints,
          "has an animation with too many keys");
  clip.times.assign(times.data(), times.data() + times.rows());
  for (std::size_t k = 1; k < clip.times.size(); ++k)
    require(clip.times[k] > clip.times[k - 1], "has an animation whose times do not increase");
  clip.poses.assign(clip.times.size(), rest_pose(model_.skeleton));
  for (const tinygltf::AnimationChannel& channel : animation.channels) {
    const tinygltf::AnimationSampler& sampler = at(animation.samplers, channel.sampler, "sampler");
    at(gltf_.nodes, channel.target_node, "node");
    const int joint = joint_of_[std::size_t(channel.target_node)];
    const bool rotation = channel.target_path == "rotation";
    require(joint >= 0 && sampler.input == input && sampler.interpolation == "LINEAR" &&
                (rotation || (joint == 0 && channel.target_path == "translation")),
            "has an animation of a kind that ArtiSketch does not write");
    const auto values = rows(sampler.output, rotation ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3);
    require(values.rows() == times.rows(), "has an animation whose keys do not match its times");
    for (Eigen::Index k = 0; k < values.rows(); ++k) {
      Pose& pose = clip.poses[std::size_t(k)];
      if (!rotation) {
        pose.root_position = values.row(k).transpose();
        continue;
      }
      const Eigen::Vector4d q = values.row(k).transpose();
      require(std::abs(q.norm() - 1) < 1e-3, "has a rotation that is no unit quaternion");
      pose.rotations[std::size_t(joint)] = Quat(q.normalized().eval());
    }
  }
}

Model Reader::read(const std::string& name) {
  const auto skinned = std::find_if(gltf_.nodes.begin(), gltf_.nodes.end(),
                                    [](const auto& n) { return n.mesh >= 0 && n.skin >= 0; });
  require(skinned != gltf_.nodes.end(), "holds no skinned mesh");
  const tinygltf::Mesh& mesh_of_it = at(gltf_.meshes, skinned->mesh, "mesh");
  require(mesh_of_it.primitives.size() == 1, "has a mesh of several pieces");
  const tinygltf::Primitive& primitive = mesh_of_it.primitives[0];
  model_.name = mesh_of_it.name;
  skeleton(at(gltf_.skins, skinned->skin, "skin"));
  mesh(primitive);
  texture(primitive.material, name);
  for (const tinygltf::Animation& animation : gltf_.animations) clip(animation);
  return std::move(model_);
}

}  // namespace

Result<Model> read_glb(std::string_view bytes, const std::string& name) {
  const auto refuse = [&](const std::string& why) {
    return bad_input(name + ": " + why + "; give a .glb that ArtiSketch wrote");
  };
  if (bytes.size() > std::size_t(INT32_MAX)) return refuse("is larger than 2 GB");
  try {
    return Reader(bytes).read(name);
  } catch (const Refused& refused) {
    return refuse(refused.why);
  } catch (const std::exception& error) {  // tinygltf and its JSON
    return refuse(std::string("is damaged: ") + error.what());
  }
}

}  // namespace artisketch
