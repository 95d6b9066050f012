#include "app/job_worker.h"

#include <chrono>

#include "app/job_bytes.h"

namespace artisketch {

void WorkerJobs::start(JobRequest request) {
  if (busy_) worker_.restart();
  busy_ = true;
  grid_ = request.options.grid;
  progress_ = {};
  outcome_.reset();
  worker_.post(job_bytes(request));
}

void WorkerJobs::cancel() {
  if (!busy_) return;
  worker_.restart();
  settle(cancelled());
}

std::optional<Result<JobResult>> WorkerJobs::poll() {
  return std::exchange(outcome_, std::nullopt);
}

void WorkerJobs::progressed(std::string_view bytes) {
  if (Result<Progress> progress = read_job_progress(bytes)) progress_ = std::move(*progress);
}

void WorkerJobs::finished(std::string_view bytes) {
  if (!busy_) return;
  Result<JobResult> outcome = read_job_outcome(bytes);
  // What broke off half-way leaves its memory behind.
  if (!outcome && outcome.error().kind != Error::Kind::bad_input) worker_.restart();
  settle(std::move(outcome));
}

void WorkerJobs::died(bool of_memory, const std::string& why) {
  worker_.restart();
  if (busy_) settle(of_memory ? out_of_memory(grid_) : broke_off(why));
}

void WorkerJobs::settle(Result<JobResult> outcome) {
  busy_ = false;
  outcome_ = std::move(outcome);
}

void serve_job(std::string_view request, const std::function<void(const std::string&)>& progress,
               const std::function<void(const std::string&)>& outcome) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kPace(30);
  Clock::time_point last{};
  Run run;
  run.on_progress = [&](const Progress& now) {
    if (Clock::now() - last < kPace && now.fraction < 1) return;
    last = Clock::now();
    progress(job_bytes(now));
  };
  const Result<JobRequest> wanted = read_job_request(request);
  outcome(job_bytes(wanted ? run_job(*wanted, run) : Result<JobResult>(wanted.error())));
}

}  // namespace artisketch
