#include "editor/modes/outline/outline_edits.h"

#include "document/edit.h"
#include "document/mend.h"
#include "editor/canvas/pointer.h"

namespace artisketch {
namespace {

constexpr double kReachToClose = 12;  // pixels between the ends of a stroke that then closes

}  // namespace

void join_with(App& app, int other) {
  Selection& selection = app.session.selection;
  app.session.next.joins = false;
  const std::string name =
      part_words(app, app.frame().contours[std::size_t(selection.contour)].joint);
  std::optional<Document> next = with_contours_joined(app.document(), selection.frame,
                                                      selection.contour, other, kReachToClose);
  if (!next) {
    Toast toast;
    toast.words = "Only outlines that touch can be joined, or strokes.";
    app.say(std::move(toast));
    return;
  }
  const int joined = selection.contour - (other < selection.contour ? 1 : 0);
  app.session.commit("Join " + name, std::move(*next));
  selection.contour = joined;
}

std::string outlines_words(const App& app, const ContourSet& contours) {
  if (contours.size() == 1)
    return part_words(app, app.frame().contours[std::size_t(*contours.begin())].joint);
  return std::to_string(contours.size()) + " outlines";
}

void lay(App& app, const std::string& undo_name, Document next,
         const std::vector<LooseOutline>& outlines) {
  Session& session = app.session;
  const int frame = session.selection.frame;
  const int before = int(next.frames[std::size_t(frame)].contours.size());
  next = with_outlines_laid(std::move(next), frame, outlines);
  const int after = int(next.frames[std::size_t(frame)].contours.size());
  if (const std::size_t left = outlines.size() - std::size_t(after - before)) {
    Toast toast;
    toast.words =
        left == 1 ? "One outline stays out: this skeleton has no such joint."
                  : std::to_string(left) + " outlines stay out: this skeleton has no such joints.";
    app.say(std::move(toast));
  }
  if (after == before) return;
  session.commit(undo_name, std::move(next));
  ContourSet laid;
  for (int i = before; i < after; ++i) laid.insert(i);
  session.selection.contour = -1;
  session.choose_outlines(laid);
}

std::vector<CrossingMark> crossing_marks(const App& app) {
  std::vector<CrossingMark> marks;
  if (!app.has_frame()) return marks;
  const Selection& selection = app.session.selection;
  const std::vector<std::optional<Vec2>>& known =
      app.session.crossings.of(app.session.history.state(), selection.frame, [&] {
        std::vector<std::optional<Vec2>> at;
        for (const Contour& contour : app.frame().contours)
          at.push_back(self_crossing(contour.line));
        return at;
      });
  for (int i = 0; i < int(known.size()); ++i)
    if (known[std::size_t(i)]) marks.push_back({i, *known[std::size_t(i)]});
  if (app.session.new_outline && app.session.new_outline->frame == selection.frame)
    if (const std::optional<Vec2> at = self_crossing(app.session.new_outline->line))
      marks.push_back({-1, *at});
  return marks;
}

void mend(App& app, int contour) {
  if (contour < 0) {
    app.session.new_outline->line = mended(app.session.new_outline->line);
    return;
  }
  const Contour& crossed = app.frame().contours[std::size_t(contour)];
  app.session.commit("Mend " + part_words(app, crossed.joint),
                     with_contour_points(app.document(), app.session.selection.frame, contour,
                                         mended(crossed.line).points));
}

}  // namespace artisketch
