// Cut: a line right across an outline makes two of it that overlap there.
#include <algorithm>

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
  void pointer(App& app, const Pointer& p, const Stage& stage) override {
    if (p.pressed) line_ = {p.at, p.at};
    if (!line_) return;
    if (p.held || p.released) line_->to = p.at;
    if (!p.released) return;
    const Line line = *line_;
    line_.reset();
    app.session.keep_new_outline();
    if (cut(app, line, stage.on)) return;
    Toast toast;
    toast.words = why_not(app, line);
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
  bool draws_lines() const override { return true; }
  void cancel(App&) override { line_.reset(); }

 private:
  struct Line {
    Vec2 from, to;  // the sketch's pixels
  };

  // A hand that stops a little before the edge meant to reach it.
  static Line lengthened(const Line& line, const OnScreen& on) {
    constexpr double kReaches = 16, kOfLength = 0.15;  // points; at each end
    const Vec2 along = line.to - line.from;
    const double length = along.norm();
    if (length < 1e-9) return line;
    const Vec2 by = along / length * std::max(kReaches / double(on.zoom), kOfLength * length);
    return {line.from - by, line.to + by};
  }

  static std::string why_not(const App& app, const Line& line) {
    for (int i = int(app.frame().contours.size()) - 1; i >= 0; --i) {
      const Contour& contour = app.frame().contours[std::size_t(i)];
      if (!contour.line.closed) continue;
      const bool within = contains(contour.line, line.from) || contains(contour.line, line.to);
      if (within)
        return "The line ends within " + part_words(app, contour.joint) +
               ": draw it from edge to edge.";
    }
    return "The line crosses no outline: draw it right across one.";
  }

  // The chosen outline, else the frontmost that the line cuts right across, else one whose edge it
  // nearly reaches.
  static bool cut(App& app, const Line& line, const OnScreen& on) {
    const Line longer = lengthened(line, on);
    const int chosen = app.session.selection.contour;
    if (chosen >= 0 && (cut(app, line, chosen) || cut(app, longer, chosen))) return true;
    for (const Line& way : {line, longer})
      for (int i = int(app.frame().contours.size()) - 1; i >= 0; --i)
        if (cut(app, way, i)) return true;
    return false;
  }

  static bool cut(App& app, const Line& line, int contour) {
    Selection& selection = app.session.selection;
    std::optional<Document> next =
        with_contour_cut(app.document(), selection.frame, contour, line.from, line.to);
    if (!next) return false;
    const int joint = app.frame().contours[std::size_t(contour)].joint;
    app.session.commit("Cut " + part_words(app, joint), std::move(*next));
    selection.contour = int(app.frame().contours.size()) - 1;
    selection.joint = app.frame().contours.back().joint;
    return true;
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
