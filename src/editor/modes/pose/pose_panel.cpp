#include "editor/modes/pose/pose_panel.h"

#include <algorithm>
#include <cmath>

#include "document/edit.h"
#include "document/posing.h"
#include "editor/canvas/controls.h"
#include "editor/canvas/pointer.h"
#include "editor/session/part_fit.h"

namespace artisketch {
namespace {

double turned_by(const Pose& a, const Pose& b, int joint) {
  return a.rotations[std::size_t(joint)].angularDistance(b.rotations[std::size_t(joint)]);
}

// Of the parts of the drawing whose edge shows; −1 where nothing is known.
double farthest_off(const App& app, const std::vector<FrameFit>& fits) {
  double farthest = -1;
  if (app.session.selection.frame < int(fits.size()))
    for (const FrameFit::PartFit& fit : fits[std::size_t(app.session.selection.frame)].parts)
      if (fit_of(app, fit.joint, app.session.selection.frame) != Fit::inside)
        farthest = std::max(farthest, fit.distance);
  return farthest;
}

// What the calibration found for the drawing.
void proposal_words(const App& app, Rect column) {
  const Theme& t = theme();
  const Proposal& proposal = *app.session.proposal;
  Rect head = column.cut_top(22);
  write_icon({head.x + 8, head.centre().y}, IconSize::small, t.accent, icon::kCrosshairsGps);
  head.cut_left(24);
  write(head, Font::body_bold, t.text, "Calibrated pose is ready");
  const Pose& mine = app.frame().pose;
  const Pose& theirs = proposal.document.frames[std::size_t(app.session.selection.frame)].pose;
  int most = 0;
  for (int j = 1; j < app.document().skeleton.size(); ++j)
    if (turned_by(mine, theirs, j) > turned_by(mine, theirs, most)) most = j;
  const double angle = degrees(turned_by(mine, theirs, most));
  if (const double farthest = farthest_off(app, proposal.fits); farthest >= 0)
    write(column.cut_top(18), Font::caption, t.muted,
          "Every part within " + std::to_string(int(std::ceil(farthest))) + " px of its outline.");
  else
    write(column.cut_top(18), Font::caption, t.muted, "Measuring …");
  const std::string words = angle < 0.5 ? "This drawing stays as it is."
                                        : "Largest turn: " + part_words(app, most) + ", " +
                                              std::to_string(int(std::lround(angle))) + "°";
  write(column.cut_top(18), Font::caption, t.muted, words);
}

void mine_or_calibrated(Proposal& proposal, const Rect& place) {
  std::vector<std::pair<std::string, Look>> choices(2);
  choices[0].first = "Mine";
  choices[1].first = "Calibrated";
  choices[std::size_t(proposal.shown)].second.on = true;
  const int clicked = segments(choices, place, Font::caption);
  if (clicked >= 0) proposal.shown = clicked == 1;
}

// The proposal may be gone after it.
void keep_or_discard(App& app, Rect row) {
  const Proposal& proposal = *app.session.proposal;
  Look keep;
  keep.primary = true;
  if (button("Keep calibrated", row.cut_left(row.w * 0.6f), keep)) {
    // Only the ticked joints' rotations are taken.
    Document next = proposal.document;
    for (std::size_t f = 0; f < next.frames.size(); ++f)
      for (std::size_t j = 0; j < proposal.taken.size(); ++j)
        if (!proposal.taken[j])
          next.frames[f].pose.rotations[j] = app.document().frames[f].pose.rotations[j];
    app.session.commit("Keep calibrated", std::move(next));
    app.session.proposal.reset();
    return;
  }
  row.cut_left(8);
  if (button("Discard", row)) app.session.proposal.reset();
}

void proposal_card(App& app, Rect& place) {
  const Theme& t = theme();
  const Rect card = place.cut_top(180).inset(12, 0);
  draw().AddRectFilled(card.min(), card.max(), t.panel, kRadiusCard);
  draw().AddRect(card.min(), card.max(), t.accent, kRadiusCard, 0, 1.5f);
  Rect column = card.inset(12);
  proposal_words(app, column.cut_top(58));
  column.cut_top(10);
  mine_or_calibrated(*app.session.proposal, column.cut_top(32));
  column.cut_top(12);
  keep_or_discard(app, column.cut_top(36));
}

std::string in_pixels(double distance) {
  return distance < 0 ? "–" : std::to_string(int(std::lround(distance))) + " px";
}

// How far each part is from its outline in this drawing, the farthest first; with a proposal also
// after it, and whether to take it.
void distance_table(App& app, Rect place) {
  const Theme& t = theme();
  Proposal* proposal = app.session.proposal ? &*app.session.proposal : nullptr;
  std::vector<std::pair<double, int>> rows;
  int inside = 0;
  for (const int joint : drawn_joints(app.document())) {
    const bool covered = fit_of(app, joint, app.session.selection.frame) == Fit::inside;
    inside += covered;
    if (const double off = distance_of(app, joint, app.session.selection.frame);
        off >= 0 && !covered)
      rows.emplace_back(-off, joint);
  }
  if (rows.empty() && inside == 0) return;
  std::sort(rows.begin(), rows.end());
  place.cut_top(14);
  Rect heads = place.cut_top(22).inset(16, 0);
  write(heads, Font::body_bold, t.text, "Distance to the outlines");
  if (proposal) {
    heads = place.cut_top(20).inset(16, 0);
    heads.cut_right(24);
    write(heads.cut_right(50), Font::caption, t.muted, "after", Align::right);
    write(heads.cut_right(54), Font::caption, t.muted, "mine", Align::right);
  }
  for (const auto& [negated, joint] : rows) {
    if (place.h < 26) break;
    const double off = -negated;
    const std::string name = part_words(app, joint);
    const Rect whole = place.cut_top(26);
    Rect row = whole.inset(16, 0);
    if (proposal) {
      bool taken = proposal->taken[std::size_t(joint)];
      if (checkbox("Take " + name, row.cut_right(16), taken, false))
        proposal->taken[std::size_t(joint)] = taken;
      row.cut_right(8);
    }
    const bool chosen = joint == app.session.selection.joint;
    const Press press =
        press_area("Off " + name + " " + in_pixels(off),
                   {whole.x + 8, whole.y, row.right() - whole.x - 8, whole.h}, true, chosen);
    if (chosen || press.hovered)
      draw().AddRectFilled({whole.x + 8, whole.y}, {row.right() + 2, whole.bottom()},
                           chosen ? t.selection : faded(t.hover, 0.5f), kRadius);
    if (press.clicked) app.session.selection.joint = joint;
    draw().AddCircleFilled({row.x + 6, row.centre().y}, 6, joint_tint(joint));
    row.cut_left(21);
    if (proposal)
      write(row.cut_right(50), Font::caption, t.muted,
            in_pixels(distance_in(proposal->fits, joint, app.session.selection.frame)),
            Align::right);
    write(row.cut_right(54), off > kOff ? Font::caption_bold : Font::caption,
          off > kOff ? t.text : t.muted, in_pixels(off), Align::right);
    const ImVec2 at{row.right() - 4, row.centre().y};
    if (off > kOff)
      draw().AddTriangleFilled({at.x, at.y - 5}, {at.x - 5, at.y + 4}, {at.x + 5, at.y + 4},
                               off > kFarOff ? t.error : t.warning);
    row.cut_right(14);
    write(row, Font::body, t.text, name);
  }
  if (inside == 0 || place.h < 26) return;
  const std::string words =
      inside == 1 ? "1 part lies inside others: no edge to compare."
                  : std::to_string(inside) + " parts lie inside others: no edge to compare.";
  const Rect line = place.cut_top(26).inset(16, 0);
  record(words, line);
  write(line, Font::caption, t.muted, words);
}

}  // namespace

std::string lean_words(const App& app, int joint) {
  const Skeleton& skeleton = app.document().skeleton;
  const int start = start_of_bone(skeleton, joint), end = end_of_bone(skeleton, joint);
  const std::vector<Transform> posed = posed_joints(skeleton, app.drawn_pose());
  const Vec3 bone = posed[end].translation() - posed[start].translation();
  if (bone.norm() < 1e-9) return "";
  const int angle = int(std::lround(degrees(std::asin(bone.normalized().z()))));
  if (angle == 0) return "in the paper's plane";
  return std::to_string(std::abs(angle)) + (angle > 0 ? "° toward you" : "° away");
}

namespace {

void chosen_joint(const App& app, Rect& place) {
  const Theme& t = theme();
  const int joint = app.session.selection.joint;
  hairline({place.x + 16, place.y}, {place.right() - 16, place.y + 1});
  place.cut_top(12);
  Rect row = place.cut_top(26).inset(16, 0);
  draw().AddCircleFilled({row.x + 6, row.centre().y}, 6, joint_tint(joint));
  row.cut_left(21);
  if (is_locked(app.document(), joint)) write(row, Font::caption, t.muted, "locked", Align::right);
  write(row, Font::body_bold, t.text, part_words(app, joint));
  write(place.cut_top(22).inset(16, 0), Font::caption, t.muted, lean_words(app, joint));
}

}  // namespace

void proposal_sheet(App& app, Rect place) {
  Rect row = place.inset(16, 22);
  Rect answers = row.cut_right(340);
  proposal_words(app, row);
  mine_or_calibrated(*app.session.proposal, answers.cut_top(44));
  answers.cut_top(12);
  keep_or_discard(app, answers.cut_top(44));
}

namespace {

// How large the drawing shows the figure, where the camera's distance can't tell: half to double.
void figure_size(App& app, Rect& place) {
  const Theme& t = theme();
  const int frame = app.session.selection.frame;
  if (frame == 0 || app.document().camera.type != Camera::Type::orthographic) return;
  const double scale = app.frame().scale;
  Rect row = place.cut_top(24).inset(16, 0);
  write(row.cut_left(84), Font::caption, t.muted, "Figure's size");
  write(row.cut_right(48), Font::caption, t.text, std::to_string(std::lround(100 * scale)) + " %",
        Align::right);
  row.cut_left(8);
  row.cut_right(8);
  float octaves = std::clamp(float(std::log2(scale)), -1.0f, 1.0f);
  const bool moved = slider("Figure's size", row, octaves, -1, 1);
  if (ImGui::IsItemActivated()) app.session.begin_gesture();
  if (moved)
    app.session.change("Size of " + drawing_words(app.document(), frame),
                       with_frame_scale(app.document(), frame, std::exp2(double(octaves))));
  place.cut_top(8);
}

// What a drawing lacks that was just added, and the way out where its pose is right by chance.
void not_posed_yet(App& app, Rect& place) {
  const Theme& t = theme();
  const float used =
      write_lines(place.inset(16, 0), Font::caption, t.warning,
                  "Not posed yet: until it is, the drawing shapes and colours nothing.", 18);
  place.cut_top(used + 6);
  command_button(app, "posed_here", place.cut_top(36).inset(12, 0));
  place.cut_top(14);
}

}  // namespace

void pose_panel(App& app, Rect place) {
  const Theme& t = theme();
  Rect head = place.cut_top(48).inset(16, 0);
  write(head.cut_left(text_width(Font::title, "Pose") + 8), Font::title, t.text, "Pose");
  if (app.has_frame())
    write(head, Font::caption, t.muted, drawing_words(app.document(), app.session.selection.frame));
  if (app.session.proposal && app.has_frame()) {
    proposal_card(app, place);
    if (app.session.proposal) distance_table(app, place);
    return;
  }
  Rect buttons = place.cut_top(36).inset(12, 0);
  command_button(app, "suggest", buttons.cut_left((buttons.w - 8) / 2));
  Look copy;
  copy.icon = icon::kContentCopy;
  copy.hint = command(app, "copy_pose").about;
  copy.key = "C";
  copy.enabled = available(app, "copy_pose");
  if (button("Copy from", buttons.cut_right(buttons.w - 8), copy)) app.ask("copy_pose");
  place.cut_top(8);
  command_button(app, "calibrate", place.cut_top(36).inset(12, 0));
  place.cut_top(14);
  if (app.has_frame()) figure_size(app, place);
  if (available(app, "posed_here")) not_posed_yet(app, place);
  const bool first =
      app.session.selection.frame == 0 && !app.document().calibration.free_first_frame;
  const float used = write_lines(
      place.inset(16, 0), Font::caption, t.muted,
      first ? "Drag the joints until they match the drawing. The first drawing is the reference: "
              "calibration keeps its pose, unless the drawings contradict each other."
            : "Drag the joints until they roughly match the drawing. Calibrate does the last bit.",
      18);
  place.cut_top(used + 16);
  if (!app.has_frame()) return;
  if (app.session.selection.joint >= 0) chosen_joint(app, place);
  distance_table(app, place);
}

}  // namespace artisketch
