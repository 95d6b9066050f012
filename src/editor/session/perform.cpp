// What each command does, and when it can.
#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "document/edit.h"
#include "document/posing.h"
#include "document/skeleton_edit.h"
#include "editor/canvas/pointer.h"
#include "editor/canvas/tools.h"
#include "editor/modes/outline/outline_commands.h"
#include "editor/session/actions.h"
#include "editor/shell/panels.h"

namespace artisketch {

bool available(const Work& work, Command command) {
  const View& view = work.view;
  switch (command) {
    case Command::undo:
      return work.history.can_undo() && !view.welcome;
    case Command::redo:
      return work.history.can_redo() && !view.welcome;
    case Command::save:
    case Command::save_as:
      return !view.welcome;
    case Command::reconstruct:
      return !drawn_joints(work.document()).empty();
    case Command::calibrate:
      return work.document().frames.size() > 1 && !drawn_joints(work.document()).empty() &&
             !work.busy();
    case Command::export_model:
      return !view.welcome && work.built != nullptr;
    case Command::previous_drawing:
    case Command::next_drawing:
      return work.document().frames.size() > 1;
    case Command::fit:
    case Command::zoom_in:
    case Command::zoom_out:
      return work.has_frame();
    case Command::behind:
    case Command::in_front:
    case Command::copy_to:
    case Command::mirror:
    case Command::redraw:
    case Command::other_joint:
    case Command::join:
    case Command::mend:
    case Command::hidden_here:
      return outline_available(work, command);
    case Command::remove:
      if (view.mode == Mode::result) return view.clip > 0 && view.key >= 0;
      return outline_available(work, command) || (view.mode == Mode::skeleton && view.joint >= 0);
    case Command::rename:
      return view.mode == Mode::skeleton && view.joint >= 0;
    case Command::both_sides:
    case Command::equalise:
      return view.mode == Mode::skeleton;
    case Command::flip:
      return view.mode == Mode::pose && view.joint > 0 && work.has_frame();
    case Command::lock:
      return view.mode == Mode::pose && view.joint >= 0;
    case Command::suggest:
      return view.mode == Mode::pose && work.has_frame() && work.frame().contours.size() > 1;
    case Command::set_key:
    case Command::new_clip:
      return view.mode == Mode::result && work.built;
    case Command::copy_pose:
      return view.mode == Mode::pose && work.document().frames.size() > 1;
    case Command::reset:
      return view.mode == Mode::pose ? work.has_frame() : view.mode == Mode::result && view.posed;
    case Command::play:
      return work.built && !work.built->model.clips.empty();
    default:
      return true;
  }
}

std::string what_it_lacks(const Work& work, Command command) {
  if (work.view.welcome || available(work, command)) return "";
  const bool outlined = !drawn_joints(work.document()).empty();
  const std::string first = work.document().frames.empty() ? "Add a drawing first."
                            : !outlined                    ? "Outline a part first."
                                                           : "";
  switch (command) {
    case Command::reconstruct:
      return first;
    case Command::calibrate:
      if (work.busy()) return "";
      return first.empty() ? "One drawing has no other to agree with: add one." : first;
    case Command::export_model:
      return first.empty() ? "Reconstruct makes the model to export." : first;
    case Command::suggest:
      if (work.view.mode != Mode::pose) return "";
      return first.empty() ? "Outline more parts in this drawing first." : first;
    default:
      return "";
  }
}

namespace {

void set_mode(Work& work, Mode mode) {
  // Whoever goes on from the welcome works on a copy of what it shows.
  if (work.view.welcome) {
    work.view.welcome = false;
    work.view.playing = false;
    work.saved = work.history.revision();
  }
  work.view.mode = mode;
  work.view.exporting = work.view.exporting && mode == Mode::result;
  if (mode != Mode::result) work.view.playing = false;
  work.view.posed.reset();
  work.stroke.clear();
  if (mode == Mode::result) work.view.time = work.view.frame;
}

void go_to_drawing(Work& work, int by) {
  const int frames = int(work.document().frames.size());
  work.view.frame = (work.view.frame + by + frames) % frames;
  work.view.contour = -1;
  work.view.time = work.view.frame;
  work.view.posed.reset();
}

// Takes up the mode's tool of that command, where it has it.
void arm(Work& work, Command command) {
  const std::vector<RailEntry> tools = tools_of(work.view.mode);
  const auto found = std::find_if(tools.begin(), tools.end(), [&](const RailEntry& e) {
    return e.command == command && e.tool;
  });
  if (found == tools.end()) return;
  work.view.tool() = *found->tool;
  work.view.picking_joint = work.view.joining = work.view.redrawing = false;
  work.stroke.clear();
}

void step_back(Work& work) {
  View& view = work.view;
  if (work.busy()) {
    work.jobs.cancel();
  } else if (work.bend.frame >= 0) {
    work.bend = {};
  } else if (work.outline) {
    work.outline.reset();
  } else if (!work.stroke.empty()) {
    work.stroke.clear();
  } else if (view.picking_joint || view.joining || view.redrawing) {
    view.picking_joint = view.joining = view.redrawing = false;
  } else if (view.exporting) {
    view.exporting = false;
  } else if (view.posed) {
    view.posed.reset();
  } else {
    view.contour = view.joint = -1;
  }
}

void toggle_play(Work& work) {
  View& view = work.view;
  view.playing = !view.playing;
  view.posed.reset();
  if (!view.welcome && view.mode != Mode::result) view.mode = Mode::result;
  const std::vector<double>& times = work.built->model.clips[std::size_t(view.clip)].times;
  if (view.playing && !times.empty() && view.time >= times.back()) view.time = 0;
}

void delete_joint(Work& work) {
  const int joint = work.view.joint;
  const std::string name = joint_words(work.document().skeleton.joints[joint].name).whole();
  std::optional<Document> next = without_joint(work.document(), joint, work.view.both_sides);
  if (!next) {
    Toast toast;
    toast.words = "All others hang on " + name + ". Delete those first.";
    work.say(std::move(toast));
    return;
  }
  const std::string& above =
      work.document()
          .skeleton.joints[std::max(0, work.document().skeleton.joints[joint].parent)]
          .name;
  const int parent = next->skeleton.find(above);
  work.commit("Delete " + name, std::move(*next));
  work.view.joint = parent;
}

void equalise(Work& work) {
  const int joint = work.view.joint;
  const std::string whose =
      joint < 0 ? "pairs" : joint_words(work.document().skeleton.joints[joint].name).name;
  work.commit("Equalise " + whose, with_pair_lengths_equal(work.document(), joint));
}

void add_blank_drawing(Work& work) {
  if (work.view.welcome) new_document(work);
  Frame frame;
  frame.name = "Drawing " + std::to_string(work.document().frames.size() + 1);
  frame.width = work.has_frame() ? work.frame().width : 800;
  frame.height = work.has_frame() ? work.frame().height : 800;
  const std::string name = frame.name;
  work.commit("Add " + name, with_frame(work.document(), std::move(frame)));
  work.view.frame = int(work.document().frames.size()) - 1;
  work.view.fit_again();
  work.view.tool() = work.view.mode == Mode::outline ? Tool::draw : work.view.tool();
}

void zoom_in_middle(View& view, float factor) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const ImVec2 about{size.x * 0.3f, size.y * 0.45f};
  view.origin = {about.x + factor * (view.origin.x - about.x),
                 about.y + factor * (view.origin.y - about.y)};
  view.zoom *= factor;
  view.fit = false;
}

}  // namespace

