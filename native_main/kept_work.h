// Work that isn't saved, kept in a folder for the time after a crash: each window's in a file of
// its own, `autosave-N`, held by a lock for as long as the window lives.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "base/result.h"

namespace artisketch {

class KeptWork {
 public:
  // Takes a number that no window has and under which nothing was left. Where the folder or its
  // locks can't be had, work goes under this process's number.
  explicit KeptWork(std::filesystem::path folder);
  ~KeptWork();
  KeptWork(const KeptWork&) = delete;
  KeptWork& operator=(const KeptWork&) = delete;

  Result<Done> keep(const std::string& bytes);  // nothing: forget it
  // The newest work that windows left behind which is `whole`; nothing where there is none. It
  // stays in its file, held by this window, until it is forgotten; so does what isn't whole.
  std::string left_behind(const std::function<bool(const std::string&)>& whole);
  void forget_left();

 private:
  std::filesystem::path at(const std::string& number) const;

  std::filesystem::path folder_;
  std::string number_;
  int lock_ = -1;
  std::filesystem::path left_;
  int left_lock_ = -1;
};

}  // namespace artisketch
