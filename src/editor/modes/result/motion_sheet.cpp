#include "editor/modes/result/motion_sheet.h"

#include <algorithm>

#include "document/edit.h"
#include "editor/canvas/controls.h"
#include "editor/session/motions_in.h"
#include "editor/ui/icons.h"
#include "editor/ui/menu.h"

namespace artisketch {
namespace {

constexpr float kLine = 28;

std::string counted_words(const JointMap& map) {
  int by_person = 0, named = 0, guessed = 0;
  for (const JointMatch& match : map.matches)
    ++(match.how == Match::given ? by_person : match.how == Match::named ? named : guessed);
  std::string words = std::to_string(named) + " by name";
  if (guessed) words += ", " + std::to_string(guessed) + " guessed";
  if (by_person) words += ", " + std::to_string(by_person) + " by you";
  const int still = int(map.mover.size()) - named - guessed - by_person;
  if (still) words += ", " + std::to_string(still) + " still";
  return words;
}

const JointMatch* match_of(const JointMap& map, int joint) {
  for (const JointMatch& match : map.matches)
    if (match.joint == joint) return &match;
  return nullptr;
}

// A joint, and what moves it; a press lists what else could.
void joint_line(App& app, const DroppedMotion& dropped, int joint, Rect row) {
  const Theme& t = theme();
  const Motion& motion = dropped.motions[0];
  const JointMatch* match = match_of(dropped.made[0].map, joint);
  const std::string name = app.document().skeleton.joints[std::size_t(joint)].name;
  write(row.cut_left(104), Font::body, match ? t.text : t.muted, name);
  Look look;
  look.id = "Mover of " + name;
  look.quiet = true;
  const bool nobody =
      std::count(app.document().motion.joints.begin(), app.document().motion.joints.end(),
                 std::pair(std::string(), joint));
  look.hint = nobody                         ? "Nothing moves it, by your word"
              : !match                       ? "Nothing moves it: as at rest"
              : match->how == Match::given   ? "By your word"
              : match->how == Match::guessed ? "Guessed by the skeleton's shape"
                                             : "By its name";
  if (nobody || (match && match->how != Match::named))
    look.icon = match && match->how == Match::guessed ? icon::kHelpCircleOutline : icon::kCheck;
  const std::string mover =
      match ? motion.skeleton.joints[std::size_t(match->mover)].name : std::string("nobody");
  const bool opens = button(mover, row.middle(row.w, kLine - 2), look);
  Menu menu(("Movers of " + name).c_str(), opens);
  if (!menu) return;
  if ((nobody || (match && match->how == Match::given)) && menu.line("As found"))
    return map_joint(app, joint, std::nullopt);
  if (!nobody && menu.line("Nobody")) return map_joint(app, joint, "");
  for (const Joint& one : motion.skeleton.joints)
    if (!one.name.empty() && menu.line(one.name)) return map_joint(app, joint, one.name);
}

void switches(App& app, const DroppedMotion& dropped, Rect& column) {
  RetargetOptions options = dropped.options;
  if (checkbox("Feet stand where they stand", column.cut_top(28), options.plant_feet))
    return retarget_again(app, options.plant_feet ? "Plant feet" : "Leave feet", options);
  if (checkbox("In place", column.cut_top(28), options.in_place))
    return retarget_again(app, options.in_place ? "Move in place" : "Move over the ground",
                          options);
}

}  // namespace

void motion_sheet(App& app, const Rect& place) {
  const Theme& t = theme();
  Rect column = place;
  if (sheet_head(column.cut_top(48).inset(16, 0), "Motion")) app.view.mapping = false;
  const DroppedMotion* dropped = dropped_motion(app);
  if (!dropped) {
    app.view.mapping = false;
    return;
  }
  column = column.inset(16, 0);
  write_name(column.cut_top(22), Font::body_bold, t.text, dropped->clips[0]);
  write(column.cut_top(20), Font::caption, t.muted, counted_words(dropped->made[0].map));
  column.cut_top(4);
  const long before = app.session.history.revision();
  switches(app, *dropped, column);
  column.cut_top(6);
  column.cut_bottom(12);
  const int joints = app.document().skeleton.size();
  const Rows rows = scrolled_rows(app.session.dropped->first_row, joints, kLine, column);
  for (int j = rows.first; j < rows.end && app.session.history.revision() == before; ++j)
    joint_line(app, *dropped, j, column.cut_top(kLine));
}

}  // namespace artisketch
