// Documents and models in and out.
#include "editor/session/files.h"

#include <optional>

#include <imgui.h>

#include "document/edit.h"
#include "editor/session/jobs.h"
#include "editor/session/motions_in.h"
#include "files/document_file.h"
#include "files/inside_images.h"
#include "files/motion_file.h"

namespace artisketch {
namespace {

bool ends_with(const std::string& text, const char* ending) {
  const std::string tail = ending;
  return text.size() >= tail.size() &&
         text.compare(text.size() - tail.size(), tail.size(), tail) == 0;
}

// A document to begin with where there is none: a person's skeleton, no drawings.
Document blank_document() {
  Document document;
  document.name = "Untitled";
  document.camera.pixels_per_unit = 300;
  document.skeleton = template_skeleton(Template::human);
  return document;
}

}  // namespace

void complain(App& app, const Error& error) {
  if (error.kind == Error::Kind::cancelled) return;
  Toast toast;
  toast.words = error.faults.empty() ? "Something went wrong." : error.faults[0];
  toast.error = true;
  app.say(std::move(toast));
}

void new_document(App& app) {
  app.open(blank_document());
}

void open_document(App& app, const NamedBytes& file) {
  Result<Document> document = parse_document(file.bytes, file.name);
  if (!document) return complain(app, document.error());
  const Result<Done> taken = app.services.drawings.take(*document);
  if (!taken) return complain(app, taken.error());
  app.open(std::move(*document));
  app.session.file.name = file.name;
  app.session.file.place = file.place;
}

void open_files(App& app, Result<std::vector<NamedBytes>> files) {
  if (!files) return complain(app, files.error());
  std::optional<int> first;  // of the drawings that came, by where it stands
  for (const NamedBytes& file : *files) {
    if (ends_with(file.name, ".artisketch") || file.bytes.starts_with("{")) {
      unless_unsaved(app, [&app, file] { open_document(app, file); });
      continue;
    }
    if (app.view.welcome) new_document(app);
    if (is_motion(file.bytes)) {
      add_motion(app, file);
      continue;
    }
    if (!first) first = int(app.document().frames.size());
    add_drawing(app, file);
  }
  if (first && *first < int(app.document().frames.size())) app.session.show_frame(*first);
}

void open_example(App& app, const std::string& name, bool greet) {
  const long asked = ++app.services.openings;
  app.services.platform.load_example(name, [&app, asked, greet](Result<Example> example) {
    if (app.services.openings != asked) return;
    if (!example) return complain(app, example.error());
    open_document(app, {"", example->document, ""});
    app.view.gallery = false;
    if (example->glb.empty()) {
      perform(app, "mode_result");
      return start_job(app, JobRequest::Kind::reconstruct);
    }
    Result<BuiltModel> built = built_from(example->glb, example->document);
    if (!built) return complain(app, built.error());
    built->source = app.document();
    show_built(app, std::move(*built));
    app.view.welcome = greet;
    app.session.playback.playing = greet;
    if (greet) app.view.orbit.yaw = 0.35;
  });
}

void save(App& app, bool ask_where, std::function<void()> then) {
  app.session.keep_new_outline();
  const std::string proposed =
      app.session.file.name.empty()
          ? (app.document().name.empty() ? "untitled" : app.document().name) + ".artisketch"
          : app.session.file.name;
  const long revision = app.session.history.revision(), session = app.session.id();
  std::string text = document_text(app.services.drawings.whole(app.document()));
  const auto done = [&app, revision, session, then](Result<Platform::Saved> saved) {
    if (!saved) return complain(app, saved.error());
    // Another document may have been opened since: its name and place are its own.
    if (app.session.id() == session) {
      app.session.file = {saved->name, saved->place, revision};
      app.services.platform.store("autosave", "");
    }
    if (then) then();
  };
  const std::string place = ask_where ? "" : app.session.file.place;
  if (!place.empty() || app.services.platform.has_dialogs())
    return app.services.platform.save_file(proposed, place, std::move(text), done);
  Question question;
  question.title = "Save as";
  question.words = "Where to, and under which name?";
  question.asks_path = true;
  question.path = proposed;
  question.with_path = [&app, text, proposed, done](const std::string& path) {
    app.services.platform.save_file(proposed, path, text, done);
  };
  question.answers = {{"Save", {}, true}, {"Cancel", {}}};
  app.question = std::move(question);
}

void ask_for_path(App& app, const std::string& title, const std::string& words) {
  Question question;
  question.title = title;
  question.words = words;
  question.asks_path = true;
  question.with_path = [&app](const std::string& path) {
    app.services.platform.open_recent(path,
                                      [&app](auto files) { open_files(app, std::move(files)); });
  };
  question.answers = {{"Open", {}, true}, {"Cancel", {}}};
  app.question = std::move(question);
}

void unless_unsaved(App& app, std::function<void()> then) {
  if (!app.session.unsaved() || app.view.welcome) return then();
  Question question;
  question.title = "Save your changes?";
  question.words = "Without saving, what you changed since the last time is lost.";
  question.answers = {{"Save", [&app, then] { save(app, false, then); }, true},
                      {"Don't save",
                       [&app, then] {
                         app.services.platform.store("autosave", "");
                         app.session.backup.revision = app.session.history.revision();
                         then();
                       }},
                      {"Cancel", {}}};
  app.question = std::move(question);
}

void autosave(App& app) {
  constexpr double kQuiet = 1, kMost = 3;  // seconds: after the last change, and at most
  Backup& backup = app.session.backup;
  const long revision = app.session.history.revision();
  const double now = app.services.now;
  if (std::exchange(backup.seen, revision) != revision) backup.changed_at = now;
  if (revision == backup.revision || app.view.welcome) {
    backup.unkept_since = -1;
    return;
  }
  if (backup.unkept_since < 0) backup.unkept_since = now;
  if (now - backup.changed_at < kQuiet && now - backup.unkept_since < kMost - 0.5) return;
  app.services.platform.store(
      "autosave",
      app.session.unsaved() ? document_text(app.services.drawings.whole(app.document())) : "");
  backup.revision = revision;
  backup.unkept_since = -1;
}

// "left" is the newest work that a window left behind: it stays where it is until this is answered,
// whatever is drawn, and kept under "autosave", meanwhile.
void offer_recovery(App& app) {
  app.services.platform.load("left", [&app](const std::string& text) {
    if (text.empty() || !parse_document(text, "the recovered document")) return;
    Toast toast;
    toast.words = "Work from last time was not saved.";
    toast.error = toast.outlives = true;  // stays until it is answered
    toast.action = "Keep";
    toast.act = [&app, text] {
      open_document(app, {"", text, ""});
      app.session.file.saved = -1;
      app.services.platform.store("autosave", text);
      app.services.platform.store("left", "");
    };
    toast.other_action = "Discard";
    toast.other_act = [&app] { app.services.platform.store("left", ""); };
    app.say(std::move(toast));
  });
}

}  // namespace artisketch
