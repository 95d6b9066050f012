// Fatness: dragged sideways, a part gets thinner or fatter.
#include <cmath>

#include "document/animate.h"
#include "document/posing.h"
#include "editor/canvas/pointer.h"
#include "editor/session/app.h"
#include "editor/ui/icons.h"
#include "editor/ui/ui.h"

namespace artisketch {
namespace {

// The drawn part whose bone passes nearest to the pointer; −1: none is near.
int part_near(const App& app, const ModelStage& stage, const Pointer& p) {
  const Skeleton& skeleton = app.document().skeleton;
  if (skeleton.size() != int(stage.joints.size())) return -1;
  const OnScreen as_it_is{{0, 0}, 1};
  int near = -1;
  float nearest = 48;  // points
  for (const int joint : drawn_joints(app.document())) {
    const ImVec2 a = stage.projection.project(stage.joints[std::size_t(joint)]),
                 b = stage.projection.project(
                     stage.joints[std::size_t(end_of_bone(skeleton, joint))]);
    const Polyline bone{{Vec2(a.x, a.y), Vec2(b.x, b.y)}, false};
    if (const OnLine on = nearest_on(bone, as_it_is, p.screen); on.distance < nearest) {
      nearest = on.distance;
      near = joint;
    }
  }
  return near;
}

class FatnessTool : public Tool {
 public:
  void pointer(App& app, const Pointer& p, const Stage& stage) override {
    constexpr double kPointsToDouble = 150;
    if (p.pressed) {
      joint_ = part_near(app, *stage.model, p);
      if (joint_ >= 0) {
        gesture_ = app.session.begin_gesture();
        app.session.selection.joint = joint_;
        from_ = fatness_of(app.document(), joint_);
      }
    }
    if (!p.held) joint_ = -1;
    if (joint_ < 0 || !p.dragging || !p.moved || !app.session.goes_on(gesture_)) return;
    const double by = double(p.screen.x - p.from.x) / kPointsToDouble;
    app.session.change("Fatness of " + part_words(app, joint_),
                       with_fatness(app.document(), joint_, from_ * std::exp2(by)));
  }

  void paint(const App& app, const Pointer& p, const Stage& stage) const override {
    const ModelStage& model = *stage.model;
    const int shown = joint_ >= 0 ? joint_ : part_near(app, model, p);
    for (const int joint : drawn_joints(app.document())) {
      const int end = end_of_bone(app.document().skeleton, joint);
      if (std::max(joint, end) >= int(model.joints.size())) continue;
      const Vec3 middle = (model.joints[std::size_t(joint)] + model.joints[std::size_t(end)]) / 2;
      const ImVec2 at = model.projection.project(middle);
      record("Fatness of " + part_words(app, joint), {at.x - 5, at.y - 5, 10, 10}, true,
             joint == joint_);
      draw().AddCircleFilled(at, joint == shown ? 6.0f : 4, rgb(0xFFFFFF));
      draw().AddCircleFilled(at, joint == shown ? 4.5f : 2.75f, joint_tint(joint));
    }
    if (shown >= 0 && p.hovered) paint_tag(app, p, shown);
  }

  std::string hint(const App&) const override {
    return "Drag a part sideways: thinner or fatter.  Reconstruct joins it again.";
  }
  void cancel(App&) override { joint_ = -1; }
  bool holds_pointer() const override { return joint_ >= 0; }
  bool shows_parts() const override { return true; }

 private:
  static void paint_tag(const App& app, const Pointer& p, int joint) {
    const std::string words =
        part_words(app, joint) + "  " +
        std::to_string(int(std::lround(100 * fatness_of(app.document(), joint)))) + " %";
    const Rect tag{p.screen.x + 14, p.screen.y - 34, text_width(Font::caption_bold, words) + 20,
                   26};
    draw().AddRectFilled(tag.min(), tag.max(), rgb(0x1F2227, 0.95f), 13);
    write(tag, Font::caption_bold, rgb(0xE8EAED), words, Align::centre);
  }

  long gesture_ = 0;
  int joint_ = -1;   // whose part is dragged
  double from_ = 1;  // its fatness as the drag found it
};

}  // namespace

ToolRow fatness_tool() {
  return {.id = "fatness",
          .mode = Mode::result,
          .name = "Fatness",
          .icon = icon::kArrowExpand,
          .key = ImGuiKey_W,
          .make = make_tool<FatnessTool>,
          .about = "Drag a part sideways: thinner or fatter"};
}

}  // namespace artisketch
