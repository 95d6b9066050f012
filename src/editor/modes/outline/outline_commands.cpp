// Outline: what can be done to the chosen outline, or to a new one before it is kept.
#include "document/edit.h"
#include "editor/canvas/pointer.h"
#include "editor/modes/mode_commands.h"
#include "editor/modes/outline/outline_edits.h"
#include "editor/ui/icons.h"

namespace artisketch {
namespace {

// ---------------------------------------------------------------- when they can be done

bool is_chosen(const App& app) {
  return app.has_frame() && app.session.selection.contour >= 0;
}

bool is_chosen_or_new(const App& app) {
  return is_chosen(app) || (app.has_frame() && app.session.new_outline);
}

const Contour& chosen(const App& app) {
  return app.frame().contours[std::size_t(app.session.selection.contour)];
}

bool can_join(const App& app) {
  return is_chosen(app) && app.frame().contours.size() > 1;
}

bool can_mend(const App& app) {
  if (!app.has_frame()) return false;
  const int which = app.session.new_outline ? -1 : app.session.selection.contour;
  for (const CrossingMark& mark : crossing_marks(app))
    if (mark.contour == which) return true;
  return false;
}

bool can_mirror(const App& app) {
  if (!is_chosen(app)) return false;
  const int joint = chosen(app).joint;
  const int mirror = app.document().skeleton.joints[std::size_t(joint)].mirror;
  return mirror >= 0 && mirror != joint;
}

bool can_copy(const App& app) {
  return is_chosen(app) && app.document().frames.size() > 1;
}

bool can_go_behind(const App& app) {
  return is_chosen(app) && app.session.selection.contour > 0;
}

bool can_go_in_front(const App& app) {
  return is_chosen(app) && app.session.selection.contour + 1 < int(app.frame().contours.size());
}

bool can_be_hidden(const App& app) {
  const int joint = app.session.selection.joint;
  return app.has_frame() && !app.session.new_outline && joint >= 0 &&
         contours_of(app.frame(), joint).empty();
}

// Else Backspace takes the last point of what is being drawn.
bool can_delete(const App& app) {
  return is_chosen(app) && !app.tool().under_way();
}

// ---------------------------------------------------------------- what they do

void redraw(App& app) {
  const bool anew = app.session.new_outline.has_value();
  app.session.new_outline.reset();
  app.take_up(Mode::outline, "draw");
  app.session.next.redraws = !anew;
}

void other_joint(App& app) {
  app.session.next.picks_joint ^= true;
}

void join(App& app) {
  const bool joins = !app.session.next.joins, picks = app.session.next.picks_joint;
  app.take_up(Mode::outline, "edit");
  app.session.next.joins = joins;
  app.session.next.picks_joint = picks;
}

void mend_chosen(App& app) {
  mend(app, app.session.new_outline ? -1 : app.session.selection.contour);
}

void mirror(App& app) {
  Selection& selection = app.session.selection;
  const std::string name = part_words(app, chosen(app).joint);
  std::optional<Document> next =
      with_contour_mirrored(app.document(), selection.frame, selection.contour);
  if (!next) return;
  app.session.commit("Mirror " + name, std::move(*next));
  selection.contour = int(app.frame().contours.size()) - 1;
  selection.joint = app.frame().contours.back().joint;
}

void copy_to_next(App& app) {
  Selection& selection = app.session.selection;
  const int to = (selection.frame + 1) % int(app.document().frames.size());
  app.session.commit("Copy " + part_words(app, chosen(app).joint),
                     with_contour_copied(app.document(), selection.frame, selection.contour, to));
  selection.frame = to;
  selection.contour = int(app.frame().contours.size()) - 1;
}

template <int by>
void shift(App& app) {
  Selection& selection = app.session.selection;
  app.session.commit(part_words(app, chosen(app).joint) + (by < 0 ? " behind" : " in front"),
                     with_contour_shifted(app.document(), selection.frame, selection.contour, by));
  selection.contour += by;
}

void hide_here(App& app) {
  const int joint = app.session.selection.joint;
  const bool hidden = is_hidden(app.frame(), joint);
  app.session.commit((hidden ? "Unhide " : "Hide ") + part_words(app, joint),
                     with_hidden(app.document(), app.session.selection.frame, joint, !hidden));
}

// A stretch of points about one of them, gone: as much of the line as its handle stood for.
std::vector<Vec2> without_point(const Polyline& line, int point, double reach) {
  std::vector<Vec2> kept;
  for (int i = 0; i < int(line.points.size()); ++i)
    if (i != point &&
        (line.points[std::size_t(i)] - line.points[std::size_t(point)]).norm() > reach)
      kept.push_back(line.points[std::size_t(i)]);
  return kept;
}

// The point under the pointer, where enough others stay; else the whole outline.
void delete_point_or_outline(App& app) {
  Selection& selection = app.session.selection;
  const Polyline& line = chosen(app).line;
  if (selection.point >= 0) {
    std::vector<Vec2> points = without_point(line, selection.point, 7 / app.view.sketch.zoom);
    if (points.size() >= (line.closed ? 3u : 2u))
      return app.session.commit(
          "Delete point", with_contour_points(app.document(), selection.frame, selection.contour,
                                              std::move(points)));
  }
  app.session.commit("Delete " + part_words(app, chosen(app).joint),
                     without_contour(app.document(), selection.frame, selection.contour));
  selection.contour = -1;
}

// ---------------------------------------------------------------- the rows

std::vector<Command> commands_of_whose_and_how() {
  return {
      {.id = "redraw",
       .name = "Redraw",
       .icon = icon::kPencil,
       .about = "Draw this outline anew",
       .key = ImGuiKey_D,
       .shift = true,
       .available = is_chosen_or_new,
       .run = redraw},
      {.id = "other_joint",
       .name = "Other joint",
       .icon = icon::kCrosshairsGps,
       .about = "Give the outline to the joint that you click next",
       .key = ImGuiKey_O,
       .available = is_chosen_or_new,
       .on = [](const App& app) { return app.session.next.picks_joint; },
       .run = other_joint},
      {.id = "join",
       .name = "Join",
       .icon = icon::kLink,
       .about = "Join with the outline that you click next",
       .key = ImGuiKey_J,
       .available = can_join,
       .on = [](const App& app) { return app.session.next.joins; },
       .run = join},
      {.id = "mend",
       .name = "Mend",
       .icon = icon::kAutoFix,
       .about = "Put right where the outline crosses itself",
       .key = ImGuiKey_M,
       .shift = true,
       .available = can_mend,
       .run = mend_chosen},
  };
}

std::vector<Command> commands_of_copies_and_order() {
  return {
      {.id = "mirror",
       .name = "Mirror",
       .icon = icon::kCompare,
       .about = "Mirror the outline for the other side",
       .key = ImGuiKey_M,
       .in_rail = true,
       .available = can_mirror,
       .run = mirror},
      {.id = "copy_to",
       .name = "Copy to",
       .icon = icon::kContentCopy,
       .about = "Copy the outline to the next drawing",
       .key = ImGuiKey_C,
       .in_rail = true,
       .available = can_copy,
       .run = copy_to_next},
      {.id = "behind",
       .name = "Behind",
       .icon = icon::kFlipToBack,
       .key = ImGuiKey_LeftBracket,
       .in_rail = true,
       .available = can_go_behind,
       .run = shift<-1>},
      {.id = "in_front",
       .name = "In front",
       .icon = icon::kFlipToFront,
       .key = ImGuiKey_RightBracket,
       .available = can_go_in_front,
       .run = shift<1>},
      {.id = "hidden_here",
       .name = "Hidden here",
       .icon = icon::kEyeOff,
       .about = "This drawing doesn't show the part: nothing is missing",
       .key = ImGuiKey_H,
       .shift = true,
       .available = can_be_hidden,
       .on = [](const App& app) { return is_hidden(app.frame(), app.session.selection.joint); },
       .run = hide_here},
      {.id = "delete_outline",
       .name = "Delete",
       .icon = icon::kDelete,
       .key = ImGuiKey_Delete,
       .other_key = ImGuiKey_Backspace,
       .in_rail = true,
       .available = can_delete,
       .run = delete_point_or_outline},
  };
}

}  // namespace

std::vector<Command> outline_commands() {
  std::vector<Command> all = commands_of_whose_and_how();
  for (Command& command : commands_of_copies_and_order()) all.push_back(std::move(command));
  for (Command& command : all) command.mode = Mode::outline, command.in_menu = true;
  return all;
}

}  // namespace artisketch
