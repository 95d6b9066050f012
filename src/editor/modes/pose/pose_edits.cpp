#include "editor/modes/pose/pose_edits.h"

#include "document/edit.h"
#include "document/posing.h"

namespace artisketch {

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
