// Pose: what the pointer does to a drawing's pose.
#include <cmath>

#include "document/edit.h"
#include "document/posing.h"
#include "editor/canvas/pointer.h"
#include "editor/canvas/tools.h"

namespace artisketch {
namespace {

constexpr double kTwistPerNotch = 5, kTwistPerPoint = 0.5;  // degrees

void twist(Work& work, double angle) {
  const Skeleton& skeleton = work.document().skeleton;
  const int joint = work.view.joint;
  work.change("Twist " + part_words(work, start_of_bone(skeleton, joint)),
              with_pose(work.document(), work.view.frame,
                        with_bone_twisted(skeleton, work.frame().pose, end_of_bone(skeleton, joint),
                                          angle)));
}

bool on_chosen_joint(const Work& work, const OnScreen& on) {
  if (work.view.joint < 0) return false;
  const FrameCamera camera = frame_camera(work.document(), work.view.frame);
  const std::vector<Transform> posed = posed_joints(work.document().skeleton, work.frame().pose);
  return joint_at(posed, camera, on, ImGui::GetIO().MousePos) == work.view.joint;
}

}  // namespace

bool wheel_twists(const Work& work, const OnScreen& on) {
  if (work.view.mode != Mode::pose || work.view.joint < 0) return false;
  return work.view.tool() == Tool::twist || on_chosen_joint(work, on);
}

void record_joints(const Work& work, const OnScreen& on) {
  const FrameCamera camera = frame_camera(work.document(), work.view.frame);
  const std::vector<Transform> posed = posed_joints(work.document().skeleton, work.drawn_pose());
  for (int j = 0; j < int(posed.size()); ++j) {
    const Vec3 place = posed[std::size_t(j)].translation();
    if (!camera.in_front(place)) continue;
    const ImVec2 p = on.of(camera.project(place));
    record("Joint " + part_words(work, j), {p.x - 9, p.y - 9, 18, 18}, true, j == work.view.joint);
  }
}

void pose_tool(Work& work, const Pointer& p, const OnScreen& on) {
  const Skeleton& skeleton = work.document().skeleton;
  const FrameCamera camera = frame_camera(work.document(), work.view.frame);
  const std::vector<Transform> posed = posed_joints(skeleton, work.frame().pose);
  take_joint(work, p, posed, camera, on);
  const int joint = work.gesture.joint;
  if (p.dragging && p.moved && joint >= 0) {
    work.proposal.reset();
    const int bones = bones_dragged(skeleton, joint);
    int turned = joint;
    for (int b = 0; b < bones; ++b) turned = skeleton.joints[std::size_t(turned)].parent;
    work.change(bones > 0 ? "Bend " + part_words(work, turned) : "Move body",
                with_pose(work.document(), work.view.frame,
                          with_joint_dragged(skeleton, work.frame().pose, camera, joint, p.at)));
  }
  const float wheel = ImGui::GetIO().MouseWheel;
  if (p.hovered && wheel != 0 && wheel_twists(work, on))
    twist(work, radians(kTwistPerNotch * wheel));
}

void twist_tool(Work& work, const Pointer& p, const OnScreen& on) {
  if (p.pressed) {
    const FrameCamera camera = frame_camera(work.document(), work.view.frame);
    const int joint =
        joint_at(posed_joints(work.document().skeleton, work.frame().pose), camera, on, p.screen);
    work.gesture = {};
    if (joint >= 0) work.view.joint = joint;
  }
  if (work.view.joint < 0) return;
  const ImGuiIO& io = ImGui::GetIO();
  if (p.hovered && io.MouseWheel != 0) twist(work, radians(kTwistPerNotch * io.MouseWheel));
  if (p.dragging && io.MouseDelta.x != 0) twist(work, radians(kTwistPerPoint * io.MouseDelta.x));
}

void turn_tool(Work& work, const Pointer& p, const Rect& place) {
  if (p.pressed) work.gesture = {};
  const ImVec2 delta = ImGui::GetIO().MouseDelta;
  if (!p.dragging || (delta.x == 0 && delta.y == 0)) return;
  const ImVec2 centre = place.centre();
  const Vec2 to(p.screen.x - centre.x, p.screen.y - centre.y);
  const double radius = 0.4 * std::min(place.w, place.h);
  turn_body(work, ball_turn(to - Vec2(delta.x, delta.y), to, radius));
}

void turn_body(Work& work, const Quat& turn) {
  work.proposal.reset();
  work.change("Turn body", with_pose(work.document(), work.view.frame,
                                     with_body_turned(work.frame().pose, turn)));
}

}  // namespace artisketch
