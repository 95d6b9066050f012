// Edit: a joint moves in every drawing. Beside a chosen joint, a click adds a child to it, and a
// drag a whole bone.
#include "document/skeleton_edit.h"
#include "editor/canvas/pointer.h"
#include "editor/canvas/sketch_paint.h"
#include "editor/modes/skeleton/skeleton_edits.h"
#include "editor/session/app.h"
#include "editor/ui/icons.h"
#include "editor/ui/ui.h"

namespace artisketch {
namespace {

// The next bone, before it is there.
void paint_next_bone(const Pointer& p, ImVec2 from) {
  const ImVec2 ends[] = {from, p.screen};
  paint_dashes(draw(), ends, false, rgb(0x1C2025, 0.45f), 4, 6, 4);
  paint_dashes(draw(), ends, false, theme().accent, 2, 6, 4);
  draw().AddCircleFilled(p.screen, 5, theme().accent);
}

class EditSkeletonTool : public Tool {
 public:
  void pointer(App& app, const Pointer& p, const Stage& stage) override {
    const Joints joints(app);
    if (p.pressed) {
      gesture_ = app.session.begin_gesture();
      begun_ = {};
      joint_ = joints.under(p, stage);
      if (joint_ >= 0)
        app.session.selection.joint = joint_;
      else if (app.session.selection.joint >= 0)
        add_child(app, joints, p);
      return;
    }
    if (!(p.dragging && p.moved && app.session.goes_on(gesture_))) return;
    if (begun_.joint >= 0)
      end_bone(app, p);
    else if (joint_ >= 0 && joint_ < int(joints.posed.size()))
      move_joint(app, joint_, p.at);
  }

  void paint(const App& app, const Pointer& p, const Stage& stage) const override {
    const Joints joints(app);
    const auto screen = [&](int joint) {
      return stage.on.of(joints.camera.project(joints.posed[std::size_t(joint)].translation()));
    };
    if (!p.hovered) return;
    const int under = joints.under(p, stage), chosen = app.session.selection.joint;
    if (under >= 0) draw().AddCircle(screen(under), 14, theme().accent, 0, 1.5f);
    if (!p.held && under < 0 && chosen >= 0) paint_next_bone(p, screen(chosen));
  }

  std::string hint(const App& app) const override {
    return app.session.selection.joint >= 0
               ? "Beside the joint, a click adds the next one, a drag a whole bone.  F2 names, "
                 "Delete "
                 "removes, Esc lets go."
               : "Drag joints to where they belong; every drawing follows.";
  }
  void cancel(App&) override { joint_ = begun_.joint = -1; }

 private:
  struct Joints {
    FrameCamera camera;
    std::vector<Transform> posed;
    explicit Joints(const App& app)
        : camera(frame_camera(app.document(), app.session.selection.frame)),
          posed(posed_joints(app.document().skeleton, app.drawn_pose())) {}
    int under(const Pointer& p, const Stage& stage) const {
      return joint_at(posed, camera, stage.on, p.screen);
    }
  };

  void add_child(App& app, const Joints& joints, const Pointer& p) {
    const int parent = app.session.selection.joint;
    const Transform& above = joints.posed[std::size_t(parent)];
    const Vec3 offset = above.inverse() * as_deep_as(above, joints.camera, p.at);
    const int at = app.document().skeleton.size();
    app.session.commit("Add joint",
                       with_joint_added(app.document(), parent, offset, app.view.both_sides));
    app.session.selection.joint = at;
    app.session.go_on_amending();
    begun_ = {app.document(), Joints(app).posed[std::size_t(at)], parent, at};
  }

  // The bone that begins with the joint just added ends under the pointer. What it hangs on stays
  // chosen, for the next limb.
  void end_bone(App& app, const Pointer& p) const {
    constexpr float kShortest = 16;  // points: a click may slip
    if (apart(p.from, p.screen) < kShortest) return;
    const Vec3 end = as_deep_as(begun_.start, Joints(app).camera, p.at);
    app.session.change("Add joint",
                       with_joint_added(begun_.document, begun_.joint, begun_.start.inverse() * end,
                                        app.view.both_sides));
    app.session.selection.joint = begun_.parent;
  }

  long gesture_ = 0;
  int joint_ = -1;  // that is dragged
  // What a press beside the chosen joint began.
  struct {
    Document document;                        // with the joint that it added
    Transform start = Transform::Identity();  // of that joint, as it is drawn
    int parent = -1, joint = -1;
  } begun_;
};

}  // namespace

ToolRow edit_skeleton_tool() {
  return {.id = "edit",
          .mode = Mode::skeleton,
          .name = "Edit",
          .icon = icon::kCursorDefaultOutline,
          .key = ImGuiKey_V,
          .make = make_tool<EditSkeletonTool>,
          .usual = true};
}

}  // namespace artisketch
