#include "editor/canvas/controls.h"

#include <algorithm>
#include <cmath>

#include "document/edit.h"
#include "editor/canvas/pointer.h"
#include "editor/canvas/sketch_paint.h"

namespace artisketch {

Look command_look(const App& app, const Command& command, Look look) {
  if (!look.icon) look.icon = command.icon;
  if (look.hint.empty()) look.hint = command.about ? command.about : command.name;
  if (const std::string lacks = what_it_lacks(app, command); !lacks.empty()) look.hint = lacks;
  look.key = key_words(command, app.services.platform.mac_keys());
  look.enabled = look.enabled && available(app, command);
  look.on = look.on || (look.enabled && command.on && command.on(app));
  return look;
}

void command_button(App& app, std::string_view id, const Rect& place, Look look) {
  const Command& row = command(app, id);
  if (button(row.name, place, command_look(app, row, std::move(look)))) app.ask(row.id);
}

void command_icon(App& app, std::string_view id, const Rect& place, Look look) {
  const Command& row = command(app, id);
  look.quiet = true;
  if (icon_button(row.name, place, command_look(app, row, std::move(look)))) app.ask(row.id);
}

ImU32 ground_of(const Drawing* drawing) {
  return drawing && drawing->pale ? theme().dark_ground : theme().paper_tint;
}

void thumbnail(const App& app, const Frame& frame, const Rect& place, bool outlines) {
  const float zoom = std::min(place.w / float(std::max(1, frame.width)),
                              place.h / float(std::max(1, frame.height)));
  const OnScreen on{{place.x + (place.w - zoom * float(frame.width)) / 2,
                     place.y + (place.h - zoom * float(frame.height)) / 2},
                    zoom};
  const Drawing* drawing = app.services.drawings.of(frame);
  draw().AddRectFilled(place.min(), place.max(), ground_of(drawing), kRadiusSmall);
  const Rect paper{on.origin.x, on.origin.y, zoom * float(frame.width), zoom * float(frame.height)};
  if (drawing) show_picture(drawing->texture, paper, 1, {0, 0}, {1, 1}, theme().paper_tint);
  if (!outlines) return;
  OutlineLook look;
  look.width = 1.1f;
  look.casing = 0;
  for (const Contour& contour : frame.contours)
    paint_outline(draw(), contour.line, on, joint_tint(contour.joint), look);
}

std::string shown_side(const JointWords& words) {
  const std::string whole = tr(words.whole()), name = tr(words.name) + " ";
  return whole.starts_with(name) ? whole.substr(name.size()) : words.side;
}

void part_name(Rect row, const std::string& name, bool chosen) {
  const JointWords words = joint_words(name);
  const Font face = chosen ? Font::body_bold : Font::body;
  write(row.cut_left(std::min(row.w, text_width(face, words.name) + 1)), face, theme().text,
        words.name);
  row.cut_left(5);
  if (!words.side.empty()) write_name(row, Font::small, theme().muted, shown_side(words));
}

void record_joints(const App& app, const OnScreen& on) {
  const FrameCamera camera = frame_camera(app.document(), app.session.selection.frame);
  const std::vector<Transform> posed = posed_joints(app.document().skeleton, app.drawn_pose());
  for (int j = 0; j < int(posed.size()); ++j) {
    const Vec3 place = posed[std::size_t(j)].translation();
    if (!camera.in_front(place)) continue;
    const ImVec2 p = on.of(camera.project(place));
    record("Joint " + part_words(app, j), {p.x - 9, p.y - 9, 18, 18}, true,
           j == app.session.selection.joint);
  }
}

void show_model(const BuiltModel& built, const ViewProjection& projection,
                const PaintOptions& options, RenderTarget& picture, float opacity,
                float pixel_ratio, float radius) {
  built.picture->paint(built.model, projection, options, picture, pixel_ratio);
  // OpenGL's pictures begin at the bottom.
  show_picture(picture.texture(), projection.place, opacity, {0, 1}, {1, 0}, IM_COL32_WHITE,
               radius);
}

Rows scrolled_rows(int& first, int count, float tall, const Rect& place) {
  const int shown = std::clamp(int(place.h / tall), 0, count);
  if (place.holds(ImGui::GetIO().MousePos)) first -= int(std::round(ImGui::GetIO().MouseWheel));
  first = std::clamp(first, 0, count - shown);
  if (shown > 0 && shown < count) {
    const float per = place.h / float(count), x = place.right() + 2;
    draw().AddRectFilled({x, place.y + per * float(first)},
                         {x + 3, place.y + per * float(first + shown)}, theme().line, 1.5f);
  }
  return {first, first + shown};
}

}  // namespace artisketch
