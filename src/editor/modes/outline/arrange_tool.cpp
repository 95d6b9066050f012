// Arrange: outlines as things. Chooses one or several, and moves, scales and turns them as they
// are.
#include <array>
#include <cmath>
#include <memory>

#include "editor/canvas/pointer.h"
#include "editor/canvas/sketch_paint.h"
#include "editor/modes/outline/outline_edits.h"
#include "editor/ui/icons.h"
#include "editor/ui/theme.h"
#include "editor/ui/ui.h"

namespace artisketch {
namespace {

// The frame round what is chosen: grips at its corners and sides, and one that turns above it, or
// below where there is no room.
struct Grips {
  static constexpr float kMargin = 10, kStem = 26;  // points
  Rect box;
  bool below = false;

  // In [0, 1] of the box; the last one turns.
  static constexpr std::array<ImVec2, 9> kAt = {
      ImVec2{0, 0}, {0.5f, 0}, {1, 0}, {1, 0.5f}, {1, 1}, {0.5f, 1}, {0, 1}, {0, 0.5f}, {0.5f, 0}};
  static constexpr int kTurn = 8;

  ImVec2 place(int grip) const {
    const ImVec2& at = kAt[std::size_t(grip)];
    if (grip == kTurn) return {box.x + box.w / 2, below ? box.bottom() + kStem : box.y - kStem};
    return {box.x + at.x * box.w, box.y + at.y * box.h};
  }
  int under(ImVec2 p) const {
    int best = -1;
    float nearest = kReach + 2;
    for (int i = 0; i < int(kAt.size()); ++i)
      if (const float d = apart(place(i), p); d < nearest) nearest = d, best = i;
    return best;
  }
};

Box2 box_of(const Frame& frame, const ContourSet& contours) {
  Box2 box;
  for (const int i : contours)
    for (const Vec2& p : frame.contours[std::size_t(i)].line.points) box.extend(p);
  return box;
}

Grips grips_round(const Box2& box, const Stage& stage) {
  const ImVec2 low = stage.on.of(box.min()), high = stage.on.of(box.max());
  const float m = Grips::kMargin;
  Grips grips{{low.x - m, low.y - m, high.x - low.x + 2 * m, high.y - low.y + 2 * m}};
  grips.below = grips.box.y - Grips::kStem < stage.place.y + m;
  return grips;
}

class ArrangeTool : public Tool {
 public:
  void pointer(App& app, const Pointer& p, const Stage& stage) override {
    if (p.pressed) take_hold(app, p, stage);
    if (!p.held && !p.released) return;
    to_ = p.at;
    if (doing_ == Doing::boxes) {
      if (p.released) choose_within(app);
    } else if (doing_ != Doing::nothing) {
      if (p.dragging && p.moved) change(app, p);
      // A click, not a drag, on one of several chooses that one.
      if (p.released && doing_ == Doing::moves && clicked_ >= 0 && !moved_ && !p.shift)
        app.session.choose_outlines({clicked_});
    }
    if (p.released) doing_ = Doing::nothing;
  }

  void paint(const App& app, const Pointer& p, const Stage& stage) const override {
    const Theme& t = theme();
    if (doing_ == Doing::boxes) {
      const ImVec2 a = stage.on.of(from_), b = stage.on.of(to_);
      const ImVec2 low{std::min(a.x, b.x), std::min(a.y, b.y)},
          high{std::max(a.x, b.x), std::max(a.y, b.y)};
      draw().AddRectFilled(low, high, faded(t.accent, 0.12f));
      draw().AddRect(low, high, t.accent);
      return;
    }
    const ContourSet chosen = app.session.chosen_outlines();
    if (chosen.empty()) return;
    OutlineLook look;
    look.width = 3;
    for (const int i : chosen) {
      const Contour& contour = app.frame().contours[std::size_t(i)];
      paint_outline(draw(), contour.line, stage.on, joint_tint(contour.joint), look);
    }
    const Grips grips = grips_round(box_of(app.frame(), chosen), stage);
    draw().AddRect(grips.box.min(), grips.box.max(), t.accent, 0, 0, 1.25f);
    draw().AddLine(grips.place(grips.below ? 5 : 1), grips.place(Grips::kTurn), t.accent, 1.25f);
    const int under = p.hovered && doing_ == Doing::nothing ? grips.under(p.screen) : grip_;
    constexpr const char* kNames[] = {"Scale top left",    "Stretch top",        "Scale top right",
                                      "Stretch right",     "Scale bottom right", "Stretch bottom",
                                      "Scale bottom left", "Stretch left",       "Turn outlines"};
    for (int i = 0; i < int(Grips::kAt.size()); ++i) {
      const ImVec2 at = grips.place(i);
      const float r = i == under ? 6.5f : 5;
      record(kNames[i], {at.x - 7, at.y - 7, 14, 14});
      if (i == Grips::kTurn) {
        draw().AddCircleFilled(at, r, rgb(0xFFFFFF));
        draw().AddCircle(at, r, t.accent, 0, 1.5f);
      } else {
        draw().AddRectFilled({at.x - r, at.y - r}, {at.x + r, at.y + r}, rgb(0xFFFFFF), 2);
        draw().AddRect({at.x - r, at.y - r}, {at.x + r, at.y + r}, t.accent, 2, 0, 1.5f);
      }
    }
  }

