// Result: playing, keys and clips, and the model out.
#include <cmath>

#include "document/animate.h"
#include "document/edit.h"
#include "editor/modes/mode_commands.h"
#include "editor/modes/result/exports.h"
#include "editor/session/app.h"
#include "editor/session/commands.h"
#include "editor/ui/icons.h"

namespace artisketch {
namespace {

// In Pose the key compares a calibrated pose with the person's.
bool can_play(const App& app) {
  return app.session.built && !app.session.built->model.clips.empty() &&
         (app.view.welcome || app.view.mode == Mode::result);
}

void play_or_pause(App& app) {
  Playback& playback = app.session.playback;
  playback.playing = !playback.playing;
  playback.posed.reset();
  if (!app.view.welcome && app.view.mode != Mode::result) {
    app.tool().cancel(app);
    app.view.mode = Mode::result;
  }
  const std::vector<double>& times =
      app.session.built->model.clips[std::size_t(playback.clip)].times;
  if (playback.playing && !times.empty() && playback.time >= times.back()) playback.time = 0;
}

// The pose shown, by the document's joints: they may be others than the model's by now.
Pose pose_to_keep(const App& app) {
  const Skeleton &mine = app.document().skeleton, &shown = app.shown()->model.skeleton;
  const Pose pose = app.shown_pose();
  Pose kept = rest_pose(mine);
  kept.root_position = pose.root_position;
  for (int j = 0; j < shown.size(); ++j)
    if (const int joint = mine.find(shown.joints[std::size_t(j)].name); joint >= 0)
      kept.rotations[std::size_t(joint)] = pose.rotations[std::size_t(j)];
  return kept;
}

void new_clip(App& app) {
  app.session.commit("New clip", with_clip(app.document(), pose_to_keep(app)));
  Playback& playback = app.session.playback;
  playback.clip = int(app.session.built->model.clips.size()) - 1;
  playback.time = 0;
  playback.key = 0;
  playback.playing = false;
  playback.posed.reset();
}

// Of the pose shown, at the playhead.
void set_key(App& app) {
  Playback& playback = app.session.playback;
  // The clip of the drawings has a key per drawing: a pose of one's own begins another.
  if (playback.clip == 0) return new_clip(app);
  const double time = playback.time;
  const std::string name = app.session.built->model.clips[std::size_t(playback.clip)].name;
  app.session.commit("Set key of " + name,
                     with_key(app.document(), playback.clip - 1, time, pose_to_keep(app)));
  playback.playing = false;
  playback.posed.reset();
  const std::vector<double>& times =
      app.session.built->model.clips[std::size_t(playback.clip)].times;
  for (int k = 0; k < int(times.size()); ++k)
    if (std::abs(times[std::size_t(k)] - time) < kLeastStep) playback.key = k;
}

void delete_key(App& app) {
  const int clip = app.session.playback.clip - 1, key = app.session.playback.key;
  if (clip >= int(app.document().animations.size())) return;
  const Animation& animation = app.document().animations[std::size_t(clip)];
  if (key >= int(animation.keys.size())) return;
  app.session.commit("Delete key of " + animation.name, without_key(app.document(), clip, key));
  app.session.playback.key = -1;
}

bool has_model(const App& app) {
  return app.session.built != nullptr;
}

std::string export_lacks(const App& app) {
  const std::string first = what_comes_first(app);
  return first.empty() ? "Reconstruct makes the model to export." : first;
}

void open_or_close_export(App& app) {
  app.view.exporting = !app.view.exporting;
  if (app.view.exporting && app.view.mode != Mode::result) perform(app, "mode_result");
}

// What the person changed since is made first.
void export_as_chosen(App& app) {
  if (!app.session.stale() || !available(app, "reconstruct")) return export_model(app);
  app.session.export_wish.waits = true;
  perform(app, "reconstruct");
}

std::vector<Command> commands_of_everywhere() {
  return {
      {.id = "export",
       .name = "Export",
       .icon = icon::kExport,
       .key = ImGuiKey_E,
       .ctrl = true,
       .available = [](const App& app) { return !app.view.welcome && has_model(app); },
       .what_it_lacks = export_lacks,
       .on = [](const App& app) { return app.view.exporting; },
       .run = open_or_close_export},
      {.id = "export_file",
       .name = "Export as chosen",
       .icon = icon::kDownload,
       .available = has_model,
       .run = export_as_chosen},
      {.id = "export_as_it_is",
       .name = "Export the model as it is",
       .available = has_model,
       .run = export_model},
      {.id = "play",
       .name = "Play",
       .icon = icon::kPlay,
       .key = ImGuiKey_P,
       .available = can_play,
       .run = play_or_pause},
  };
}

}  // namespace

std::vector<Command> result_commands() {
  std::vector<Command> all = commands_of_everywhere();
  std::vector<Command> own = {
      {.id = "set_key",
       .name = "Set key",
       .icon = icon::kKeyVariant,
       .about = "Keep this pose at the playhead",
       .key = ImGuiKey_I,
       .in_rail = true,
       .available = has_model,
       .run = set_key},
      {.id = "new_clip",
       .name = "New clip",
       .icon = icon::kPlus,
       .about = "An animation of your own, from this pose on",
       .available = has_model,
       .run = new_clip},
      {.id = "reset_model",
       .name = "Reset",
       .icon = icon::kBackupRestore,
       .in_rail = true,
       .available = [](const App& app) { return app.session.playback.posed.has_value(); },
       .run = [](App& app) { app.session.playback.posed.reset(); }},
      {.id = "delete_key",
       .name = "Delete",
       .icon = icon::kDelete,
       .key = ImGuiKey_Delete,
       .other_key = ImGuiKey_Backspace,
       .available =
           [](const App& app) {
             return app.session.playback.clip > 0 && app.session.playback.key >= 0;
           },
       .run = delete_key},
  };
  for (Command& command : own) {
    command.mode = Mode::result;
    all.push_back(std::move(command));
  }
  return all;
}

}  // namespace artisketch
