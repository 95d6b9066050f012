#include "app/job_thread.h"

#include <atomic>
#include <mutex>
#include <thread>

#include "base/at_once.h"

namespace artisketch {

struct ThreadJobs::Work {
  std::thread thread;
  std::atomic<bool> cancel = false;
  std::atomic<bool> ended = false;  // the thread is about to return
  mutable std::mutex guard;         // of what follows
  Progress progress;
  std::optional<Result<JobResult>> outcome;

  ~Work() {
    cancel = true;
    thread.join();
  }
  void run(const JobRequest& request, const std::function<void()>& wake) {
    Run run;
    run.cancel = &cancel;
    run.threads = threads_here();
    run.on_progress = [this, &wake](const Progress& now) {
      {
        const std::lock_guard lock(guard);
        progress = now;
      }
      if (wake) wake();
    };
    Result<JobResult> result = run_job(request, run);
    {
      const std::lock_guard lock(guard);
      outcome = std::move(result);
    }
    ended = true;
    if (wake) wake();
  }
};

ThreadJobs::ThreadJobs(std::function<void()> wake) : wake_(std::move(wake)) {}

ThreadJobs::~ThreadJobs() {
  retire();
}

void ThreadJobs::start(JobRequest request) {
  retire();
  sweep();
  cancelled_ = false;
  progress_ = {};
  work_ = std::make_unique<Work>();
  work_->thread = std::thread(
      [this, work = work_.get(), request = std::move(request)] { work->run(request, wake_); });
}

bool ThreadJobs::busy() const {
  return work_ != nullptr;
}

Progress ThreadJobs::progress() const {
  if (!work_) return progress_;
  const std::lock_guard lock(work_->guard);
  return work_->progress;
}

std::optional<Result<JobResult>> ThreadJobs::poll() {
  sweep();
  if (cancelled_) {
    cancelled_ = false;
    return artisketch::cancelled();
  }
  if (!work_ || !work_->ended) return std::nullopt;
  progress_ = progress();
  const std::unique_ptr<Work> done = std::move(work_);
  return std::move(done->outcome);
}

void ThreadJobs::cancel() {
  if (!work_) return;
  retire();
  cancelled_ = true;
}

void ThreadJobs::retire() {
  if (!work_) return;
  progress_ = progress();
  work_->cancel = true;
  retired_.push_back(std::move(work_));
}

void ThreadJobs::sweep() {
  std::erase_if(retired_, [](const std::unique_ptr<Work>& work) { return work->ended.load(); });
}

}  // namespace artisketch
