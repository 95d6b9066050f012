// Writes sample_models() and an avatar into a folder, for the Khronos validator and three-vrm:
// write_samples FOLDER
#include <cstdio>

#include "files/bytes.h"
#include "files/gltf.h"
#include "files/sample_models.h"
#include "files/vrm.h"

using namespace artisketch;

int main(int count, char** arguments) {
  if (count != 2) return 2;
  const auto write = [&](const std::string& file, const Result<std::string>& bytes) {
    const Result<Done> written =
        bytes ? write_file(arguments[1] + ("/" + file), *bytes) : Result<Done>(bytes.error());
    if (!written) std::fprintf(stderr, "%s: %s\n", file.c_str(), written.error().text().c_str());
    return bool(written);
  };
  for (const auto& [name, model] : sample_models())
    if (!write(name + ".glb", glb_bytes(model))) return 1;
  VrmMeta meta;
  meta.name = "person";
  meta.authors = {"ArtiSketch's tests"};
  return write("person.vrm", vrm_bytes(person_with_tail_model(), meta)) ? 0 : 1;
}
