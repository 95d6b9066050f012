// Writes sample_models() and an avatar into a folder, for the Khronos validator and three-vrm:
// write_samples FOLDER
#include <cstdio>

#include "files/bytes.h"
#include "files/gltf.h"
#include "files/gltf_compress.h"
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
  const Result<std::string> avatar = vrm_bytes(person_with_tail_model(), meta);
  if (!write("person.vrm", avatar) || !write("small.vrm", compressed_glb(*avatar))) return 1;
  const std::string small = compressed_glb(*glb_bytes(textured_model()));
  if (!write("small.glb", small)) return 1;
  return write("quantized.glb", glb_of(decompressed(glb_parts(small)))) ? 0 : 1;
}
