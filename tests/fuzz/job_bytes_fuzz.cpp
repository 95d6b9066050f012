// Bytes that cross between the page and its worker: any at all are what they say or are refused,
// and what was read writes itself the same.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "app/job_bytes.h"
#include "files/bytes.h"

using namespace artisketch;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (const auto request = read_job_request(bytes)) (void)job_bytes(*request);
  if (const auto progress = read_job_progress(bytes)) (void)job_bytes(*progress);
  if (const auto outcome = read_job_outcome(bytes)) (void)job_bytes(outcome);
  // The same bytes as the text of a data: URI, which decodes to one sequence or none.
  if (const auto decoded = from_base64(bytes); decoded && base64(*decoded) != bytes) std::abort();
  if (const auto again = from_base64(base64(bytes)); !again || *again != bytes) std::abort();
  return 0;
}