void perform(Work& work, Command command) {
  if (!available(work, command)) {
    Toast toast;
    toast.words = what_it_lacks(work, command);
    if (!toast.words.empty()) work.say(std::move(toast));
    return;
  }
  View& view = work.view;
  switch (command) {
    case Command::none:
      break;
    case Command::new_document:
      unless_unsaved(work, [&work] { new_document(work); });
      break;
    case Command::open:
      unless_unsaved(work, [&work] {
        if (work.platform.has_dialogs())
          return work.platform.open_files(Platform::Kind::document, [&work](auto files) {
            open_files(work, std::move(files));
          });
        ask_for_path(work, "Open", "The path of a document");
      });
      break;
    case Command::add_drawings:
      if (work.platform.has_dialogs())
        work.platform.open_files(Platform::Kind::drawings,
                                 [&work](auto files) { open_files(work, std::move(files)); });
      else
        ask_for_path(work, "Add a drawing", "The path of a PNG or JPEG");
      break;
    case Command::save:
      save(work, false);
      break;
    case Command::save_as:
      save(work, true);
      break;
    case Command::blank_drawing:
      add_blank_drawing(work);
      break;
    case Command::export_model:
      view.exporting = !view.exporting;
      if (view.exporting && view.mode != Mode::result) set_mode(work, Mode::result);
      break;
    case Command::undo:
      work.undo();
      break;
    case Command::redo:
      work.redo();
      break;
    case Command::reconstruct:
      start_job(work, JobRequest::Kind::reconstruct);
      break;
    case Command::calibrate:
      start_job(work, JobRequest::Kind::calibrate);
      break;
    case Command::cancel_job:
      step_back(work);
      break;
    case Command::mode_outline:
      set_mode(work, Mode::outline);
      break;
    case Command::mode_skeleton:
      set_mode(work, Mode::skeleton);
      break;
    case Command::mode_pose:
      set_mode(work, Mode::pose);
      break;
    case Command::mode_result:
      set_mode(work, Mode::result);
      break;
    case Command::previous_drawing:
      go_to_drawing(work, -1);
      break;
    case Command::next_drawing:
      go_to_drawing(work, 1);
      break;
    case Command::show_drawing:
      view.layer().drawing = !view.layer().drawing;
      break;
    case Command::show_bones:
      view.layer().bones = !view.layer().bones;
      break;
    case Command::show_model:
      view.layer().model = !view.layer().model;
      break;
    case Command::fit:
      view.fit_again();
      break;
    case Command::home:
      if (const Built* shown = work.shown()) look_at(work, shown->model);
      break;
    case Command::zoom_in:
      zoom_in_middle(view, 1.25f);
      break;
    case Command::zoom_out:
      zoom_in_middle(view, 0.8f);
      break;
    case Command::play:
      if (!(work.proposal && view.mode == Mode::pose)) toggle_play(work);  // there it compares
      break;
    case Command::fade:
      view.layer().drawing_opacity = view.layer().drawing_opacity > 0.5f ? 0.3f : 0.85f;
      break;
    case Command::theme:
      view.dark = !view.dark;
      work.platform.store("theme", view.dark ? "dark" : "light");
      break;
    case Command::help:
      view.help = !view.help;
      break;
    case Command::tool_edit:
    case Command::tool_pose:
    case Command::tool_draw:
    case Command::tool_points:
    case Command::tool_trace:
    case Command::tool_cut:
    case Command::tool_twist:
    case Command::tool_turn:
    case Command::tool_orbit:
    case Command::tool_joints:
    case Command::tool_fatness:
      arm(work, command);
      break;
    case Command::mirror:
    case Command::copy_to:
    case Command::behind:
    case Command::in_front:
    case Command::redraw:
    case Command::other_joint:
    case Command::join:
    case Command::mend:
    case Command::hidden_here:
      outline_command(work, command);
      break;
    case Command::remove:
      if (view.mode == Mode::skeleton)
        delete_joint(work);
      else if (view.mode == Mode::result)
        remove_key(work);
      else
        outline_command(work, command);
      break;
    case Command::both_sides:
      view.both_sides = !view.both_sides;
      break;
    case Command::equalise:
      equalise(work);
      break;
    case Command::rename:
      work.naming.begin = true;
      break;
    case Command::flip: {
      const Skeleton& skeleton = work.document().skeleton;
      const std::string name = part_words(work, start_of_bone(skeleton, view.joint));
      work.commit("Flip " + name, with_pose(work.document(), view.frame,
                                            with_bone_flipped(skeleton, work.frame().pose,
                                                              end_of_bone(skeleton, view.joint))));
      break;
    }
    case Command::lock: {
      const bool locked = is_locked(work.document(), view.joint);
      work.commit((locked ? "Free " : "Lock ") + part_words(work, view.joint),
                  with_lock(work.document(), view.joint, !locked));
      break;
    }
    case Command::set_key:
      set_key(work);
      break;
    case Command::new_clip:
      new_clip(work);
      break;
    case Command::suggest:
      suggest_pose(work);
      break;
    case Command::copy_pose:
      view.choosing_pose = true;
      break;
    case Command::reset:
      if (view.mode == Mode::result)
        view.posed.reset();
      else
        work.commit("Reset pose", with_pose(work.document(), view.frame,
                                            fitted_rest_pose(work.document(), work.frame())));
      break;
  }
}

}  // namespace artisketch
