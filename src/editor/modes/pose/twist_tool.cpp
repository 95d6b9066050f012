// Twist: the chosen joint's bone turns about itself, by dragging sideways or by the wheel.
#include "document/edit.h"
#include "editor/modes/pose/pose_edits.h"
#include "editor/session/app.h"
#include "editor/ui/icons.h"

namespace artisketch {
namespace {

class TwistTool : public Tool {
 public:
  void pointer(App& app, const Pointer& p, const Stage& stage) override {
    if (p.pressed) {
      const int joint =
          joint_at(posed_joints(app.document().skeleton, app.frame().pose),
                   frame_camera(app.document(), app.session.selection.frame), stage.on, p.screen);
      app.session.begin_gesture();
      if (joint >= 0) app.session.selection.joint = joint;
    }
    if (app.session.selection.joint < 0) return;
    if (p.hovered && p.wheel != 0) twist_bone(app, radians(kTwistPerNotch * double(p.wheel)));
    if (p.dragging && p.delta.x != 0) twist_bone(app, radians(kTwistPerPoint * double(p.delta.x)));
  }

  bool takes_wheel(const App& app, const Pointer&, const Stage&) const override {
    return app.session.selection.joint >= 0;
  }

  std::string hint(const App&) const override {
    return "Choose a joint, then drag sideways or turn the wheel: the part twists.";
  }
};

}  // namespace

ToolRow twist_tool() {
  return {.id = "twist",
          .mode = Mode::pose,
          .name = "Twist",
          .icon = icon::kRotateRight,
          .key = ImGuiKey_T,
          .make = make_tool<TwistTool>};
}

}  // namespace artisketch
