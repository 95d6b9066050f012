// What one does in a mode, in three lines and a moving picture: shown at the first visit, and
// whenever it is asked for.
#include "editor/session/hints.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "editor/canvas/sketch_paint.h"
#include "editor/shell/panels.h"
#include "editor/ui/ui.h"

namespace artisketch {
namespace {

using Lines = std::array<const char*, 3>;

const Lines& lines_of(Mode mode) {
  static constexpr Lines kLines[kModes] = {
      {"Draw (D) round a part, or click it with Trace (T).",
       "Go on behind what covers it. Cut (K) makes two parts of one.",
       "Do that in every drawing that shows the part."},
      {"One skeleton serves all drawings: begin with a template.",
       "Drag joints until the bones are as long as the drawn ones.",
       "A click beside the chosen joint adds the next."},
      {"Drag hands and feet until the bones lie in their parts.",
       "Suggest (S) guesses a pose from the outlines.", "Calibrate (Shift+C) does the last bit."},
      {"Reconstruct (R) joins the parts to one model.",
       "Drag its joints; Set key (I) keeps that in a clip.",
       "Export (Ctrl+E) writes it for other programs."},
  };
  return kLines[std::size_t(mode)];
}

// ---------------------------------------------------------------- the picture

// Where a picture of 100 × 100 stands; time goes from 0 to 1, and begins again.
struct Scene {
  ImVec2 corner;
  float size = 1, time = 0;
  ImVec2 at(float x, float y) const { return {corner.x + size * x, corner.y + size * y}; }
  // From 0 to 1 between two times, gently.
  float during(float from, float to) const {
    const float t = std::clamp((time - from) / (to - from), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
  }
};

ImVec2 between(ImVec2 a, ImVec2 b, float t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

void paint_hand(const Scene& scene, ImVec2 tip, bool pressed) {
  if (pressed) draw().AddCircle(tip, 9 * scene.size, faded(theme().accent, 0.8f), 0, 1.5f);
  write_icon({tip.x + 5, tip.y + 7}, IconSize::small, theme().text, icon::kCursorDefaultOutline);
}

void paint_limb(const Scene& scene, ImVec2 a, ImVec2 b, float width, ImU32 colour) {
  draw().AddLine(a, b, colour, 2 * width * scene.size);
  for (const ImVec2 end : {a, b}) draw().AddCircleFilled(end, width * scene.size, colour);
}

void paint_bone(const Scene& scene, ImVec2 a, ImVec2 b) {
  draw().AddLine(a, b, theme().accent, 2);
  for (const ImVec2 end : {a, b}) {
    draw().AddCircleFilled(end, 3.5f * scene.size, rgb(0xFFFFFF));
    draw().AddCircle(end, 3.5f * scene.size, theme().accent, 0, 1.5f);
  }
}

// What is drawn, where limbs overlap, too.
ImU32 paper_colour() {
  return mixed(theme().canvas, theme().muted, 0.5f);
}

// A head on a body, without its arms.
void paint_doll(const Scene& scene, ImU32 colour) {
  draw().AddCircleFilled(scene.at(50, 22), 14 * scene.size, colour);
  paint_limb(scene, scene.at(50, 46), scene.at(50, 62), 11, colour);
  for (const float side : {-1.0f, 1.0f})
    paint_limb(scene, scene.at(50 + 6 * side, 66), scene.at(50 + 9 * side, 92), 5, colour);
}

// A hand draws round the head; a click outlines the body.
void outline_picture(const Scene& scene) {
  const ImU32 paper = paper_colour();
  paint_doll(scene, paper);
  const float round = scene.during(0.05f, 0.45f), clicked = scene.during(0.62f, 0.66f);
  constexpr int kSteps = 40;
  std::vector<ImVec2> head;
  for (int i = 0; i <= int(kSteps * round); ++i) {
    const float a = 2 * float(kPi) * float(i) / kSteps - 1.2f;
    head.push_back(scene.at(50 + 15.5f * std::cos(a), 22 + 15.5f * std::sin(a)));
  }
  draw().AddPolyline(head.data(), int(head.size()), joint_tint(1), 0, 2.5f);
  if (round >= 1)
    draw().AddCircleFilled(scene.at(50, 22), 15.5f * scene.size, joint_tint(1, 0.25f));
  if (clicked > 0) {
    const ImVec2 low = scene.at(37.5f, 33.5f), high = scene.at(62.5f, 74.5f);
    draw().AddRectFilled(low, high, joint_tint(0, 0.25f * clicked), 12 * scene.size);
    draw().AddRect(low, high, joint_tint(0, clicked), 12 * scene.size, 0, 2.5f);
  }
  const ImVec2 on_body = scene.at(52, 56);
  const ImVec2 hand =
      round < 1 ? head.back() : between(head.back(), on_body, scene.during(0.47f, 0.6f));
  paint_hand(scene, hand, round < 1 || (scene.time > 0.61f && scene.time < 0.7f));
}

// A joint is dragged into the drawn hand; its mirror image follows.
void skeleton_picture(const Scene& scene) {
  const ImU32 paper = paper_colour();
  paint_doll(scene, paper);
  for (const float side : {-1.0f, 1.0f})
    paint_limb(scene, scene.at(50 + 13 * side, 44), scene.at(50 + 34 * side, 60), 5, paper);
  const float out = scene.during(0.2f, 0.6f);
  paint_bone(scene, scene.at(50, 64), scene.at(50, 40));
  paint_bone(scene, scene.at(50, 40), scene.at(50, 14));
  ImVec2 hand;
  for (const float side : {-1.0f, 1.0f}) {
    const ImVec2 shoulder = scene.at(50 + 12 * side, 42);
    hand = between(scene.at(50 + 20 * side, 66), scene.at(50 + 34 * side, 60), out);
    paint_bone(scene, scene.at(50, 40), shoulder);
    paint_bone(scene, shoulder, hand);
    paint_bone(scene, scene.at(50 + 5 * side, 64), scene.at(50 + 9 * side, 92));
  }
  paint_hand(scene, hand, scene.time > 0.15f && scene.time < 0.65f);
}

// The elbow of an arm of two bones of one length.
ImVec2 elbow_of(ImVec2 shoulder, ImVec2 hand, float bone) {
  const ImVec2 d{hand.x - shoulder.x, hand.y - shoulder.y};
  const float half = std::sqrt(d.x * d.x + d.y * d.y) / 2;
  const float aside =
      std::sqrt(std::max(0.0f, bone * bone - half * half)) / std::max(1e-3f, 2 * half);
  return {shoulder.x + d.x / 2 - aside * d.y, shoulder.y + d.y / 2 + aside * d.x};
}

// A hand is dragged to where the drawing has it; the arm follows.
void pose_picture(const Scene& scene) {
  const ImU32 paper = paper_colour();
  paint_doll(scene, paper);
  const float bone = 19 * scene.size;
  const ImVec2 shoulder = scene.at(60, 42), drawn = scene.at(88, 22);
  const ImVec2 bent = elbow_of(shoulder, drawn, bone);
  paint_limb(scene, shoulder, bent, 5, paper);
  paint_limb(scene, bent, drawn, 5, paper);
  paint_limb(scene, scene.at(38, 44), scene.at(28, 74), 5, paper);
  const ImVec2 hand = between(scene.at(74, 74), drawn, scene.during(0.2f, 0.65f));
  const ImVec2 elbow = elbow_of(shoulder, hand, bone);
  paint_bone(scene, scene.at(50, 64), scene.at(50, 40));
  paint_bone(scene, scene.at(50, 40), shoulder);
  paint_bone(scene, shoulder, elbow);
  paint_bone(scene, elbow, hand);
  paint_hand(scene, hand, scene.time > 0.15f && scene.time < 0.7f);
}

// The model waves, from key to key of a clip.
void result_picture(const Scene& scene) {
  const float wave = std::sin(4 * float(kPi) * scene.time);
  draw().AddCircleFilled(scene.at(50, 18), 13 * scene.size, joint_tint(1));
  for (const float side : {-1.0f, 1.0f})
    paint_limb(scene, scene.at(50 + 6 * side, 58), scene.at(50 + 9 * side, 78), 5, joint_tint(2));
  paint_limb(scene, scene.at(50, 40), scene.at(50, 54), 11, joint_tint(0));
  paint_limb(scene, scene.at(38, 40), scene.at(30, 60), 5, joint_tint(3));
  paint_limb(scene, scene.at(62, 40), scene.at(78 + 6 * wave, 24 + 4 * wave * wave), 5,
             joint_tint(3));
  draw().AddLine(scene.at(0, 93), scene.at(100, 93), theme().line, 2);
  for (const float key : {2.0f, 34.0f, 66.0f, 98.0f})
    write_icon(scene.at(key, 93), IconSize::small, theme().muted, icon::kDiamond);
  const float x = 2 + 96 * scene.time;
  draw().AddLine(scene.at(x, 86), scene.at(x, 100), theme().accent, 2);
}

void paint_picture(Mode mode, const Rect& place, float time) {
  draw().AddRectFilled(place.min(), place.max(), theme().canvas, kRadius);
  const Rect square = place.inset(8).middle(place.h - 16, place.h - 16);
  const Scene scene{square.min(), square.h / 100, time};
  constexpr void (*kPictures[kModes])(const Scene&) = {outline_picture, skeleton_picture,
                                                       pose_picture, result_picture};
  draw().PushClipRect(place.min(), place.max(), true);
  kPictures[std::size_t(mode)](scene);
  draw().PopClipRect();
}

// ---------------------------------------------------------------- the card

constexpr float kCardPad = 12, kCardHead = 40, kHintLine = 18, kHintsApart = 6;

// Over what the mode's tools don't work on, where that stands beside it: the model, in Result the
// drawing. Else at the top of what they do.
Rect room_for_hints(const App& app, const Layout& layout) {
  if (layout.tablet || layout.inset) {
    Rect free = layout.swapped ? layout.view : layout.canvas;
    if (layout.tablet) {
      const float right = rail_place(app, layout).right();
      free.cut_left(right - free.x);
      free.cut_top(56);
    }
    return free.inset(kCardPad);
  }
  return (app.view.mode == Mode::result ? layout.canvas : layout.view).inset(kCardPad, 56);
}

}  // namespace

void hints_card(App& app, const Layout& layout) {
  if (!hints_shown(app)) return;
  const Theme& t = theme();
  const Mode mode = app.view.mode;
  const bool beside = !layout.tablet && !layout.inset;
  const Rect room = room_for_hints(app, layout);
  const float width = std::min(room.w, 340.0f);
  const float text = width - 2 * kCardPad - 14;
  float high = kCardHead + kCardPad;
  for (const char* line : lines_of(mode))
    high += lines_height(Font::body, line, text, kHintLine) + kHintsApart;
  const float picture = std::clamp(room.h - high - kCardPad, 0.0f, beside ? 132.0f : 96.0f);
  high += picture;
  const Rect place{room.x + (beside ? (room.w - width) / 2 : 0),
                   beside ? room.bottom() - high : room.y, width, high};
  const FloatingCard card("Hints", place);
  Rect column = place;
  Rect head = column.cut_top(kCardHead).inset(kCardPad, 0);
  const float ok = text_width(Font::body_bold, "Got it") + 24;
  Look done;
  done.on = true;
  if (button("Got it", head.cut_right(ok).middle(ok, layout.tablet ? 36.0f : 28.0f), done))
    close_hints(app);
  constexpr const char* kTitle[kModes] = {"Outline", "Skeleton", "Pose", "Result"};
  write(head, Font::body_bold, t.text, kTitle[std::size_t(mode)]);
  column = column.inset(kCardPad, 0);
  if (picture > 0) paint_picture(mode, column.cut_top(picture), hints_time(app));
  column.cut_top(8);
  for (const char* line : lines_of(mode)) {
    draw().AddCircleFilled({column.x + 3, column.y + kHintLine / 2}, 2.5f, t.accent);
    const Rect words{column.x + 14, column.y, text, column.h};
    column.cut_top(write_lines(words, Font::body, t.text, line, kHintLine) + kHintsApart);
  }
}

}  // namespace artisketch
