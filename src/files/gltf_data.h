// A binary glTF taken apart and checked, for what reads one.
#pragma once

#include <string>
#include <string_view>

#include <Eigen/Core>

#include "base/result.h"
#include "files/tinygltf_setup.h"

namespace artisketch {

// Why a file is refused. Thrown by what reads glTF and caught at its ends: the checks are many and
// deep.
struct Refused {
  std::string why;
};

inline void require(bool holds, const std::string& otherwise) {
  if (!holds) throw Refused{otherwise};
}

template <class List>
const auto& at(const List& list, int index, const char* what) {
  require(index >= 0 && std::size_t(index) < list.size(),
          std::string("names a ") + what + " that is not there");
  return list[std::size_t(index)];
}

using GltfRows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

class GltfData {
 public:
  explicit GltfData(std::string_view bytes);  // throws Refused; images stay encoded
  const tinygltf::Model& gltf() const { return gltf_; }
  std::string_view view_bytes(int view) const;
  // The accessor's elements, one row each, whatever the component type; all finite. Throws Refused,
  // also where it is sparse.
  GltfRows rows(int accessor, int type) const;

 private:
  tinygltf::Model gltf_;
};

// What `read` makes of the bytes, or why it doesn't; `hint` ends the words.
template <class Read>
auto read_gltf(std::string_view bytes, const std::string& name, const char* hint, Read read)
    -> Result<decltype(read())> {
  const auto refuse = [&](const std::string& why) { return bad_input(name + ": " + why + hint); };
  if (bytes.size() > std::size_t(INT32_MAX)) return refuse("is larger than 2 GB");
  try {
    return read();
  } catch (const Refused& refused) {
    return refuse(refused.why);
  } catch (const std::exception& error) {  // tinygltf and its JSON
    return refuse(std::string("is damaged: ") + error.what());
  }
}

}  // namespace artisketch
