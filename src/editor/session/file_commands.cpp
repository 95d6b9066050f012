// Documents and drawings: what opens, saves and adds them.
#include "document/edit.h"
#include "editor/session/app.h"
#include "editor/session/commands.h"
#include "editor/session/files.h"
#include "editor/ui/icons.h"

namespace artisketch {
namespace {

bool is_open(const App& app) {
  return !app.view.welcome;
}

void choose_document(App& app) {
  if (!app.services.platform.has_dialogs())
    return ask_for_path(app, "Open", "The path of a document");
  app.services.platform.open_files(Platform::Kind::document,
                                   [&app](auto files) { open_files(app, std::move(files)); });
}

void choose_drawings(App& app) {
  if (!app.services.platform.has_dialogs())
    return ask_for_path(app, "Add a drawing", "The path of a PNG or JPEG");
  app.services.platform.open_files(Platform::Kind::drawings,
                                   [&app](auto files) { open_files(app, std::move(files)); });
}

void add_blank_drawing(App& app) {
  if (app.view.welcome) new_document(app);
  Frame frame;
  frame.name = "Drawing " + std::to_string(app.document().frames.size() + 1);
  frame.width = app.has_frame() ? app.frame().width : 800;
  frame.height = app.has_frame() ? app.frame().height : 800;
  const std::string name = frame.name;
  app.session.commit("Add " + name, with_frame(app.document(), std::move(frame)));
  app.session.selection.frame = int(app.document().frames.size()) - 1;
  app.view.fit_again();
  if (app.view.mode == Mode::outline) app.take_up(Mode::outline, "draw");
}

}  // namespace

std::vector<Command> file_commands() {
  return {
      {.id = "new",
       .name = "New",
       .icon = icon::kFileDocumentBox,
       .key = ImGuiKey_N,
       .ctrl = true,
       .run = [](App& app) { unless_unsaved(app, [&app] { new_document(app); }); }},
      {.id = "open",
       .name = "Open",
       .icon = icon::kFolderOutline,
       .key = ImGuiKey_O,
       .ctrl = true,
       .run = choose_document},
      {.id = "save",
       .name = "Save",
       .icon = icon::kContentSave,
       .key = ImGuiKey_S,
       .ctrl = true,
       .available = is_open,
       .run = [](App& app) { save(app, false); }},
      {.id = "save_as",
       .name = "Save as",
       .icon = icon::kContentSaveSettings,
       .key = ImGuiKey_S,
       .ctrl = true,
       .shift = true,
       .available = is_open,
       .run = [](App& app) { save(app, true); }},
      {.id = "add_drawings",
       .name = "Add drawings",
       .icon = icon::kImageMultiple,
       .run = choose_drawings},
      {.id = "blank_drawing",
       .name = "Blank paper",
       .icon = icon::kPencil,
       .run = add_blank_drawing},
  };
}

}  // namespace artisketch
