#include <algorithm>
#include <cmath>
#include <optional>

#include "files/gltf_data.h"
#include "files/motion_file.h"

namespace artisketch {
namespace {

constexpr int kMostJoints = 1000;
constexpr std::size_t kMostNumbers = 10'000'000;
constexpr std::size_t kMostNodes = 100'000;
constexpr double kFinest = 1.0 / 120, kCoarsest = 1.0 / 24;  // seconds from pose to pose

using NodePlace = Eigen::Affine3d;

struct Trs {
  Vec3 translation = Vec3::Zero();
  Quat rotation = Quat::Identity();
  Vec3 scale = Vec3::Ones();
  NodePlace frame() const {
    NodePlace all = NodePlace::Identity();
    all.translation() = translation;
    all.linear() = rotation.toRotationMatrix() * scale.asDiagonal();
    return all;
  }
};

// How a frame is turned, whatever it stretches; not at all where it is flat.
Quat turn_of(const NodePlace& frame) {
  constexpr double kFlat = 1e-12;
  Vec3 x = frame.linear().col(0), y = frame.linear().col(1);
  if (x.norm() < kFlat) return Quat::Identity();
  x.normalize();
  y -= x.dot(y) * x;
  if (y.norm() < kFlat) return Quat::Identity();
  y.normalize();
  Mat3 turn;
  turn << x, y, x.cross(y);
  return Quat(turn).normalized();
}

// One channel's keys.
struct Track {
  enum class What { translation, rotation, scale };
  int node = 0;
  What what = What::translation;
  std::string way;  // LINEAR, STEP or CUBICSPLINE
  std::vector<double> times;
  GltfRows values;

  Eigen::Index row(std::size_t key) const {
    return Eigen::Index(way == "CUBICSPLINE" ? 3 * key + 1 : key);
  }
  Eigen::VectorXd at(double time) const {
    // A key's time is as exact as single precision, and a step must not come a pose late.
    if (way == "STEP") time += kFinest / 100;
    const auto after = std::upper_bound(times.begin(), times.end(), time);
    if (after == times.begin()) return values.row(row(0));
    const auto b = std::size_t(after - times.begin()), a = b - 1;
    if (b == times.size() || way == "STEP") return values.row(row(a));
    const double gap = times[b] - times[a], t = (time - times[a]) / gap;
    if (way == "CUBICSPLINE") {
      const double t2 = t * t, t3 = t2 * t;
      return (2 * t3 - 3 * t2 + 1) * values.row(row(a)) +
             gap * (t3 - 2 * t2 + t) * values.row(row(a) + 1) +
             (3 * t2 - 2 * t3) * values.row(row(b)) + gap * (t3 - t2) * values.row(row(b) - 1);
    }
    if (what == What::rotation) {
      const Eigen::Vector4d from = values.row(row(a)), to = values.row(row(b));
      return Quat(from).slerp(t, Quat(to)).coeffs();
    }
    return values.row(row(a)) + t * (values.row(row(b)) - values.row(row(a)));
  }
  void put(double time, Trs& trs) const {
    const Eigen::VectorXd value = at(time);
    if (what == What::translation) trs.translation = value;
    if (what == What::scale) trs.scale = value;
    if (what == What::rotation && value.norm() > 0)
      trs.rotation = Quat(Eigen::Vector4d(value.normalized()));
  }
};

class MotionReader {
 public:
  explicit MotionReader(std::string_view bytes) : data_(bytes), gltf_(data_.gltf()) {}

  std::vector<Motion> read(const std::string& name) {
    require(!gltf_.animations.empty(), "holds no animation");
    std::vector<std::vector<Track>> all = find_all();
    std::vector<Motion> motions;
    for (std::size_t i = 0; i < all.size(); ++i) {
      std::erase_if(all[i], [&](const Track& track) { return !matters_[track.node]; });
      if (all[i].empty()) continue;
      motions.push_back(motion(all[i]));
      const std::string& own = gltf_.animations[i].name;
      motions.back().name = !own.empty()      ? own
                            : all.size() == 1 ? name
                                              : name + " " + std::to_string(i + 1);
    }
    require(!motions.empty(), "holds no animation that moves joints");
    return motions;
  }

  Motion skeleton(const std::string& name) {
    find_all();
    Motion motion;
    motion.name = name;
    motion.skeleton = skeleton_;
    motion.step = kCoarsest;
    motion.poses = {rest_pose(skeleton_)};
    return motion;
  }

