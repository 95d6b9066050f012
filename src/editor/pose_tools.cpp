// Pose: what the pointer does to a drawing's pose.
#include <cmath>

#include "document/edit.h"
#include "editor/pointer.h"
#include "editor/tools.h"

namespace artisketch {
namespace {

// Where a joint goes when it is dragged to a pixel: on that pixel's ray, at the bone's own length,
// on the side of the paper where it was.
Vec3 target_at(const Skeleton& skeleton, const std::vector<Transform>& posed,
               const FrameCamera& camera, int joint, const Vec2& pixel) {
  const Ray ray = camera.ray(pixel);
  const Vec3 here = posed[std::size_t(joint)].translation();
  const auto at_depth = [&](double z) {
    return Vec3(ray.at((z - ray.origin.z()) / ray.direction.z()));
  };
  const int parent = skeleton.joints[std::size_t(joint)].parent;
  if (parent < 0) return at_depth(here.z());
  const Vec3 pivot = posed[std::size_t(parent)].translation();
  const double length = (here - pivot).norm();
  // Two bones reach within their lengths: only a lone bone is kept on its sphere.
  const Vec3 flat = at_depth(pivot.z());
  const double across = (flat - pivot).norm();
  if (across >= length) return at_depth(here.z());
  const double depth = std::sqrt(length * length - across * across);
  return at_depth(pivot.z() + (here.z() >= pivot.z() ? depth : -depth));
}

}  // namespace

void pose_tool(Work& work, const Pointer& p, const OnScreen& on) {
  const Skeleton& skeleton = work.document().skeleton;
  const FrameCamera camera = frame_camera(work.document(), work.view.frame);
  const std::vector<Transform> posed = posed_joints(skeleton, work.frame().pose);
  take_joint(work, p, posed, camera, on);
  if (p.dragging && work.gesture.joint >= 0) {
    if (work.proposal) work.proposal.reset();
    const Vec3 target = target_at(skeleton, posed, camera, work.gesture.joint, p.at);
    const int parent = skeleton.joints[std::size_t(work.gesture.joint)].parent;
    const std::string name = part_words(work, parent >= 0 ? parent : work.gesture.joint);
    work.change(
        parent >= 0 ? "Bend " + name : "Move body",
        with_pose(work.document(), work.view.frame,
                  with_joint_at(skeleton, work.frame().pose, work.gesture.joint, target, 1)));
  }
}

void twist_tool(Work& work, const Pointer& p, const OnScreen& on) {
  const Skeleton& skeleton = work.document().skeleton;
  if (p.pressed) {
    work.gesture = {};
    const FrameCamera camera = frame_camera(work.document(), work.view.frame);
    work.view.joint = joint_at(posed_joints(skeleton, work.frame().pose), camera, on, p.screen);
  }
  const float wheel = ImGui::GetIO().MouseWheel;
  if (!p.hovered || wheel == 0 || work.view.joint <= 0) return;
  const int parent = skeleton.joints[std::size_t(work.view.joint)].parent;
  work.change("Twist " + part_words(work, parent),
              with_pose(work.document(), work.view.frame,
                        with_bone_twisted(skeleton, work.frame().pose, work.view.joint,
                                          radians(5 * wheel))));
}

}  // namespace artisketch
