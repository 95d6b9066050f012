// Jobs: what goes to the worker, and what is made of what it brings.
#pragma once

#include <functional>

#include "editor/session/app.h"

namespace artisketch {

void start_job(App& app, JobRequest::Kind kind);
// Sprites of a model; `then` takes them.
void start_sprites(App& app, JobRequest request, std::function<void(JobResult)> then);
// Takes what a job brought, each frame. What was asked for by a document that is no longer open is
// dropped.
void collect_job(App& app);
void show_built(App& app, BuiltModel built);

}  // namespace artisketch
