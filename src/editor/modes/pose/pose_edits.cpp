#include "editor/modes/pose/pose_edits.h"

#include "document/edit.h"
#include "document/posing.h"

namespace artisketch {

void drag_joint(App& app, int joint, const Vec2& pixel) {
  app.session.proposal.reset();
  const Skeleton& skeleton = app.document().skeleton;
  const int frame = app.session.selection.frame;
  const int bones = bones_dragged(skeleton, joint);
  int turned = joint;
  for (int b = 0; b < bones; ++b) turned = skeleton.joints[std::size_t(turned)].parent;
  app.session.change(
      bones > 0 ? "Bend " + part_words(app, turned) : "Move body",
      with_pose(app.document(), frame,
                with_joint_dragged(skeleton, app.frame().pose, frame_camera(app.document(), frame),
                                   joint, pixel)));
}

void turn_body(App& app, const Quat& turn) {
  app.session.proposal.reset();
  app.session.change("Turn body", with_pose(app.document(), app.session.selection.frame,
                                            with_body_turned(app.frame().pose, turn)));
}

void twist_bone(App& app, double angle) {
  const Skeleton& skeleton = app.document().skeleton;
  const int joint = app.session.selection.joint;
  app.session.change("Twist " + part_words(app, start_of_bone(skeleton, joint)),
                     with_pose(app.document(), app.session.selection.frame,
                               with_bone_twisted(skeleton, app.frame().pose,
                                                 end_of_bone(skeleton, joint), angle)));
}

}  // namespace artisketch
