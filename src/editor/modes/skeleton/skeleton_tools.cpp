// Skeleton: what the pointer does to the rest pose.
#include "document/edit.h"
#include "document/skeleton_edit.h"
#include "editor/canvas/pointer.h"
#include "editor/canvas/tools.h"

namespace artisketch {
namespace {

// Where the pointer is in the world, as deep as a joint.
Vec3 beneath(const FrameCamera& camera, const Transform& joint, const Vec2& at) {
  return camera.ray(at).at_z(joint.translation().z());
}

// The next bone, before it is there.
void paint_next_bone(const Pointer& p, ImVec2 from) {
  const ImVec2 ends[] = {from, p.screen};
  paint_dashes(draw(), ends, false, rgb(0x1C2025, 0.45f), 4, 6, 4);
  paint_dashes(draw(), ends, false, theme().accent, 2, 6, 4);
  draw().AddCircleFilled(p.screen, 5, theme().accent);
}

void add_child(Work& work, int parent, const Vec3& offset) {
  const int at = work.document().skeleton.size();
  work.commit("Add joint", with_joint_added(work.document(), parent, offset, work.view.both_sides));
  work.view.joint = work.gesture.joint = at;
  work.gesture.moved = true;  // what follows amends it
}

}  // namespace

// A joint moves in every drawing. Beside a chosen joint, a click adds a child to it.
void skeleton_tool(Work& work, const Pointer& p, const OnScreen& on) {
  const FrameCamera camera = frame_camera(work.document(), work.view.frame);
  const std::vector<Transform> posed = posed_joints(work.document().skeleton, work.drawn_pose());
  const auto screen = [&](int joint) {
    return on.of(camera.project(posed[std::size_t(joint)].translation()));
  };
  for (int j = 0; j < int(posed.size()); ++j)
    record("Joint " + part_words(work, j), {screen(j).x - 9, screen(j).y - 9, 18, 18}, true,
           j == work.view.joint);
  const int under = joint_at(posed, camera, on, p.screen), chosen = work.view.joint;
  if (under >= 0 && p.hovered) draw().AddCircle(screen(under), 14, theme().accent, 0, 1.5f);
  if (p.hovered && !p.held && under < 0 && chosen >= 0) paint_next_bone(p, screen(chosen));
  if (p.pressed) {
    work.gesture = {};
    if (under >= 0) {
      work.view.joint = work.gesture.joint = under;
    } else if (chosen >= 0) {
      const Transform& parent = posed[std::size_t(chosen)];
      add_child(work, chosen, parent.inverse() * beneath(camera, parent, p.at));
    }
    return;
  }
  const int joint = work.gesture.joint;
  if (!p.dragging || !p.moved || joint < 0 || joint >= int(posed.size())) return;
  const Vec3 target = beneath(camera, posed[std::size_t(joint)], p.at);
  const int parent = work.document().skeleton.joints[std::size_t(joint)].parent;
  if (parent < 0) {
    Pose pose = work.frame().pose;
    pose.root_position = target;
    work.change("Move body", with_pose(work.document(), work.view.frame, std::move(pose)));
    return;
  }
  work.change(
      "Move " + part_words(work, joint),
      with_joint_moved(work.document(), joint, posed[std::size_t(parent)].inverse() * target,
                       work.view.both_sides));
}

}  // namespace artisketch
