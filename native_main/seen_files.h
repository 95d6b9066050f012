// What files held when this window read or wrote them last, so that it doesn't replace unasked what
// another one has saved there since.
#pragma once

#include <functional>
#include <map>
#include <string>

namespace artisketch {

class SeenFiles {
 public:
  void saw(const std::string& path, const std::string& bytes);
  // Whether a file that was seen holds something else by now. One that is gone, or can't be read,
  // has nothing to lose.
  bool changed(const std::string& path) const;
  void forget(const std::string& path);

 private:
  std::map<std::string, std::size_t> seen_;  // path without links → hash of its bytes
};

}  // namespace artisketch
