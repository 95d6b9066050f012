// Outline: what can be done to the chosen outline, or to a new one before it is kept.
#include "document/edit.h"
#include "document/outline_edit.h"
#include "document/skeleton_edit.h"
#include "editor/canvas/pointer.h"
#include "editor/modes/mode_commands.h"
#include "editor/modes/nudging.h"
#include "editor/modes/outline/copy_to.h"
#include "editor/modes/outline/outline_all.h"
#include "editor/modes/outline/outline_edits.h"
#include "editor/modes/outline/split_part.h"
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

// ---------------------------------------------------------------- things

template <Role role>
bool chosen_is(const App& app) {
  return is_chosen(app) && role_of(app.document(), chosen(app).joint) == role;
}

// Or a part of the body again.
template <Role role>
void make(App& app) {
  const int joint = chosen(app).joint;
  const Role next = chosen_is<role>(app) ? Role::body : role;
  const char* words = next == Role::held    ? " is held"
                      : next == Role::apart ? " is no part of the figure"
                                            : " is a part of the figure";
  app.session.commit(part_words(app, joint) + words, with_role(app.document(), joint, next));
}

bool can_hold(const App& app) {
  return app.has_frame() && app.session.selection.joint >= 0 && !app.session.new_outline;
}

// To be drawn next.
void hold_thing(App& app) {
  const int joint = app.session.selection.joint;
  app.session.commit("Thing held by " + part_words(app, joint),
                     with_thing_added(app.document(), joint));
  app.session.selection.joint = app.document().skeleton.size() - 1;
  app.session.selection.contour = -1;
  app.take_up(Mode::outline, "draw");
}

// ---------------------------------------------------------------- several at once

bool has_outlines(const App& app) {
  return app.has_frame() && !app.frame().contours.empty();
}

bool can_paste(const App& app) {
  return app.has_frame() && !app.services.clipboard.empty();
}

void choose_all(App& app) {
  app.take_up(Mode::outline, "arrange");
  ContourSet all;
  for (int i = 0; i < int(app.frame().contours.size()); ++i) all.insert(i);
  app.session.choose_outlines(all);
}

void copy(App& app) {
  app.services.clipboard =
      loose_outlines(app.document(), app.session.selection.frame, app.session.chosen_outlines());
  // Else an older picture of the system's clipboard would be pasted.
  ImGui::SetClipboardText(outlines_words(app, app.session.chosen_outlines()).c_str());
}

// Where one lies already, the copy lies beside it, to be seen.
void lay_beside(App& app, const std::string& verb, std::vector<LooseOutline> outlines) {
  const double aside = 12 / double(app.view.sketch.zoom);
  const Frame& frame = app.frame();
  const Document laid = with_outlines_laid(app.document(), app.session.selection.frame, outlines);
  const std::vector<Contour>& all = laid.frames[std::size_t(app.session.selection.frame)].contours;
  bool covered = false;
  for (std::size_t i = frame.contours.size(); i < all.size(); ++i)
    for (const Contour& own : frame.contours)
      covered |= own.line.points.size() == all[i].line.points.size() &&
                 (own.line.points.front() - all[i].line.points.front()).norm() < aside;
  const std::string words = outlines.size() == 1 ? joint_words(outlines[0].joint).whole()
                                                 : std::to_string(outlines.size()) + " outlines";
  if (covered)
    for (LooseOutline& loose : outlines)
      for (Vec2& p : loose.line.points) p += aside * Vec2(1, 1);
  app.take_up(Mode::outline, "arrange");
  lay(app, verb + words, app.document(), outlines);
}

void paste(App& app) {
  lay_beside(app, "Paste ", app.services.clipboard);
}

void duplicate(App& app) {
  lay_beside(
      app, "Duplicate ",
      loose_outlines(app.document(), app.session.selection.frame, app.session.chosen_outlines()));
}

void simplify(App& app) {
  constexpr double kError = 0.5;  // pixels: half of what is drawn of an edge
  const ContourSet chosen = app.session.chosen_outlines();
  Document next =
      with_contours_simplified(app.document(), app.session.selection.frame, chosen, kError);
  app.session.commit("Simplify " + outlines_words(app, chosen), std::move(next));
}

