// Jobs on a thread of their own, for programs that may have threads.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "app/job.h"

namespace artisketch {

class ThreadJobs : public Jobs {
 public:
  // `wake` is called from the working thread whenever there is news; it may be empty.
  explicit ThreadJobs(std::function<void()> wake = {});
  ~ThreadJobs() override;  // waits for what was cancelled: at most 0.2 s or so

  void start(JobRequest request) override;
  bool busy() const override;
  Progress progress() const override;
  std::optional<Result<JobResult>> poll() override;
  void cancel() override;

 private:
  struct Work;
  void retire();  // asks the work under way to end, and lets go of it
  void sweep();   // joins what has ended

  std::function<void()> wake_;
  std::unique_ptr<Work> work_;                  // under way
  std::vector<std::unique_ptr<Work>> retired_;  // asked to end
  Progress progress_;                           // of work that is gone
  bool cancelled_ = false;                      // not told yet
};

}  // namespace artisketch
