// What a drawing lacks, said once on tablets, whose sheet has no room for rings in all drawings.
#include "document/edit.h"
#include "editor/canvas/pointer.h"
#include "editor/shell/panels.h"

namespace artisketch {
namespace {

// While most are missing, they are still being drawn.
std::vector<int> missing_parts(const Work& work) {
  std::vector<int> missing;
  const std::vector<int> parts = parts_to_draw(work.document());
  for (const int joint : parts)
    if (fit_of(work, joint, work.view.frame) == Fit::missing) missing.push_back(joint);
  if (2 * missing.size() > parts.size()) missing.clear();
  return missing;
}

// "Forearm L, Hand L and Foot L"
std::string listed(const Work& work, const std::vector<int>& joints) {
  std::string words;
  for (std::size_t i = 0; i < joints.size(); ++i)
    words += (i == 0 ? "" : i + 1 == joints.size() ? " and " : ", ") + part_words(work, joints[i]);
  return words;
}

std::string counted(std::size_t parts) {
  return parts == 1 ? "1 part" : std::to_string(parts) + " parts";
}

}  // namespace

std::optional<Rect> missing_card_place(const Work& work, const Layout& layout) {
  const View& view = work.view;
  if (!layout.tablet || layout.swapped || view.exporting || view.mode != Mode::outline ||
      work.outline || !work.has_frame() || view.missing_seen.count(view.frame) > 0 ||
      missing_parts(work).empty())
    return std::nullopt;
  return Rect{12, layout.canvas.bottom() - 96, layout.view.x - 24, 84};
}

void missing_card(Work& work, const Layout& layout) {
  const std::optional<Rect> place = missing_card_place(work, layout);
  if (!place) return;
  const Theme& t = theme();
  View& view = work.view;
  const std::vector<int> missing = missing_parts(work);
  const Panel panel("Missing", *place, t.panel, Panel::Layer::floating, kRadiusPanel);
  Rect row = place->inset(12);
  draw().AddCircle({row.x + 10, row.y + 14}, 6, t.warning, 0, 2);
  row.cut_left(30);
  Look close;
  close.icon = icon::kClose;
  close.quiet = true;
  close.hint = "Leave them missing";
  if (icon_button("Leave missing", row.cut_right(44).middle(44, 44), close))
    view.missing_seen.insert(view.frame);
  row.cut_right(4);
  Look hide;
  hide.icon = icon::kEyeOff;
  hide.id = "Hide all missing";
  hide.hint = "This drawing doesn't show them";
  if (button("Hidden here", row.cut_right(132).middle(132, 44), hide)) {
    Document next = work.document();
    for (const int joint : missing) next = with_hidden(std::move(next), view.frame, joint, true);
    work.commit("Hide " + counted(missing.size()), std::move(next));
  }
  row.cut_right(8);
  write(row.cut_top(24), Font::body_bold, t.text,
        counted(missing.size()) + (missing.size() == 1 ? " is" : " are") + " missing in " +
            drawing_words(work.document(), view.frame));
  write_lines(row, Font::caption, t.muted, listed(work, missing) + ". Other drawings can stand in.",
              16);
}

}  // namespace artisketch