void nudge(App& app, const Vec2& by) {
  const ContourSet chosen = app.session.chosen_outlines();
  PictureMap map = PictureMap::Identity();
  map.translate(by);
  app.session.change(
      "Move " + outlines_words(app, chosen),
      with_contours_mapped(app.document(), app.session.selection.frame, chosen, map));
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
  const ContourSet chosen_ones = app.session.chosen_outlines();
  app.session.commit("Delete " + outlines_words(app, chosen_ones),
                     without_contours(app.document(), selection.frame, chosen_ones));
  selection.contour = -1;
}

// ---------------------------------------------------------------- the rows

std::vector<Command> commands_of_whose_and_how() {
  return {
      {.id = "outline_all",
       .name = "Outline all",
       .icon = icon::kAutoFix,
       .about = "Outline every part that has none here, each about its posed bone",
       .key = ImGuiKey_T,
       .shift = true,
       .available = can_outline_all,
       .what_it_lacks = why_not_outline_all,
       .run = outline_all},
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
      {.id = "split_part",
       .name = "Split at a joint",
       .about = "A new joint where the part bends, its outlines cut there in every drawing",
       .key = ImGuiKey_K,
       .shift = true,
       .available = can_split_chosen,
       .run = split_chosen},
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
       .about = "Copy the outline to another drawing",
       .key = ImGuiKey_C,
       .in_rail = true,
       .available = can_copy,
       .run = copy_to},
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

std::vector<Command> commands_of_things() {
  return {
      {.id = "held",
       .name = "Held thing",
       .about = "Held before the body, a part of its own: its pixels paint nothing else",
       .available = is_chosen,
       .on = chosen_is<Role::held>,
       .run = make<Role::held>},
      {.id = "apart",
       .name = "Not of it",
       .about = "No part of the figure: it makes no surface, and its pixels paint nothing",
       .available = is_chosen,
       .on = chosen_is<Role::apart>,
       .run = make<Role::apart>},
      {.id = "hold_thing",
       .name = "New held thing",
       .about = "A part of its own that the chosen one holds, to be outlined next",
       .available = can_hold,
       .run = hold_thing},
  };
}

std::vector<Command> commands_of_several() {
  return {
      {.id = "choose_all",
       .name = "Choose all",
       .key = ImGuiKey_A,
       .ctrl = true,
       .available = has_outlines,
       .run = choose_all},
      {.id = "copy_outlines",
       .name = "Copy",
       .key = ImGuiKey_C,
       .ctrl = true,
       .in_menu = true,
       .available = is_chosen,
       .run = copy},
      {.id = "paste_outlines",
       .name = "Paste",
       .about = "Lay what was copied over the same bones of this drawing",
       .key = ImGuiKey_V,
       .ctrl = true,
       .in_menu = true,
       .available = can_paste,
       .run = paste},
      {.id = "duplicate",
       .name = "Duplicate",
       .key = ImGuiKey_D,
       .ctrl = true,
       .in_menu = true,
       .available = is_chosen,
       .run = duplicate},
      {.id = "simplify",
       .name = "Simplify",
       .about = "The fewest points that keep within half a pixel of the outline",
       .key = ImGuiKey_S,
       .shift = true,
       .in_menu = true,
       .available = is_chosen,
       .run = simplify},
  };
}

}  // namespace

std::vector<Command> outline_commands() {
  std::vector<Command> all = commands_of_whose_and_how();
  for (Command& command : commands_of_copies_and_order()) all.push_back(std::move(command));
  for (Command& command : commands_of_things()) all.push_back(std::move(command));
  for (Command& command : all) command.in_menu = true;
  for (Command& command : commands_of_several()) all.push_back(std::move(command));
  for (Command& command : nudge_commands("nudge", is_chosen, nudge))
    all.push_back(std::move(command));
  for (Command& command : all) command.mode = Mode::outline;
  return all;
}

}  // namespace artisketch
