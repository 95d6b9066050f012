#include "editor/modes/skeleton/skeleton_edits.h"

#include "document/edit.h"
#include "document/skeleton_edit.h"
#include "editor/canvas/pointer.h"

namespace artisketch {

Vec3 as_deep_as(const Transform& joint, const FrameCamera& camera, const Vec2& pixel) {
  return camera.ray(pixel).at_z(joint.translation().z());
}

void move_joint(App& app, int joint, const Vec2& pixel) {
  const int frame = app.session.selection.frame;
  const Skeleton& skeleton = app.document().skeleton;
  const int parent = skeleton.joints[std::size_t(joint)].parent;
  const std::vector<Transform> posed = posed_joints(skeleton, app.drawn_pose());
  const Vec3 target =
      as_deep_as(posed[std::size_t(joint)], frame_camera(app.document(), frame), pixel);
  if (parent < 0) {
    Pose pose = app.frame().pose;
    pose.root_position = target;
    return app.session.change("Move body", with_pose(app.document(), frame, std::move(pose)));
  }
  app.session.change(
      "Move " + part_words(app, joint),
      with_joint_moved(app.document(), joint, posed[std::size_t(parent)].inverse() * target,
                       app.view.both_sides));
}

}  // namespace artisketch
