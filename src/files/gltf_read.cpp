#include <algorithm>

#include "files/gltf.h"
#include "files/gltf_data.h"
#include "files/image_file.h"

namespace artisketch {
namespace {

// Keys times joints of one clip: a small file can name the same keys for many joints.
constexpr std::size_t kMostRotations = 10'000'000;

class Reader {
 public:
  explicit Reader(std::string_view bytes) : data_(bytes), gltf_(data_.gltf()) {}
  Model read(const std::string& name);

 private:
  void skeleton(const tinygltf::Skin& skin);
  void mesh(const tinygltf::Primitive& primitive, const tinygltf::Skin& skin);
  void unquantize(int positions, int inverse_bind);
  void texture(int material, const std::string& name);
  void clip(const tinygltf::Animation& animation);

  const GltfData data_;
  const tinygltf::Model& gltf_;
  std::vector<int> joint_of_;  // by node; −1: none
  Model model_;
};

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

// Positions in whole steps (gltf_compress.h) are where the skin puts them at rest.
void Reader::unquantize(int positions, int inverse_bind) {
  if (gltf_.accessors[std::size_t(positions)].componentType == TINYGLTF_COMPONENT_TYPE_FLOAT)
    return;
  require(inverse_bind >= 0, "has positions in steps of unknown size");
  const GltfRows matrices = data_.rows(inverse_bind, TINYGLTF_TYPE_MAT4);  // by columns
  const Eigen::Map<const Eigen::Matrix4d> root(matrices.data());
  Points3& V = model_.mesh.V;
  V = (V * root.topLeftCorner<3, 3>().transpose()).rowwise() +
      (root.topRightCorner<3, 1>() + model_.skeleton.joints[0].offset).transpose();
}

void Reader::mesh(const tinygltf::Primitive& primitive, const tinygltf::Skin& skin) {
  require(primitive.mode == TINYGLTF_MODE_TRIANGLES, "is not made of triangles");
  const auto attribute = [&](const char* name, int type) {
    const auto found = primitive.attributes.find(name);
    require(found != primitive.attributes.end(), std::string("has a mesh without ") + name);
    return data_.rows(found->second, type);
  };
  model_.mesh.V = attribute("POSITION", TINYGLTF_TYPE_VEC3);
  unquantize(primitive.attributes.at("POSITION"), skin.inverseBindMatrices);
  const Eigen::Index vertices = model_.mesh.V.rows();
  const auto indices = data_.rows(primitive.indices, TINYGLTF_TYPE_SCALAR);
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
  Result<Image> picture = decode_image(data_.view_bytes(image.bufferView), name + ": its texture");
  if (!picture) throw Refused{"has a damaged texture: " + picture.error().text()};
  model_.texture = std::move(*picture);
}

void Reader::clip(const tinygltf::Animation& animation) {
  Clip& clip = model_.clips.emplace_back();
  clip.name = animation.name;
  require(!animation.channels.empty(), "has an animation without channels");
  const int input = at(animation.samplers, animation.channels[0].sampler, "sampler").input;
  const auto times = data_.rows(input, TINYGLTF_TYPE_SCALAR);
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
    const auto values =
        data_.rows(sampler.output, rotation ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3);
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
  const tinygltf::Skin& skin = at(gltf_.skins, skinned->skin, "skin");
  skeleton(skin);
  mesh(primitive, skin);
  texture(primitive.material, name);
  for (const tinygltf::Animation& animation : gltf_.animations) clip(animation);
  return std::move(model_);
}

}  // namespace

Result<Model> read_glb(std::string_view bytes, const std::string& name) {
  return read_gltf(bytes, name, "; give a .glb that ArtiSketch wrote",
                   [&] { return Reader(bytes).read(name); });
}

}  // namespace artisketch
