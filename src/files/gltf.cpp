#include "files/gltf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <sstream>

#include "base/ensure.h"
#include "files/image_file.h"
#include "files/tinygltf_setup.h"

namespace artisketch {
namespace {

constexpr std::size_t kLargestBuffer = std::size_t(1) << 31;         // GLB counts in 32 bits
constexpr std::array<double, 4> kPlainColour = {0.8, 0.76, 0.7, 1};  // warm light grey, linear
constexpr double kRoughness = 0.9;

// Numbers are as fine as anyone can see and no finer: bits that say nothing don't compress. All
// steps are powers of two, as position_step is.
constexpr double kNormalStep = 0x1p-11;
constexpr double kTexcoordStep = 0x1p-14;  // a sixteenth of a texel of a usual atlas
// Each step is exact in single precision, and so is their sum.
constexpr int kWeightSteps = 1 << 14;

// Grows a glTF model around one buffer.
class Builder {
 public:
  tinygltf::Model gltf;

  Builder() { gltf.buffers.resize(1); }

  std::size_t size() const { return gltf.buffers[0].data.size(); }

  // `target`: what the GPU will use it for; 0: nothing.
  int add_view(const void* data, std::size_t bytes, int target) {
    std::vector<unsigned char>& buffer = gltf.buffers[0].data;
    buffer.resize((buffer.size() + 3) / 4 * 4);  // components lie at multiples of their size
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = buffer.size();
    view.byteLength = bytes;
    view.target = target;
    const auto* first = static_cast<const unsigned char*>(data);
    buffer.insert(buffer.end(), first, first + bytes);
    gltf.bufferViews.push_back(std::move(view));
    return int(gltf.bufferViews.size()) - 1;
  }

