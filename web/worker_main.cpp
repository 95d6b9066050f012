// The worker's module: the core, and what worker.js calls to have a job done.
#include <string>

#include <emscripten.h>

#include "app/job_worker.h"

// clang-format off
EM_JS(void, send_progress, (const char* bytes, std::size_t size), {
  Module.send("progress", HEAPU8.slice(bytes, bytes + size));
});
EM_JS(void, send_outcome, (const char* bytes, std::size_t size), {
  Module.send("outcome", HEAPU8.slice(bytes, bytes + size));
});
// clang-format on

extern "C" EMSCRIPTEN_KEEPALIVE void serve(const char* request, std::size_t size) {
  artisketch::serve_job(
      {request, size}, [](const std::string& bytes) { send_progress(bytes.data(), bytes.size()); },
      [](const std::string& bytes) { send_outcome(bytes.data(), bytes.size()); });
}

// Makes a model of a document and forgets it, for the sake of the code that a browser compiles well
// once it has run.
extern "C" EMSCRIPTEN_KEEPALIVE void rehearse(const char* document, std::size_t size) {
  artisketch::JobRequest request;
  request.document.assign(document, size);
  request.options.grid = 32;  // runs all that finer grids run
  artisketch::Run run;
  static_cast<void>(artisketch::run_job(request, run));
}
