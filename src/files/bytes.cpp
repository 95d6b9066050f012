#include "files/bytes.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include <fcntl.h>
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

}  // namespace

Result<std::string> read_file(const std::string& path) {
  Descriptor in(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!in.open()) return failure(path + ": cannot be read", errno);
  std::string bytes;
  std::array<char, 1 << 16> chunk;
  for (;;) {
    const ssize_t n = ::read(in.get(), chunk.data(), chunk.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return failure(path + ": cannot be read", errno);
    if (n == 0) return bytes;
    bytes.append(chunk.data(), std::size_t(n));
    if (bytes.size() > kLargestFile)
      return io_error(path + ": is larger than 1 GB; no file of ours is");
  }
}

Result<Done> write_file(const std::string& asked, std::string_view bytes) {
  const std::string path = behind_links(asked);
  struct stat old;
  const bool exists = ::stat(path.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode))
    return io_error(asked + ": is a folder; name a file inside it");
  if (exists && !S_ISREG(old.st_mode)) return write_to_device(path, bytes);

  // Beside the target, since rename works within one file system only.
  const std::string temporary = path + ".part-" + std::to_string(::getpid());
  const mode_t mode = exists ? old.st_mode & 0777 : 0666;
  ::unlink(temporary.c_str());  // of a process that died, whose number we have now
  Descriptor out(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode));
  if (!out.open()) return failure(asked + ": cannot be written", errno);
  if (!write_all(out.get(), bytes) || ::fsync(out.get()) != 0 || !out.close() ||
      ::rename(temporary.c_str(), path.c_str()) != 0) {
    const int code = errno;
    ::unlink(temporary.c_str());
    return failure(asked + ": cannot be written", code);
  }
  // The new name itself must reach the disk. Some file systems cannot sync folders: the file is
  // whole all the same.
  Descriptor folder(::open(folder_of(path).c_str(), O_RDONLY | O_CLOEXEC));
  if (folder.open()) ::fsync(folder.get());
  return Done{};
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
