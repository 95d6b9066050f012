#include "editor/modes/outline/copy_to.h"

#include <algorithm>
#include <set>

#include "document/edit.h"
#include "document/outline_edit.h"
#include "editor/canvas/pointer.h"
#include "editor/modes/outline/outline_edits.h"
#include "editor/ui/menu.h"

namespace artisketch {
namespace {

std::set<int> chosen_joints(const App& app) {
  std::set<int> joints;
  for (const int i : app.session.chosen_outlines())
    joints.insert(app.frame().contours[std::size_t(i)].joint);
  return joints;
}

// Which outlines of a drawing are of those parts.
ContourSet of_joints(const Frame& frame, const std::set<int>& joints) {
  ContourSet found;
  for (int i = 0; i < int(frame.contours.size()); ++i)
    if (joints.contains(frame.contours[std::size_t(i)].joint)) found.insert(i);
  return found;
}

void lay_copies(App& app, int to, bool replaces) {
  const ContourSet chosen = app.session.chosen_outlines();
  const std::string words = "Copy " + outlines_words(app, chosen);
  const std::vector<LooseOutline> loose =
      loose_outlines(app.document(), app.session.selection.frame, chosen);
  Document next = app.document();
  if (replaces) {
    const ContourSet own = of_joints(next.frames[std::size_t(to)], chosen_joints(app));
    next = without_contours(std::move(next), to, own);
  }
  app.session.selection.frame = to;
  lay(app, words, std::move(next), loose);
}

void copy_or_ask(App& app, int to) {
  const Frame& there = app.document().frames[std::size_t(to)];
  const ContourSet own = of_joints(there, chosen_joints(app));
  if (own.empty()) return lay_copies(app, to, false);
  const std::string drawing = drawing_words(app.document(), to);
  Question question;
  question.title = drawing + " has that part already";
  question.words = own.size() == 1 ? "Its outline there can make room for the copy, or stay."
                                   : "Its outlines there can make room for the copy, or stay.";
  question.answers = {{"Replace", [&app, to] { lay_copies(app, to, true); }, true},
                      {"Keep both", [&app, to] { lay_copies(app, to, false); }},
                      {"Cancel", {}}};
  app.question = std::move(question);
}

}  // namespace

void copy_to(App& app) {
  if (app.document().frames.size() == 2) return copy_or_ask(app, 1 - app.session.selection.frame);
  app.view.choosing_copy = true;
}

void copy_menu(App& app, const Rect& canvas) {
  constexpr float kMargin = 16;  // points
  ImGui::SetNextWindowPos({canvas.x + kMargin, canvas.y + kMargin}, ImGuiCond_Appearing);
  Menu menu("drawings to copy to", std::exchange(app.view.choosing_copy, false));
  if (!menu || app.session.selection.contour < 0) return;
  for (int f = 0; f < int(app.document().frames.size()); ++f) {
    if (f == app.session.selection.frame) continue;
    const bool has = !of_joints(app.document().frames[std::size_t(f)], chosen_joints(app)).empty();
    if (menu.line("Copy to " + drawing_words(app.document(), f), has ? "outlined" : ""))
      copy_or_ask(app, f);
  }
}

}  // namespace artisketch
