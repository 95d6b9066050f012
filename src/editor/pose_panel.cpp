// Pose: the calibration's proposal beside the person's own pose, to compare and to take.
#include <cmath>

#include "document/edit.h"
#include "document/posing.h"
#include "editor/panels.h"

namespace artisketch {
namespace {

// How much of a part's outlines in a drawing the other drawings explain, in percent.
std::string percent(double share) {
  return std::to_string(int(std::floor(share * 100))) + " %";
}

double turned_by(const Pose& a, const Pose& b, int joint) {
  return a.rotations[std::size_t(joint)].angularDistance(b.rotations[std::size_t(joint)]);
}

void proposal_card(Work& work, Rect& place) {
  const Theme& t = theme();
  Proposal& proposal = *work.proposal;
  const Rect card = place.cut_top(158).inset(12, 0);
  draw().AddRectFilled(card.min(), card.max(), t.panel, kRadiusCard);
  draw().AddRect(card.min(), card.max(), t.accent, kRadiusCard, 0, 1.5f);
  Rect column = card.inset(12);
  Rect head = column.cut_top(22);
  write_icon({head.x + 8, head.centre().y}, IconSize::small, t.accent, icon::kCrosshairsGps);
  head.cut_left(24);
  write(head, Font::body_bold, t.text, "Calibrated pose is ready");
  const Pose& mine = work.frame().pose;
  const Pose& theirs = proposal.document.frames[std::size_t(work.view.frame)].pose;
  int most = 0;
  for (int j = 1; j < work.document().skeleton.size(); ++j)
    if (turned_by(mine, theirs, j) > turned_by(mine, theirs, most)) most = j;
  const double angle = degrees(turned_by(mine, theirs, most));
  const std::string words =
      angle < 0.5
          ? "This drawing stays as it is."
          : "Largest turn: " + joint_words(work.document().skeleton.joints[most].name).whole() +
                ", " + std::to_string(int(std::lround(angle))) + "°";
  write(column.cut_top(24), Font::caption, t.muted, words);
  column.cut_top(4);
  std::vector<std::pair<std::string, Look>> choices(2);
  choices[0].first = "Mine";
  choices[1].first = "Calibrated";
  choices[std::size_t(proposal.shown)].second.on = true;
  const int clicked = segments(choices, column.cut_top(32), Font::caption);
  if (clicked >= 0) proposal.shown = clicked == 1;
  column.cut_top(12);
  Rect row = column.cut_top(36);
  Look keep;
  keep.primary = true;
  const float width = row.w * 0.6f;
  if (button("Keep calibrated", row.cut_left(width), keep)) {
    // Only the ticked joints' rotations are taken.
    Document next = proposal.document;
    for (std::size_t f = 0; f < next.frames.size(); ++f)
      for (std::size_t j = 0; j < proposal.taken.size(); ++j)
        if (!proposal.taken[j])
          next.frames[f].pose.rotations[j] = work.document().frames[f].pose.rotations[j];
    work.commit("Keep calibrated", std::move(next));
    work.proposal.reset();
    return;
  }
  row.cut_left(8);
  if (button("Discard", row)) work.proposal.reset();
}

void coverage_table(Work& work, Rect place) {
  const Theme& t = theme();
  Proposal& proposal = *work.proposal;
  place.cut_top(14);
  write(place.cut_top(22).inset(16, 0), Font::body_bold, t.text, "Explained by the other drawings");
  Rect heads = place.cut_top(22).inset(16, 0);
  heads.cut_right(24);
  write(heads.cut_right(54), Font::caption, t.muted, "after", Align::right);
  write(heads.cut_right(54), Font::caption, t.muted, "mine", Align::right);
  for (const PartCoverage& part : proposal.coverage) {
    if (part.frame != work.view.frame || place.h < 26) continue;
    Rect row = place.cut_top(26).inset(16, 0);
    draw().AddCircleFilled({row.x + 6, row.centre().y}, 6, joint_tint(part.joint));
    row.cut_left(21);
    const std::string name = joint_words(work.document().skeleton.joints[part.joint].name).whole();
    bool taken = proposal.taken[std::size_t(part.joint)];
    if (checkbox("Take " + name, row.cut_right(16), taken, false))
      proposal.taken[std::size_t(part.joint)] = taken;
    row.cut_right(8);
    write(row.cut_right(54), Font::caption, t.muted, percent(part.after), Align::right);
    const bool poor = part.before < 0.9;
    write(row.cut_right(54), Font::caption_bold, poor ? t.warning : t.text, percent(part.before),
          Align::right);
    write(row, Font::body, t.text, name);
  }
}

}  // namespace

std::string lean_words(const Work& work, int joint) {
  const Skeleton& skeleton = work.document().skeleton;
  const int start = start_of_bone(skeleton, joint), end = end_of_bone(skeleton, joint);
  const std::vector<Transform> posed = posed_joints(skeleton, work.drawn_pose());
  const Vec3 bone = posed[end].translation() - posed[start].translation();
  if (bone.norm() < 1e-9) return "";
  const int angle = int(std::lround(degrees(std::asin(bone.normalized().z()))));
  if (angle == 0) return "in the paper's plane";
  return std::to_string(std::abs(angle)) + (angle > 0 ? "° toward you" : "° away");
}

void pose_panel(Work& work, Rect place) {
  const Theme& t = theme();
  Rect head = place.cut_top(48).inset(16, 0);
  write(head.cut_left(text_width(Font::title, "Pose") + 8), Font::title, t.text, "Pose");
  if (work.has_frame())
    write(head, Font::caption, t.muted, drawing_words(work.document(), work.view.frame));
  if (work.proposal && work.has_frame()) {
    proposal_card(work, place);
    if (work.proposal) coverage_table(work, place);
    return;
  }
  Rect buttons = place.cut_top(36).inset(12, 0);
  command_button(work, Command::calibrate, buttons.cut_left((buttons.w - 8) / 2));
  Look copy;
  copy.icon = icon::kContentCopy;
  copy.hint = words_of(Command::copy_pose).hint;
  copy.key = "C";
  copy.enabled = available(work, Command::copy_pose);
  if (button("Copy from", buttons.cut_right(buttons.w - 8), copy)) work.ask(Command::copy_pose);
  place.cut_top(14);
  const bool first = work.view.frame == 0 && !work.document().calibration.free_first_frame;
  const float used = write_lines(
      place.inset(16, 0), Font::caption, t.muted,
      first ? "Drag the joints until they match the drawing. The first drawing is the reference: "
              "calibration keeps its pose."
            : "Drag the joints until they roughly match the drawing. Calibrate does the last bit.",
      18);
  place.cut_top(used + 16);
  if (work.view.joint < 0 || !work.has_frame()) return;
  // The chosen joint.
  const Skeleton& skeleton = work.document().skeleton;
  const int joint = work.view.joint;
  hairline({place.x + 16, place.y}, {place.right() - 16, place.y + 1});
  place.cut_top(12);
  Rect row = place.cut_top(26).inset(16, 0);
  draw().AddCircleFilled({row.x + 6, row.centre().y}, 6, joint_tint(joint));
  row.cut_left(21);
  write(row, Font::body_bold, t.text, joint_words(skeleton.joints[joint].name).whole());
  if (is_locked(work.document(), joint)) write(row, Font::caption, t.muted, "locked", Align::right);
  write(place.cut_top(22).inset(16, 0), Font::caption, t.muted, lean_words(work, joint));
}

}  // namespace artisketch
