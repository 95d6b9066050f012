// Documents and models in and out.
#include <imgui.h>

#include "document/edit.h"
#include "editor/session/actions.h"
#include "editor/shell/panels.h"
#include "files/document_file.h"
#include "files/inside_images.h"

namespace artisketch {
namespace {

bool ends_with(const std::string& text, const char* ending) {
  const std::string tail = ending;
  return text.size() >= tail.size() &&
         text.compare(text.size() - tail.size(), tail.size(), tail) == 0;
}

// Starts afresh with a document; what is looked at begins anew, how stays.
void start_with(Work& work, Document document) {
  if (work.jobs.busy()) work.jobs.cancel();
  work.history = History(std::move(document));
  work.saved = work.autosaved = work.history.revision();
  work.place.clear();
  work.name.clear();
  work.built.reset();
  work.live = Live();
  work.proposal.reset();
  work.outline.reset();
  work.gesture = {};
  work.stroke.clear();
  View& view = work.view;
  view.welcome = false;
  view.mode = Mode::outline;
  view.frame = 0;
  view.missing_seen.clear();
  view.joint = view.contour = -1;
  view.fit_again();
  view.playing = view.exporting = false;
  view.clip = 0;
  view.time = 0;
  view.posed.reset();
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

void complain(Work& work, const Error& error) {
  if (error.kind == Error::Kind::cancelled) return;
  Toast toast;
  toast.words = error.faults.empty() ? "Something went wrong." : error.faults[0];
  toast.error = true;
  work.say(std::move(toast));
}

void new_document(Work& work) {
  start_with(work, blank_document());
}

void open_document(Work& work, const NamedBytes& file) {
  Result<Document> document = parse_document(file.bytes, file.name);
  if (!document) return complain(work, document.error());
  const Result<Done> taken = work.drawings.take(*document);
  if (!taken) return complain(work, taken.error());
  start_with(work, std::move(*document));
  work.name = file.name;
  work.place = file.place;
}

void open_files(Work& work, Result<std::vector<NamedBytes>> files) {
  if (!files) return complain(work, files.error());
  for (const NamedBytes& file : *files) {
    if (ends_with(file.name, ".artisketch") || file.bytes.starts_with("{")) {
      unless_unsaved(work, [&work, file] { open_document(work, file); });
      continue;
    }
    if (work.view.welcome) new_document(work);
    add_drawing(work, file);
  }
}

void open_example(Work& work, const std::string& name, bool greet) {
  work.platform.load_example(name, [&work, greet](Result<Example> example) {
    if (!example) return complain(work, example.error());
    open_document(work, {"", example->document, ""});
    if (example->glb.empty()) {
      perform(work, Command::mode_result);
      return start_job(work, JobRequest::Kind::reconstruct);
    }
    Result<Built> built = built_from(example->glb, example->document);
    if (!built) return complain(work, built.error());
    built->source = work.document();
    show_built(work, std::move(*built));
    work.view.welcome = greet;
    work.view.playing = greet;
    if (greet) work.view.orbit.yaw = 0.35;
  });
}

void save(Work& work, bool ask_where, std::function<void()> then) {
  const std::string proposed =
      work.name.empty()
          ? (work.document().name.empty() ? "untitled" : work.document().name) + ".artisketch"
          : work.name;
  const long revision = work.history.revision();
  std::string text = document_text(work.drawings.whole(work.document()));
  const auto done = [&work, revision, then](Result<Platform::Saved> saved) {
    if (!saved) return complain(work, saved.error());
    work.name = saved->name;
    work.place = saved->place;
    work.saved = revision;
    work.platform.store("autosave", "");
    if (then) then();
  };
  const std::string place = ask_where ? "" : work.place;
  if (!place.empty() || work.platform.has_dialogs())
    return work.platform.save_file(proposed, place, std::move(text), done);
  Question question;
  question.title = "Save as";
  question.words = "Where to, and under which name?";
  question.asks_path = true;
  question.path = proposed;
  question.with_path = [&work, text, proposed, done](const std::string& path) {
    work.platform.save_file(proposed, path, text, done);
  };
  question.answers = {{"Save", {}, true}, {"Cancel", {}}};
  work.question = std::move(question);
}

void ask_for_path(Work& work, const std::string& title, const std::string& words) {
  Question question;
  question.title = title;
  question.words = words;
  question.asks_path = true;
  question.with_path = [&work](const std::string& path) {
    work.platform.open_recent(path, [&work](auto files) { open_files(work, std::move(files)); });
  };
  question.answers = {{"Open", {}, true}, {"Cancel", {}}};
  work.question = std::move(question);
}

void unless_unsaved(Work& work, std::function<void()> then) {
  if (!work.unsaved() || work.view.welcome) return then();
  Question question;
  question.title = "Save your changes?";
  question.words = "Without saving, what you changed since the last time is lost.";
  question.answers = {{"Save", [&work, then] { save(work, false, then); }, true},
                      {"Don't save",
                       [&work, then] {
                         work.platform.store("autosave", "");
                         work.autosaved = work.history.revision();
                         then();
                       }},
                      {"Cancel", {}}};
  work.question = std::move(question);
}

void autosave(Work& work) {
  constexpr double kQuiet = 1, kMost = 3;  // seconds: after the last change, and at most
  double& first_change = work.unkept_since;
  const double now = ImGui::GetTime();
  if (work.history.revision() == work.autosaved || work.view.welcome) {
    first_change = -1;
    return;
  }
  if (first_change < 0) first_change = now;
  if (now - work.changed_at < kQuiet && now - first_change < kMost - 0.5) return;
  work.platform.store("autosave",
                      work.unsaved() ? document_text(work.drawings.whole(work.document())) : "");
  work.autosaved = work.history.revision();
  first_change = -1;
}

void offer_recovery(Work& work) {
  work.platform.load("autosave", [&work](const std::string& text) {
    if (text.empty() || !parse_document(text, "the recovered document")) return;
    Toast toast;
    toast.words = "Work from last time was not saved.";
    toast.error = true;  // stays until it is answered
    toast.action = "Keep";
    toast.act = [&work, text] {
      open_document(work, {"", text, ""});
      work.saved = -1;
    };
    toast.other_action = "Discard";
    toast.other_act = [&work] { work.platform.store("autosave", ""); };
    work.say(std::move(toast));
  });
}

}  // namespace artisketch
