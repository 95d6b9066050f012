// Writes sample_models() into a folder, for the Khronos validator: write_samples FOLDER
#include <cstdio>

#include "files/bytes.h"
#include "files/gltf.h"
#include "files/sample_models.h"

using namespace artisketch;

int main(int count, char** arguments) {
  if (count != 2) return 2;
  for (const auto& [name, model] : sample_models()) {
    const Result<std::string> glb = glb_bytes(model);
    const Result<Done> written =
        glb ? write_file(arguments[1] + ("/" + name) + ".glb", *glb) : Result<Done>(glb.error());
    if (written) continue;
    std::fprintf(stderr, "%s: %s\n", name.c_str(), written.error().text().c_str());
    return 1;
  }
  return 0;
}
