// Pose: a joint is dragged and its limb follows; over the chosen joint the wheel twists.
#include "document/edit.h"
#include "document/posing.h"
#include "editor/modes/pose/pose_edits.h"
#include "editor/session/app.h"
#include "editor/ui/icons.h"

namespace artisketch {
namespace {

class PoseTool : public Tool {
 public:
  void pointer(App& app, const Pointer& p, const Stage& stage) override {
    if (p.pressed) {
      gesture_ = app.session.begin_gesture();
      app.session.selection.joint = joint_ = joint_under(app, p, stage);
    }
    if (p.dragging && p.moved && joint_ >= 0 && app.session.goes_on(gesture_))
      drag_joint(app, joint_, p.at);
    if (p.hovered && p.wheel != 0 && takes_wheel(app, p, stage))
      twist_bone(app, radians(kTwistPerNotch * double(p.wheel)));
  }

  bool takes_wheel(const App& app, const Pointer& p, const Stage& stage) const override {
    const int chosen = app.session.selection.joint;
    return chosen >= 0 && joint_under(app, p, stage) == chosen;
  }

  std::string hint(const App& app) const override {
    return app.session.proposal ? "Hold P to see your own pose."
                                : "Drag a joint: the limb follows.  The wheel on a joint twists "
                                  "it, F flips it toward you or away.";
  }
  void cancel(App&) override { joint_ = -1; }

 private:
  static int joint_under(const App& app, const Pointer& p, const Stage& stage) {
    return joint_at(posed_joints(app.document().skeleton, app.frame().pose),
                    frame_camera(app.document(), app.session.selection.frame), stage.on, p.screen);
  }

  long gesture_ = 0;
  int joint_ = -1;  // that is dragged
};

}  // namespace

ToolRow pose_tool() {
  return {.id = "pose",
          .mode = Mode::pose,
          .name = "Pose",
          .icon = icon::kCursorMove,
          .key = ImGuiKey_V,
          .make = make_tool<PoseTool>,
          .usual = true};
}

}  // namespace artisketch
