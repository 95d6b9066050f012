// Jobs in a worker that only messages reach: a Web Worker with its own copy of the core. The worker
// does one job per request and knows nothing of cancelling: it is ended, and begun afresh.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "app/job.h"

namespace artisketch {

class WorkerJobs : public Jobs {
 public:
  struct Worker {
    std::function<void(const std::string& request)> post;  // job_bytes of a request
    std::function<void()> restart;  // ends it, whatever it does, and begins another
  };
  explicit WorkerJobs(Worker worker) : worker_(std::move(worker)) {}

  // What the worker sent: job_bytes of a progress and of an outcome. Whoever calls makes sure that
  // it comes from the worker that was begun last.
  void progressed(std::string_view bytes);
  void finished(std::string_view bytes);
  // The worker broke off, as the browser tells it.
  void died(bool of_memory, const std::string& why);

  void start(JobRequest request) override;
  bool busy() const override { return busy_; }
  Progress progress() const override { return progress_; }
  std::optional<Result<JobResult>> poll() override;
  void cancel() override;

 private:
  void settle(Result<JobResult> outcome);

  Worker worker_;
  bool busy_ = false;
  int grid_ = 0;  // of the last request
  Progress progress_;
  std::optional<Result<JobResult>> outcome_;
};

// The worker's side: does the job of `request` and sends what progressed() and finished() take;
// progress at most every 30 ms or so.
void serve_job(std::string_view request, const std::function<void(const std::string&)>& progress,
               const std::function<void(const std::string&)>& outcome);

}  // namespace artisketch
