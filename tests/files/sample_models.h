// Small models with every feature that a GLB of ours can have.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "document/templates.h"
#include "model/rig/body_plan.h"
#include "model/rig/library.h"
#include "model/stages.h"

namespace artisketch {

// A unit sphere about the origin on two joints, with clip `frames` of three keys.
inline Model two_joint_model(int subdivisions = 2) {
  Model model;
  model.name = "ball";
  model.skeleton.joints = {{"hips", -1, {0, -0.25, 0}, -1, ""},
                           {"chest.üp", 0, {0.1, 0.5, 0}, -1, ""}};
  model.mesh = icosphere(Vec3::Zero(), 1, subdivisions);
  const Eigen::Index n = model.mesh.V.rows();
  model.weights.joints.setZero(n, 4);
  model.weights.weights.setZero(n, 4);
  for (Eigen::Index v = 0; v < n; ++v) {
    const double up = (model.mesh.V(v, 1) + 1) / 2;
    model.weights.joints.row(v) << 1, 0, 0, 0;
    model.weights.weights.row(v) << up, 1 - up, 0, 0;
  }
  Clip frames{"frames", {0, 1, 2}, std::vector<Pose>(3, rest_pose(model.skeleton))};
  for (int k = 1; k < 3; ++k) {
    frames.poses[k].root_position = {0.1 * k, 0, 0.2};
    frames.poses[k].rotations[1] = Quat(Eigen::AngleAxisd(1.2 * k, Vec3(1, 2, 3).normalized()));
  }
  model.clips.push_back(std::move(frames));
  return model;
}

// The same with a texture whose seam splits vertices, and a second clip.
inline Model textured_model(int subdivisions = 2) {
  Model model = two_joint_model(subdivisions);
  model.name = "hips";  // a joint's name too
  // Every face with vertices of its own: all edges are seams.
  const Mesh whole = model.mesh;
  const Weights weights = model.weights;
  const Eigen::Index n = whole.F.size();
  model.mesh.V.resize(n, 3);
  model.weights.joints.resize(n, 4);
  model.weights.weights.resize(n, 4);
  for (Eigen::Index i = 0; i < n; ++i) {
    const int v = whole.F.data()[i];
    model.mesh.V.row(i) = whole.V.row(v);
    model.mesh.F.data()[i] = int(i);
    model.weights.joints.row(i) = weights.joints.row(v);
    model.weights.weights.row(i) = weights.weights.row(v);
    model.texcoords.emplace_back((whole.V(v, 0) + 1) / 2, (1 - whole.V(v, 1)) / 2);
  }
  Image texture(16, 8);
  for (int i = 0; i < 16 * 8; ++i) {
    std::uint8_t* p = texture.at(i % 16, i / 16);
    p[0] = std::uint8_t(i), p[1] = 90, p[2] = 60;
  }
  model.texture = std::move(texture);
  Clip wave = model.clips[0];
  wave.name = "wave";
  wave.times = {0, 0.25, 3.5};
  model.clips.push_back(std::move(wave));
  return model;
}

// A chain of 300 joints; vertices with four influences, repeated and unused ones.
inline Model many_joints_model() {
  Model model = two_joint_model();
  model.name.clear();
  model.skeleton.joints.resize(1);
  for (int j = 1; j < 300; ++j)
    model.skeleton.joints.push_back({"joint " + std::to_string(j), j - 1, {0, 0.005, 0}, -1, ""});
  for (Eigen::Index v = 0; v < model.mesh.V.rows(); ++v) {
    const int j = int(v * 299 / (model.mesh.V.rows() - 1));
    model.weights.joints.row(v) << j, (j + 7) % 300, j, (j + 100) % 300;
    model.weights.weights.row(v) << 0.3, 1.0 / 3, 0.3 + 1e-12 * double(v), v % 2 ? 0 : 1e-9;
    model.weights.weights.row(v) /= model.weights.weights.row(v).sum();
  }
  model.clips[0] = {"frames", {0}, {rest_pose(model.skeleton)}};  // a single key
  return model;
}

// A person with a lock of hair and a parted tail, its arms hanging: a small ball on every joint.
inline Model person_with_tail_model() {
  Model model;
  model.name = "person";
  model.skeleton = template_skeleton(Template::human);
  const auto add = [&](const char* name, const char* parent, const Vec3& offset) {
    model.skeleton.joints.push_back({name, model.skeleton.find(parent), offset, -1, ""});
  };
  add("hair", "head", {0, 0.1, -0.1});
  add("hair_2", "hair", {0, -0.1, -0.1});
  add("hair_tip", "hair_2", {0, -0.15, 0});
  add("tail", "hips", {0, 0, -0.1});
  add("tail_2", "tail", {0, -0.05, -0.15});
  add("tail_tip", "tail_2", {0, -0.05, -0.15});
  add("tuft", "tail_2", {0.1, 0, -0.1});
  add("tuft_tip", "tuft", {0.05, 0, -0.1});
  const BodyPlan plan = body_plan_of(model.skeleton, rest_positions(model.skeleton), false);
  Pose hanging = rest_pose(model.skeleton);
  for (int side = 0; side < 2; ++side)
    hanging.rotations[plan.arms[std::size_t(side)].upper] =
        Quat(Eigen::AngleAxisd(side == 0 ? -1.1 : 1.1, Vec3::UnitZ()));
  const std::vector<Transform> at = posed_joints(model.skeleton, hanging);
  const Mesh ball = icosphere(Vec3::Zero(), 0.05, 0);
  const Eigen::Index corners = ball.V.rows(), faces = ball.F.rows(), n = model.skeleton.size();
  model.mesh.V.resize(n * corners, 3);
  model.mesh.F.resize(n * faces, 3);
  model.weights.joints.setZero(n * corners, 4);
  model.weights.weights.setZero(n * corners, 4);
  for (Eigen::Index j = 0; j < n; ++j) {
    Joint& joint = model.skeleton.joints[std::size_t(j)];
    const Vec3 place = at[std::size_t(j)].translation();
    joint.offset = place;
    if (joint.parent >= 0) joint.offset -= at[std::size_t(joint.parent)].translation();
    model.mesh.V.middleRows(j * corners, corners) = ball.V.rowwise() + place.transpose();
    model.mesh.F.middleRows(j * faces, faces) = ball.F.array() + int(j * corners);
    model.weights.joints.col(0).segment(j * corners, corners).setConstant(int(j));
    model.weights.weights.col(0).segment(j * corners, corners).setOnes();
  }
  model.clips.push_back({"frames", {0}, {rest_pose(model.skeleton)}});
  model.clips.push_back(*library_clip(model.skeleton, "walk", {}));
  return model;
}

inline std::vector<std::pair<std::string, Model>> sample_models() {
  Model still = two_joint_model();
  still.clips.clear();
  return {{"plain", two_joint_model()},
          {"textured", textured_model()},
          {"many_joints", many_joints_model()},
          {"still", std::move(still)}};
}

// The same features in few bytes.
inline std::vector<std::pair<std::string, Model>> small_models() {
  return {{"plain", two_joint_model(0)}, {"textured", textured_model(0)}};
}

}  // namespace artisketch
