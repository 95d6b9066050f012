// How the document is looked at: modes, drawings, layers, zoom.
#include "editor/session/app.h"
#include "editor/session/commands.h"
#include "editor/ui/icons.h"

namespace artisketch {
namespace {

template <Mode mode>
void enter(App& app) {
  // Whoever goes on from the welcome works on a copy of what it shows.
  if (app.view.welcome) {
    app.view.welcome = false;
    app.session.playback.playing = false;
    app.session.file.saved = app.session.history.revision();
  }
  app.tool().cancel(app);
  app.view.mode = mode;
  app.view.exporting = app.view.exporting && mode == Mode::result;
  app.view.mapping = app.view.mapping && mode == Mode::result;
  Playback& playback = app.session.playback;
  if (mode != Mode::result) playback.playing = false;
  playback.posed.reset();
  if (mode == Mode::result) playback.time = app.session.selection.frame;
}

template <int by>
void go_to_drawing(App& app) {
  const int frames = int(app.document().frames.size());
  Selection& selection = app.session.selection;
  selection.frame = (selection.frame + by + frames) % frames;
  selection.contour = -1;
  app.session.playback.time = selection.frame;
  app.session.playback.posed.reset();
}

void zoom_in_middle(SketchPlace& sketch, float factor) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  const ImVec2 about{size.x * 0.3f, size.y * 0.45f};
  sketch.origin = {about.x + factor * (sketch.origin.x - about.x),
                   about.y + factor * (sketch.origin.y - about.y)};
  sketch.zoom *= factor;
  sketch.fit = false;
}

void switch_theme(App& app) {
  app.view.dark = !app.view.dark;
  app.services.platform.store("theme", app.view.dark ? "dark" : "light");
}

bool has_drawing(const App& app) {
  return app.has_frame();
}
bool has_several_drawings(const App& app) {
  return app.document().frames.size() > 1;
}

std::vector<Command> mode_commands() {
  return {
      {.id = "mode_outline",
       .name = "Outline",
       .icon = icon::kPencil,
       .about = "Outline each part",
       .key = ImGuiKey_1,
       .run = enter<Mode::outline>},
      {.id = "mode_skeleton",
       .name = "Skeleton",
       .icon = icon::kBone,
       .about = "One skeleton for all drawings",
       .key = ImGuiKey_2,
       .run = enter<Mode::skeleton>},
      {.id = "mode_pose",
       .name = "Pose",
       .icon = icon::kWalk,
       .about = "Match the skeleton to each drawing",
       .key = ImGuiKey_3,
       .run = enter<Mode::pose>},
      {.id = "mode_result",
       .name = "Result",
       .icon = icon::kCubeOutline,
       .about = "See the model move",
       .key = ImGuiKey_4,
       .run = enter<Mode::result>},
  };
}

std::vector<Command> layer_commands() {
  return {
      {.id = "show_drawing",
       .name = "Drawing",
       .icon = icon::kImage,
       .about = "Show or hide the drawing",
       .key = ImGuiKey_H,
       .on = [](const App& app) { return app.view.layer().drawing; },
       .run = [](App& app) { app.view.layer().drawing ^= true; }},
      {.id = "show_outlines",
       .name = "Outlines",
       .icon = icon::kVectorCurve,
       .about = "Show or hide the outlines",
       .on = [](const App& app) { return app.view.layer().outlines; },
       .run = [](App& app) { app.view.layer().outlines ^= true; }},
      {.id = "show_bones",
       .name = "Bones",
       .icon = icon::kBone,
       .about = "Show or hide the skeleton",
       .key = ImGuiKey_B,
       .on = [](const App& app) { return app.view.layer().bones; },
       .run = [](App& app) { app.view.layer().bones ^= true; }},
      {.id = "show_model",
       .name = "Model",
       .icon = icon::kCubeOutline,
       .about = "Lay the model over the drawing",
       .key = ImGuiKey_G,
       .on = [](const App& app) { return app.view.layer().model; },
       .run = [](App& app) { app.view.layer().model ^= true; }},
      {.id = "fade",
       .name = "Fade",
       .about = "Fade the drawing, or bring it back",
       .key = ImGuiKey_Slash,
       .run =
           [](App& app) {
             float& opacity = app.view.layer().drawing_opacity;
             opacity = opacity > 0.5f ? 0.3f : 0.85f;
           }},
  };
}

std::vector<Command> zoom_commands() {
  return {
      {.id = "fit",
       .name = "Fit",
       .icon = icon::kArrowExpandAll,
       .about = "Fit the drawing into view",
       .key = ImGuiKey_0,
       .available = has_drawing,
       .run = [](App& app) { app.view.fit_again(); }},
      {.id = "home",
       .name = "Home",
       .about = "See the whole model",
       .key = ImGuiKey_Home,
       .run =
           [](App& app) {
             if (const BuiltModel* shown = app.shown()) app.view.orbit = orbit_round(shown->model);
           }},
      {.id = "zoom_in",
       .name = "Zoom in",
       .icon = icon::kPlus,
       .key = ImGuiKey_Equal,
       .any_shift = true,
       .repeats = true,
       .available = has_drawing,
       .run = [](App& app) { zoom_in_middle(app.view.sketch, 1.25f); }},
      {.id = "zoom_out",
       .name = "Zoom out",
       .icon = icon::kMinus,
       .key = ImGuiKey_Minus,
       .repeats = true,
       .available = has_drawing,
       .run = [](App& app) { zoom_in_middle(app.view.sketch, 0.8f); }},
  };
}

}  // namespace

std::vector<Command> view_commands() {
  std::vector<Command> all = mode_commands();
  all.push_back({.id = "previous_drawing",
                 .name = "Previous drawing",
                 .icon = icon::kChevronLeft,
                 .key = ImGuiKey_Comma,
                 .available = has_several_drawings,
                 .run = go_to_drawing<-1>});
  all.push_back({.id = "next_drawing",
                 .name = "Next drawing",
                 .icon = icon::kChevronRight,
                 .key = ImGuiKey_Period,
                 .available = has_several_drawings,
                 .run = go_to_drawing<1>});
  for (Command& command : layer_commands()) all.push_back(std::move(command));
  for (Command& command : zoom_commands()) all.push_back(std::move(command));
  all.push_back(
      {.id = "theme", .name = "Light or dark", .icon = icon::kThemeLightDark, .run = switch_theme});
  all.push_back({.id = "hints",
                 .name = "How this mode works",
                 .icon = icon::kLightbulbOutline,
                 .available = [](const App& app) { return app.has_frame() && !app.view.welcome; },
                 .run =
                     [](App& app) {
                       app.view.exporting = app.view.mapping = app.view.help = false;
                       app.view.hints.open = true;
                       app.view.hints.mode = app.view.mode;
                       app.view.hints.since = app.services.now;
                     }});
  all.push_back({.id = "guide",
                 .name = "Guide",
                 .icon = icon::kFileDocumentBox,
                 .about = "All of it, step by step, with pictures",
                 .key = ImGuiKey_F1,
                 .available = [](const App& app) { return app.services.platform.has_guide(); },
                 .run = [](App& app) { app.services.platform.show_guide(); }});
  all.push_back({.id = "help",
                 .name = "Shortcuts",
                 .icon = icon::kHelpCircleOutline,
                 .key = ImGuiKey_Slash,
                 .shift = true,
                 .key_words = "?",
                 .run = [](App& app) { app.view.help ^= true; }});
  return all;
}

}  // namespace artisketch
