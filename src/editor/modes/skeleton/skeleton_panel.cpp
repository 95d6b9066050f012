#include "editor/modes/skeleton/skeleton_panel.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "document/edit.h"
#include "document/skeleton_edit.h"
#include "editor/canvas/controls.h"
#include "editor/session/files.h"

namespace artisketch {
namespace {

constexpr float kCardMargin = 6;

// A template as a small stick figure: long bodies from the side, a spider from above.
void stick_figure(Template kind, const Rect& place, ImU32 colour) {
  const Skeleton skeleton = template_skeleton(kind);
  std::vector<Vec2> points;
  Box2 box;
  for (const Vec3& p : rest_positions(skeleton)) {
    switch (kind) {
      case Template::quadruped:
      case Template::fish:
        points.push_back({-p.z() + 0.3 * p.x(), -p.y() + 0.2 * p.x()});
        break;
      case Template::spider:
        points.push_back({p.x(), p.z()});
        break;
      default:
        points.push_back({p.x(), -p.y()});
    }
    box.extend(points.back());
  }
  const Vec2 size = box.sizes().cwiseMax(0.2);
  const float zoom = float(std::min(place.w / size.x(), place.h / size.y()));
  const auto at = [&](int j) {
    const Vec2 p = points[std::size_t(j)] - box.center();
    return ImVec2{place.centre().x + zoom * float(p.x()), place.centre().y + zoom * float(p.y())};
  };
  for (int j = 1; j < skeleton.size(); ++j)
    draw().AddLine(at(skeleton.joints[std::size_t(j)].parent), at(j), colour, 2);
  for (int j = 0; j < skeleton.size(); ++j)
    draw().AddCircleFilled(at(j), skeleton.size() == 1 ? 4.0f : 2.2f, colour);
}

void template_card(App& app, const TemplateWords& words, const Rect& card) {
  const Theme& t = theme();
  const Press press = press_area(std::string("Template ") + words.name, card);
  draw().AddRectFilled(card.min(), card.max(), press.hovered ? t.hover : t.control, kRadiusCard);
  Rect inside = card.inset(kCardMargin, 8);
  write(inside.cut_bottom(18), Font::caption, t.text, words.name, Align::centre);
  stick_figure(words.kind, inside.inset(6, 4), press.hovered ? t.accent : t.muted);
  if (press.hovered) tooltip(words.about, "");
  if (press.clicked) begin_with_template(app, words.kind);
}

// The chosen joint's name, to type over.
void name_row(App& app, Rect row) {
  const Theme& t = theme();
  const int joint = app.session.selection.joint;
  Naming& naming = app.session.naming;
  const std::string& name = app.document().skeleton.joints[std::size_t(joint)].name;
  const JointWords words = joint_words(name);
  if (naming.joint != joint || naming.of != name) naming = {joint, name, words.name, naming.begin};
  draw().AddCircleFilled({row.x + 8, row.centre().y}, 7, joint_tint(joint));
  row.cut_left(26);
  if (!words.side.empty()) {
    write_name(row.cut_right(18), Font::small, t.muted, shown_side(words), Align::right);
    row.cut_right(6);
  }
  const bool entered = text_field("Joint name", row, naming.typed, naming.begin);
  // The keyboard arrives some frames later: a window that rests must not wait for the first key.
  if (std::exchange(naming.begin, false)) app.services.platform.request_frame();
  if (!entered && !ImGui::IsItemDeactivatedAfterEdit()) return;
  if (naming.typed == words.name) return;
  Document next = with_joint_renamed(app.document(), joint, naming.typed);
  if (next.skeleton.joints[std::size_t(joint)].name != name)
    app.session.commit("Rename " + words.whole(), std::move(next));
}

std::string fellow_words(const App& app) {
  const std::vector<Joint>& joints = app.document().skeleton.joints;
  const int mirror = joints[std::size_t(app.session.selection.joint)].mirror;
  if (mirror < 0) return "Has no mirror image";
  if (mirror == app.session.selection.joint) return "In the middle";
  return "Mirror image of " + joint_words(joints[std::size_t(mirror)].name).whole();
}

void chosen_joint(App& app, Rect& place) {
  const Theme& t = theme();
  if (app.session.selection.joint < 0) {
    const float taken = write_lines(place.inset(16, 0), Font::body, t.muted,
                                    "Choose a joint to move or name it. Then a click beside it "
                                    "adds the next one.",
                                    20);
    place.cut_top(taken + 12);
    return;
  }
  name_row(app, place.cut_top(34).inset(16, 0));
  place.cut_top(6);
  write(place.cut_top(20).inset(42, 0), Font::caption, t.muted, fellow_words(app));
  place.cut_top(8);
  Rect row = place.cut_top(34).inset(16, 0);
  command_button(app, "equalise", row.cut_left(row.w / 2 - 4));
  row.cut_left(8);
  command_button(app, "delete_joint", row);
  place.cut_top(10);
}

void size_row(App& app, Rect row) {
  const Theme& t = theme();
  write(row.cut_left(row.w - 72), Font::body, t.text, "Size of the whole");
  Look look;
  look.icon = icon::kMinus;
  look.hint = "Make the skeleton smaller";
  const auto scale = [&](double factor) {
    app.session.commit("Scale skeleton", with_figure_scaled(app.document(), factor));
  };
  constexpr double kStep = 1.03;
  if (icon_button("Smaller skeleton", row.cut_left(34), look)) scale(1 / kStep);
  row.cut_left(4);
  look.icon = icon::kPlus;
  look.hint = "Make the skeleton larger";
  if (icon_button("Larger skeleton", row, look)) scale(kStep);
}

void both_sides_box(App& app, const Rect& place) {
  bool on = app.view.both_sides;
  if (checkbox("Both sides alike", place, on)) app.ask("both_sides");
}

// In so many columns, or as many as hold the longest name.
void template_cards(App& app, Rect place, int columns) {
  const float gap = 8;
  float widest = 0;
  for (const TemplateWords& words : all_templates())
    widest = std::max(widest, text_width(Font::caption, words.name) + 2 * kCardMargin);
  columns = std::clamp(int((place.w + gap) / (widest + gap)), 1, columns);
  const float width = (place.w - gap * float(columns - 1)) / float(columns);
  const int count = int(all_templates().size()), rows = (count + columns - 1) / columns;
  const float height = std::min(92.0f, (place.h - gap * float(rows - 1)) / float(rows));
  for (int i = 0; i < count; ++i)
    template_card(app, all_templates()[std::size_t(i)],
                  {place.x + float(i % columns) * (width + gap),
                   place.y + float(i / columns) * (height + gap), width, height});
}

}  // namespace

void skeleton_sheet(App& app, Rect place) {
  if (app.session.selection.joint < 0)
    return template_cards(app, place.inset(12, 14), int(all_templates().size()));
  place = place.inset(16, 20);
  Rect row = place.cut_top(44);
  size_row(app, row.cut_right(260).middle(260, 34));
  row.cut_right(24);
  name_row(app, row);
  place.cut_top(12);
  row = place.cut_top(44);
  both_sides_box(app, row.cut_right(260).middle(260, 30));
  row.cut_left(26);
  write(row, Font::caption, theme().muted, fellow_words(app));
}

void skeleton_panel(App& app, Rect place) {
  const Theme& t = theme();
  Rect head = place.cut_top(48).inset(16, 0);
  write(head.cut_left(text_width(Font::title, "Skeleton") + 8), Font::title, t.text, "Skeleton");
  const int joints = app.document().skeleton.size();
  write(head, Font::caption, t.muted,
        std::to_string(joints) + (joints == 1 ? " joint" : " joints"));
  chosen_joint(app, place);
  Rect both = place.cut_top(30).inset(16, 0);
  key_cap(both.cut_right(24).middle(24, 18), "X");
  both_sides_box(app, both);
  size_row(app, place.cut_top(34).inset(16, 0));
  place.cut_top(14);
  hairline({place.x + 16, place.y}, {place.right() - 16, place.y + 1});
  place.cut_top(6);
  write(place.cut_top(34).inset(16, 0), Font::title, t.text, "Start from");
  place.cut_top(4);
  template_cards(app, place.inset(16, 0), 3);
}

}  // namespace artisketch
