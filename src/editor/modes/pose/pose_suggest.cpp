#include "editor/modes/pose/pose_suggest.h"

#include <algorithm>
#include <cmath>

#include "document/edit.h"
#include "document/posing.h"
#include "document/suggest.h"
#include "editor/canvas/pointer.h"
#include "editor/ui/ui.h"

namespace artisketch {
namespace {

constexpr float kWidth = 172, kHeight = 152;  // points

// The bones in question in their colours among the others, turned so that depth shows.
void small_picture(const App& app, const Pose& pose, int joint, const Rect& place) {
  const Skeleton& skeleton = app.document().skeleton;
  const Mat3 turn =
      (Eigen::AngleAxisd(radians(8), Vec3::UnitX()) * Eigen::AngleAxisd(radians(50), Vec3::UnitY()))
          .toRotationMatrix();
  std::vector<Vec3> at;
  for (const Transform& posed : posed_joints(skeleton, pose))
    at.push_back(turn * posed.translation());
  const int start = start_of_bone(skeleton, joint), end = end_of_bone(skeleton, joint);
  std::vector<char> limb(at.size(), 0);
  limb[std::size_t(start)] = limb[std::size_t(end)] = 1;
  for (int j = end + 1; j < skeleton.size(); ++j)
    if (limb[std::size_t(skeleton.joints[std::size_t(j)].parent)] &&
        skeleton.joints[std::size_t(j)].parent != start)
      limb[std::size_t(j)] = 1;
  if (const int above = skeleton.joints[std::size_t(start)].parent; above >= 0)
    limb[std::size_t(above)] = 1;
  Box3 box;
  for (std::size_t j = 0; j < at.size(); ++j)
    if (limb[j]) box.extend(at[j]);
  const double size = std::max({1e-6, box.sizes().x(), box.sizes().y()});
  const float scale = 0.62f * std::min(place.w, place.h) / float(size);
  const auto of = [&](int j) {
    const Vec3 d = at[std::size_t(j)] - box.center();
    return ImVec2{place.centre().x + scale * float(d.x()), place.centre().y - scale * float(d.y())};
  };
  draw().PushClipRect(place.min(), place.max(), true);
  for (const bool front : {false, true})
    for (int j = 1; j < skeleton.size(); ++j) {
      const int parent = skeleton.joints[std::size_t(j)].parent;
      const bool chosen = limb[std::size_t(j)] && limb[std::size_t(parent)];
      if (chosen != front) continue;
      draw().AddLine(of(parent), of(j), chosen ? joint_tint(parent) : rgb(0xA3A9B2, 0.55f),
                     chosen ? 4.0f : 2.0f);
    }
  for (int j = 0; j < skeleton.size(); ++j)
    if (limb[std::size_t(j)]) draw().AddCircleFilled(of(j), 3, rgb(0xFFFFFF));
  draw().PopClipRect();
}

double lean(const Skeleton& skeleton, const Pose& pose, int joint) {
  const std::vector<Transform> posed = posed_joints(skeleton, pose);
  return posed[std::size_t(end_of_bone(skeleton, joint))].translation().z() -
         posed[std::size_t(start_of_bone(skeleton, joint))].translation().z();
}

}  // namespace

void suggest_pose(App& app) {
  const int frame = app.session.selection.frame;
  app.session.proposal.reset();
  Pose pose = suggested_pose(app.document(), frame);
  // The bone that leans most is asked about first.
  const Skeleton& skeleton = app.document().skeleton;
  double most = 0;
  for (const int joint : drawn_joints(app.document())) {
    const double leaning = std::abs(lean(skeleton, pose, joint));
    if (joint == 0 || skeleton.children(joint).size() > 1 || leaning <= most) continue;
    most = leaning;
    app.session.selection.joint = joint;
  }
  app.session.commit("Suggest pose", with_pose(app.document(), frame, std::move(pose)));
  app.session.bend = {};
  app.session.bend.frame = frame;
}

void bend_chooser(App& app, ImVec2 corner) {
  Bend& bend = app.session.bend;
  const int joint = app.session.selection.joint;
  if (bend.frame != app.session.selection.frame || joint <= 0 || app.session.proposal) return;
  const Skeleton& skeleton = app.document().skeleton;
  const Pose& mine = app.frame().pose;
  if (!leans(skeleton, mine, joint)) return;
  const bool is_toward = lean(skeleton, mine, joint) > 0;
  const Leanings& leanings = bend.of.of(app.session.history.state(), joint, [&]() -> Leanings {
    const Pose other = with_lean_flipped(app.document(), bend.frame, mine, joint);
    return is_toward ? Leanings{mine, other} : Leanings{other, mine};
  });
  const Rect card{corner.x, corner.y - kHeight, kWidth, kHeight};
  shadow(card, kRadiusPanel);
  draw().AddRectFilled(card.min(), card.max(), rgb(0x1F2227, 0.96f), kRadiusPanel);
  draw().AddRect(card.min(), card.max(), rgb(0x343940), kRadiusPanel);
  Rect column = card.inset(10, 8);
  Rect head = column.cut_top(20);
  key_cap(head.cut_right(20), "F");
  write(head, Font::caption_bold, rgb(0xE8EAED), "Bends which way?");
  column.cut_top(6);
  for (const bool toward : {true, false}) {
    const Rect half = toward ? column.cut_left(column.w / 2 - 3) : column.cut_right(column.w - 6);
    const std::string words = toward ? "Toward you" : "Away";
    const bool on = toward == is_toward;
    const Press press = press_area(words, half, true, on);
    draw().AddRectFilled(half.min(), half.max(),
                         on              ? rgb(0x25403B)
                         : press.hovered ? rgb(0x3A4048)
                                         : rgb(0x292D33),
                         kRadius);
    if (on) draw().AddRect(half.min(), half.max(), rgb(0x4FD1B5), kRadius, 0, 1.5f);
    Rect inside = half;
    write(inside.cut_bottom(22), Font::caption, on ? rgb(0x4FD1B5) : rgb(0xA3A9B2), words,
          Align::centre);
    small_picture(app, toward ? leanings.toward : leanings.away, joint, inside);
    if (!press.clicked || on) continue;
    app.session.commit(
        "Bend " + part_words(app, start_of_bone(skeleton, joint)) +
            (toward ? " toward you" : " away"),
        with_pose(app.document(), bend.frame, toward ? leanings.toward : leanings.away));
    return;
  }
  press_area("Bends which way?", card);  // what is beside the two doesn't fall through
}

}  // namespace artisketch
