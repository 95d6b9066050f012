// Pose: the model follows a joint that is dragged; I keeps the pose as a key.
#include <algorithm>

#include "document/posing.h"
#include "editor/canvas/pointer.h"
#include "editor/session/app.h"
#include "editor/ui/icons.h"
#include "editor/ui/ui.h"

namespace artisketch {
namespace {

int joint_near(const ModelStage& stage, const Pointer& p) {
  float reach = 12;  // points
  int near = -1;
  for (int j = 0; j < int(stage.joints.size()); ++j)
    if (const float distance =
            apart(stage.projection.project(stage.joints[std::size_t(j)]), p.screen);
        distance < reach) {
      reach = distance;
      near = j;
    }
  return near;
}

class PoseModelTool : public Tool {
 public:
  void pointer(App& app, const Pointer& p, const Stage& stage) override {
    const ModelStage& model = *stage.model;
    if (p.pressed) joint_ = joint_near(model, p);
    if (!p.held) joint_ = -1;
    if (joint_ < 0 || joint_ >= int(model.joints.size()) || !p.dragging) return;
    const Vec3 target =
        under_pointer(model.projection, p.screen, model.joints[std::size_t(joint_)]) - model.shift;
    app.session.playback.playing = false;
    if (joint_ < app.document().skeleton.size()) app.session.selection.joint = joint_;
    const Skeleton& skeleton = app.session.built->model.skeleton;
    app.session.playback.posed =
        with_joint_at(skeleton, app.shown_pose(), joint_, target, bones_dragged(skeleton, joint_));
  }

  void paint(const App& app, const Pointer&, const Stage& stage) const override {
    const int count = std::min(int(stage.model->joints.size()), app.document().skeleton.size());
    for (int j = 0; j < count; ++j) {
      const ImVec2 p = stage.model->projection.project(stage.model->joints[std::size_t(j)]);
      record("Pose " + part_words(app, j), {p.x - 6, p.y - 6, 12, 12}, true,
             j == app.session.selection.joint);
    }
  }

  std::string hint(const App&) const override {
    return "Drag a joint on the model.  I sets a key at the playhead, P plays.";
  }
  void cancel(App&) override { joint_ = -1; }
  bool holds_pointer() const override { return joint_ >= 0; }
  bool shows_bones() const override { return true; }

 private:
  int joint_ = -1;  // that is dragged
};

}  // namespace

ToolRow pose_model_tool() {
  return {.id = "pose",
          .mode = Mode::result,
          .name = "Pose",
          .icon = icon::kCursorMove,
          .key = ImGuiKey_V,
          .make = make_tool<PoseModelTool>,
          .usual = true};
}

}  // namespace artisketch
