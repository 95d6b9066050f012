// Undo, the jobs, and a step back.
#include "document/edit.h"
#include "editor/session/app.h"
#include "editor/session/commands.h"
#include "editor/session/hints.h"
#include "editor/session/jobs.h"
#include "editor/session/notes.h"
#include "editor/ui/icons.h"

namespace artisketch {
namespace {

bool has_outlines(const App& app) {
  return !drawn_joints(app.document()).empty();
}

std::string calibrate_lacks(const App& app) {
  if (app.busy()) return "";
  const std::string first = what_comes_first(app);
  return first.empty() ? "One drawing has no other to agree with: add one." : first;
}

// Gives up what was begun last.
void step_back(App& app) {
  Session& session = app.session;
  if (app.busy()) {
    app.services.jobs.cancel();
  } else if (app.view.welcome && app.view.gallery) {
    app.view.gallery = false;
  } else if (session.notes_shown) {
    session.notes_shown = false;
  } else if (!session.rivals.poses.empty()) {
    session.rivals = {};
  } else if (session.bend.frame >= 0) {
    session.bend = {};
  } else if (session.new_outline) {
    session.new_outline.reset();
  } else if (app.tool().under_way()) {
    app.tool().cancel(app);
  } else if (session.next.any()) {
    session.next = {};
  } else if (app.view.mapping) {
    app.view.mapping = false;
  } else if (app.view.exporting) {
    app.view.exporting = false;
  } else if (session.playback.posed) {
    session.playback.posed.reset();
  } else if (hints_shown(app) && session.selection.contour < 0 && session.selection.joint < 0) {
    close_hints(app);
  } else {
    session.selection.contour = session.selection.joint = -1;
  }
}

}  // namespace

std::string what_comes_first(const App& app) {
  return app.document().frames.empty() ? "Add a drawing first."
         : !has_outlines(app)          ? "Outline a part first."
                                       : "";
}

std::vector<Command> edit_commands() {
  return {
      {.id = "undo",
       .name = "Undo",
       .icon = icon::kUndoVariant,
       .key = ImGuiKey_Z,
       .ctrl = true,
       .repeats = true,
       .available =
           [](const App& app) {
             return (app.tool().under_way() || app.session.can_undo()) && !app.view.welcome;
           },
       .run =
           [](App& app) {
             if (!app.tool().undo() && app.session.can_undo()) app.session.undo();
           }},
      {.id = "redo",
       .name = "Redo",
       .icon = icon::kRedoVariant,
       .key = ImGuiKey_Z,
       .ctrl = true,
       .shift = true,
       .other_key = ImGuiKey_Y,
       .repeats = true,
       .available = [](const App& app) { return app.session.can_redo() && !app.view.welcome; },
       .run = [](App& app) { app.session.redo(); }},
      {.id = "reconstruct",
       .name = "Reconstruct",
       .icon = icon::kCubeOutline,
       .about = "Make the model from the drawings",
       .key = ImGuiKey_R,
       .available = has_outlines,
       .what_it_lacks = what_comes_first,
       .run = [](App& app) { start_job(app, JobRequest::Kind::reconstruct); }},
      {.id = "calibrate",
       .name = "Calibrate",
       .icon = icon::kCrosshairsGps,
       .about = "Turn the bones until the outlines of all drawings agree",
       .key = ImGuiKey_C,
       .shift = true,
       .available =
           [](const App& app) {
             return app.document().frames.size() > 1 && has_outlines(app) && !app.busy();
           },
       .what_it_lacks = calibrate_lacks,
       .run = [](App& app) { start_job(app, JobRequest::Kind::calibrate); }},
      {.id = "notes",
       .name = "Notes",
       .icon = icon::kAlert,
       .about = "What was noticed on the way, drawing by drawing",
       .available = [](const App& app) { return count_notes(app) > 0; },
       .on = [](const App& app) { return app.session.notes_shown; },
       .run = [](App& app) { app.session.notes_shown = !app.session.notes_shown; }},
      {.id = "step_back",
       .name = "Step back, stop",
       .icon = icon::kClose,
       .key = ImGuiKey_Escape,
       .run = step_back},
  };
}

}  // namespace artisketch
