#include "app/job_thread.h"

#include <atomic>
#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "files/bytes.h"

namespace artisketch {
namespace {

JobRequest example(const std::string& name, int grid) {
  JobRequest request;
  request.document =
      *read_file(ARTISKETCH_SOURCE_DIR "/assets/examples/" + name + "/" + name + ".artisketch");
  request.options.grid = grid;
  return request;
}

void wait(std::chrono::milliseconds time = std::chrono::milliseconds(1)) {
  std::this_thread::sleep_for(time);
}

Result<JobResult> outcome_of(Jobs& jobs) {
  for (;;) {
    if (auto outcome = jobs.poll()) return *outcome;
    wait();
  }
}

TEST(JobThread, GivesWhatRunJobGivesAndOnlyOnce) {
  const JobRequest request = example("heart", 32);
  artisketch::Run run;
  const auto here = run_job(request, run);
  std::atomic<int> woken = 0;
  ThreadJobs jobs([&woken] { ++woken; });
  EXPECT_FALSE(jobs.busy());
  jobs.start(request);
  EXPECT_TRUE(jobs.busy());
  const auto there = outcome_of(jobs);
  ASSERT_TRUE(there);
  EXPECT_EQ(there->glb, here->glb);
  EXPECT_EQ(there->document, here->document);
  EXPECT_FALSE(jobs.busy());
  EXPECT_FALSE(jobs.poll());
  EXPECT_EQ(jobs.progress().fraction, 1);
  EXPECT_GT(woken, 1);
}

TEST(JobThread, ShowsHowFarItIs) {
  ThreadJobs jobs;
  jobs.start(example("robot", 48));
  double last = 0;
  int risen = 0;
  for (std::optional<Result<JobResult>> outcome; !outcome; outcome = jobs.poll()) {
    const double now = jobs.progress().fraction;
    EXPECT_GE(now, last);
    risen += now > last;
    last = now;
    wait();
  }
  EXPECT_GT(risen, 3);
}

TEST(JobThread, CancelIsAnsweredAtOnceAndTheThreadEndsSoon) {
  ThreadJobs jobs;
  jobs.start(example("hero", 200));
  wait(std::chrono::milliseconds(50));
  jobs.cancel();
  EXPECT_FALSE(jobs.busy());
  const auto outcome = jobs.poll();
  ASSERT_TRUE(outcome);
  ASSERT_FALSE(*outcome);
  EXPECT_EQ(outcome->error().kind, Error::Kind::cancelled);
  EXPECT_FALSE(jobs.poll());
  jobs.cancel();
  EXPECT_FALSE(jobs.poll()) << "nothing was under way";
}

TEST(JobThread, ANewJobReplacesTheOld) {
  ThreadJobs jobs;
  jobs.start(example("hero", 200));
  jobs.start(example("circles", 24));
  const auto outcome = outcome_of(jobs);
  ASSERT_TRUE(outcome);
  artisketch::Run run;
  EXPECT_EQ(outcome->glb, run_job(example("circles", 24), run)->glb);
}

TEST(JobThread, EndsWithItsOwner) {
  std::atomic<int> of_all = 0, of_this = 0;  // news of a job
  {
    ThreadJobs jobs([&of_all] { ++of_all; });
    jobs.start(example("hero", 24));
    EXPECT_TRUE(outcome_of(jobs));
  }
  {
    ThreadJobs jobs([&of_this] { ++of_this; });
    jobs.start(example("hero", 400));
    wait(std::chrono::milliseconds(20));
  }
  EXPECT_LT(of_this, of_all / 2) << "long before the job is done";
}

TEST(JobThread, FaultsComeInWords) {
  ThreadJobs jobs;
  JobRequest request;
  request.document = "no document";
  jobs.start(request);
  const auto outcome = outcome_of(jobs);
  ASSERT_FALSE(outcome);
  EXPECT_EQ(outcome.error().kind, Error::Kind::bad_input);
  EXPECT_FALSE(outcome.error().faults.empty());
}

}  // namespace
}  // namespace artisketch
