#include "editor/editor.h"

#include <algorithm>
#include <utility>

#include <imgui.h>

#include "editor/modes/mode_commands.h"
#include "editor/modes/outline/missing_card.h"
#include "editor/modes/result/timeline.h"
#include "editor/modes/tools.h"
#include "editor/session/app.h"
#include "editor/session/commands.h"
#include "editor/session/files.h"
#include "editor/session/hints.h"
#include "editor/session/jobs.h"
#include "editor/session/language.h"
#include "editor/session/live.h"
#include "editor/shell/panels.h"
#include "editor/ui/keys.h"
#include "editor/ui/ui.h"

namespace artisketch {

namespace {

// In the order of the sheet of shortcuts.
std::vector<Command> all_commands() {
  std::vector<Command> all;
  for (const auto& some : {file_commands, edit_commands, view_commands, tool_commands,
                           outline_commands, skeleton_commands, pose_commands, result_commands})
    for (Command& command : some()) all.push_back(std::move(command));
  return all;
}

}  // namespace

struct Editor::Parts {
  App app;
  std::vector<Widget> widgets;
  std::string message;
  bool begun = false;
  double drawn_at = 0;  // by the platform's clock

  Parts(Platform& platform, Jobs& jobs, Graphics& graphics)
      : app(platform, jobs, graphics, all_tools(), all_commands()) {
    View& view = app.view;
    view.dark = platform.prefers_dark();
    platform.load("theme", [&view](const std::string& name) {
      if (!name.empty()) view.dark = name == "dark";
    });
    recall_language(app);
    recall_hints(app);
    view.layers[std::size_t(Mode::pose)].drawing_opacity = 0.42f;
    Layers& result = view.layers[std::size_t(Mode::result)];
    result.drawing_opacity = 0.3f;
    result.model = true;
    result.bones = false;
  }
};

Editor::Editor(Platform& platform, Jobs& jobs, Graphics& graphics)
    : parts_(new Parts(platform, jobs, graphics)) {}
Editor::~Editor() = default;

void Editor::open(Result<std::vector<NamedBytes>> files) {
  parts_->begun = true;
  open_files(parts_->app, std::move(files));
}

bool Editor::close() {
  App& app = parts_->app;
  unless_unsaved(app, [&app] { app.closed = true; });
  return app.closed;
}
bool Editor::closed() const {
  return parts_->app.closed;
}

namespace {

void greet(App& app) {
  new_document(app);
  app.view.welcome = true;
  app.services.examples = app.services.platform.examples();
  if (!app.services.examples.empty()) open_example(app, app.services.examples.front().name, true);
}

// Whether pictures are to be rough: from the first slow frame of a drag to its end.
bool hurried(bool before) {
  constexpr float kSlow = 1 / 25.0f;  // seconds
  const ImGuiIO& io = ImGui::GetIO();
  float held = -1;
  for (const int button : {ImGuiMouseButton_Left, ImGuiMouseButton_Middle})
    held = std::max(held, io.MouseDownDuration[button]);
  return held >= 0 && (before || (io.DeltaTime > kSlow && held > io.DeltaTime));
}

// What greets rests while the gallery lies over it.
bool plays(const App& app) {
  return app.session.playback.playing && !(app.view.welcome && app.view.gallery);
}

void advance(App& app) {
  View& view = app.view;
  if (!plays(app) || !app.session.built || app.session.built->model.clips.empty()) return;
  const std::vector<double>& times =
      app.session.built->model.clips[std::size_t(app.session.playback.clip)].times;
  const double end = times.empty() ? 0 : times.back();
  // After a rest the clock has run on: no leap.
  app.session.playback.time += std::min(0.1, double(ImGui::GetIO().DeltaTime));
  constexpr double kLast = 0.6;  // seconds on the last key before it begins again
  if (app.session.playback.time > end + kLast) {
    app.session.playback.time = view.looping || view.welcome ? 0 : end;
    app.session.playback.playing = view.looping || view.welcome;
  }
  // The first clip goes through the drawings, and they follow. What greets shows none: whoever goes
  // on from there begins with the first, however long it has played.
  if (!view.welcome && app.session.playback.clip == 0 && !app.document().frames.empty())
    app.session.show_frame(
        std::min(int(app.session.playback.time + 0.5), int(app.document().frames.size()) - 1));
}

}  // namespace

void Editor::touch(const Fingers& fingers) {
  App& app = parts_->app;
  app.fingers = fingers;
  // The first finger may have begun something before the second came.
  if (fingers.began) app.drop_gesture();
  if (fingers.tapped == 2) app.ask("undo");
  if (fingers.tapped == 3) app.ask("redo");
}

std::vector<std::string> Editor::commands() const {
  std::vector<std::string> ids;
  for (const Command& command : parts_->app.commands) ids.push_back(command.id);
  return ids;
}

void Editor::ask(const std::string& id) {
  parts_->app.ask(command(parts_->app, id).id);
}

void Editor::frame(float width, float height, float pixel_ratio) {
  App& app = parts_->app;
  parts_->drawn_at = app.services.platform.now();
  app.services.now = ImGui::GetTime();
  ++app.services.frames;
  if (!parts_->begun) greet(app);
  if (!parts_->begun) offer_recovery(app);
  parts_->begun = true;
  use_theme(app.view.dark ? dark_theme() : light_theme());
  parts_->widgets.clear();
  begin_controls(parts_->widgets);
  app.services.hurried = hurried(app.services.hurried);
  collect_job(app);
  advance(app);
  follow_hints(app);
  const bool asking = app.question || app.view.help || !app.picking.empty();
  if (asking)
    app.asked.clear();
  else
    for (const std::string_view command : pressed_commands(app)) app.ask(command);
  if (app.session.proposal)
    app.session.proposal->peeking =
        ImGui::IsKeyDown(ImGuiKey_P) && !ImGui::GetIO().WantTextInput && !asking;

  const Layout layout = lay_out(width, height, app.view);
  top_bar(app, layout);
  if (app.view.welcome) {
    welcome(app, layout, pixel_ratio);
  } else {
    if (layout.swapped) model_panel(app, layout, pixel_ratio);
    sketch_panel(app, layout, pixel_ratio);
    keep_live(app);  // what was dragged there is computed while the rest is drawn
    const bool tall =
        layout.tablet && (app.view.exporting || app.view.mapping || app.view.all_drawings);
    if (!tall) tool_rail(app, layout);  // else the sheet goes there
    if (!layout.swapped) model_panel(app, layout, pixel_ratio);
    missing_card(app, layout);
    if (app.view.mode == Mode::result)
      timeline(app, layout);
    else
      drawing_strip(app, layout);
    inspector(app, layout);
    splitters(app, layout);
    hints_card(app, layout);
    notes_card(app, layout);
  }
  if (!layout.tablet) status_line(app, layout);
  toasts(app, layout);
  shortcut_sheet(app, width, height);
  picking_sheet(app, width, height);
  question_sheet(app, width, height);

  for (const std::string_view command : std::exchange(app.asked, {})) perform(app, command);
  if (!asking && ((app.question && app.question->asks_path) ||
                  (!app.picking.empty() && !app.picking.front().one)))
    await_text_field();
  keep_live(app);
  autosave(app);
  if (!app.toasts.empty()) parts_->message = app.toasts.back().words;
  const std::string& name = app.document().name;
  app.services.platform.set_title(
      app.view.welcome || name.empty() ? "ArtiSketch" : name + " – ArtiSketch", unsaved());
}

double Editor::next_frame_in() const {
  constexpr double kSmooth = 1.0 / 60, kSeldom = 1.0 / 30, kNever = 1e9;
  const App& app = parts_->app;
  double interval = kNever;
  if (app.busy() || app.session.history.revision() != app.session.backup.revision)
    interval = kSeldom;
  // A toast goes by itself; an error stays until it is answered.
  for (const Toast& toast : app.toasts)
    if (!toast.error)
      interval = std::min(
          interval, toast.since < 0 ? 0 : toast.since + kToastSeconds - app.services.now + kSmooth);
  // A press may grow long.
  constexpr float kLongest = 0.6f;  // seconds
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left) &&
      ImGui::GetIO().MouseDownDuration[ImGuiMouseButton_Left] < kLongest)
    interval = kSmooth;
  const bool live = app.services.jobs.busy() && !app.busy();
  if (plays(app) || app.changing_pose() || live || hints_move(app)) interval = kSmooth;
  return interval - (app.services.platform.now() - parts_->drawn_at);
}

