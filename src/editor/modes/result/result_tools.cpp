// Result: posing the model by its joints, its keys, its joints' spheres, its parts' fatness.
#include <cmath>

#include "document/animate.h"
#include "document/edit.h"
#include "document/posing.h"
#include "editor/canvas/pointer.h"
#include "editor/canvas/tools.h"

namespace artisketch {

// ---------------------------------------------------------------- keys

void new_clip(Work& work) {
  work.commit("New clip", with_clip(work.document(), work.shown_pose()));
  work.view.clip = int(work.built->model.clips.size()) - 1;
  work.view.time = 0;
  work.view.key = 0;
  work.view.playing = false;
  work.view.posed.reset();
}

void set_key(Work& work) {
  View& view = work.view;
  // The clip of the drawings has a key per drawing: a pose of one's own begins another.
  if (view.clip == 0) return new_clip(work);
  const double time = view.time;
  const std::string name = work.built->model.clips[std::size_t(view.clip)].name;
  work.commit("Set key of " + name,
              with_key(work.document(), view.clip - 1, time, work.shown_pose()));
  view.playing = false;
  view.posed.reset();
  const std::vector<double>& times = work.built->model.clips[std::size_t(view.clip)].times;
  for (int k = 0; k < int(times.size()); ++k)
    if (std::abs(times[std::size_t(k)] - time) < kLeastStep) view.key = k;
}

void remove_key(Work& work) {
  const int clip = work.view.clip - 1, key = work.view.key;
  if (clip < 0 || clip >= int(work.document().animations.size())) return;
  const Animation& animation = work.document().animations[std::size_t(clip)];
  if (key >= int(animation.keys.size())) return;
  work.commit("Delete key of " + animation.name, without_key(work.document(), clip, key));
  work.view.key = -1;
}

// ---------------------------------------------------------------- joints

namespace {

// The joint in reach of the pointer; −1: none.
int joint_near(const Eye& eye, const std::vector<Vec3>& joints, float reach) {
  int near = -1;
  for (int j = 0; j < int(joints.size()); ++j)
    if (const float distance = apart(eye.project(joints[std::size_t(j)]), ImGui::GetIO().MousePos);
        distance < reach) {
      reach = distance;
      near = j;
    }
  return near;
}

bool pressed() {
  return ImGui::IsMouseClicked(ImGuiMouseButton_Left) && ImGui::IsWindowHovered();
}

// The world point under the pointer, as deep as X.
Vec3 under_pointer(const Eye& eye, const Vec3& X) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  Eigen::Vector4d clip = eye.clip * X.homogeneous();
  clip.x() = clip.w() * (2 * (mouse.x - eye.place.x) / eye.place.w - 1);
  clip.y() = clip.w() * (1 - 2 * (mouse.y - eye.place.y) / eye.place.h);
  return (eye.clip.inverse() * clip).hnormalized();
}

// A drag that begins on a joint poses the model.
bool drag_joints(Work& work, const Eye& eye, const std::vector<Vec3>& joints, const Vec3& shift) {
  int& dragged = work.model_joint;
  if (pressed()) dragged = joint_near(eye, joints, 12);
  if (!pointer_holds()) dragged = -1;
  if (dragged < 0) return false;
  if (!pointer_dragged()) return true;
  const Vec3 target = under_pointer(eye, joints[std::size_t(dragged)]) - shift;
  work.view.playing = false;
  if (dragged < work.document().skeleton.size()) work.view.joint = dragged;
  const Skeleton& skeleton = work.built->model.skeleton;
  work.view.posed =
      with_joint_at(skeleton, work.shown_pose(), dragged, target, bones_dragged(skeleton, dragged));
  return true;
}

// ---------------------------------------------------------------- spheres

struct Sphere {
  int joint = 0;
  double radius = 0;
  Vec3 offset = Vec3::Zero(), centre = Vec3::Zero();  // in rest space; in the world
};

// As the document has them by now.
std::vector<Sphere> spheres_of(const Work& work, const std::vector<Transform>& motions,
                               const Vec3& shift) {
  std::vector<Sphere> spheres;
  const std::vector<Vec3> rest = rest_positions(work.built->model.skeleton);
  for (const JointSphere& made : work.built->spheres) {
    if (made.joint >= std::min(work.document().skeleton.size(), int(motions.size()))) continue;
    Sphere sphere{made.joint, made.radius, Vec3::Zero(), Vec3::Zero()};
    const auto own = work.document().spheres.find(made.joint);
    if (own != work.document().spheres.end()) {
      sphere.radius = own->second.radius.value_or(made.radius);
      sphere.offset = own->second.offset;
    }
    const std::size_t j = std::size_t(made.joint);
    sphere.centre = motions[j] * Vec3(rest[j] + sphere.offset) + shift;
    spheres.push_back(sphere);
  }
  return spheres;
}

// Points that a unit takes across the view at X.
float points_per_unit(const Eye& eye, const Vec3& X) {
  return apart(eye.project(X), eye.project(X + eye.turn.row(0).transpose()));
}

bool drag_spheres(Work& work, const Eye& eye, const std::vector<Transform>& motions,
                  const Vec3& shift) {
  const std::vector<Sphere> spheres = spheres_of(work, motions, shift);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  int& dragged = work.model_joint;
  if (pressed()) {
    constexpr float kReach = 8;
    dragged = -1;
    float nearest = kReach;
    for (const Sphere& sphere : spheres) {
      const ImVec2 at = eye.project(sphere.centre);
      const float rim =
          std::abs(apart(at, mouse) - float(sphere.radius) * points_per_unit(eye, sphere.centre));
      const float middle = apart(at, mouse);
      if (std::min(rim, middle) >= nearest) continue;
      nearest = std::min(rim, middle);
      dragged = work.view.joint = sphere.joint;
      work.sphere_rim = rim < middle;
    }
    if (dragged >= 0) work.gesture = {};
  }
  for (const Sphere& sphere : spheres) {
    const bool chosen = sphere.joint == work.view.joint;
    const ImVec2 at = eye.project(sphere.centre);
    const float radius = float(sphere.radius) * points_per_unit(eye, sphere.centre);
    const std::string name = part_words(work, sphere.joint);
    record("Sphere " + name, {at.x - 4, at.y - 4, 8, 8}, true, chosen);
    record("Sphere rim " + name, {at.x + radius - 4, at.y - 4, 8, 8}, true, chosen);
    draw().AddCircleFilled(at, radius, joint_tint(sphere.joint, chosen ? 0.4f : 0.22f));
    draw().AddCircle(at, radius, rgb(0xFFFFFF, 0.9f), 0, chosen ? 3.0f : 2.0f);
    draw().AddCircle(at, radius, joint_tint(sphere.joint), 0, chosen ? 2.0f : 1.25f);
    draw().AddCircleFilled(at, 3, rgb(0xFFFFFF));
  }
  if (!pointer_holds()) dragged = -1;
  for (const Sphere& sphere : spheres) {
    if (sphere.joint != dragged || !pointer_dragged() || !pointer_moved()) continue;
    const Vec3 target = under_pointer(eye, sphere.centre);
    const double radius = work.sphere_rim ? (target - sphere.centre).norm() : sphere.radius;
    const Vec3 by =
        work.sphere_rim
            ? Vec3(Vec3::Zero())
            : Vec3(motions[std::size_t(dragged)].linear().transpose() * (target - sphere.centre));
    work.change("Joint of " + part_words(work, dragged),
                with_sphere(work.document(), dragged, radius, sphere.offset + by));
    break;
  }
  return dragged >= 0;
}

// ---------------------------------------------------------------- fatness

// The drawn part whose bone passes nearest to the pointer; −1: none is near.
int part_near(const Work& work, const Eye& eye, const std::vector<Vec3>& joints) {
  const Skeleton& skeleton = work.document().skeleton;
  if (skeleton.size() != int(joints.size())) return -1;
  const OnScreen as_it_is{{0, 0}, 1};
  int near = -1;
  float nearest = 48;
  for (const int joint : drawn_joints(work.document())) {
    const ImVec2 a = eye.project(joints[std::size_t(joint)]),
                 b = eye.project(joints[std::size_t(end_of_bone(skeleton, joint))]);
    const Polyline bone{{Vec2(a.x, a.y), Vec2(b.x, b.y)}, false};
    if (const OnLine on = nearest_on(bone, as_it_is, ImGui::GetIO().MousePos);
        on.distance < nearest) {
      nearest = on.distance;
      near = joint;
    }
  }
  return near;
}

bool drag_fatness(Work& work, const Eye& eye, const std::vector<Vec3>& joints) {
  constexpr double kPointsToDouble = 150;
  int& dragged = work.model_joint;
  if (pressed()) {
    dragged = part_near(work, eye, joints);
    if (dragged >= 0) {
      work.gesture = {};
      work.view.joint = dragged;
      work.fatness_from = fatness_of(work.document(), dragged);
    }
  }
  if (!pointer_holds()) dragged = -1;
  if (dragged >= 0 && pointer_dragged() && pointer_moved()) {
    const ImGuiIO& io = ImGui::GetIO();
    const double by =
        (io.MousePos.x - io.MouseClickedPos[ImGuiMouseButton_Left].x) / kPointsToDouble;
    work.change("Fatness of " + part_words(work, dragged),
                with_fatness(work.document(), dragged, work.fatness_from * std::exp2(by)));
  }
  const int shown = dragged >= 0 ? dragged : part_near(work, eye, joints);
  for (const int joint : drawn_joints(work.document())) {
    if (joint >= int(joints.size())) continue;
    const Vec3 middle = (joints[std::size_t(joint)] +
                         joints[std::size_t(end_of_bone(work.document().skeleton, joint))]) /
                        2;
    const ImVec2 at = eye.project(middle);
    record("Fatness of " + part_words(work, joint), {at.x - 5, at.y - 5, 10, 10}, true,
           joint == dragged);
    draw().AddCircleFilled(at, joint == shown ? 6.0f : 4, rgb(0xFFFFFF));
    draw().AddCircleFilled(at, joint == shown ? 4.5f : 2.75f, joint_tint(joint));
  }
  if (shown >= 0 && ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem)) {
    const std::string words =
        part_words(work, shown) + "  " +
        std::to_string(int(std::lround(100 * fatness_of(work.document(), shown)))) + " %";
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const Rect tag{mouse.x + 14, mouse.y - 34, text_width(Font::caption_bold, words) + 20, 26};
    draw().AddRectFilled(tag.min(), tag.max(), rgb(0x1F2227, 0.95f), 13);
    write(tag, Font::caption_bold, rgb(0xE8EAED), words, Align::centre);
  }
  return dragged >= 0;
}

}  // namespace

bool use_result_tool(Work& work, const Eye& eye, const Pose& pose, const Vec3& shift) {
  const Skeleton& skeleton = work.shown()->model.skeleton;
  std::vector<Vec3> joints;
  for (const Transform& joint : posed_joints(skeleton, pose))
    joints.push_back(joint.translation() + shift);
  switch (work.view.tool()) {
    case Tool::pose:
      for (int j = 0; j < int(joints.size()) && j < work.document().skeleton.size(); ++j) {
        const ImVec2 p = eye.project(joints[std::size_t(j)]);
        record("Pose " + part_words(work, j), {p.x - 6, p.y - 6, 12, 12}, true,
               j == work.view.joint);
      }
      return drag_joints(work, eye, joints, shift);
    case Tool::joints:
      return drag_spheres(work, eye, skinning_transforms(skeleton, pose), shift);
    case Tool::fatness:
      return drag_fatness(work, eye, joints);
    default:
      return false;
  }
}

}  // namespace artisketch
