#include "app/job_worker.h"

#include <gtest/gtest.h>

#include "app/job_bytes.h"
#include "files/bytes.h"

namespace artisketch {
namespace {

struct WorkerJobsTest : testing::Test {
  std::vector<std::string> posted;
  int restarts = 0;
  WorkerJobs jobs{
      {[this](const std::string& bytes) { posted.push_back(bytes); }, [this] { ++restarts; }}};

  static JobRequest circles() {
    JobRequest request;
    request.document =
        *read_file(ARTISKETCH_SOURCE_DIR "/assets/examples/circles/circles.artisketch");
    request.options.grid = 24;
    return request;
  }
  // Does what was posted last, as the worker would.
  void serve() {
    serve_job(
        posted.back(), [this](const std::string& bytes) { jobs.progressed(bytes); },
        [this](const std::string& bytes) { jobs.finished(bytes); });
  }
  Error error() {
    const auto outcome = jobs.poll();
    EXPECT_TRUE(outcome && !*outcome);
    return outcome && !*outcome ? outcome->error() : Error();
  }
};

TEST_F(WorkerJobsTest, GivesWhatRunJobGives) {
  jobs.start(circles());
  EXPECT_TRUE(jobs.busy());
  EXPECT_FALSE(jobs.poll());
  serve();
  EXPECT_FALSE(jobs.busy());
  const auto outcome = jobs.poll();
  ASSERT_TRUE(outcome && *outcome);
  artisketch::Run run;
  EXPECT_EQ((*outcome)->glb, run_job(circles(), run)->glb);
  EXPECT_EQ(jobs.progress().fraction, 1);
  EXPECT_FALSE(jobs.poll());
  EXPECT_EQ(restarts, 0);
}

TEST_F(WorkerJobsTest, CancelEndsTheWorkerAndSaysSo) {
  jobs.cancel();
  EXPECT_EQ(restarts, 0) << "nothing to cancel";
  jobs.start(circles());
  jobs.cancel();
  EXPECT_FALSE(jobs.busy());
  EXPECT_EQ(restarts, 1);
  EXPECT_EQ(error().kind, Error::Kind::cancelled);
}

TEST_F(WorkerJobsTest, ANewJobEndsTheOldWithoutAWord) {
  jobs.start(circles());
  jobs.start(circles());
  EXPECT_EQ(restarts, 1);
  EXPECT_EQ(posted.size(), 2u);
  EXPECT_TRUE(jobs.busy());
  EXPECT_FALSE(jobs.poll());
}

TEST_F(WorkerJobsTest, DeathIsToldInWordsAndTheWorkerBeginsAfresh) {
  jobs.start(circles());
  jobs.died(false, "unreachable");
  EXPECT_EQ(restarts, 1);
  Error told = error();
  EXPECT_EQ(told.kind, Error::Kind::crashed);
  EXPECT_NE(told.text().find("unreachable"), std::string::npos);
  jobs.start(circles());
  jobs.died(true, "out of memory");
  EXPECT_EQ(restarts, 2);
  EXPECT_EQ(error().kind, Error::Kind::out_of_memory);
  jobs.start(circles());
  serve();
  EXPECT_TRUE(jobs.poll()->ok()) << "the next job is done as ever";
}

TEST_F(WorkerJobsTest, AWorkerThatLacksMemoryIsReplacedOneThatRefusesIsNot) {
  jobs.start(circles());
  jobs.finished(job_bytes(Result<JobResult>(out_of_memory(24))));
  EXPECT_EQ(restarts, 1);
  EXPECT_EQ(error().kind, Error::Kind::out_of_memory);
  JobRequest empty;
  jobs.start(empty);
  serve();
  EXPECT_EQ(restarts, 1);
  EXPECT_EQ(error().kind, Error::Kind::bad_input);
}

TEST_F(WorkerJobsTest, ADamagedMessageIsAnErrorToo) {
  jobs.start(circles());
  jobs.finished("rubbish");
  EXPECT_EQ(error().kind, Error::Kind::crashed);
  jobs.start(circles());
  posted.back() = "rubbish";
  serve();
  EXPECT_EQ(error().kind, Error::Kind::crashed);
}

}  // namespace
}  // namespace artisketch
