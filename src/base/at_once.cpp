#include "base/at_once.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>

namespace artisketch {

#ifdef __EMSCRIPTEN__  // a page's threads need headers that plain static hosts don't send

int threads_here() {
  return 1;
}

void at_once(int count, int, const std::function<void(int)>& work) {
  for (int i = 0; i < count; ++i) work(i);
}

#else

int threads_here() {
  return std::max(1, int(std::thread::hardware_concurrency()));
}

void at_once(int count, int threads, const std::function<void(int)>& work) {
  if (std::min(count, threads) < 2) {
    for (int i = 0; i < count; ++i) work(i);
    return;
  }
  std::atomic<int> next = 0;
  std::atomic<bool> failed = false;
  std::vector<std::exception_ptr> thrown(count);
  const auto work_on = [&] {
    for (int i; !failed && (i = next++) < count;) try {
        work(i);
      } catch (...) {
        thrown[i] = std::current_exception();
        failed = true;
      }
  };
  std::vector<std::thread> others;
  others.reserve(std::min(count, threads) - 1);
  try {
    while (int(others.size()) + 1 < std::min(count, threads)) others.emplace_back(work_on);
  } catch (const std::system_error&) {  // no more threads to be had: fewer do
  }
  work_on();
  for (std::thread& other : others) other.join();
  for (const std::exception_ptr& one : thrown)
    if (one) std::rethrow_exception(one);
}

#endif

}  // namespace artisketch
