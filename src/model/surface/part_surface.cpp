// One part, or many, by the chosen method.
#include <iterator>
#include <mutex>
#include <numeric>
#include <optional>

#include "base/at_once.h"
#include "model/one_order.h"
#include "model/stages.h"

namespace artisketch {

Result<PartSurface> reconstruct_part(const Part& given, const SurfaceOptions& options, Run& run) {
  const Part part = with_views_in_one_order(given);
  switch (options.method) {
    case Method::paper:
      return surface_paper(part, options, run);
    case Method::rays:
      return surface_rays(part, options, run);
  }
  return surface_paper(part, options, run);
}

std::vector<Result<PartSurface>> reconstruct_parts(std::span<const Part> parts,
                                                   const SurfaceOptions& options, Run& run) {
  const int count = int(parts.size());
  std::vector<std::optional<Result<PartSurface>>> made(parts.size());
  std::vector<Trace> traces(parts.size());
  std::vector<double> done(parts.size(), 0);
  std::mutex telling;
  at_once(count, run.threads, [&](int p) {
    Run own;
    own.cancel = run.cancel;
    own.trace = run.trace ? &traces[p] : nullptr;
    own.on_progress = [&](const Progress& now) {
      const std::lock_guard lock(telling);
      done[p] = now.fraction;
      run.now.item = parts[p].name;
      run.now.part = p;
      run.now.parts = count;
      run.report(std::accumulate(done.begin(), done.end(), 0.0) / count);
    };
    own.report(0);
    made[p] = reconstruct_part(parts[p], options, own);
    own.report(1);
  });
  std::vector<Result<PartSurface>> surfaces;
  for (int p = 0; p < count; ++p) {
    if (run.trace)
      std::move(traces[p].entries.begin(), traces[p].entries.end(),
                std::back_inserter(run.trace->entries));
    surfaces.push_back(std::move(*made[p]));
  }
  return surfaces;
}

}  // namespace artisketch
