// Pose: what can be done to the pose of the drawing in view.
#include "document/edit.h"
#include "document/posing.h"
#include "editor/canvas/pointer.h"
#include "editor/modes/mode_commands.h"
#include "editor/modes/nudging.h"
#include "editor/modes/pose/pose_edits.h"
#include "editor/modes/pose/pose_suggest.h"
#include "editor/session/app.h"
#include "editor/session/commands.h"
#include "editor/ui/icons.h"

namespace artisketch {
namespace {

void flip(App& app) {
  const Skeleton& skeleton = app.document().skeleton;
  const Selection& selection = app.session.selection;
  app.session.commit("Flip " + part_words(app, start_of_bone(skeleton, selection.joint)),
                     with_pose(app.document(), selection.frame,
                               with_bone_flipped(skeleton, app.frame().pose,
                                                 end_of_bone(skeleton, selection.joint))));
}

void lock_or_free(App& app) {
  const int joint = app.session.selection.joint;
  const bool locked = is_locked(app.document(), joint);
  app.session.commit((locked ? "Free " : "Lock ") + part_words(app, joint),
                     with_lock(app.document(), joint, !locked));
}

void reset_pose(App& app) {
  app.session.commit("Reset pose", with_rest_pose(app.document(), app.session.selection.frame));
}

void take_pose_as_it_is(App& app) {
  app.session.commit("Take pose as it is",
                     with_frame_posed(app.document(), app.session.selection.frame));
}

bool is_chosen(const App& app) {
  return app.session.selection.joint >= 0 && app.has_frame();
}

void nudge(App& app, const Vec2& by) {
  const int joint = app.session.selection.joint;
  const Transform at = posed_joints(app.document().skeleton, app.frame().pose)[std::size_t(joint)];
  const FrameCamera camera = frame_camera(app.document(), app.session.selection.frame);
  drag_joint(app, joint, camera.project(at.translation()) + by);
}

// The body, as a drag of the ball beside it does.
std::vector<Command> turning_commands() {
  struct Way {
    const char *id, *name;
    ImGuiKey key;
    Vec3 axis;
  };
  const Way ways[] = {{"turn_left", "Turn the body left", ImGuiKey_LeftArrow, -Vec3::UnitY()},
                      {"turn_right", "Turn the body right", ImGuiKey_RightArrow, Vec3::UnitY()},
                      {"turn_up", "Turn the body up", ImGuiKey_UpArrow, -Vec3::UnitX()},
                      {"turn_down", "Turn the body down", ImGuiKey_DownArrow, Vec3::UnitX()}};
  constexpr double kStep = 5;  // degrees
  std::vector<Command> rows;
  for (const Way& way : ways) {
    Command row;
    row.id = way.id;
    row.name = way.name;
    row.key = way.key;
    row.ctrl = row.repeats = true;
    row.available = [](const App& app) { return app.has_frame(); };
    row.run = held_down([axis = way.axis](App& app) {
      turn_body(app, Quat(Eigen::AngleAxisd(radians(kStep), axis)));
    });
    rows.push_back(std::move(row));
  }
  return rows;
}

std::string suggest_lacks(const App& app) {
  const std::string first = what_comes_first(app);
  return first.empty() ? "Outline more parts in this drawing first." : first;
}

}  // namespace

std::vector<Command> pose_commands() {
  std::vector<Command> all = {
      {.id = "flip",
       .name = "Flip",
       .icon = icon::kSwapHorizontal,
       .about = "Flip the bone toward you or away",
       .key = ImGuiKey_F,
       .available =
           [](const App& app) { return app.session.selection.joint > 0 && app.has_frame(); },
       .run = flip},
      {.id = "lock",
       .name = "Lock",
       .icon = icon::kLockOutline,
       .about = "Calibration keeps this part's turn, or may change it again",
       .key = ImGuiKey_L,
       .available = [](const App& app) { return app.session.selection.joint >= 0; },
       .run = lock_or_free},
      {.id = "suggest",
       .name = "Suggest",
       .icon = icon::kAutoFix,
       .about = "Find a pose from the outlines",
       .key = ImGuiKey_S,
       .available =
           [](const App& app) { return app.has_frame() && app.frame().contours.size() > 1; },
       .what_it_lacks = suggest_lacks,
       .run = suggest_pose},
      {.id = "copy_pose",
       .name = "Copy",
       .icon = icon::kContentCopy,
       .about = "Take the pose of another drawing",
       .key = ImGuiKey_C,
       .available = [](const App& app) { return app.document().frames.size() > 1; },
       .run = [](App& app) { app.view.choosing_pose = true; }},
      {.id = "posed_here",
       .name = "Right as it is",
       .icon = icon::kCheck,
       .about = "The drawing shows the figure in the pose that its skeleton has",
       .available =
           [](const App& app) {
             return app.has_frame() && !is_posed(app.document(), app.session.selection.frame);
           },
       .run = take_pose_as_it_is},
      {.id = "reset_pose",
       .name = "Reset",
       .icon = icon::kBackupRestore,
       .available = [](const App& app) { return app.has_frame(); },
       .run = reset_pose},
  };
  for (Command& command : all) {
    command.mode = Mode::pose;
    command.in_menu = true;
    command.in_rail =
        command.id != std::string_view("posed_here");  // the panel has it, where asked
  }
  for (const auto& some : {nudge_commands("nudge_joint", is_chosen, nudge), turning_commands()})
    for (const Command& command : some) {
      all.push_back(command);
      all.back().mode = Mode::pose;
    }
  return all;
}

}  // namespace artisketch
