#include "editor/session/jobs.h"

#include <utility>

#include <imgui.h>

#include "base/words.h"
#include "editor/session/files.h"
#include "editor/session/live.h"
#include "files/document_file.h"

namespace artisketch {

void start_job(App& app, JobRequest::Kind kind) {
  app.session.keep_new_outline();
  JobRequest request;
  request.kind = kind;
  request.document = document_text(app.services.drawings.whole(app.document()));
  request.options.grid = app.services.platform.default_grid();
  request.options = with_settings(request.options, app.document().settings);
  app.session.job = RunningJob{kind, app.session.history.revision(), app.document(), {}};
  // Whoever starts a job from the welcome goes on with its document.
  if (app.view.welcome) perform(app, "mode_result");
  app.services.jobs.start(std::move(request));
}

void start_sprites(App& app, JobRequest request, std::function<void(JobResult)> then) {
  request.kind = JobRequest::Kind::sprites;
  app.session.job =
      RunningJob{request.kind, app.session.history.revision(), Document(), std::move(then)};
  app.services.jobs.start(std::move(request));
}

void show_built(App& app, BuiltModel built) {
  const bool first = !app.session.built;
  app.session.built = std::make_shared<BuiltModel>(std::move(built));
  if (!app.view.welcome) app.session.follow_document();
  if (app.session.playback.clip >= int(app.session.built->model.clips.size()))
    app.session.playback.clip = 0;
  app.session.playback.posed.reset();
  if (first) app.view.orbit = orbit_round(app.session.built->model);
}

namespace {

void take_model(App& app, RunningJob job, JobResult result) {
  Result<BuiltModel> built = built_from(result.glb, result.document);
  if (!built) {
    Toast toast;
    toast.words = built.error().text();
    toast.error = true;
    app.say(std::move(toast));
    return;
  }
  built->fits = std::move(result.fits);
  built->warnings = std::move(result.warnings);
  built->source = std::move(job.document);
  built->spheres = std::move(result.spheres);
  Toast toast;
  toast.words = "The model is ready.";
  const int notes = int(built->warnings.size());
  const bool elsewhere = app.view.mode != Mode::result;
  if (notes > 0) {
    toast.words +=
        " There " + std::string(notes == 1 ? "is " : "are ") + counted(notes, "note") + ".";
    (elsewhere ? toast.other_action : toast.action) = "Read";
    (elsewhere ? toast.other_act : toast.act) = [&app] { app.session.notes_shown = true; };
  }
  show_built(app, std::move(*built));
  if (std::exchange(app.session.export_wish.waits, false)) return perform(app, "export_as_it_is");
  if (elsewhere) {
    toast.action = "See it move";
    toast.act = [&app] {
      perform(app, "mode_result");
      app.session.playback.time = 0;
      app.session.playback.playing = true;
    };
  }
  app.say(std::move(toast));
}

void take_calibration(App& app, const RunningJob& job, const JobResult& result) {
  if (job.revision != app.session.history.revision()) return;  // edited meanwhile
  Result<Document> calibrated = parse_document(result.document, "the calibrated document");
  if (!calibrated) return;
  // The drawings stay where they are.
  Document next = app.document();
  for (std::size_t f = 0; f < next.frames.size(); ++f) {
    next.frames[f].pose = calibrated->frames[f].pose;
    next.frames[f].scale = calibrated->frames[f].scale;
  }
  Proposal proposal;
  proposal.document = std::move(next);
  proposal.coverage = result.coverage;
  proposal.warnings = result.warnings;
  proposal.taken.assign(std::size_t(app.document().skeleton.size()), true);
  proposal.since = app.services.now;
  proposal.revision = app.session.history.revision();
  app.session.proposal = std::move(proposal);
  if (app.view.mode != Mode::pose) perform(app, "mode_pose");
}

}  // namespace

void collect_job(App& app) {
  std::optional<Result<JobResult>> outcome = app.services.jobs.poll();
  if (!outcome || !app.session.job) return;
  RunningJob job = std::move(*app.session.job);
  app.session.job.reset();
  if (job.kind == JobRequest::Kind::parts) return take_parts(app, job, std::move(*outcome));
  if (job.kind == JobRequest::Kind::spheres) {
    if (*outcome && app.session.built && app.session.built->spheres.empty())
      app.session.built->spheres = std::move(outcome->value().spheres);
    return;
  }
  if (!*outcome) {
    app.session.export_wish.waits = false;
    const Error& error = outcome->error();
    Toast toast;
    toast.words = error.kind == Error::Kind::cancelled ? "Stopped." : error.text();
    toast.error = error.kind != Error::Kind::cancelled;
    if (toast.error) {
      toast.action = "Try again";
      toast.act = [&app, kind = job.kind] {
        if (kind == JobRequest::Kind::sprites) return perform(app, "export_as_it_is");
        start_job(app, kind);
      };
    }
    app.say(std::move(toast));
    return;
  }
  if (job.then) return job.then(std::move(outcome->value()));
  if (job.kind == JobRequest::Kind::reconstruct)
    take_model(app, std::move(job), std::move(outcome->value()));
  else
    take_calibration(app, job, outcome->value());
}

}  // namespace artisketch
