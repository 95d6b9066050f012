#include "editor/modes/outline/outline_commands.h"

#include "document/edit.h"
#include "document/mend.h"
#include "editor/modes/outline/new_outline.h"

namespace artisketch {
namespace {

constexpr double kReachToClose = 12;  // pixels between the ends of a stroke that then closes

// A stretch of points about one of them, gone: as much of the line as its handle stood for.
std::vector<Vec2> without_point(const Polyline& line, int point, double reach) {
  std::vector<Vec2> kept;
  for (int i = 0; i < int(line.points.size()); ++i)
    if (i != point &&
        (line.points[std::size_t(i)] - line.points[std::size_t(point)]).norm() > reach)
      kept.push_back(line.points[std::size_t(i)]);
  return kept;
}

void remove(Work& work, const std::string& name) {
  const View& view = work.view;
  const Polyline& line = work.frame().contours[std::size_t(view.contour)].line;
  if (view.point >= 0 && view.tool() == Tool::edit) {
    std::vector<Vec2> points = without_point(line, view.point, 7 / view.zoom);
    if (points.size() >= (line.closed ? 3u : 2u)) {
      work.commit("Delete point", with_contour_points(work.document(), view.frame, view.contour,
                                                      std::move(points)));
      return;
    }
  }
  work.commit("Delete " + name, without_contour(work.document(), view.frame, view.contour));
  work.view.contour = -1;
}

void redraw(Work& work) {
  work.stroke.clear();
  if (work.outline)
    work.outline.reset();
  else
    work.view.redrawing = true;
  work.view.tool() = Tool::draw;
}

}  // namespace

bool outline_available(const Work& work, Command command) {
  const View& view = work.view;
  if (view.mode != Mode::outline || !work.has_frame()) return false;
  const bool pending = work.outline.has_value(), chosen = view.contour >= 0;
  const int contours = int(work.frame().contours.size());
  switch (command) {
    case Command::redraw:
    case Command::other_joint:
      return pending || chosen;
    case Command::mend:
      for (const CrossingMark& mark : crossing_marks(work))
        if (mark.contour == (pending ? -1 : view.contour)) return true;
      return false;
    case Command::hidden_here:
      return !pending && view.joint >= 0 && contours_of(work.frame(), view.joint).empty();
    case Command::remove:
      return chosen && work.stroke.empty();  // else Backspace takes the last point
    case Command::join:
      return chosen && contours > 1;
    case Command::behind:
      return chosen && view.contour > 0;
    case Command::in_front:
      return chosen && view.contour + 1 < contours;
    case Command::copy_to:
      return chosen && work.document().frames.size() > 1;
    case Command::mirror: {
      if (!chosen) return false;
      const int joint = work.frame().contours[std::size_t(view.contour)].joint;
      const int mirror = work.document().skeleton.joints[std::size_t(joint)].mirror;
      return mirror >= 0 && mirror != joint;
    }
    default:
      return chosen;
  }
}

void outline_command(Work& work, Command command) {
  View& view = work.view;
  if (command == Command::redraw) return redraw(work);
  if (command == Command::mend) return mend(work, work.outline ? -1 : view.contour);
  if (command == Command::other_joint) {
    view.picking_joint = !view.picking_joint;
    return;
  }
  if (command == Command::join) {
    view.joining = !view.joining;
    view.tool() = Tool::edit;
    return;
  }
  if (command == Command::hidden_here) {
    const bool hidden = is_hidden(work.frame(), view.joint);
    work.commit((hidden ? "Unhide " : "Hide ") + part_words(work, view.joint),
                with_hidden(work.document(), view.frame, view.joint, !hidden));
    return;
  }
  const int frame = view.frame, contour = view.contour;
  const Document& document = work.document();
  const int joint = work.frame().contours[std::size_t(contour)].joint;
  const std::string name = part_words(work, joint);
  if (command == Command::remove) {
    remove(work, name);
  } else if (command == Command::mirror) {
    if (std::optional<Document> next = with_contour_mirrored(document, frame, contour)) {
      work.commit("Mirror " + name, std::move(*next));
      view.contour = int(work.frame().contours.size()) - 1;
      view.joint = work.frame().contours.back().joint;
    }
  } else if (command == Command::copy_to) {
    const int to = (frame + 1) % int(document.frames.size());
    work.commit("Copy " + name, with_contour_copied(document, frame, contour, to));
    view.frame = to;
    view.contour = int(work.frame().contours.size()) - 1;
  } else {
    const int by = command == Command::behind ? -1 : 1;
    work.commit(name + (by < 0 ? " behind" : " in front"),
                with_contour_shifted(document, frame, contour, by));
    view.contour += by;
  }
}

void join_with(Work& work, int other) {
  View& view = work.view;
  view.joining = false;
  const std::string name = part_words(work, work.frame().contours[std::size_t(view.contour)].joint);
  std::optional<Document> next =
      with_contours_joined(work.document(), view.frame, view.contour, other, kReachToClose);
  if (!next) {
    Toast toast;
    toast.words = "Only outlines that touch can be joined, or strokes.";
    work.say(std::move(toast));
    return;
  }
  const int joined = view.contour - (other < view.contour ? 1 : 0);
  work.commit("Join " + name, std::move(*next));
  view.contour = joined;
}

std::vector<CrossingMark> crossing_marks(const Work& work) {
  std::vector<CrossingMark> marks;
  if (!work.has_frame()) return marks;
  const std::vector<std::optional<Vec2>>& known =
      work.crossings.of(work.history.state(), work.view.frame, [&] {
        std::vector<std::optional<Vec2>> at;
        for (const Contour& contour : work.frame().contours)
          at.push_back(self_crossing(contour.line));
        return at;
      });
  for (int i = 0; i < int(known.size()); ++i)
    if (known[std::size_t(i)]) marks.push_back({i, *known[std::size_t(i)]});
  if (work.outline && work.outline->frame == work.view.frame)
    if (const std::optional<Vec2> at = self_crossing(work.outline->line))
      marks.push_back({-1, *at});
  return marks;
}

void mend(Work& work, int contour) {
  if (contour < 0) {
    work.outline->line = mended(work.outline->line);
    return;
  }
  const Contour& crossed = work.frame().contours[std::size_t(contour)];
  work.commit(
      "Mend " + part_words(work, crossed.joint),
      with_contour_points(work.document(), work.view.frame, contour, mended(crossed.line).points));
}

}  // namespace artisketch
