#include "editor/modes/outline/new_outline.h"

#include <algorithm>
#include <cmath>

#include "document/edit.h"
#include "document/outline_edit.h"
#include "editor/canvas/controls.h"
#include "editor/canvas/pointer.h"
#include "editor/canvas/sketch_paint.h"
#include "editor/ui/ui.h"

namespace artisketch {
namespace {

void find_candidates(const App& app, NewOutline& fresh) {
  fresh.joints.clear();
  fresh.reasons.clear();
  for (Candidate& candidate : joint_candidates(app.document(), fresh.frame, fresh.line)) {
    fresh.joints.push_back(candidate.joint);
    fresh.reasons.push_back(std::move(candidate.reason));
  }
  // A thing that was chosen to be drawn is no bone's, wherever it lies.
  const int chosen = app.session.selection.joint;
  if (chosen >= 0 && role_of(app.document(), chosen) != Role::body &&
      contours_of(app.document().frames[std::size_t(fresh.frame)], chosen).empty()) {
    const auto known = std::find(fresh.joints.begin(), fresh.joints.end(), chosen);
    if (known != fresh.joints.end()) {
      fresh.reasons.erase(fresh.reasons.begin() + (known - fresh.joints.begin()));
      fresh.joints.erase(known);
    }
    fresh.joints.insert(fresh.joints.begin(), chosen);
    fresh.reasons.insert(fresh.reasons.begin(), "the thing chosen");
  }
  if (fresh.joints.empty()) fresh.joints = {0}, fresh.reasons = {"the only joint"};
  fresh.choice = 0;
}

// A joint without children only marks where a bone ends: its part is the one before.
int part_of(const Document& document, int joint) {
  const std::vector<int> parts = parts_to_draw(document);
  const bool own = std::find(parts.begin(), parts.end(), joint) != parts.end();
  const int parent = document.skeleton.joints[std::size_t(joint)].parent;
  return own || parent < 0 ? joint : parent;
}

}  // namespace

void propose(App& app, NewOutline fresh) {
  app.session.keep_new_outline();
  fresh.frame = app.session.selection.frame;
  fresh.arrived = app.services.frames;
  find_candidates(app, fresh);
  app.session.selection.contour = -1;
  app.session.new_outline = std::move(fresh);
}

void trace_again(App& app, double tolerance) {
  constexpr double kLeast = 0.01;
  tolerance = std::clamp(tolerance, kLeast, 1.0);
  if (std::abs(tolerance - app.view.tolerance) < 1e-6) return;
  app.view.tolerance = tolerance;
  NewOutline& fresh = *app.session.new_outline;
  std::optional<RegionOutline> traced_anew =
      region_outline(fresh.tracing->image, fresh.tracing->levels, tolerance);
  if (!traced_anew) return;
  fresh.line = std::move(traced_anew->outline);
  fresh.holes = std::move(traced_anew->holes);
  find_candidates(app, fresh);
}

void reassign(App& app, int joint) {
  joint = part_of(app.document(), joint);
  app.session.next.picks_joint = false;
  if (app.session.new_outline) {
    NewOutline& fresh = *app.session.new_outline;
    const auto known = std::find(fresh.joints.begin(), fresh.joints.end(), joint);
    fresh.choice = int(known - fresh.joints.begin());
    if (known != fresh.joints.end()) return;
    fresh.joints.push_back(joint);
    fresh.reasons.push_back("as you chose");
    return;
  }
  const int contour = app.session.selection.contour;
  if (contour < 0 || app.frame().contours[std::size_t(contour)].joint == joint) return;
  app.session.commit(
      "Give to " + part_words(app, joint),
      with_contour_joint(app.document(), app.session.selection.frame, contour, joint));
  app.session.selection.joint = joint;
}

Offer offer_under(const App& app, const Pointer& p, const Stage& stage) {
  const std::optional<NewOutline>& fresh = app.session.new_outline;
  const bool picking = app.session.next.picks_joint;
  const Selection& selection = app.session.selection;
  const bool wanted = fresh ? fresh->frame == selection.frame
                            : selection.contour >= 0 && (picking || app.tool().gives_outlines());
  if (!wanted || !p.hovered || app.document().skeleton.joints.empty()) return {};
  const std::vector<Transform> posed = posed_joints(app.document().skeleton, app.frame().pose);
  const FrameCamera camera = frame_camera(app.document(), selection.frame);
  const int joint = joint_at(posed, camera, stage.on, p.screen, kReach);
  if (joint < 0) return {};
  const int part = part_of(app.document(), joint);
  if (!fresh && !picking && part == selection.joint) return {};
  return {part, stage.on.of(camera.project(posed[std::size_t(joint)].translation()))};
}

void paint_offer(const App& app, const Offer& offer, const Pointer& p) {
  draw().AddCircle(offer.at, kReach, theme().accent, 0, 2);
  if (!p.held) tooltip("Give it to " + part_words(app, offer.part), "");
}

void answer_pending(App& app, const Pointer& p) {
  NewOutline& fresh = *app.session.new_outline;
  // The Enter that closed it does not keep it as well.
  if (fresh.frame != app.session.selection.frame || fresh.arrived == app.services.frames) return;
  if (p.tab) fresh.choice = (fresh.choice + 1) % int(fresh.joints.size());
  if (p.enter) app.session.keep_new_outline();
}

void paint_pending(const App& app, const Rect& place, const OnScreen& on) {
  const Theme& t = theme();
  const NewOutline& fresh = *app.session.new_outline;
  if (fresh.frame != app.session.selection.frame) return;
  const int joint = fresh.joints[std::size_t(fresh.choice)];
  OutlineLook look;
  look.dashed = true;
  look.width = 2.5f;
  look.fill = 0.12f;
  paint_outline(draw(), fresh.line, on, joint_tint(joint), look);
  look.fill = 0;
  for (const Polyline& hole : fresh.holes) paint_outline(draw(), hole, on, joint_tint(joint), look);
  const Box2 box = bounds(std::span(&fresh.line, 1));
  const JointWords words = joint_words(app.document().skeleton.joints[std::size_t(joint)].name);
  const float width = std::max(164.0f, text_width(Font::title, words.whole()) + 60);
  const ImVec2 side = on.of({box.min().x(), box.center().y()});
  Rect chip{side.x - width - 14, side.y - 31, width, 62};
  if (chip.x < place.x + 4) chip.x = on.of({box.max().x(), 0}).x + 14;
  chip.x = std::clamp(chip.x, place.x + 4, std::max(place.x + 4, place.right() - width - 4));
  chip.y = std::clamp(chip.y, place.y + 4, place.bottom() - 66);
  shadow(chip, kRadiusCard);
  draw().AddRectFilled(chip.min(), chip.max(), t.raised, kRadiusCard);
  draw().AddCircleFilled({chip.x + 20, chip.y + 19}, 7, joint_tint(joint));
  write({chip.x + 36, chip.y + 8, chip.w - 40, 22}, Font::title, t.text, words.name);
  write_name({chip.x + 42 + text_width(Font::title, words.name), chip.y + 9, 20, 22}, Font::small,
             t.muted, shown_side(words));
  key_cap({chip.x + 12, chip.y + 36, 40, 18}, "Enter");
  const bool anew = !contours_redrawn(app.frame(), joint, fresh.line).empty();
  write({chip.x + 57, chip.y + 36, 40, 18}, Font::caption, t.muted, anew ? "replace" : "keep");
  key_cap({chip.x + 94, chip.y + 36, 32, 18}, "Tab");
  write({chip.x + 131, chip.y + 36, 40, 18}, Font::caption, t.muted, "next");
}

}  // namespace artisketch