 private:
  // The joints, and what moves them: the tracks of each animation.
  std::vector<std::vector<Track>> find_all() {
    find_tree();
    find_rest();
    std::vector<std::vector<Track>> all;
    for (const tinygltf::Animation& animation : gltf_.animations) all.push_back(tracks(animation));
    find_joints(all);
    return all;
  }

  // A small file can name the same numbers again and again.
  void count(std::size_t numbers) {
    require(numbers <= kMostNumbers - counted_, "has more keys than anyone needs");
    counted_ += numbers;
  }

  // Each node's parent, and an order in which each is followed by what hangs from it.
  void find_tree() {
    const std::size_t nodes = gltf_.nodes.size();
    require(nodes <= kMostNodes, "has too many nodes");
    parent_.assign(nodes, -1);
    for (std::size_t n = 0; n < nodes; ++n)
      for (const int child : gltf_.nodes[n].children) {
        at(gltf_.nodes, child, "child");
        require(parent_[std::size_t(child)] < 0, "has a node below two others");
        parent_[std::size_t(child)] = int(n);
      }
    std::vector<int> open;
    for (std::size_t n = nodes; n-- > 0;)
      if (parent_[n] < 0) open.push_back(int(n));
    while (!open.empty()) {
      const int n = open.back();
      open.pop_back();
      order_.push_back(n);
      const std::vector<int>& children = gltf_.nodes[std::size_t(n)].children;
      open.insert(open.end(), children.rbegin(), children.rend());
    }
    require(order_.size() == nodes, "has nodes that hang in a ring");
  }

  static bool finite(const std::vector<double>& numbers) {
    return std::all_of(numbers.begin(), numbers.end(),
                       [](double x) { return std::isfinite(x) && std::abs(x) < 1e12; });
  }

  // Where every node is at rest, and where the skins have it, which counts.
  void find_rest() {
    for (const tinygltf::Node& node : gltf_.nodes) {
      require(finite(node.translation) && finite(node.rotation) && finite(node.scale) &&
                  finite(node.matrix),
              "has a number that is not finite");
      Trs trs;
      if (node.translation.size() == 3) trs.translation = Vec3(node.translation.data());
      if (node.scale.size() == 3) trs.scale = Vec3(node.scale.data());
      if (node.rotation.size() == 4) {
        const Eigen::Vector4d q(node.rotation.data());
        if (q.norm() > 0) trs.rotation = Quat(Eigen::Vector4d(q.normalized()));
      }
      local_.push_back(trs);
      fixed_.emplace_back();
      if (node.matrix.size() == 16)
        fixed_.back() =
            NodePlace(Eigen::Matrix4d(Eigen::Map<const Eigen::Matrix4d>(node.matrix.data())));
    }
    rest_ = placed(local_);
    in_skin_.assign(gltf_.nodes.size(), false);
    for (const tinygltf::Skin& skin : gltf_.skins) add_bind_pose(skin);
  }

  void add_bind_pose(const tinygltf::Skin& skin) {
    GltfRows inverse;
    if (skin.inverseBindMatrices >= 0)
      inverse = data_.rows(skin.inverseBindMatrices, TINYGLTF_TYPE_MAT4);
    count(std::size_t(inverse.size()) + skin.joints.size());
    std::optional<NodePlace> to_scene;  // from the space of the skin's mesh, by its first joint
    for (std::size_t i = 0; i < skin.joints.size(); ++i) {
      const int node = skin.joints[i];
      at(gltf_.nodes, node, "joint");
      const bool known = in_skin_[std::size_t(node)];
      in_skin_[std::size_t(node)] = true;
      if (Eigen::Index(i) >= inverse.rows()) continue;
      const Eigen::RowVectorXd row = inverse.row(Eigen::Index(i));
      const NodePlace one(Eigen::Matrix4d(Eigen::Map<const Eigen::Matrix4d>(row.data())));
      constexpr double kFlat = 1e-15;
      if (!(std::abs(one.linear().determinant()) > kFlat)) continue;
      if (!to_scene) to_scene = rest_[std::size_t(node)] * one;
      const NodePlace bound = *to_scene * one.inverse(Eigen::Affine);
      if (!known && bound.matrix().allFinite()) rest_[std::size_t(node)] = bound;
    }
  }

