// Jobs: what goes to the worker, and what is made of what it brings.
#include <utility>

#include <imgui.h>

#include "editor/session/actions.h"
#include "editor/session/live.h"
#include "editor/shell/panels.h"
#include "files/document_file.h"

namespace artisketch {

void start_job(Work& work, JobRequest::Kind kind) {
  JobRequest request;
  request.kind = kind;
  request.document = document_text(work.drawings.whole(work.document()));
  request.options.grid = work.document().settings.grid.value_or(work.platform.default_grid());
  if (work.document().settings.triangles)
    request.options.triangles = *work.document().settings.triangles;
  if (work.document().settings.mirror) request.options.mirror = *work.document().settings.mirror;
  work.running = kind;
  work.running_revision = work.history.revision();
  work.running_document = work.document();
  // Whoever starts a job from the welcome goes on with its document.
  if (work.view.welcome) perform(work, Command::mode_result);
  work.jobs.start(std::move(request));
}

void show_built(Work& work, Built built) {
  const bool first = !work.built;
  work.built = std::make_shared<Built>(std::move(built));
  if (!work.view.welcome) work.follow_document();
  if (work.view.clip >= int(work.built->model.clips.size())) work.view.clip = 0;
  work.view.posed.reset();
  if (first) look_at(work, work.built->model);
}

namespace {

void take_model(Work& work, JobResult result) {
  Result<Built> built = built_from(result.glb, result.document);
  if (!built) {
    Toast toast;
    toast.words = built.error().text();
    toast.error = true;
    work.say(std::move(toast));
    return;
  }
  built->fits = std::move(result.fits);
  built->warnings = std::move(result.warnings);
  built->source = work.running_document;
  built->spheres = std::move(result.spheres);
  Toast toast;
  toast.words = "The model is ready.";
  if (!built->warnings.empty()) toast.words += " " + built->warnings[0];
  show_built(work, std::move(*built));
  if (std::exchange(work.view.wish.waits, false))
    return export_model(work, export_formats()[work.view.wish.format]);
  if (work.view.mode != Mode::result) {
    toast.action = "See it move";
    toast.act = [&work] {
      perform(work, Command::mode_result);
      work.view.time = 0;
      work.view.playing = true;
    };
  }
  work.say(std::move(toast));
}

void take_calibration(Work& work, const JobResult& result) {
  if (work.running_revision != work.history.revision()) return;  // edited meanwhile
  Result<Document> calibrated = parse_document(result.document, "the calibrated document");
  if (!calibrated) return;
  // The drawings stay where they are.
  Document next = work.document();
  for (std::size_t f = 0; f < next.frames.size(); ++f) {
    next.frames[f].pose = calibrated->frames[f].pose;
    next.frames[f].scale = calibrated->frames[f].scale;
  }
  Proposal proposal;
  proposal.document = std::move(next);
  proposal.coverage = result.coverage;
  proposal.taken.assign(std::size_t(work.document().skeleton.size()), true);
  proposal.since = ImGui::GetTime();
  proposal.revision = work.history.revision();
  work.proposal = std::move(proposal);
  if (work.view.mode != Mode::pose) perform(work, Command::mode_pose);
}

}  // namespace

void collect_job(Work& work) {
  std::optional<Result<JobResult>> outcome = work.jobs.poll();
  if (!outcome) return;
  if (work.running == JobRequest::Kind::parts) return take_parts(work, std::move(*outcome));
  if (work.running == JobRequest::Kind::spheres) {
    if (*outcome && work.built && work.built->spheres.empty())
      work.built->spheres = std::move(outcome->value().spheres);
    return;
  }
  if (!*outcome) {
    const Error& error = outcome->error();
    Toast toast;
    toast.words = error.kind == Error::Kind::cancelled ? "Stopped." : error.text();
    toast.error = error.kind != Error::Kind::cancelled;
    if (toast.error) {
      toast.action = "Try again";
      toast.act = [&work] { start_job(work, work.running); };
    }
    work.say(std::move(toast));
    return;
  }
  if (work.running == JobRequest::Kind::reconstruct)
    take_model(work, std::move(outcome->value()));
  else
    take_calibration(work, outcome->value());
}

}  // namespace artisketch
