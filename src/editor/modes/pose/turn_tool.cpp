// Turn: wherever it is dragged, the whole body turns like a ball.
#include <algorithm>

#include "document/posing.h"
#include "editor/modes/pose/pose_edits.h"
#include "editor/session/app.h"
#include "editor/ui/icons.h"

namespace artisketch {
namespace {

class TurnTool : public Tool {
 public:
  void pointer(App& app, const Pointer& p, const Stage& stage) override {
    if (p.pressed) app.session.begin_gesture();
    if (!p.dragging || !p.moved) return;
    const ImVec2 centre = stage.place.centre();
    const Vec2 to(p.screen.x - centre.x, p.screen.y - centre.y);
    const double radius = 0.4 * std::min(stage.place.w, stage.place.h);
    turn_body(app, ball_turn(to - Vec2(p.delta.x, p.delta.y), to, radius));
  }

  std::string hint(const App&) const override { return "Drag: the whole body turns like a ball."; }
};

}  // namespace

ToolRow turn_tool() {
  return {.id = "turn",
          .mode = Mode::pose,
          .name = "Turn",
          .icon = icon::kRotate3d,
          .key = ImGuiKey_A,
          .make = make_tool<TurnTool>,
          .about = "Turn the whole body"};
}

}  // namespace artisketch
