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

// The joints of the bone and of what hangs on it.
std::vector<char> limb_of(const Skeleton& skeleton, int joint) {
  const int start = start_of_bone(skeleton, joint), end = end_of_bone(skeleton, joint);
  std::vector<char> limb(skeleton.joints.size(), 0);
  limb[std::size_t(start)] = limb[std::size_t(end)] = 1;
  for (int j = end + 1; j < skeleton.size(); ++j)
    if (limb[std::size_t(skeleton.joints[std::size_t(j)].parent)] &&
        skeleton.joints[std::size_t(j)].parent != start)
      limb[std::size_t(j)] = 1;
  if (const int above = skeleton.joints[std::size_t(start)].parent; above >= 0)
    limb[std::size_t(above)] = 1;
  return limb;
}

// The joints in question with their bones in colours among the others, turned so that depth shows.
void small_picture(const Skeleton& skeleton, const Pose& pose, const std::vector<char>& limb,
                   const Rect& place, float dot = 3) {
  const Mat3 turn =
      (Eigen::AngleAxisd(radians(8), Vec3::UnitX()) * Eigen::AngleAxisd(radians(50), Vec3::UnitY()))
          .toRotationMatrix();
  std::vector<Vec3> at;
  for (const Transform& posed : posed_joints(skeleton, pose))
    at.push_back(turn * posed.translation());
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
                     chosen ? dot + 1 : 2.0f);
    }
  for (int j = 0; j < skeleton.size(); ++j)
    if (limb[std::size_t(j)]) draw().AddCircleFilled(of(j), dot, rgb(0xFFFFFF));
  draw().PopClipRect();
}

double lean(const Skeleton& skeleton, const Pose& pose, int joint) {
  const std::vector<Transform> posed = posed_joints(skeleton, pose);
  return posed[std::size_t(end_of_bone(skeleton, joint))].translation().z() -
         posed[std::size_t(start_of_bone(skeleton, joint))].translation().z();
}

// A card above `corner` with its title and, at the right, what the title's key is; gives the room
// below.
Rect card_with_title(ImVec2 corner, float width, const std::string& title, const char* key) {
  const Rect card{corner.x, corner.y - kHeight, width, kHeight};
  shadow(card, kRadiusPanel);
  draw().AddRectFilled(card.min(), card.max(), rgb(0x1F2227, 0.96f), kRadiusPanel);
  draw().AddRect(card.min(), card.max(), rgb(0x343940), kRadiusPanel);
  Rect column = card.inset(10, 8);
  Rect head = column.cut_top(20);
  if (*key) key_cap(head.cut_right(20), key);
  write(head, Font::caption_bold, rgb(0xE8EAED), title);
  column.cut_top(6);
  return column;
}

// One of the poses on a card; gives whether it was pressed.
bool choice(const App& app, const std::string& words, const Pose& pose,
            const std::vector<char>& limb, bool on, const Rect& place, float dot = 3) {
  const Press press = press_area(words, place, true, on);
  draw().AddRectFilled(place.min(), place.max(),
                       on              ? rgb(0x25403B)
                       : press.hovered ? rgb(0x3A4048)
                                       : rgb(0x292D33),
                       kRadius);
  if (on) draw().AddRect(place.min(), place.max(), rgb(0x4FD1B5), kRadius, 0, 1.5f);
  Rect inside = place;
  write(inside.cut_bottom(22), Font::caption, on ? rgb(0x4FD1B5) : rgb(0xA3A9B2), words,
        Align::centre);
  small_picture(app.document().skeleton, pose, limb, inside, dot);
  return press.clicked;
}

// Which of the suggested poses the drawing has; −1 where it has none of them, or there is no
// choice.
int rival_in_use(const App& app) {
  const Rivals& rivals = app.session.rivals;
  if (rivals.frame != app.session.selection.frame || rivals.poses.size() < 2) return -1;
  for (int k = 0; k < int(rivals.poses.size()); ++k)
    if (same_pose(rivals.poses[std::size_t(k)], app.frame().pose)) return k;
  return -1;
}

