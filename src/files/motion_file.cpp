#include "files/motion_file.h"

#include <filesystem>

#include "files/bvh_file.h"
#include "files/bytes.h"

namespace artisketch {
namespace {

bool is_glb(std::string_view bytes) {
  return bytes.starts_with("glTF");
}

}  // namespace

bool is_motion(std::string_view bytes) {
  return is_glb(bytes) || is_bvh(bytes);
}

Result<std::vector<Motion>> parse_motions(std::string_view bytes, const std::string& name,
                                          const std::string& file) {
  if (is_glb(bytes)) return parse_glb_motions(bytes, name, file);
  Result<Motion> one = parse_bvh(bytes, name, file);
  if (!one) return one.error();
  std::vector<Motion> motions;
  motions.push_back(std::move(*one));
  return motions;
}

Result<Motion> read_skeleton(const std::string& path) {
  const Result<std::string> bytes = read_file(path);
  if (!bytes) return bad_input(bytes.error().text());
  const std::string name = std::filesystem::path(path).stem().string();
  return is_glb(*bytes) ? parse_glb_skeleton(*bytes, name, path) : parse_bvh(*bytes, name, path);
}

Result<std::vector<Motion>> read_motions(const std::string& path) {
  const Result<std::string> bytes = read_file(path);
  if (!bytes) return bad_input(bytes.error().text());
  return parse_motions(*bytes, std::filesystem::path(path).stem().string(), path);
}

}  // namespace artisketch