  std::vector<NodePlace> placed(const std::vector<Trs>& local) const {
    std::vector<NodePlace> all(local.size());
    for (const int n : order_) {
      const NodePlace own = fixed_[n] ? *fixed_[n] : local[n].frame();
      all[n] = parent_[n] < 0 ? own : NodePlace(all[parent_[n]] * own);
    }
    return all;
  }

  std::vector<Track> tracks(const tinygltf::Animation& animation) {
    std::vector<Track> all;
    for (const tinygltf::AnimationChannel& channel : animation.channels) {
      Track track;
      const bool rotation = channel.target_path == "rotation";
      if (channel.target_path == "scale")
        track.what = Track::What::scale;
      else if (rotation)
        track.what = Track::What::rotation;
      else if (channel.target_path != "translation")
        continue;
      if (channel.target_node < 0) continue;
      at(gltf_.nodes, channel.target_node, "node");
      track.node = channel.target_node;
      const tinygltf::AnimationSampler& sampler =
          at(animation.samplers, channel.sampler, "sampler");
      track.way = sampler.interpolation;
      count(at(gltf_.accessors, sampler.output, "accessor").count * 5);
      const GltfRows times = data_.rows(sampler.input, TINYGLTF_TYPE_SCALAR);
      count(std::size_t(times.size()));
      track.times.assign(times.data(), times.data() + times.rows());
      require(std::is_sorted(track.times.begin(), track.times.end()),
              "has an animation whose times do not increase");
      track.values = data_.rows(sampler.output, rotation ? TINYGLTF_TYPE_VEC4 : TINYGLTF_TYPE_VEC3);
      require(track.values.rows() == track.row(track.times.size()) - (track.row(0)),
              "has an animation whose keys do not match its times");
      all.push_back(std::move(track));
    }
    return all;
  }

  void find_joints(const std::vector<std::vector<Track>>& all) {
    const std::size_t nodes = gltf_.nodes.size();
    std::vector<bool> animated(nodes, false);
    for (const std::vector<Track>& tracks : all)
      for (const Track& track : tracks) animated[std::size_t(track.node)] = true;
    const bool skinned = std::find(in_skin_.begin(), in_skin_.end(), true) != in_skin_.end();
    std::vector<bool> wanted = in_skin_;
    // Above a skin's joints what is animated, without one what is animated and all below.
    matters_.assign(nodes, false);
    if (skinned) {
      for (std::size_t i = order_.size(); i-- > 0;) {
        const int n = order_[i];
        matters_[n] = matters_[n] || in_skin_[n];
        if (matters_[n] && parent_[n] >= 0) matters_[parent_[n]] = true;
        if (matters_[n] && animated[n]) wanted[n] = true;
      }
    } else {
      for (const int n : order_) {
        wanted[n] = animated[n] || (parent_[n] >= 0 && wanted[parent_[n]]);
        matters_[n] = wanted[n];
      }
    }
    joint_of_.assign(nodes, -1);
    std::vector<int> above(nodes, -1);  // the nearest wanted node, itself included
    int roots = 0;
    for (const int n : order_) {
      above[n] = wanted[n] ? n : parent_[n] >= 0 ? above[parent_[n]] : -1;
      if (wanted[n]) nodes_.push_back(n);
      if (wanted[n] && (parent_[n] < 0 || above[parent_[n]] < 0)) ++roots;
    }
    require(!nodes_.empty(), "holds no joints");
    require(nodes_.size() <= std::size_t(kMostJoints), "has more than a thousand joints");
    if (roots > 1) nodes_.insert(nodes_.begin(), -1);  // the scene's own origin carries them
    for (std::size_t j = 0; j < nodes_.size(); ++j)
      if (nodes_[j] >= 0) joint_of_[nodes_[j]] = int(j);
    for (std::size_t j = 0; j < nodes_.size(); ++j) {
      Joint joint;
      if (nodes_[j] >= 0) {
        const int n = nodes_[j], up = parent_[n] < 0 ? -1 : above[parent_[n]];
        joint.name = gltf_.nodes[n].name;
        joint.parent = up >= 0 ? joint_of_[up] : j > 0 ? 0 : -1;
        joint.offset = rest_[n].translation();
        if (up >= 0) joint.offset -= rest_[up].translation();
      }
      skeleton_.joints.push_back(joint);
      rest_turn_.push_back(nodes_[j] >= 0 ? turn_of(rest_[nodes_[j]]) : Quat::Identity());
    }
  }

