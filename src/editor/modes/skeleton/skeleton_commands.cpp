// Skeleton: what can be done to the chosen joint.
#include <algorithm>

#include "document/edit.h"
#include "document/skeleton_edit.h"
#include "editor/canvas/pointer.h"
#include "editor/modes/mode_commands.h"
#include "editor/modes/nudging.h"
#include "editor/modes/skeleton/skeleton_edits.h"
#include "editor/session/app.h"
#include "editor/ui/icons.h"
#include "editor/ui/keys.h"

namespace artisketch {
namespace {

bool is_chosen(const App& app) {
  return app.session.selection.joint >= 0;
}

void nudge(App& app, const Vec2& by) {
  const int joint = app.session.selection.joint;
  const Transform at = posed_joints(app.document().skeleton, app.drawn_pose())[std::size_t(joint)];
  const FrameCamera camera = frame_camera(app.document(), app.session.selection.frame);
  move_joint(app, joint, camera.project(at.translation()) + by);
}

bool is_seen(const App& app) {
  return is_chosen(app) && app.has_frame();
}

void equalise(App& app) {
  const int joint = app.session.selection.joint;
  const std::string whose =
      joint < 0 ? "pairs"
                : joint_words(app.document().skeleton.joints[std::size_t(joint)].name).name;
  app.session.commit("Equalise " + whose, with_pair_lengths_equal(app.document(), joint));
}

void delete_joint(App& app) {
  const std::vector<Joint>& joints = app.document().skeleton.joints;
  const int joint = app.session.selection.joint;
  const std::string name = part_words(app, joint);
  std::optional<Document> next = without_joint(app.document(), joint, app.view.both_sides);
  if (!next) {
    Toast toast;
    toast.words = "All others hang on " + name + ". Delete those first.";
    app.say(std::move(toast));
    return;
  }
  const int parent = std::max(0, joints[std::size_t(joint)].parent);
  const int chosen = next->skeleton.find(joints[std::size_t(parent)].name);
  app.session.commit("Delete " + name, std::move(*next));
  app.session.selection.joint = chosen;
}

}  // namespace

std::vector<Command> skeleton_commands() {
  std::vector<Command> all = {
      {.id = "both_sides",
       .name = "Mirror",
       .icon = icon::kCompare,
       .about = "Do to both sides what is done to one",
       .key = ImGuiKey_X,
       .on = [](const App& app) { return app.view.both_sides; },
       .run = [](App& app) { app.view.both_sides ^= true; }},
      {.id = "equalise",
       .name = "Equalise",
       .icon = icon::kSwapHorizontal,
       .about = "Make the bone as long as its mirror image; all pairs where none is chosen",
       .key = ImGuiKey_L,
       .in_menu = true,
       .run = equalise},
      {.id = "rename",
       .name = "Rename",
       .icon = icon::kKeyboard,
       .about = "Name the joint",
       .key = ImGuiKey_F2,
       .in_menu = true,
       .available = is_chosen,
       .run =
           [](App& app) {
             app.session.naming.begin = true;
             await_text_field();
           }},
      {.id = "delete_joint",
       .name = "Delete",
       .icon = icon::kDelete,
       .key = ImGuiKey_Delete,
       .other_key = ImGuiKey_Backspace,
       .in_menu = true,
       .available = is_chosen,
       .run = delete_joint},
  };
  for (Command& command : all) command.in_rail = true;
  for (Command& command : nudge_commands("nudge_bone", is_seen, nudge))
    all.push_back(std::move(command));
  for (Command& command : all) command.mode = Mode::skeleton;
  return all;
}

}  // namespace artisketch
