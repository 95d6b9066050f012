// What is drawn of a model: a picture, a turntable, a sheet of sprites.
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/outputs.h"
#include "app/verbs.h"
#include "base/words.h"
#include "files/bytes.h"
#include "files/gltf.h"
#include "files/image_file.h"
#include "files/preview.h"

namespace artisketch {
namespace {

// The model that a picture is drawn of, once it is sure where that can go; else the exit status.
std::optional<Model> model_to_draw(const Arguments& a, const std::vector<Target>& targets,
                                   int& status) {
  status = judge_endings(targets);
  if (status == kDone) status = judge_places(targets);
  if (status == kDone) status = judge_overwriting(targets, {a.in});
  if (status != kDone) return std::nullopt;
  const Result<std::string> bytes = read_file(a.in);
  if (!bytes) return status = fail(bad_input(bytes.error().text())), std::nullopt;
  Result<Model> model = read_glb(*bytes, a.in);
  if (!model) return status = fail(bad_input(model.error().text())), std::nullopt;
  return std::move(*model);
}

}  // namespace

int render_verb(const Arguments& a) {
  RenderOptions options;
  char extra = 0;
  if (std::sscanf(a.size.c_str(), "%dx%d%c", &options.width, &options.height, &extra) != 2 ||
      std::min(options.width, options.height) < 16 ||
      std::max(options.width, options.height) > 8192)
    return bad_command_line("--size " + a.size +
                            ": wanted WIDTHxHEIGHT in pixels, 16 to 8192 each, like 800x600");
  int status = kDone;
  const std::optional<Model> model = model_to_draw(a, {{"-o", a.out, Kind::picture}}, status);
  if (!model) return status;
  if (a.frame) {
    const int keys = model->clips.empty() ? 0 : int(model->clips[0].poses.size());
    if (a.frame > keys)
      return bad_command_line("--frame " + std::to_string(a.frame) + ": " + a.in + " has " +
                              std::to_string(keys) + " frames; name one from 1 to " +
                              std::to_string(keys));
    options.frame = a.frame - 1;
  }
  options.clear = a.clear;
  options.yaw = radians(a.yaw);
  options.pitch = radians(a.pitch);
  const Image image =
      a.turntable ? render_turntable(*model, options, a.turntable) : render_model(*model, options);
  return write_all({{a.out, png_bytes(image)}});
}

// The sheet's files go beside each other, or into one archive.
int sprites_verb(Arguments& a) {
  namespace fs = std::filesystem;
  const fs::path out(a.out);
  const std::string folder = out.parent_path().empty() ? "" : out.parent_path().string() + "/",
                    name = out.stem().string();
  const bool archive = lower_case(out.extension().string()) == ".zip";
  if (archive && !a.json.empty())
    return bad_command_line("--json " + a.json + ": goes into the archive; leave it out");
  std::vector<Target> targets{{"-o", a.out, archive ? Kind::archive : Kind::picture}};
  if (!archive) {
    if (a.json.empty()) a.json = folder + name + ".json";
    targets.push_back({"--json", a.json, Kind::report});
    if (a.sprites.normals)
      targets.push_back({"--normals", folder + name + "_n.png", Kind::picture});
    if (a.sprites.depth) targets.push_back({"--depth", folder + name + "_d.png", Kind::picture});
  }
  int status = kDone;
  const std::optional<Model> model = model_to_draw(a, targets, status);
  if (!model) return status;
  a.sprites.pitch = radians(a.pitch);
  if (archive) {
    const Result<std::string> bytes = sprite_zip(*model, a.sprites, name);
    if (!bytes) return fail(bad_input(a.in + ": " + bytes.error().text()));
    return write_all({{a.out, *bytes}});
  }
  const Result<std::vector<FileInside>> files = sprite_files(*model, a.sprites, name);
  if (!files) return fail(bad_input(a.in + ": " + files.error().text()));
  std::vector<Output> outputs;
  for (std::size_t i = 0; i < files->size(); ++i)
    outputs.push_back({targets[i].path, (*files)[i].bytes});
  return write_all(outputs);
}

}  // namespace artisketch
