// The worker's module: the core, and one function that does a job (worker.js calls it).
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
