#include "app/command_run.h"

#include <atomic>
#include <csignal>
#include <new>

#include "app/job.h"
#include "app/outputs.h"

namespace artisketch {
namespace {

std::atomic<bool> stop_asked = false;
static_assert(std::atomic<bool>::is_always_lock_free, "set by a signal handler");

void ask_to_stop(int) {
  stop_asked = true;
}

}  // namespace

CommandRun::CommandRun(bool shows_progress) : line_(shows_progress) {
  stop_asked = false;
  std::signal(SIGINT, ask_to_stop);
  std::signal(SIGTERM, ask_to_stop);
  run.cancel = &stop_asked;
  run.on_progress = [this](const Progress& progress) { line_.show(progress); };
}

CommandRun::~CommandRun() {
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
}

bool CommandRun::asked_to_stop() {
  return stop_asked;
}

int guarded(const std::optional<int>& grid, const std::function<int()>& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return fail(out_of_memory(grid));
  } catch (const std::exception& thrown) {
    return fail(broke_off(thrown.what()));
  }
}

}  // namespace artisketch
