#include "editor/session/session.h"

#include <algorithm>
#include <utility>

#include "document/animate.h"
#include "document/edit.h"

namespace artisketch {

Session::Session(Document document) : history(std::move(document)) {
  static long last = 0;
  id_ = ++last;
  file.saved = backup.revision = backup.seen = history.revision();
}

void Session::show_frame(int frame) {
  if (frame != selection.frame) selection.contour = selection.point = -1;
  selection.frame = frame;
}

ContourSet Session::chosen_outlines() const {
  if (selection.contour < 0 || !has_frame()) return {};
  ContourSet chosen{selection.contour};
  const Selection::Along& along = selection.along;
  if (along.frame == selection.frame && along.contour == selection.contour)
    for (const int i : along.which)
      if (i < int(frame().contours.size())) chosen.insert(i);
  return chosen;
}

void Session::choose_outlines(const ContourSet& which) {
  // The one that was chosen stays the first of them.
  if (!which.contains(selection.contour)) selection.contour = which.empty() ? -1 : *which.begin();
  selection.joint =
      selection.contour < 0 ? -1 : frame().contours[std::size_t(selection.contour)].joint;
  selection.along = {selection.frame, selection.contour, which};
}

void Session::commit(std::string undo_name, Document next) {
  history.commit(std::move(undo_name), std::move(next));
  settle();
}

long Session::begin_gesture() {
  gesture_moved_ = false;
  return ++gesture_;
}

void Session::change(const std::string& undo_name, Document next) {
  // Keys held one after the other may do different things.
  const bool first = !std::exchange(gesture_moved_, true);
  if (first || history.undo_name() != undo_name) return commit(undo_name, std::move(next));
  history.amend(std::move(next));
  settle();
}

void Session::drop_gesture() {
  if (gesture_moved_) history.undo(), settle();
  begin_gesture();
}

void Session::keep_new_outline() {
  if (!new_outline) return;
  const NewOutline fresh = std::move(*new_outline);
  new_outline.reset();
  const int joint = fresh.joints[std::size_t(fresh.choice)];
  const ContourSet old =
      contours_redrawn(document().frames[std::size_t(fresh.frame)], joint, fresh.line);
  Document next = with_contour_over(document(), fresh.frame, {joint, fresh.line, ""});
  const int last = int(next.frames[std::size_t(fresh.frame)].contours.size()) - 1;
  const int contour = old.empty() ? last : *old.begin();
  for (const Polyline& hole : fresh.holes)
    next = with_contour(std::move(next), fresh.frame, {joint, hole, ""});
  const std::string part = joint_words(document().skeleton.joints[std::size_t(joint)].name).whole();
  commit((old.empty() ? fresh.verb : "Redraw") + " " + part, std::move(next));
  if (fresh.frame != selection.frame) return;
  selection.joint = joint;
  selection.contour = contour;
}

bool Session::brings_back_outline() const {
  return !new_outline && taken_back_ && taken_back_->over == history.state();
}

namespace {
constexpr const char* kNewOutline = "new outline";
}  // namespace

std::string Session::undo_name() const {
  return new_outline ? kNewOutline : history.can_undo() ? history.undo_name() : "";
}

std::string Session::redo_name() const {
  return brings_back_outline() ? kNewOutline : history.can_redo() ? history.redo_name() : "";
}

void Session::undo() {
  if (new_outline) {
    taken_back_ = {std::move(*new_outline), history.state()};
    new_outline.reset();
  } else {
    history.undo();
  }
  begin_gesture();
  settle();
}

void Session::redo() {
  if (brings_back_outline()) {
    new_outline = std::move(taken_back_->outline);
    taken_back_.reset();
    show_frame(new_outline->frame);
    selection.contour = -1;
  } else {
    history.redo();
  }
  begin_gesture();
  settle();
}

namespace {
bool same_joints(const Skeleton& a, const Skeleton& b) {
  return std::equal(a.joints.begin(), a.joints.end(), b.joints.begin(), b.joints.end(),
                    [](const Joint& p, const Joint& q) { return p.parent == q.parent; });
}
}  // namespace

void Session::settle() {
  const Document& now = document();
  selection.frame = std::clamp(selection.frame, 0, std::max(0, int(now.frames.size()) - 1));
  if (selection.joint >= now.skeleton.size()) selection.joint = -1;
  if (!has_frame() || selection.contour >= int(frame().contours.size())) selection.contour = -1;
  selection.point = -1;  // found anew with the pointer
  // Parts of another skeleton stand in no pose of this one.
  if (live.model && !same_joints(live.model->model.skeleton, now.skeleton)) live = Live();
  follow_document();
  if (proposal && proposal->revision != history.revision()) proposal.reset();
  if (new_outline && new_outline->frame >= int(now.frames.size())) new_outline.reset();
}

void Session::follow_document() {
  if (!built) return;
  built->fresh = same_model(document(), built->source);
  built->take_clips(document());
  if (playback.clip >= int(built->model.clips.size())) playback.clip = 0, playback.key = -1;
}

}  // namespace artisketch
