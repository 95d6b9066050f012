// Cut: a line right across an outline makes two of it that overlap there.
#include "document/edit.h"
#include "editor/canvas/pointer.h"
#include "editor/modes/outline/new_outline.h"
#include "editor/session/app.h"
#include "editor/ui/icons.h"
#include "editor/ui/ui.h"

namespace artisketch {
namespace {

class CutTool : public Tool {
 public:
  void pointer(App& app, const Pointer& p, const Stage&) override {
    if (p.pressed) {
      if (app.session.new_outline) keep_outline(app);
      line_ = {p.at, p.at};
    }
    if (!line_) return;
    if (p.held || p.released) line_->to = p.at;
    if (!p.released) return;
    const Line line = *line_;
    line_.reset();
    if (cut(app, line)) return;
    Toast toast;
    toast.words = "Draw the line right across one outline.";
    app.say(std::move(toast));
  }

  void paint(const App&, const Pointer&, const Stage& stage) const override {
    if (!line_) return;
    const ImVec2 a = stage.on.of(line_->from), b = stage.on.of(line_->to);
    draw().AddLine(a, b, rgb(0xFFFFFF, 0.7f), 4.5f);
    draw().AddLine(a, b, theme().error, 2);
  }

  std::string hint(const App&) const override {
    return "Drag a line across a part: it becomes two that overlap.";
  }
  bool under_way() const override { return line_.has_value(); }
  void cancel(App&) override { line_.reset(); }

 private:
  struct Line {
    Vec2 from, to;  // the sketch's pixels
  };

  // The chosen outline, else the frontmost that the line cuts right across.
  static bool cut(App& app, const Line& line) {
    Selection& selection = app.session.selection;
    std::vector<int> order;
    if (selection.contour >= 0) order.push_back(selection.contour);
    for (int i = int(app.frame().contours.size()) - 1; i >= 0; --i) order.push_back(i);
    for (int i : order) {
      std::optional<Document> next =
          with_contour_cut(app.document(), selection.frame, i, line.from, line.to);
      if (!next) continue;
      const int joint = app.frame().contours[std::size_t(i)].joint;
      app.session.commit("Cut " + part_words(app, joint), std::move(*next));
      selection.contour = int(app.frame().contours.size()) - 1;
      selection.joint = app.frame().contours.back().joint;
      return true;
    }
    return false;
  }

  std::optional<Line> line_;
};

}  // namespace

ToolRow cut_tool() {
  return {.id = "cut",
          .mode = Mode::outline,
          .name = "Cut",
          .icon = icon::kContentCut,
          .key = ImGuiKey_K,
          .make = make_tool<CutTool>};
}

}  // namespace artisketch
