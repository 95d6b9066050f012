#include "editor/modes/pose/fit_paint.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "document/edit.h"
#include "editor/canvas/pointer.h"
#include "editor/canvas/sketch_paint.h"
#include "editor/session/live.h"
#include "editor/session/part_fit.h"
#include "editor/ui/ui.h"

namespace artisketch {
namespace {

constexpr float kHairs = 7;      // points from one to the next
constexpr double kLongest = 32;  // pixels; what is farther off needs no exact hair
constexpr unsigned kAmber = 0xE58A00, kRed = 0xDB3434, kInk = 0x1C2025;

void paint_hairs(const FitMarks& marks, const OnScreen& on) {
  for (const std::vector<EdgePoint>& loop : marks.edge) {
    float since = kHairs;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const EdgePoint& p = loop[i];
      if (i > 0) since += apart(on.of(p.at), on.of(loop[i - 1].at));
      const double off = p.off();
      if (off <= kOff || since < kHairs) continue;
      since = 0;
      const Vec2 end = p.at + std::min(1.0, kLongest / off) * (p.outline - p.at);
      draw().AddLine(on.of(p.at), on.of(end), rgb(off > kFarOff ? kRed : kAmber, 0.95f), 1.5f);
    }
  }
}

void paint_edge(const FitMarks& marks, const OnScreen& on) {
  for (const std::vector<EdgePoint>& loop : marks.edge) {
    Polyline line;
    for (const EdgePoint& p : loop) line.points.push_back(p.at);
    const std::vector<ImVec2> points = on_screen(line, on);
    draw().AddPolyline(points.data(), int(points.size()), rgb(0xFFFFFF, 0.55f), ImDrawFlags_Closed,
                       2.75f);
    draw().AddPolyline(points.data(), int(points.size()), rgb(kInk, 0.9f), ImDrawFlags_Closed,
                       1.25f);
  }
}

// Of the pose as shown; pixels.
double off_here(const App& app, int joint) {
  const bool theirs = app.session.proposal && app.session.proposal->theirs();
  return theirs ? distance_in(app.session.proposal->fits, joint, app.session.selection.frame)
                : distance_of(app, joint, app.session.selection.frame);
}

bool overlap(const Rect& a, const Rect& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

// The tag where nothing floats, as near as may be; where it is if there is no such place.
Rect clear_of(const Rect& tag, const std::vector<Rect>& floating, const Rect& place) {
  const auto clear = [&](const Rect& at) {
    return std::none_of(floating.begin(), floating.end(),
                        [&](const Rect& over) { return overlap(at, over); });
  };
  if (clear(tag)) return tag;
  constexpr float kStep = 10, kMargin = 8;
  Rect best = tag;
  float least = std::numeric_limits<float>::infinity();
  for (float y = place.y + kMargin; y + tag.h + kMargin <= place.bottom(); y += kStep)
    for (float x = place.x + kMargin; x + tag.w + kMargin <= place.right(); x += kStep) {
      const Rect at{x, y, tag.w, tag.h};
      const float way = apart(at.min(), tag.min());
      if (way < least && clear(at)) least = way, best = at;
    }
  return best;
}

// What the longest stretch belongs to, and how far it is off, beside it.
void paint_tag(const App& app, const PartMarks& part, const Rect& place,
               const std::vector<Rect>& floating, const OnScreen& on) {
  const double off = off_here(app, part.joint);
  const std::string words =
      part_words(app, part.joint) + " " + std::to_string(int(std::lround(off))) + " px off";
  const float width = text_width(Font::caption_bold, words) + 36, height = 26;
  const ImVec2 at = on.of(part.marks.middle.at);
  const float reach = 24 + on.zoom * float(part.marks.middle.off());
  const Vec2 out = part.marks.outward;
  Rect tag{at.x + reach * float(out.x()) + (out.x() < 0 ? -width : 0),
           at.y + reach * float(out.y()) - height / 2, width, height};
  tag.x = std::clamp(tag.x, place.x + 8, std::max(place.x + 8, place.right() - width - 8));
  tag.y = std::clamp(tag.y, place.y + 8, std::max(place.y + 8, place.bottom() - height - 8));
  tag = clear_of(tag, floating, place);
  draw().AddRectFilled(tag.min(), tag.max(), rgb(0x1F2227, 0.95f), height / 2);
  draw().AddCircleFilled({tag.x + 14, tag.centre().y}, 5, joint_tint(part.joint));
  record("Tag " + words, tag);
  tag.cut_left(24);
  write(tag, Font::caption_bold, rgb(0xE8EAED), words);
}

// While a pose is dragged the parts of a moment ago tell enough; after a leap they tell nothing. A
// drawing without a pose isn't judged.
bool tell(const App& app) {
  if (!is_posed(app.document(), app.session.selection.frame)) return false;
  return app.session.live.revision == app.session.history.revision() ||
         ImGui::IsMouseDown(ImGuiMouseButton_Left);
}

}  // namespace

void paint_fit_marks(App& app, const OnScreen& on) {
  if (!tell(app)) return;
  const std::vector<PartMarks>& parts = marks_of_drawing(app);
  for (const PartMarks& part : parts) paint_hairs(part.marks, on);
  for (const PartMarks& part : parts) paint_edge(part.marks, on);
}

void paint_fit_tag(App& app, const Rect& place, const std::vector<Rect>& floating,
                   const OnScreen& on) {
  if (!tell(app)) return;
  const PartMarks* longest = nullptr;
  for (const PartMarks& part : marks_of_drawing(app)) {
    if (off_here(app, part.joint) <= kOff) continue;
    if (part.marks.stretch > 0 && (!longest || part.marks.stretch > longest->marks.stretch))
      longest = &part;
  }
  if (longest) paint_tag(app, *longest, place, floating, on);
}

}  // namespace artisketch
