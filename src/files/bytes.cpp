#include "files/bytes.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <deque>
#include <memory>
#include <set>
#include <vector>

#include <dirent.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

namespace artisketch {
namespace {

// Far above any document with its drawings inside; ends the reading of a device that never does.
constexpr std::size_t kLargestFile = std::size_t(1) << 30;

constexpr std::string_view kAlphabet =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }
  bool open() const { return fd_ >= 0; }
  int get() const { return fd_; }
  bool close() {
    const int fd = fd_;
    fd_ = -1;
    return fd < 0 || ::close(fd) == 0;
  }

 private:
  int fd_;
};

Error failure(const std::string& what, int code) {
  return io_error(what + ": " + std::strerror(code));
}

bool write_all(int fd, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    bytes.remove_prefix(std::size_t(n));
  }
  return true;
}

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  if (slash == std::string::npos) return ".";
  return slash == 0 ? "/" : path.substr(0, slash);
}

// The file that a chain of links leads to: the link itself is to stay where it is.
std::string behind_links(std::string path) {
  for (int hops = 0; hops < 40; ++hops) {
    std::array<char, 4096> target;
    const ssize_t n = ::readlink(path.c_str(), target.data(), target.size());
    if (n < 0 || n == ssize_t(target.size())) break;
    const std::string to(target.data(), std::size_t(n));
    path = !to.empty() && to[0] == '/' ? to : folder_of(path) + "/" + to;
  }
  return path;
}

// Pipes, terminals and /dev/null take the bytes as they are: there is nothing to replace.
Result<Done> write_to_device(const std::string& path, std::string_view bytes) {
  Descriptor out(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (!out.open() || !write_all(out.get(), bytes) || !out.close())
    return failure(path + ": cannot be written", errno);
  return Done{};
}

// Beside its target, since rename works within one file system only, and goes where it isn't put in
// place. Its name is short and says nothing of the target's, which may be as long as names can be.
class Temporary {
 public:
  explicit Temporary(std::string target) : target_(std::move(target)) {
    static std::atomic<unsigned> count = 0;
    name_ = folder_of(target_) + "/" + kTemporary + std::to_string(::getpid()) + "-" +
            std::to_string(++count) + kPart;
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    if (written_) ::unlink(name_.c_str());
  }
  // Both leave errno where they fail.
  bool write(std::string_view bytes, mode_t mode) {
    ::unlink(name_.c_str());  // of a process that died, whose number we have now
    Descriptor out(::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode));
    if (!out.open()) return false;
    written_ = true;
    return write_all(out.get(), bytes) && ::fsync(out.get()) == 0 && out.close();
  }
  bool put_in_place() {
    if (::rename(name_.c_str(), target_.c_str()) != 0) return false;
    written_ = false;
    // The new name itself must reach the disk. Some file systems cannot sync folders: the file is
    // whole all the same.
    Descriptor folder(::open(folder_of(target_).c_str(), O_RDONLY | O_CLOEXEC));
    if (folder.open()) ::fsync(folder.get());
    return true;
  }
  static void sweep(const std::string& folder);

 private:
  static constexpr const char* kTemporary = ".artisketch-";
  static constexpr const char* kPart = ".part";
  std::string target_, name_;
  bool written_ = false;
};

// Removes what killed processes left: old, and of a number that no process has. The age is for
// folders that machines share.
void Temporary::sweep(const std::string& folder) {
  constexpr std::time_t kOld = 3600;  // seconds
  const std::unique_ptr<DIR, int (*)(DIR*)> entries(::opendir(folder.c_str()), ::closedir);
  while (const dirent* entry = entries ? ::readdir(entries.get()) : nullptr) {
    const std::string_view name = entry->d_name;
    if (!name.starts_with(kTemporary) || !name.ends_with(kPart)) continue;
    const long process = std::atol(entry->d_name + std::strlen(kTemporary));
    const std::string path = folder + "/" + entry->d_name;
    struct stat is;
    if (process <= 0 || ::stat(path.c_str(), &is) != 0 || !S_ISREG(is.st_mode)) continue;
    if (std::time(nullptr) - is.st_mtime > kOld && ::kill(pid_t(process), 0) != 0 && errno == ESRCH)
      ::unlink(path.c_str());
  }
}

// Whether there is something to read, or the end; waits for what is no regular file.
bool readable(int fd, int milliseconds) {
  pollfd wanted{fd, POLLIN, 0};
  int found = 0;
  do found = ::poll(&wanted, 1, milliseconds);
  while (found < 0 && errno == EINTR);
  return found != 0;
}

std::string folder_words(const std::string& path) {
  std::string words = path + ": is a folder; name the file in it that you mean";
  const std::unique_ptr<DIR, int (*)(DIR*)> entries(::opendir(path.c_str()), ::closedir);
  std::string first;
  while (const dirent* entry = entries ? ::readdir(entries.get()) : nullptr) {
    const std::string_view name = entry->d_name;
    if (name.ends_with(".artisketch") && (first.empty() || name < first)) first = name;
  }
  return first.empty() ? words
                       : words + ", like " + path + (path.ends_with('/') ? "" : "/") + first;
}

}  // namespace

