#include "editor/modes/outline/new_outline.h"

#include <algorithm>

#include "document/edit.h"
#include "editor/canvas/tools.h"

namespace artisketch {
namespace {

void find_candidates(const Work& work, NewOutline& fresh) {
  fresh.joints.clear();
  fresh.reasons.clear();
  for (Candidate& candidate : joint_candidates(work.document(), fresh.frame, fresh.line)) {
    fresh.joints.push_back(candidate.joint);
    fresh.reasons.push_back(std::move(candidate.reason));
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

void propose(Work& work, NewOutline fresh) {
  if (work.outline) keep_outline(work);
  fresh.frame = work.view.frame;
  fresh.arrived = ImGui::GetFrameCount();
  find_candidates(work, fresh);
  work.view.contour = -1;
  work.outline = std::move(fresh);
}

void propose_again(Work& work, std::optional<Traced> traced) {
  if (!traced) return;
  NewOutline& fresh = *work.outline;
  fresh.line = std::move(traced->outline);
  fresh.holes = std::move(traced->holes);
  find_candidates(work, fresh);
}

void keep_outline(Work& work) {
  const NewOutline fresh = std::move(*work.outline);
  work.outline.reset();
  const int joint = fresh.joints[std::size_t(fresh.choice)];
  Document next = with_contour(work.document(), fresh.frame, {joint, fresh.line, ""});
  const int contour = int(next.frames[std::size_t(fresh.frame)].contours.size()) - 1;
  for (const Polyline& hole : fresh.holes)
    next = with_contour(std::move(next), fresh.frame, {joint, hole, ""});
  work.commit(fresh.verb + " " + part_words(work, joint), std::move(next));
  if (fresh.frame != work.view.frame) return;
  work.view.joint = joint;
  work.view.contour = contour;
}

void reassign(Work& work, int joint) {
  joint = part_of(work.document(), joint);
  work.view.picking_joint = false;
  if (work.outline) {
    NewOutline& fresh = *work.outline;
    const auto known = std::find(fresh.joints.begin(), fresh.joints.end(), joint);
    fresh.choice = int(known - fresh.joints.begin());
    if (known != fresh.joints.end()) return;
    fresh.joints.push_back(joint);
    fresh.reasons.push_back("as you chose");
    return;
  }
  const int contour = work.view.contour;
  if (contour < 0 || work.frame().contours[std::size_t(contour)].joint == joint) return;
  work.commit("Give to " + part_words(work, joint),
              with_contour_joint(work.document(), work.view.frame, contour, joint));
  work.view.joint = joint;
}

bool picks_joint(Work& work, const Pointer& p, const OnScreen& on) {
  const bool wanted = work.outline ? work.outline->frame == work.view.frame
                                   : work.view.contour >= 0 && (work.view.picking_joint ||
                                                                work.view.tool() == Tool::edit);
  if (!wanted || work.document().skeleton.joints.empty()) return false;
  const std::vector<Transform> posed = posed_joints(work.document().skeleton, work.frame().pose);
  const FrameCamera camera = frame_camera(work.document(), work.view.frame);
  const int joint = joint_at(posed, camera, on, p.screen, kReach);
  if (joint < 0 || !p.hovered) return false;
  const ImVec2 at = on.of(camera.project(posed[std::size_t(joint)].translation()));
  const int part = part_of(work.document(), joint);
  if (!work.outline && !work.view.picking_joint && part == work.view.joint) return false;
  draw().AddCircle(at, kReach, theme().accent, 0, 2);
  if (!p.held) tooltip("Give it to " + part_words(work, part), "");
  if (!p.pressed) return false;
  reassign(work, part);
  return true;
}

void pending_outline(Work& work, const Rect& place, const OnScreen& on) {
  const Theme& t = theme();
  NewOutline& fresh = *work.outline;
  if (fresh.frame != work.view.frame) return;
  const int joint = fresh.joints[std::size_t(fresh.choice)];
  OutlineLook look;
  look.dashed = true;
  look.width = 2.5f;
  look.fill = 0.12f;
  paint_outline(draw(), fresh.line, on, joint_tint(joint), look);
  look.fill = 0;
  for (const Polyline& hole : fresh.holes) paint_outline(draw(), hole, on, joint_tint(joint), look);
  const Box2 box = bounds(std::span(&fresh.line, 1));
  const JointWords words = joint_words(work.document().skeleton.joints[std::size_t(joint)].name);
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
  write({chip.x + 42 + text_width(Font::title, words.name), chip.y + 9, 20, 22}, Font::small,
        t.muted, words.side);
  key_cap({chip.x + 12, chip.y + 36, 40, 18}, "Enter");
  write({chip.x + 57, chip.y + 36, 40, 18}, Font::caption, t.muted, "keep");
  key_cap({chip.x + 94, chip.y + 36, 32, 18}, "Tab");
  write({chip.x + 131, chip.y + 36, 40, 18}, Font::caption, t.muted, "next");
  // The Enter that closed it does not keep it as well.
  if (ImGui::GetIO().WantTextInput || fresh.arrived == ImGui::GetFrameCount()) return;
  if (ImGui::IsKeyPressed(ImGuiKey_Tab))
    fresh.choice = (fresh.choice + 1) % int(fresh.joints.size());
  if (ImGui::IsKeyPressed(ImGuiKey_Enter, false)) keep_outline(work);
}

}  // namespace artisketch
