// Jobs as bytes, to cross into a worker and back. Both sides are one build: the layout is private
// to it and carries no version.
#pragma once

#include <string>
#include <string_view>

#include "app/job.h"

namespace artisketch {

std::string job_bytes(const JobRequest& request);
std::string job_bytes(const Progress& progress);
std::string job_bytes(const Result<JobResult>& outcome);

// Fail (crashed) on bytes that the functions above did not make.
Result<JobRequest> read_job_request(std::string_view bytes);
Result<Progress> read_job_progress(std::string_view bytes);
Result<JobResult> read_job_outcome(std::string_view bytes);

}  // namespace artisketch
