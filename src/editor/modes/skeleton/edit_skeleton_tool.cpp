// Edit: a joint moves in every drawing. Beside a chosen joint, a click adds a child to it.
#include "document/edit.h"
#include "document/skeleton_edit.h"
#include "editor/canvas/pointer.h"
#include "editor/canvas/sketch_paint.h"
#include "editor/session/app.h"
#include "editor/ui/icons.h"
#include "editor/ui/ui.h"

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

class EditSkeletonTool : public Tool {
 public:
  void pointer(App& app, const Pointer& p, const Stage& stage) override {
    const Joints joints(app);
    if (p.pressed) {
      gesture_ = app.session.begin_gesture();
      joint_ = joints.under(p, stage);
      if (joint_ >= 0)
        app.session.selection.joint = joint_;
      else if (app.session.selection.joint >= 0)
        add_child(app, joints, p);
      return;
    }
    if (p.dragging && p.moved && app.session.goes_on(gesture_) && joint_ >= 0 &&
        joint_ < int(joints.posed.size()))
      move(app, joints, p);
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
               ? "Click beside the joint to add the next one, or drag it.  F2 names, Delete "
                 "removes, Esc lets go."
               : "Drag joints to where they belong; every drawing follows.";
  }
  void cancel(App&) override { joint_ = -1; }

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
    const Vec3 offset = above.inverse() * beneath(joints.camera, above, p.at);
    const int at = app.document().skeleton.size();
    app.session.commit("Add joint",
                       with_joint_added(app.document(), parent, offset, app.view.both_sides));
    app.session.selection.joint = joint_ = at;
    app.session.go_on_amending();
  }

  void move(App& app, const Joints& joints, const Pointer& p) const {
    const Vec3 target = beneath(joints.camera, joints.posed[std::size_t(joint_)], p.at);
    const int parent = app.document().skeleton.joints[std::size_t(joint_)].parent;
    if (parent < 0) {
      Pose pose = app.frame().pose;
      pose.root_position = target;
      app.session.change("Move body",
                         with_pose(app.document(), app.session.selection.frame, std::move(pose)));
      return;
    }
    app.session.change("Move " + part_words(app, joint_),
                       with_joint_moved(app.document(), joint_,
                                        joints.posed[std::size_t(parent)].inverse() * target,
                                        app.view.both_sides));
  }

  long gesture_ = 0;
  int joint_ = -1;  // that is dragged
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
