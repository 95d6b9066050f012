// The whole pipeline on every example, by both methods side by side, on one core. The counters are
// milliseconds per stage.
#include <algorithm>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "files/document_file.h"
#include "model/stages.h"

namespace artisketch {
namespace {

std::vector<std::filesystem::path> example_documents() {
  std::vector<std::filesystem::path> paths;
  std::error_code none;  // no folder, no benches
  const auto folder = std::filesystem::path(ARTISKETCH_SOURCE_DIR) / "assets" / "examples";
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, none))
    if (entry.path().extension() == ".artisketch") paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

void time_reconstruct(benchmark::State& state, const std::string& path, Method method) {
  const Result<Document> document = read_document(path);
  if (!document) return state.SkipWithError(document.error().text().c_str());
  PipelineOptions options;
  options.method = method;
  options.grid = document->settings.grid.value_or(options.grid);
  for (auto _ : state) {
    Run run;
    const Result<Reconstruction> result = reconstruct(*document, options, run);
    if (!result) return state.SkipWithError(result.error().text().c_str());
    for (const StageTime& stage : result->stages)
      state.counters[stage.stage] += 1000 * stage.seconds;
  }
  for (auto& [stage, milliseconds] : state.counters)
    milliseconds.flags = benchmark::Counter::kAvgIterations;
}

const bool registered = [] {
  for (const std::filesystem::path& path : example_documents())
    for (const auto& [name, method] :
         {std::pair("paper", Method::paper), std::pair("rays", Method::rays)})
      benchmark::RegisterBenchmark(
          ("reconstruct/" + path.stem().string() + "/" + name).c_str(),
          [path = path.string(), method = method](benchmark::State& state) {
            time_reconstruct(state, path, method);
          })
          ->Unit(benchmark::kMillisecond);
  return true;
}();

}  // namespace
}  // namespace artisketch
