// Skeleton: what the pointer does to the rest pose.
#include "document/edit.h"
#include "editor/pointer.h"
#include "editor/tools.h"

namespace artisketch {

// A joint moves in every drawing: its rest offset takes up the move, seen from the drawing's pose.
void skeleton_tool(Work& work, const Pointer& p, const OnScreen& on) {
  const Skeleton& skeleton = work.document().skeleton;
  const FrameCamera camera = frame_camera(work.document(), work.view.frame);
  const std::vector<Transform> posed = posed_joints(skeleton, work.frame().pose);
  take_joint(work, p, posed, camera, on);
  if (!p.dragging || work.gesture.joint < 0) return;
  const int joint = work.gesture.joint, parent = skeleton.joints[std::size_t(joint)].parent;
  const Ray ray = camera.ray(p.at);
  const double z = posed[std::size_t(joint)].translation().z();
  const Vec3 target = ray.at((z - ray.origin.z()) / ray.direction.z());
  if (parent < 0) {
    Pose pose = work.frame().pose;
    pose.root_position = target;
    work.change("Move body", with_pose(work.document(), work.view.frame, std::move(pose)));
    return;
  }
  work.change(
      "Move " + part_words(work, joint),
      with_joint_offset(work.document(), joint, posed[std::size_t(parent)].inverse() * target));
}

}  // namespace artisketch
