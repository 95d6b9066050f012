#include "editor/editor.h"

#include <algorithm>
#include <utility>

#include <imgui.h>

#include "editor/session/actions.h"
#include "editor/session/live.h"
#include "editor/shell/panels.h"

namespace artisketch {

struct Editor::Parts {
  Work work;
  std::vector<Widget> widgets;
  std::string message;
  bool begun = false;
  double drawn_at = 0;  // by the platform's clock

  Parts(Platform& platform, Jobs& jobs, Graphics& graphics) : work(platform, jobs, graphics) {
    View& view = work.view;
    view.dark = platform.prefers_dark();
    platform.load("theme", [&view](const std::string& name) {
      if (!name.empty()) view.dark = name == "dark";
    });
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
  open_files(parts_->work, std::move(files));
}

bool Editor::close() {
  Work& work = parts_->work;
  unless_unsaved(work, [&work] { work.closed = true; });
  return work.closed;
}
bool Editor::closed() const {
  return parts_->work.closed;
}

namespace {

void greet(Work& work) {
  new_document(work);
  work.view.welcome = true;
  work.examples = work.platform.examples();
  if (!work.examples.empty()) open_example(work, work.examples.front().name, true);
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

void advance(Work& work) {
  View& view = work.view;
  if (!view.playing || !work.built || work.built->model.clips.empty()) return;
  const std::vector<double>& times = work.built->model.clips[std::size_t(view.clip)].times;
  const double end = times.empty() ? 0 : times.back();
  // After a rest the clock has run on: no leap.
  view.time += std::min(0.1, double(ImGui::GetIO().DeltaTime));
  constexpr double kLast = 0.6;  // seconds on the last key before it begins again
  if (view.time > end + kLast) {
    view.time = view.looping || view.welcome ? 0 : end;
    view.playing = view.looping || view.welcome;
  }
  if (view.clip == 0 && !work.document().frames.empty())
    view.frame = std::min(int(view.time + 0.5), int(work.document().frames.size()) - 1);
}

}  // namespace

void Editor::touch(const Fingers& fingers) {
  Work& work = parts_->work;
  work.fingers = fingers;
  // The first finger may have begun something before the second came.
  if (fingers.began) work.drop_gesture();
  if (fingers.tapped == 2) work.ask(Command::undo);
  if (fingers.tapped == 3) work.ask(Command::redo);
}

void Editor::frame(float width, float height, float pixel_ratio) {
  Work& work = parts_->work;
  parts_->drawn_at = work.platform.now();
  if (!parts_->begun) greet(work);
  if (!parts_->begun) offer_recovery(work);
  parts_->begun = true;
  use_theme(work.view.dark ? dark_theme() : light_theme());
  parts_->widgets.clear();
  begin_controls(parts_->widgets);
  work.hurried = hurried(work.hurried);
  collect_job(work);
  advance(work);
  const bool asking = work.question || work.view.help;
  if (asking)
    work.asked.clear();
  else
    for (Command command : pressed_commands()) work.ask(command);
  if (work.proposal)
    work.proposal->peeking =
        ImGui::IsKeyDown(ImGuiKey_Space) && !ImGui::GetIO().WantTextInput && !asking;

  const Layout layout = lay_out(width, height, work.view);
  top_bar(work, layout);
  if (work.view.welcome) {
    welcome(work, layout, pixel_ratio);
  } else {
    if (layout.swapped) model_view(work, layout, pixel_ratio);
    canvas(work, layout, pixel_ratio);
    keep_live(work);  // what was dragged there is computed while the rest is drawn
    const bool tall = layout.tablet && (work.view.exporting || work.view.all_drawings);
    if (!tall) tool_rail(work, layout);  // else the sheet goes there
    if (!layout.swapped) model_view(work, layout, pixel_ratio);
    missing_card(work, layout);
    if (work.view.mode == Mode::result)
      timeline(work, layout);
    else
      drawing_strip(work, layout);
    inspector(work, layout);
    splitters(work, layout);
  }
  if (!layout.tablet) status_line(work, layout);
  toasts(work, layout);
  shortcut_sheet(work, width, height);
  question_sheet(work, width, height);

  for (Command command : std::exchange(work.asked, {})) perform(work, command);
  keep_live(work);
  autosave(work);
  if (!work.toasts.empty()) parts_->message = work.toasts.back().words;
  const std::string& name = work.document().name;
  work.platform.set_title(work.view.welcome || name.empty() ? "ArtiSketch" : name + " – ArtiSketch",
                          unsaved());
}

double Editor::next_frame_in() const {
  constexpr double kSmooth = 1.0 / 60, kSeldom = 1.0 / 30, kNever = 1e9;
  const Work& work = parts_->work;
  double interval = kNever;
  if (work.busy() || work.history.revision() != work.autosaved) interval = kSeldom;
  // A toast goes by itself; an error stays until it is answered.
  for (const Toast& toast : work.toasts)
    if (!toast.error)
      interval = std::min(
          interval, toast.since < 0 ? 0 : toast.since + kToastSeconds - ImGui::GetTime() + kSmooth);
  // A press may grow long.
  constexpr float kLongest = 0.6f;  // seconds
  if (ImGui::IsMouseDown(ImGuiMouseButton_Left) &&
      ImGui::GetIO().MouseDownDuration[ImGuiMouseButton_Left] < kLongest)
    interval = kSmooth;
  const bool live = work.jobs.busy() && !work.busy();
  if (work.view.playing || work.changing_pose() || live) interval = kSmooth;
  return interval - (work.platform.now() - parts_->drawn_at);
}

const std::vector<Widget>& Editor::widgets() const {
  return parts_->widgets;
}

EditorState Editor::state() const {
  const Work& work = parts_->work;
  constexpr const char* kNames[] = {"outline", "skeleton", "pose", "result"};
  EditorState state;
  state.mode = work.view.welcome ? "welcome" : kNames[std::size_t(work.view.mode)];
  state.busy = work.busy();
  const Progress progress = work.jobs.progress();
  state.stage = state.busy ? progress.stage : "";
  state.progress = state.busy ? progress.fraction : 0;
  state.frame = work.view.frame;
  state.frames = int(work.document().frames.size());
  for (const Joint& joint : work.document().skeleton.joints) state.joints.push_back(joint.name);
  state.has_model = work.built != nullptr;
  state.live_parts = int(work.live.parts.size());
  state.revision = work.history.revision();
  state.live_revision = work.live.revision;
  state.can_undo = work.history.can_undo();
  if (state.can_undo) state.undo = work.history.undo_name();
  state.message = parts_->message;
  for (const Toast& toast : work.toasts) state.messages.push_back(toast.words);
  return state;
}

std::optional<Vec2> Editor::project(int frame, double x, double y) const {
  const Work& work = parts_->work;
  if (frame != work.view.frame || work.view.welcome || !work.has_frame()) return std::nullopt;
  const ImVec2 p = OnScreen{work.view.origin, work.view.zoom}.of({x, y});
  return Vec2(p.x, p.y);
}

const Document& Editor::document() const {
  return parts_->work.document();
}

bool Editor::unsaved() const {
  return parts_->work.unsaved() && !parts_->work.view.welcome;
}

}  // namespace artisketch
