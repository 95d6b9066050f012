#include "kept_work.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "files/bytes.h"

namespace artisketch {
namespace fs = std::filesystem;
namespace {

constexpr const char* kWork = "autosave-";
constexpr int kMostWindows = 1000;

// A lock on a file beside the work: that one is replaced whole with every change. Negative where
// another window has it, or it can't be had.
int locked(const fs::path& work) {
  const std::string path = work.string() + ".lock";
  const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0 || ::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  ::close(file);
  return -1;
}

// Earlier versions had no locks, and named work by the process.
bool without_lock_but_alive(const fs::path& work, const std::string& number) {
  std::error_code ignored;
  if (fs::exists(work.string() + ".lock", ignored)) return false;
  const pid_t process = std::atoi(number.c_str());
  return process != ::getpid() && (::kill(process, 0) == 0 || errno == EPERM);
}

struct Left {
  fs::path path;
  std::string number;
  fs::file_time_type time;
};

// Files `autosave-N` alone: no locks, and nothing that was half written. The newest first.
std::vector<Left> all_work(const fs::path& folder) {
  std::vector<Left> all;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(kWork)) continue;
    const std::string number = name.substr(std::string(kWork).size());
    if (number.empty() || number.size() > 9 ||
        number.find_first_not_of("0123456789") != number.npos)
      continue;
    all.push_back({entry.path(), number, fs::last_write_time(entry.path(), ignored)});
  }
  std::sort(all.begin(), all.end(), [](const Left& a, const Left& b) { return a.time > b.time; });
  return all;
}

}  // namespace

KeptWork::KeptWork(fs::path folder) : folder_(std::move(folder)) {
  std::error_code ignored;  // a folder that can't be made shows when something is kept
  fs::create_directories(folder_, ignored);
  for (int n = 1; n <= kMostWindows && lock_ < 0; ++n) {
    number_ = std::to_string(n);
    lock_ = locked(at(number_));
    if (lock_ >= 0 && fs::exists(at(number_), ignored)) {  // left behind: to be inherited
      ::close(lock_);
      lock_ = -1;
    }
  }
  if (lock_ < 0) number_ = std::to_string(::getpid());
}

KeptWork::~KeptWork() {
  for (const int lock : {lock_, left_lock_})
    if (lock >= 0) ::close(lock);
}

fs::path KeptWork::at(const std::string& number) const {
  return folder_ / (kWork + number);
}

Result<Done> KeptWork::keep(const std::string& bytes) {
  if (!bytes.empty()) return write_file(at(number_).string(), bytes);
  std::error_code ignored;
  fs::remove(at(number_), ignored);
  return Done{};
}

std::string KeptWork::left_behind(const std::function<bool(const std::string&)>& whole) {
  if (left_lock_ >= 0) ::close(std::exchange(left_lock_, -1));
  for (const Left& left : all_work(folder_)) {
    if (left.number == number_ || without_lock_but_alive(left.path, left.number)) continue;
    const int lock = locked(left.path);
    if (lock < 0) continue;
    Result<std::string> bytes = read_file(left.path.string());
    if (!bytes || !whole(*bytes)) {
      ::close(lock);
      continue;
    }
    left_ = left.path;
    left_lock_ = lock;
    return std::move(*bytes);
  }
  return {};
}

void KeptWork::forget_left() {
  if (left_lock_ < 0) return;
  std::error_code ignored;
  fs::remove(left_, ignored);
  ::close(std::exchange(left_lock_, -1));
}

}  // namespace artisketch