Result<std::string> read_file(const std::string& path) {
  // Not to wait in open() for a pipe that nobody writes to.
  Descriptor in(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!in.open()) return failure(path + ": cannot be read", errno);
  struct stat is;
  if (::fstat(in.get(), &is) != 0) return failure(path + ": cannot be read", errno);
  if (S_ISDIR(is.st_mode)) return io_error(folder_words(path));
  const auto too_large = [&] {
    return io_error(path + ": is larger than 1 GB; no file of ours is");
  };
  if (S_ISREG(is.st_mode) && std::uintmax_t(is.st_size) > kLargestFile) return too_large();
  std::string bytes;
  std::array<char, 1 << 16> chunk;
  constexpr int kForAWriter = 1000, kForBytes = 60000;  // ms
  // A pipe whose other end nobody has opened reads as empty; where somebody has, bytes may come.
  if (S_ISFIFO(is.st_mode) && !readable(in.get(), kForAWriter) &&
      ::read(in.get(), chunk.data(), 1) == 0)
    return io_error(path + ": is a pipe that nobody writes to; name a file");
  for (;;) {
    if (!S_ISREG(is.st_mode) && !readable(in.get(), kForBytes))
      return io_error(path + ": is a pipe that brings nothing; name a file");
    const ssize_t n = ::read(in.get(), chunk.data(), chunk.size());
    if (n < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (n < 0) return failure(path + ": cannot be read", errno);
    if (n == 0) return bytes;
    bytes.append(chunk.data(), std::size_t(n));
    if (bytes.size() > kLargestFile) return too_large();
  }
}

Result<Done> write_files(std::span<const NewFile> files) {
  std::deque<Temporary> ready;
  std::vector<const NewFile*> of, devices;
  std::set<std::string> folders;
  for (const NewFile& file : files) {
    const std::string path = behind_links(file.path);
    struct stat old;
    const bool exists = ::stat(path.c_str(), &old) == 0;
    if (exists && S_ISDIR(old.st_mode))
      return io_error(file.path + ": is a folder; name a file inside it");
    if (exists && !S_ISREG(old.st_mode)) {
      devices.push_back(&file);
      continue;
    }
    if (folders.insert(folder_of(path)).second) Temporary::sweep(folder_of(path));
    of.push_back(&file);
    if (!ready.emplace_back(path).write(file.bytes, exists ? old.st_mode & 0777 : 0666))
      return failure(file.path + ": cannot be written", errno);
  }
  for (const NewFile* file : devices)
    if (const Result<Done> written = write_to_device(file->path, file->bytes); !written)
      return written;
  for (std::size_t i = 0; i < ready.size(); ++i)
    if (!ready[i].put_in_place()) return failure(of[i]->path + ": cannot be written", errno);
  return Done{};
}

Result<Done> write_file(const std::string& path, std::string_view bytes) {
  const NewFile file{path, bytes};
  return write_files({&file, 1});
}

std::string file_identity(const std::string& path) {
  struct stat status;
  if (::stat(path.c_str(), &status) == 0)
    return S_ISREG(status.st_mode)
               ? std::to_string(status.st_dev) + ":" + std::to_string(status.st_ino)
               : "";
  const std::string at = behind_links(path);
  const std::unique_ptr<char, void (*)(void*)> folder(::realpath(folder_of(at).c_str(), nullptr),
                                                      std::free);
  return (folder ? folder.get() : folder_of(at)) + "/" + at.substr(at.rfind('/') + 1);
}

bool same_file(const std::string& a, const std::string& b) {
  const std::string of_a = file_identity(a);
  return !of_a.empty() && of_a == file_identity(b);
}

std::string base64(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < n ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= n ? kAlphabet[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

Result<std::string> from_base64(std::string_view text) {
  const auto bad = [](const std::string& what) { return bad_input("the base64 text " + what); };
  if (text.size() % 4 != 0) return bad("is cut off: its length is no multiple of four");
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  for (std::size_t i = 0; i < text.size(); i += 4) {
    const bool last = i + 4 == text.size();
    const int padding = !last ? 0 : text[i + 3] != '=' ? 0 : text[i + 2] != '=' ? 1 : 2;
    unsigned group = 0;
    for (int k = 0; k < 4; ++k) {
      const std::size_t digit = k < 4 - padding ? kAlphabet.find(text[i + k]) : 0;
      if (digit == kAlphabet.npos)
        return bad("has a foreign character at position " + std::to_string(i + k + 1));
      group = group << 6 | unsigned(digit);
    }
    // Strict: one text for one sequence of bytes.
    if (padding && (group & (padding == 2 ? 0xffffu : 0xffu))) return bad("ends in stray bits");
    for (int k = 0; k < 3 - padding; ++k) bytes += char(group >> (16 - 8 * k) & 255);
  }
  return bytes;
}

}  // namespace artisketch
