#include "editor/session/app.h"

#include <algorithm>
#include <cassert>

namespace artisketch {

void Tool::paint(const App&, const Pointer&, const Stage&) const {}
void Tool::cancel(App&) {}

App::App(Platform& platform, Jobs& jobs, Graphics& graphics, std::span<const ToolRow> rows,
         std::vector<Command> all_commands)
    : services(platform, jobs, graphics), tools(rows), commands(std::move(all_commands)) {
  for (std::size_t row = 0; row < tools.size(); ++row)
    if (tools[row].usual) view.armed[std::size_t(tools[row].mode)] = row;
  lay_out_tools();
}

void App::open(Document document) {
  ++services.openings;
  if (services.jobs.busy()) services.jobs.cancel();
  (void)services.jobs.poll();  // what it brought was for the document before
  std::erase_if(toasts,
                [](const Toast& toast) { return !toast.action.empty() && !toast.outlives; });
  session = Session(std::move(document));
  lay_out_tools();
  view.begin();
}

void App::say(Toast toast) {
  std::erase_if(toasts, [&](const Toast& said) { return said.words == toast.words; });
  toasts.push_back(std::move(toast));
}

void App::lay_out_tools() {
  for (const ToolRow& row : tools) session.tools.push_back(row.make());
}

void App::take_up(const ToolRow& row) {
  tool().cancel(*this);
  view.armed[std::size_t(row.mode)] = std::size_t(&row - tools.data());
  session.next = {};
}

void App::take_up(Mode mode, std::string_view id) {
  for (const ToolRow& row : tools)
    if (row.mode == mode && row.id == id) return take_up(row);
  assert(!"no such tool");
}

void App::drop_gesture() {
  tool().cancel(*this);
  session.drop_gesture();
}

const BuiltModel* App::shown() const {
  const bool result = view.mode == Mode::result || view.welcome;
  const BuiltModel* parts = session.live.model.get();
  if (result && !view.welcome && tool().shows_parts() && session.stale() && parts) return parts;
  if (session.built && (result || !session.stale() || !parts)) return session.built.get();
  const std::optional<Proposal>& proposal = session.proposal;
  if (view.mode == Mode::pose && proposal && proposal->model && proposal->theirs())
    return proposal->model.get();
  return parts;
}

Pose App::shown_pose() const {
  const BuiltModel& model = *shown();
  const std::vector<Clip>& clips = model.model.clips;
  if (view.mode == Mode::result || view.welcome) {
    const Playback& playback = session.playback;
    if (playback.posed) return *playback.posed;
    return clips.empty() ? rest_pose(model.model.skeleton)
                         : pose_at(clips[std::min(std::size_t(playback.clip), clips.size() - 1)],
                                   playback.time);
  }
  if (shows_parts() && has_frame()) return drawn_pose();
  if (clips.empty() || clips[0].poses.empty()) return rest_pose(model.model.skeleton);
  return clips[0].poses[std::min(std::size_t(session.selection.frame), clips[0].poses.size() - 1)];
}

Vec3 App::shown_footing() const {
  const BuiltModel& model = *shown();
  if (model.footing.empty() || model.footing[0].empty()) return Vec3::Zero();
  if (view.mode == Mode::result || view.welcome)
    return footing_at(model, std::min(session.playback.clip, int(model.footing.size()) - 1),
                      session.playback.time);
  return model
      .footing[0][std::min(std::size_t(session.selection.frame), model.footing[0].size() - 1)];
}

namespace {
constexpr double kCalibrating = 0.6;  // seconds from the person's pose to the calibrated one
}

bool App::changing_pose() const {
  return session.proposal && services.now < session.proposal->since + kCalibrating;
}

Pose App::drawn_pose() const {
  const Pose& mine = frame().pose;
  if (view.mode == Mode::skeleton) {
    // The rest pose, as the body stands in this drawing.
    Pose rest = mine;
    for (std::size_t j = 1; j < rest.rotations.size(); ++j) rest.rotations[j].setIdentity();
    return rest;
  }
  const std::optional<Proposal>& proposal = session.proposal;
  if (!proposal || !proposal->theirs()) return mine;
  const Pose& theirs = proposal->document.frames[std::size_t(session.selection.frame)].pose;
  const double t = std::clamp((services.now - proposal->since) / kCalibrating, 0.0, 1.0);
  return pose_at({"", {0, 1}, {mine, theirs}}, t * t * (3 - 2 * t));
}

}  // namespace artisketch