  // `values`: `count` elements one after the other. Floats with `ranged` carry their bounds.
  template <class T>
  int add_accessor(const std::vector<T>& values, std::size_t count, int type, int component,
                   int target, bool ranged = false) {
    tinygltf::Accessor accessor;
    accessor.bufferView = add_view(values.data(), values.size() * sizeof(T), target);
    accessor.type = type;
    accessor.componentType = component;
    accessor.count = count;
    const std::size_t width = values.size() / count;
    for (std::size_t c = 0; ranged && c < width; ++c) {
      T low = values[c], high = values[c];
      for (std::size_t i = c; i < values.size(); i += width) {
        low = std::min(low, values[i]);
        high = std::max(high, values[i]);
      }
      accessor.minValues.push_back(double(low));
      accessor.maxValues.push_back(double(high));
    }
    gltf.accessors.push_back(std::move(accessor));
    return int(gltf.accessors.size()) - 1;
  }
  int add_floats(const std::vector<float>& values, int type, int target, bool ranged = false) {
    return add_accessor(values, values.size() / tinygltf::GetNumComponentsInType(type), type,
                        TINYGLTF_COMPONENT_TYPE_FLOAT, target, ranged);
  }
};

constexpr int kForVertices = TINYGLTF_TARGET_ARRAY_BUFFER;
constexpr int kForIndices = TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER;

float rounded(double x, double step) {
  return float(std::nearbyint(x / step) * step);
}

std::vector<float> rounded(const Points3& rows, double step) {
  std::vector<float> values;
  values.reserve(std::size_t(rows.size()));
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    for (Eigen::Index c = 0; c < rows.cols(); ++c) values.push_back(rounded(rows(i, c), step));
  return values;
}

template <class Numbers>
bool all_finite(const Numbers& numbers) {
  return numbers.template cast<float>().array().isFinite().all();
}

// What keeps the model from being written, or nothing.
std::string trouble(const Model& model) {
  if (model.mesh.F.rows() == 0) return "the model has no surface";
  if (!all_finite(model.mesh.V)) return "a vertex of the model is not finite";
  if (!all_finite(model.weights.weights)) return "a weight of the model is not finite";
  for (const Vec2& uv : model.texcoords)
    if (!all_finite(uv)) return "a texture coordinate of the model is not finite";
  for (const Joint& joint : model.skeleton.joints)
    if (!all_finite(joint.offset)) return "the offset of '" + joint.name + "' is not finite";
  for (const Clip& clip : model.clips) {
    if (clip.times.empty()) return "the clip '" + clip.name + "' has no keys";
    for (std::size_t k = 0; k < clip.times.size(); ++k) {
      if (!std::isfinite(float(clip.times[k])) || clip.times[k] < 0 ||
          (k > 0 && !(float(clip.times[k]) > float(clip.times[k - 1]))))
        return "the times of the clip '" + clip.name + "' do not increase from 0 on";
      bool finite = all_finite(clip.poses[k].root_position);
      for (const Quat& q : clip.poses[k].rotations)
        finite = finite && all_finite(q.coeffs()) && q.norm() > 0;
      if (!finite) return "a pose of the clip '" + clip.name + "' is not finite";
    }
  }
  return "";
}

// One vertex' influences as glTF wants them: joints named once, whole steps that add up, unused
// ones joint 0.
struct Influences {
  std::array<int, 4> joints = {}, steps = {};
};
Influences influences(const Weights& weights, int v) {
  Influences out;
  std::array<double, 4> share = {};
  int used = 0;
  for (int k = 0; k < 4; ++k) {
    const double w = weights.weights(v, k);
    if (!(w > 0)) continue;
    int i = 0;
    while (i < used && out.joints[i] != weights.joints(v, k)) ++i;
    out.joints[i] = weights.joints(v, k);
    share[i] += w;
    used = std::max(used, i + 1);
  }
  if (used == 0) {
    share[0] = 1;
    used = 1;
  }
  const double sum = std::accumulate(share.begin(), share.end(), 0.0);
  int left = kWeightSteps;
  for (int k = 0; k < used; ++k) left -= out.steps[k] = int(share[k] / sum * kWeightSteps);
  // What rounding down left over is a few steps: the largest hardly notices.
  *std::max_element(out.steps.begin(), out.steps.end()) += left;
  for (int k = 0; k < 4; ++k)
    if (out.steps[k] == 0) out.joints[k] = 0;
  return out;
}

template <class Index>
std::vector<Index> joint_indices(const std::vector<Influences>& all) {
  std::vector<Index> values;
  for (const Influences& one : all)
    for (const int joint : one.joints) values.push_back(Index(joint));
  return values;
}

template <class Index>
std::vector<Index> face_indices(const Triangles& F) {
  return {F.data(), F.data() + F.size()};
}

// Whether a texture is pixel art: of so few colours that none can be a mixture of others. Viewers
// are to show its texels as squares.
bool has_few_colours(const Image& texture) {
  constexpr std::size_t kMost = 256;
  std::set<std::uint32_t> colours;
  std::uint32_t last = 0;
  for (std::size_t i = 0; i < texture.rgba.size(); i += 4) {
    const std::uint32_t c = std::uint32_t(texture.rgba[i]) << 16 |
                            std::uint32_t(texture.rgba[i + 1]) << 8 | texture.rgba[i + 2];
    if (i > 0 && c == last) continue;
    last = c;
    colours.insert(c);
    if (colours.size() > kMost) return false;
  }
  return true;
}

void add_material(const Model& model, Builder& out) {
  tinygltf::Material material;
  material.name = "skin";
  tinygltf::PbrMetallicRoughness& pbr = material.pbrMetallicRoughness;
  pbr.metallicFactor = 0;
  pbr.roughnessFactor = kRoughness;
  if (!model.texture) {
    pbr.baseColorFactor.assign(kPlainColour.begin(), kPlainColour.end());
  } else {
    const std::string png = png_bytes(*model.texture);
    tinygltf::Image image;
    image.mimeType = "image/png";
    image.bufferView = out.add_view(png.data(), png.size(), 0);
    out.gltf.images.push_back(std::move(image));
    tinygltf::Sampler sampler;
    const bool squares = has_few_colours(*model.texture);
    sampler.magFilter = squares ? TINYGLTF_TEXTURE_FILTER_NEAREST : TINYGLTF_TEXTURE_FILTER_LINEAR;
    sampler.minFilter = squares ? TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR
                                : TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
    sampler.wrapS = sampler.wrapT = TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
    out.gltf.samplers.push_back(sampler);
    tinygltf::Texture texture;
    texture.sampler = texture.source = 0;
    out.gltf.textures.push_back(std::move(texture));
    pbr.baseColorTexture.index = 0;
  }
  out.gltf.materials.push_back(std::move(material));
}

// What each vertex owes to which joints.
void add_influences(const Model& model, std::map<std::string, int>& attributes, Builder& out) {
  const std::size_t vertices = std::size_t(model.mesh.V.rows());
  std::vector<Influences> all;
  std::vector<float> weights;
  for (int v = 0; v < int(vertices); ++v) {
    all.push_back(influences(model.weights, v));
    for (const int steps : all.back().steps) weights.push_back(float(steps) / kWeightSteps);
  }
  attributes["JOINTS_0"] =
      model.skeleton.size() <= 256
          ? out.add_accessor(joint_indices<std::uint8_t>(all), vertices, TINYGLTF_TYPE_VEC4,
                             TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE, kForVertices)
          : out.add_accessor(joint_indices<std::uint16_t>(all), vertices, TINYGLTF_TYPE_VEC4,
                             TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, kForVertices);
  attributes["WEIGHTS_0"] = out.add_floats(weights, TINYGLTF_TYPE_VEC4, kForVertices);
}

void add_mesh(const Model& model, Builder& out) {
  const Mesh& mesh = model.mesh;
  const std::size_t vertices = std::size_t(mesh.V.rows());
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.material = 0;
  auto& attributes = primitive.attributes;
  attributes["POSITION"] = out.add_floats(rounded(mesh.V, position_step(mesh.V)),
                                          TINYGLTF_TYPE_VEC3, kForVertices, true);
  attributes["NORMAL"] = out.add_floats(rounded(seamless_normals(mesh), kNormalStep),
                                        TINYGLTF_TYPE_VEC3, kForVertices);
  if (model.texture) {
    std::vector<float> uv;
    for (const Vec2& t : model.texcoords)
      uv.insert(uv.end(), {rounded(t.x(), kTexcoordStep), rounded(t.y(), kTexcoordStep)});
    attributes["TEXCOORD_0"] = out.add_floats(uv, TINYGLTF_TYPE_VEC2, kForVertices);
  }

  if (model.skeleton.size() > 0) add_influences(model, attributes, out);

  // The largest index of a kind is not to be used: it restarts primitives.
  const std::size_t corners = std::size_t(mesh.F.size());
  primitive.indices =
      vertices <= 65535
          ? out.add_accessor(face_indices<std::uint16_t>(mesh.F), corners, TINYGLTF_TYPE_SCALAR,
                             TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, kForIndices)
          : out.add_accessor(face_indices<std::uint32_t>(mesh.F), corners, TINYGLTF_TYPE_SCALAR,
                             TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, kForIndices);
  tinygltf::Mesh skinned;
  skinned.name = model.name;
  skinned.primitives.push_back(std::move(primitive));
  out.gltf.meshes.push_back(std::move(skinned));
}

void add_skeleton(const Skeleton& skeleton, Builder& out) {
  tinygltf::Skin skin;
  skin.skeleton = 0;
  std::vector<float> inverse_bind;
  const std::vector<Vec3> rest = rest_positions(skeleton);
  for (int j = 0; j < skeleton.size(); ++j) {
    const Joint& joint = skeleton.joints[j];
    tinygltf::Node node;
    node.name = joint.name;
    node.translation = {joint.offset.x(), joint.offset.y(), joint.offset.z()};
    node.children = skeleton.children(j);
    out.gltf.nodes.push_back(std::move(node));
    skin.joints.push_back(j);
    Eigen::Matrix4f inverse = Eigen::Matrix4f::Identity();
    inverse.topRightCorner<3, 1>() = -rest[j].cast<float>();
    inverse_bind.insert(inverse_bind.end(), inverse.data(), inverse.data() + 16);  // by columns
  }
  skin.inverseBindMatrices = out.add_floats(inverse_bind, TINYGLTF_TYPE_MAT4, 0);
  out.gltf.skins.push_back(std::move(skin));
}

// Its own node beside the joints: a skinned mesh must not move with its skeleton twice.
void add_scene(const Model& model, Builder& out) {
  tinygltf::Node node;
  node.name = model.name.empty() ? "model" : model.name;
  while (model.skeleton.find(node.name) >= 0) node.name += " mesh";
  node.mesh = 0;
  if (model.skeleton.size() > 0) node.skin = 0;
  out.gltf.nodes.push_back(std::move(node));
  tinygltf::Scene scene;
  scene.name = model.name;
  scene.nodes = {0};
  if (model.skeleton.size() > 0) scene.nodes.push_back(model.skeleton.size());
  out.gltf.scenes.push_back(std::move(scene));
  out.gltf.defaultScene = 0;
}

void add_clip(const Clip& clip, int joints, Builder& out) {
  ensure(clip.poses.size() == clip.times.size(), "a time for every pose");
  tinygltf::Animation animation;
  animation.name = clip.name;
  const int times =
      out.add_floats({clip.times.begin(), clip.times.end()}, TINYGLTF_TYPE_SCALAR, 0, true);
  const auto add_channel = [&](int joint, const char* path, int type,
                               const std::vector<float>& values) {
    tinygltf::AnimationSampler sampler;
    sampler.input = times;
    sampler.output = out.add_floats(values, type, 0);
    sampler.interpolation = "LINEAR";
    tinygltf::AnimationChannel channel;
    channel.sampler = int(animation.samplers.size());
    channel.target_node = joint;
    channel.target_path = path;
    animation.samplers.push_back(std::move(sampler));
    animation.channels.push_back(std::move(channel));
  };
  std::vector<float> values;
  for (const Pose& pose : clip.poses)
    for (int c = 0; c < 3; ++c) values.push_back(float(pose.root_position[c]));
  add_channel(0, "translation", TINYGLTF_TYPE_VEC3, values);
  for (int j = 0; j < joints; ++j) {
    values.clear();
    Quat before = clip.poses[0].rotations[j].normalized();
    for (const Pose& pose : clip.poses) {
      Quat q = pose.rotations[j].normalized();
      if (q.dot(before) < 0) q.coeffs() *= -1;
      for (int c = 0; c < 4; ++c) values.push_back(float(q.coeffs()[c]));
      before = q;
    }
    add_channel(j, "rotation", TINYGLTF_TYPE_VEC4, values);
  }
  out.gltf.animations.push_back(std::move(animation));
}

}  // namespace

Result<std::string> glb_bytes(const Model& model) {
  const bool still = model.skeleton.size() == 0;
  ensure(model.skeleton.size() <= 65536, "joints that 16 bits can count");
  ensure(still ? model.clips.empty() : model.weights.joints.rows() == model.mesh.V.rows(),
         "weights for every vertex, or nothing that moves");
  ensure(!model.texture || Eigen::Index(model.texcoords.size()) == model.mesh.V.rows(),
         "a texture coordinate for every vertex");
  if (const std::string why = trouble(model); !why.empty())
    return bad_input(why + ": nothing can be written");
  Builder out;
  out.gltf.asset.version = "2.0";
  out.gltf.asset.generator = "ArtiSketch " ARTISKETCH_VERSION;
  add_material(model, out);
  add_mesh(model, out);
  if (!still) add_skeleton(model.skeleton, out);
  add_scene(model, out);
  for (const Clip& clip : model.clips) add_clip(clip, model.skeleton.size(), out);
  if (out.size() > kLargestBuffer) return bad_input("the model would take more than 2 GB");

  std::ostringstream stream;
  try {
    if (tinygltf::TinyGLTF writer; !writer.WriteGltfSceneToStream(&out.gltf, stream, false, true))
      return bad_input("the model cannot be written as glTF");
  } catch (const std::exception& error) {  // a name that is no UTF-8
    return bad_input(std::string("the model cannot be written as glTF: ") + error.what());
  }
  return stream.str();
}

}  // namespace artisketch
