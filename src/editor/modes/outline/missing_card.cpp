#include "editor/modes/outline/missing_card.h"

#include "document/edit.h"
#include "editor/canvas/pointer.h"
#include "editor/session/part_fit.h"
#include "editor/ui/ui.h"

namespace artisketch {
namespace {

// While most are missing, they are still being drawn.
std::vector<int> missing_parts(const App& app) {
  std::vector<int> missing;
  const std::vector<int> parts = parts_to_draw(app.document());
  for (const int joint : parts)
    if (fit_of(app, joint, app.session.selection.frame) == Fit::missing) missing.push_back(joint);
  if (2 * missing.size() > parts.size()) missing.clear();
  return missing;
}

std::string counted(std::size_t parts) {
  return parts == 1 ? "1 part" : std::to_string(parts) + " parts";
}

}  // namespace

std::optional<Rect> missing_card_place(const App& app, const Layout& layout) {
  const View& view = app.view;
  if (!layout.tablet || layout.swapped || view.exporting || view.mode != Mode::outline ||
      app.session.new_outline || !app.has_frame() ||
      app.session.missing_seen.count(app.session.selection.frame) > 0 || missing_parts(app).empty())
    return std::nullopt;
  return Rect{12, layout.canvas.bottom() - 96, layout.view.x - 24, 84};
}

void missing_card(App& app, const Layout& layout) {
  const std::optional<Rect> place = missing_card_place(app, layout);
  if (!place) return;
  const Theme& t = theme();
  const std::vector<int> missing = missing_parts(app);
  const Panel panel("Missing", *place, t.panel, Panel::Layer::floating, kRadiusPanel);
  Rect row = place->inset(12);
  draw().AddCircle({row.x + 10, row.y + 14}, 6, t.warning, 0, 2);
  row.cut_left(30);
  Look close;
  close.icon = icon::kClose;
  close.quiet = true;
  close.hint = "Leave them missing";
  if (icon_button("Leave missing", row.cut_right(44).middle(44, 44), close))
    app.session.missing_seen.insert(app.session.selection.frame);
  row.cut_right(4);
  Look hide;
  hide.icon = icon::kEyeOff;
  hide.id = "Hide all missing";
  hide.hint = "This drawing doesn't show them";
  if (button("Hidden here", row.cut_right(132).middle(132, 44), hide)) {
    Document next = app.document();
    for (const int joint : missing)
      next = with_hidden(std::move(next), app.session.selection.frame, joint, true);
    app.session.commit("Hide " + counted(missing.size()), std::move(next));
  }
  row.cut_right(8);
  write(row.cut_top(24), Font::body_bold, t.text,
        counted(missing.size()) + (missing.size() == 1 ? " is" : " are") + " missing in " +
            drawing_words(app.document(), app.session.selection.frame));
  write_lines(row, Font::caption, t.muted,
              parts_listed(app, missing) + ". Other drawings can stand in.", 16);
}

}  // namespace artisketch
