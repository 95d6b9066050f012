// The model out: what the export sheet chose, as a file.
#include <algorithm>

#include "editor/session/actions.h"
#include "editor/shell/panels.h"
#include "editor/ui/icons.h"
#include "files/gltf.h"
#include "files/mesh_file.h"
#include "files/preview.h"

namespace artisketch {
namespace {

// Each pixel the mean of four.
Texture halved(const Texture& from) {
  Texture to;
  to.width = std::max(1, from.width / 2);
  to.height = std::max(1, from.height / 2);
  const auto at = [&](int x, int y, int channel) {
    const std::size_t pixel = std::size_t(std::min(y, from.height - 1)) * std::size_t(from.width) +
                              std::size_t(std::min(x, from.width - 1));
    return int(from.rgba[4 * pixel + std::size_t(channel)]);
  };
  to.rgba.reserve(4 * std::size_t(to.width) * std::size_t(to.height));
  for (int y = 0; y < to.height; ++y)
    for (int x = 0; x < to.width; ++x)
      for (int c = 0; c < 4; ++c)
        to.rgba.push_back(std::uint8_t((at(2 * x, 2 * y, c) + at(2 * x + 1, 2 * y, c) +
                                        at(2 * x, 2 * y + 1, c) + at(2 * x + 1, 2 * y + 1, c) + 2) /
                                       4));
  return to;
}

Result<std::string> as_glb(const Work& work) {
  const ExportWish& wish = work.view.wish;
  if (wish.texture && wish.halvings == 0 && wish.without.empty() && !work.built->clips_edited)
    return work.built->glb;
  Model model = work.built->model;
  if (!wish.texture) {
    model.texture.reset();
    model.texcoords.clear();
  }
  for (int i = 0; model.texture && i < wish.halvings; ++i) model.texture = halved(*model.texture);
  std::erase_if(model.clips, [&](const Clip& clip) { return wish.without.contains(clip.name); });
  return glb_bytes(model);
}

// The model with its surface as the view shows it.
Model posed(const Work& work) {
  Model model = work.built->model;
  model.mesh.V = posed_vertices(model.mesh.V, model.weights, model.skeleton, work.shown_pose());
  return model;
}

Result<std::string> as_obj(const Work& work) {
  return obj_text(posed(work));
}
Result<std::string> as_stl(const Work& work) {
  return stl_bytes(posed(work));
}
Result<std::string> as_ply(const Work& work) {
  return ply_bytes(posed(work));
}

Result<std::string> as_picture(const Work& work) {
  constexpr int kPicture = 1024, kSprite = 256, kSides = 8;  // pixels
  RenderOptions options;
  options.yaw = -work.view.orbit.yaw;
  options.pitch = work.view.orbit.pitch;
  options.pose = work.shown_pose();
  options.clear = work.view.wish.sides;
  options.width = options.height = work.view.wish.sides ? kSprite : kPicture;
  return png_bytes(render_turntable(work.built->model, options, work.view.wish.sides ? kSides : 1));
}

constexpr ExportFormat kFormats[] = {
    {"GLB", "rigged, textured, animated", icon::kCubeSend, ".glb", as_glb},
    {"OBJ", "the shape in this pose", icon::kCubeOutline, ".obj", as_obj},
    {"STL", "for 3D printing, in this pose", icon::kGrid, ".stl", as_stl},
    {"PLY", "the shape with its colours", icon::kPalette, ".ply", as_ply},
    {"PNG", "picture, or sprites from 8 sides", icon::kImageMultiple, ".png", as_picture},
};

}  // namespace

std::span<const ExportFormat> export_formats() {
  return kFormats;
}

std::string export_name(const Work& work, const ExportFormat& format) {
  const std::string& name = work.document().name;
  return (name.empty() ? "model" : name) + format.ending;
}

void export_model(Work& work, const ExportFormat& format) {
  if (!work.built) return;
  Result<std::string> bytes = format.bytes(work);
  if (!bytes) return complain(work, bytes.error());
  const std::string name = export_name(work, format);
  const auto done = [&work](Result<Platform::Saved> saved) {
    if (!saved) return complain(work, saved.error());
    Toast toast;
    toast.words = "Exported " + saved->name + ".";
    work.say(std::move(toast));
  };
  if (work.platform.has_dialogs())
    return work.platform.save_file(name, "", std::move(*bytes), done);
  Question question;
  question.title = "Export";
  question.words = "Where to, and under which name?";
  question.asks_path = true;
  question.path = name;
  question.with_path = [&work, name, bytes = std::move(*bytes), done](const std::string& path) {
    work.platform.save_file(name, path, bytes, done);
  };
  question.answers = {{"Export", {}, true}, {"Cancel", {}}};
  work.question = std::move(question);
}

}  // namespace artisketch
