#include "editor/session/motions_in.h"

#include <algorithm>

#include "document/animate.h"
#include "editor/session/files.h"
#include "files/motion_file.h"
#include "model/rig/library.h"

namespace artisketch {
namespace {

void choose_clip(App& app, int clip) {
  Playback& playback = app.session.playback;
  playback.clip = clip;
  playback.time = 0;
  playback.key = -1;
  playback.posed.reset();
  playback.playing = true;
  app.view.mode = Mode::result;
}

// The last clip of the document's is chosen and played.
void commit_clips(App& app, const std::string& undo_name, Document document) {
  app.session.commit(undo_name, std::move(document));
  if (app.session.built) choose_clip(app, int(app.session.built->model.clips.size()) - 1);
}

Document with_mover(Document document, int joint, const std::optional<std::string>& mover) {
  auto& pairs = document.motion.joints;
  std::erase_if(pairs, [&](const auto& pair) {
    return pair.second == joint || (!pair.first.empty() && pair.first == mover);
  });
  if (mover) pairs.emplace_back(*mover, joint);
  return document;
}

void say_what_moves(App& app, const DroppedMotion& dropped) {
  Toast toast;
  for (std::size_t i = 0; i < dropped.motions.size(); ++i) {
    const Retargeted& made = dropped.made[i];
    toast.words +=
        (toast.words.empty() ? "" : "; ") + mapping_words(app.document(), dropped.motions[i], made);
    for (const std::string& warning : made.warnings)
      if (toast.words.find(warning) == toast.words.npos) toast.words += "; " + warning;
    toast.error |= !made.warnings.empty();
  }
  toast.action = "Change";
  toast.act = [&app] { app.view.mapping = true; };
  app.say(std::move(toast));
}

// The clips anew for the document, which has their pairs.
void make_again(App& app, const std::string& undo_name, Document document) {
  DroppedMotion& dropped = *app.session.dropped;
  for (std::size_t i = 0; i < dropped.motions.size(); ++i) {
    Result<Retargeted> moved = retargeted(document, dropped.motions[i], dropped.options);
    if (!moved) return complain(app, moved.error());
    Animation& animation = document.animations[dropped.first + i];
    animation.keys = animation_of(moved->clip).keys;
    dropped.made[i] = std::move(*moved);
  }
  app.session.commit(undo_name, std::move(document));
  dropped.revision = app.session.history.revision();
  if (app.session.built) choose_clip(app, int(dropped.first) + 1);
}

}  // namespace

void add_clip(App& app, const std::string& undo_name, Animation animation) {
  commit_clips(app, undo_name, with_animation(app.document(), std::move(animation)));
}

void add_motion(App& app, const NamedBytes& file) {
  const std::string name = file.name.substr(0, file.name.rfind('.'));
  Result<std::vector<Motion>> motions = parse_motions(file.bytes, name, file.name);
  if (!motions) return complain(app, motions.error());
  Document document = app.document();
  DroppedMotion dropped;
  dropped.first = document.animations.size();
  for (const Motion& motion : *motions) {
    Result<Retargeted> moved = retargeted(document, motion, {});
    if (!moved) return complain(app, moved.error());
    document = with_animation(std::move(document), animation_of(moved->clip));
    dropped.made.push_back(std::move(*moved));
  }
  std::size_t keys = 0;
  for (const Animation& one : document.animations) keys += one.keys.size();
  if (keys > kMostKeys)
    return complain(app, bad_input(file.name + " is too long: a document has " +
                                   std::to_string(kMostKeys) + " keys at most"));
  dropped.motions = std::move(*motions);
  app.tool().cancel(app);
  commit_clips(app, "Add " + name, std::move(document));
  dropped.revision = app.session.history.revision();
  for (std::size_t i = 0; i < dropped.motions.size(); ++i)
    dropped.clips.push_back(app.document().animations[dropped.first + i].name);
  app.session.dropped = std::move(dropped);
  say_what_moves(app, *app.session.dropped);
}

DroppedMotion* dropped_motion(App& app) {
  std::optional<DroppedMotion>& dropped = app.session.dropped;
  if (!dropped) return nullptr;
  const std::vector<Animation>& there = app.document().animations;
  for (std::size_t i = 0; i < dropped->clips.size(); ++i)
    if (dropped->first + i >= there.size() || there[dropped->first + i].name != dropped->clips[i])
      return nullptr;
  if (dropped->revision == app.session.history.revision()) return &*dropped;
  // Something was done or undone since: what moves what may be another.
  dropped->revision = app.session.history.revision();
  for (std::size_t i = 0; i < dropped->motions.size(); ++i)
    if (Result<Retargeted> moved =
            retargeted(app.document(), dropped->motions[i], dropped->options))
      dropped->made[i] = std::move(*moved);
    else
      return nullptr;
  return &*dropped;
}

void map_joint(App& app, int joint, const std::optional<std::string>& mover) {
  if (!dropped_motion(app)) return;
  make_again(app, "Map " + app.document().skeleton.joints[std::size_t(joint)].name,
             with_mover(app.document(), joint, mover));
}

void retarget_again(App& app, const std::string& undo_name, const RetargetOptions& options) {
  if (!dropped_motion(app)) return;
  app.session.dropped->options = options;
  make_again(app, undo_name, app.document());
}

}  // namespace artisketch