  Motion motion(const std::vector<Track>& tracks) {
    Motion motion;
    motion.skeleton = skeleton_;
    double first = 1e300, last = -1e300;
    std::size_t most = 1;
    for (const Track& track : tracks) {
      first = std::min(first, track.times.front());
      last = std::max(last, track.times.back());
      most = std::max(most, track.times.size());
    }
    const double length = last - first;
    const double wanted =
        std::clamp(length / double(std::max<std::size_t>(most - 1, 1)), kFinest, kCoarsest);
    const double numbers = 4.0 * double(gltf_.nodes.size()) * (length / wanted + 2);
    require(numbers < double(kMostNumbers), "has an animation with too many keys");
    count(std::size_t(numbers));
    const int steps = std::max(length > 0 ? 1 : 0, int(std::lround(length / wanted)));
    motion.step = steps > 0 ? length / steps : kCoarsest;

    std::vector<std::vector<Vec3>> places;
    std::vector<Trs> local = local_;
    for (int k = 0; k <= steps; ++k) {
      const double time = k == steps ? last : first + k * motion.step;
      for (const Track& track : tracks) track.put(time, local[std::size_t(track.node)]);
      const std::vector<NodePlace> now = placed(local);
      std::vector<Quat> turns;
      Pose pose = rest_pose(skeleton_);
      places.emplace_back();
      for (std::size_t j = 0; j < nodes_.size(); ++j) {
        const int n = nodes_[j], parent = skeleton_.joints[j].parent;
        const Quat above = parent < 0 ? Quat(Quat::Identity()) : turns[std::size_t(parent)];
        const Vec3 up = parent < 0 || nodes_[std::size_t(parent)] < 0
                            ? Vec3(Vec3::Zero())
                            : Vec3(now[nodes_[std::size_t(parent)]].translation());
        const Vec3 here = n < 0 ? Vec3(Vec3::Zero()) : Vec3(now[n].translation());
        turns.push_back(n < 0 ? Quat(Quat::Identity())
                              : (turn_of(now[n]) * rest_turn_[j].conjugate()).normalized());
        pose.rotations[j] = (above.conjugate() * turns[j]).normalized();
        places.back().push_back(above.conjugate() * (here - up));
        require(places.back().back().allFinite() && places.back().back().norm() < 1e6,
                "has joints beyond all bounds");
      }
      pose.root_position = places.back()[0];
      motion.poses.push_back(std::move(pose));
    }
    keep_what_moves(places, motion);
    return motion;
  }

  // Joints that don't stay where their parent has them at rest.
  void keep_what_moves(const std::vector<std::vector<Vec3>>& places, Motion& motion) const {
    double size = 0;
    for (const Joint& joint : skeleton_.joints) size = std::max(size, joint.offset.norm());
    constexpr double kStill = 1e-4;  // of the longest bone
    for (std::size_t j = 1; j < nodes_.size(); ++j)
      if (std::any_of(places.begin(), places.end(), [&](const std::vector<Vec3>& at) {
            return (at[j] - skeleton_.joints[j].offset).norm() > kStill * size;
          }))
        motion.moved.push_back(int(j));
    if (motion.moved.empty()) return;
    for (const std::vector<Vec3>& at : places) {
      motion.places.emplace_back();
      for (const int j : motion.moved) motion.places.back().push_back(at[std::size_t(j)]);
    }
  }

  const GltfData data_;
  const tinygltf::Model& gltf_;
  std::size_t counted_ = 0;
  std::vector<int> parent_, order_;  // of the nodes
  std::vector<Trs> local_;           // at rest
  std::vector<std::optional<NodePlace>>
      fixed_;  // of nodes that have a matrix: they can't be animated
  std::vector<NodePlace> rest_;
  std::vector<bool> in_skin_, matters_;
  std::vector<int> nodes_;  // by joint; −1: the scene's origin
  std::vector<int> joint_of_;
  Skeleton skeleton_;
  std::vector<Quat> rest_turn_;  // by joint
};

}  // namespace

Result<std::vector<Motion>> parse_glb_motions(std::string_view bytes, const std::string& name,
                                              const std::string& file) {
  return read_gltf(bytes, file, "; wanted a .glb or .vrm with animations",
                   [&] { return MotionReader(bytes).read(name); });
}

Result<Motion> parse_glb_skeleton(std::string_view bytes, const std::string& name,
                                  const std::string& file) {
  return read_gltf(bytes, file, "; wanted a .glb or .vrm with a skeleton",
                   [&] { return MotionReader(bytes).skeleton(name); });
}

}  // namespace artisketch