void rival_chooser(App& app, ImVec2 corner, int in_use) {
  const Rivals& rivals = app.session.rivals;
  const int count = int(rivals.poses.size());
  constexpr float kEach = 84, kBetween = 6;
  const float width = 20 + float(count) * kEach + float(count - 1) * kBetween;
  Rect column = card_with_title(corner, width, "Which one is it?", "");
  const std::vector<char> whole(app.document().skeleton.joints.size(), 1);
  for (int k = 0; k < count; ++k) {
    const Rect place = column.cut_left(kEach);
    column.cut_left(kBetween);
    const std::string words = k == in_use ? "Keep" : "Rival " + std::to_string(k + 1);
    if (!choice(app, words, rivals.poses[std::size_t(k)], whole, k == in_use, place, 1.5f))
      continue;
    if (k == in_use) {
      app.session.rivals = {};
    } else {
      app.session.commit("Take rival pose", with_guessed_pose(app.document(), rivals.frame,
                                                              rivals.poses[std::size_t(k)]));
    }
    return;
  }
  press_area("Which one is it?", {corner.x, corner.y - kHeight, width, kHeight});
}

void bend_chooser(App& app, ImVec2 corner) {
  Bend& bend = app.session.bend;
  const int joint = app.session.selection.joint;
  if (bend.frame != app.session.selection.frame || joint <= 0) return;
  const Skeleton& skeleton = app.document().skeleton;
  const Pose& mine = app.frame().pose;
  if (!leans(skeleton, mine, joint)) return;
  const bool is_toward = lean(skeleton, mine, joint) > 0;
  const Leanings& leanings = bend.of.of(app.session.history.state(), joint, [&]() -> Leanings {
    const Pose other = with_lean_flipped(app.document(), bend.frame, mine, joint);
    return is_toward ? Leanings{mine, other} : Leanings{other, mine};
  });
  Rect column = card_with_title(corner, kWidth, "Bends which way?", "F");
  const std::vector<char> limb = limb_of(skeleton, joint);
  for (const bool toward : {true, false}) {
    const Rect half = toward ? column.cut_left(column.w / 2 - 3) : column.cut_right(column.w - 6);
    const Pose& pose = toward ? leanings.toward : leanings.away;
    const bool on = toward == is_toward;
    if (!choice(app, toward ? "Toward you" : "Away", pose, limb, on, half) || on) continue;
    const int start = start_of_bone(skeleton, joint);
    app.session.commit("Bend " + part_words(app, start) + (toward ? " toward you" : " away"),
                       with_guessed_pose(app.document(), bend.frame, pose, start));
    return;
  }
  // What is beside the two doesn't fall through.
  press_area("Bends which way?", {corner.x, corner.y - kHeight, kWidth, kHeight});
}

}  // namespace

void suggest_pose(App& app) {
  const int frame = app.session.selection.frame;
  app.session.proposal.reset();
  std::vector<Pose> poses = suggested_poses(app.document(), frame);
  // The bone that leans most is asked about first.
  const Skeleton& skeleton = app.document().skeleton;
  double most = 0;
  for (const int joint : drawn_joints(app.document())) {
    const double leaning = std::abs(lean(skeleton, poses[0], joint));
    if (joint == 0 || skeleton.children(joint).size() > 1 || leaning <= most) continue;
    most = leaning;
    app.session.selection.joint = joint;
  }
  app.session.commit("Suggest pose", with_guessed_pose(app.document(), frame, poses[0]));
  app.session.bend = {};
  app.session.bend.frame = frame;
  app.session.rivals = {frame, std::move(poses)};
}

void pose_chooser(App& app, ImVec2 corner) {
  if (app.session.proposal || !app.has_frame()) return;
  if (const int in_use = rival_in_use(app); in_use >= 0)
    rival_chooser(app, corner, in_use);
  else
    bend_chooser(app, corner);
}

}  // namespace artisketch