  std::string hint(const App& app) const override {
    return app.session.chosen_outlines().empty()
               ? "Click an outline, or drag round several; Shift adds one."
               : "Drag to move; the frame's corners scale, the knob turns.  Arrow keys: 1 px, with "
                 "Shift 10.";
  }
  bool under_way() const override { return doing_ == Doing::boxes; }
  void cancel(App&) override { doing_ = Doing::nothing; }
  bool gives_outlines() const override { return true; }

 private:
  enum class Doing { nothing, boxes, moves, scales, turns };

  void take_hold(App& app, const Pointer& p, const Stage& stage) {
    gesture_ = app.session.begin_gesture();
    from_ = p.at;
    moved_ = false;
    clicked_ = grip_ = -1;
    ContourSet chosen = app.session.chosen_outlines();
    if (!chosen.empty()) {
      grip_ = grips_round(box_of(app.frame(), chosen), stage).under(p.screen);
      if (grip_ >= 0) {
        doing_ = grip_ == Grips::kTurn ? Doing::turns : Doing::scales;
        return hold(app, chosen);
      }
    }
    const int under = contour_at(app, stage.on, p.screen);
    if (under < 0) {
      doing_ = Doing::boxes;
      along_ = p.shift ? chosen : ContourSet{};
      return;
    }
    if (app.session.next.joins && app.session.selection.contour >= 0) {
      doing_ = Doing::nothing;
      return join_with(app, under);
    }
    if (p.shift) {
      if (!chosen.insert(under).second) chosen.erase(under);
      app.session.choose_outlines(chosen);
    } else if (chosen.contains(under)) {
      clicked_ = under;
    } else {
      chosen = {under};
      app.session.choose_outlines(chosen);
    }
    doing_ = chosen.contains(under) ? Doing::moves : Doing::nothing;
    hold(app, chosen);
  }

  void hold(const App& app, const ContourSet& chosen) {
    was_ = app.session.history.state();
    held_ = chosen;
    frame_ = app.session.selection.frame;
    words_ = outlines_words(app, chosen);
    box_ = box_of(app.frame(), chosen);
  }

  void change(App& app, const Pointer& p) {
    if (!app.session.goes_on(gesture_) || held_.empty()) return;
    moved_ = true;
    const char* verb = doing_ == Doing::moves   ? "Move "
                       : doing_ == Doing::turns ? "Turn "
                                                : "Scale ";
    app.session.change(verb + words_, with_contours_mapped(*was_, frame_, held_, map(p)));
  }

  PictureMap map(const Pointer& p) const {
    PictureMap map = PictureMap::Identity();
    if (doing_ == Doing::moves) {
      Vec2 by = p.at - from_;
      if (p.shift) by[std::abs(by.x()) < std::abs(by.y()) ? 0 : 1] = 0;
      map.pretranslate(by);
      return map;
    }
    const Vec2 middle = box_.center();
    if (doing_ == Doing::turns) {
      const Vec2 a = from_ - middle, b = p.at - middle;
      double angle = std::atan2(b.y(), b.x()) - std::atan2(a.y(), a.x());
      constexpr double kStep = 3.14159265358979 / 12;  // with Shift
      if (p.shift) angle = kStep * std::round(angle / kStep);
      map.translate(middle).rotate(angle).translate(-middle);
      return map;
    }
    // About the far corner or side, with Alt about the middle; corners keep the proportions, but
    // for Shift.
    const ImVec2 at = Grips::kAt[std::size_t(grip_)];
    const Vec2 where = box_.min() + Vec2(at.x, at.y).cwiseProduct(box_.sizes());
    const Vec2 still = p.alt ? middle : Vec2(box_.min() + box_.max() - where);
    const Vec2 span = where - still, now = span + (p.at - from_);
    constexpr double kLeast = 0.02;  // never turned over, nor to a line
    Vec2 scale(1, 1);
    for (const int axis : {0, 1})
      if (std::abs(span[axis]) > 1e-9) scale[axis] = std::max(kLeast, now[axis] / span[axis]);
    if (at.x != 0.5f && at.y != 0.5f && !p.shift)
      scale.setConstant(std::max(kLeast, now.dot(span) / span.squaredNorm()));
    map.translate(still).scale(scale).translate(-still);
    return map;
  }

  // Those that lie in the box with all their points; along with those that Shift kept.
  void choose_within(App& app) {
    Box2 box;
    box.extend(from_);
    box.extend(to_);
    ContourSet chosen = along_;
    for (int i = 0; i < int(app.frame().contours.size()); ++i)
      if (box.contains(box_of(app.frame(), {i}))) chosen.insert(i);
    app.session.choose_outlines(chosen);
  }

  Doing doing_ = Doing::nothing;
  long gesture_ = 0;
  Vec2 from_ = Vec2::Zero(), to_ = Vec2::Zero();  // the sketch's pixels
  bool moved_ = false;
  int clicked_ = -1;  // one of several that were chosen
  int grip_ = -1;
  ContourSet along_;  // that stay chosen beside those in the box
  ContourSet held_;   // what is changed, in which drawing,
  int frame_ = 0;
  std::string words_;
  std::shared_ptr<const Document> was_;  // as it was,
  Box2 box_;                             // and the box round it then
};

}  // namespace

ToolRow arrange_tool() {
  return {.id = "arrange",
          .mode = Mode::outline,
          .name = "Arrange",
          .icon = icon::kCursorMove,
          .key = ImGuiKey_A,
          .make = make_tool<ArrangeTool>,
          .about = "Move, scale and turn whole outlines"};
}

}  // namespace artisketch