const std::vector<Widget>& Editor::widgets() const {
  return parts_->widgets;
}

EditorState Editor::state() const {
  const App& app = parts_->app;
  constexpr const char* kNames[] = {"outline", "skeleton", "pose", "result"};
  EditorState state;
  state.mode = app.view.welcome ? "welcome" : kNames[std::size_t(app.view.mode)];
  state.busy = app.busy();
  const Progress progress = app.services.jobs.progress();
  state.stage = state.busy ? progress.stage : "";
  state.progress = state.busy ? progress.fraction : 0;
  state.frame = app.session.selection.frame;
  state.frames = int(app.document().frames.size());
  for (const Joint& joint : app.document().skeleton.joints) state.joints.push_back(joint.name);
  state.has_model = app.session.built != nullptr;
  state.live_parts = int(app.session.live.parts.size());
  state.revision = app.session.history.revision();
  state.live_revision = app.session.live.revision;
  state.can_undo = app.session.can_undo();
  state.undo = app.session.undo_name();
  state.message = parts_->message;
  for (const Toast& toast : app.toasts) state.messages.push_back(toast.words);
  return state;
}

std::optional<Vec2> Editor::project(int frame, double x, double y) const {
  const App& app = parts_->app;
  if (frame != app.session.selection.frame || app.view.welcome || !app.has_frame())
    return std::nullopt;
  const ImVec2 p = app.view.sketch.on().of({x, y});
  return Vec2(p.x, p.y);
}

const Document& Editor::document() const {
  return parts_->app.document();
}

bool Editor::unsaved() const {
  return parts_->app.session.unsaved() && !parts_->app.view.welcome;
}

}  // namespace artisketch
