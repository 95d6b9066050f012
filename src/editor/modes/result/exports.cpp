#include "editor/modes/result/exports.h"

#include <algorithm>

#include "editor/session/files.h"
#include "editor/session/jobs.h"
#include "editor/ui/icons.h"
#include "files/gltf.h"
#include "files/gltf_compress.h"
#include "files/mesh_file.h"
#include "files/preview.h"
#include "files/vrm.h"
#include "model/rig/rig_profile.h"
#include "model/rig/t_pose.h"

namespace artisketch {
namespace {

std::string export_stem(const App& app) {
  const std::string& name = app.document().name;
  return name.empty() ? "model" : name;
}

// Each pixel the mean of four.
Image halved(const Image& from) {
  Image to;
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

// The model with the texture and the clips that were chosen.
Model chosen_model(const App& app) {
  const ExportChoice& wish = app.view.export_choice;
  Model model = app.session.built->model;
  if (!wish.texture) {
    model.texture.reset();
    model.texcoords.clear();
  }
  for (int i = 0; model.texture && i < wish.halvings; ++i) model.texture = halved(*model.texture);
  std::erase_if(model.clips, [&](const Clip& clip) {
    return app.session.export_wish.without.contains(clip.name);
  });
  return model;
}

Result<std::string> packed(const App& app, Result<std::string> bytes) {
  if (!bytes || !app.view.export_choice.compress) return bytes;
  return compressed_glb(*bytes);
}

// The model with its surface as the view shows it.
Model posed(const App& app, Model model) {
  model.mesh.V = posed_vertices(model.mesh.V, model.weights, model.skeleton, app.shown_pose());
  return model;
}
Model posed(const App& app) {
  return posed(app, app.session.built->model);
}

Result<std::string> as_still(const App& app) {
  Model model = posed(app, chosen_model(app));
  model.skeleton = {};
  model.weights = {};
  model.clips.clear();
  return packed(app, glb_bytes(model));
}

Result<std::string> as_glb(const App& app) {
  const ExportChoice& wish = app.view.export_choice;
  if (wish.rig == without_skeleton()) return as_still(app);
  if (wish.rig) {
    const Result<Model> rigged = for_engine(chosen_model(app), rig_profiles()[wish.rig - 1].name);
    return rigged ? packed(app, glb_bytes(*rigged)) : Result<std::string>(rigged.error());
  }
  if (wish.texture && wish.halvings == 0 && app.session.export_wish.without.empty() &&
      !app.session.built->clips_edited)
    return packed(app, app.session.built->glb);
  return packed(app, glb_bytes(chosen_model(app)));
}

Result<std::string> as_vrm(const App& app) {
  const Result<VrmMeta> meta = vrm_meta(app.document(), "the document");
  if (!meta) return meta.error();
  return packed(app, vrm_bytes(chosen_model(app), *meta));
}

Result<std::string> as_obj(const App& app) {
  return obj_text(posed(app));
}
Result<std::string> as_stl(const App& app) {
  return stl_bytes(posed(app));
}
Result<std::string> as_ply(const App& app) {
  return ply_bytes(posed(app));
}

Result<std::string> as_picture(const App& app) {
  constexpr int kPicture = 1024, kSprite = 256, kSides = 8;  // pixels
  RenderOptions options;
  options.yaw = -app.view.orbit.yaw;
  options.pitch = app.view.orbit.pitch;
  options.pose = app.shown_pose();
  options.clear = app.view.export_choice.sides;
  options.width = options.height = app.view.export_choice.sides ? kSprite : kPicture;
  return png_bytes(render_turntable(app.session.built->model, options,
                                    app.view.export_choice.sides ? kSides : 1));
}

constexpr ExportFormat kFormats[] = {
    {"GLB", "rigged, textured, animated", icon::kCubeSend, ".glb", as_glb},
    {"VRM", "a person as an avatar", icon::kRun, ".vrm", as_vrm},
    {"OBJ", "the shape in this pose", icon::kCubeOutline, ".obj", as_obj},
    {"STL", "for 3D printing, in this pose", icon::kGrid, ".stl", as_stl},
    {"PLY", "the shape with its colours", icon::kPalette, ".ply", as_ply},
    {"PNG", "from here, or from 8 sides", icon::kImage, ".png", as_picture},
    {"Sprites", "a sheet of the chosen clip", icon::kImageMultiple, ".zip", nullptr},
};

}  // namespace

std::size_t without_skeleton() {
  return rig_profiles().size() + 1;
}

std::span<const ExportFormat> export_formats() {
  return kFormats;
}

std::string export_name(const App& app, const ExportFormat& format) {
  return export_stem(app) + format.ending;
}

SpriteOptions sprite_wish(const App& app) {
  SpriteOptions options = app.view.export_choice.sprites;
  const std::vector<Clip>& clips = app.session.built->model.clips;
  if (const std::size_t chosen = std::size_t(app.session.playback.clip); chosen < clips.size())
    options.clip = clips[chosen].name;
  return options;
}

namespace {

// An avatar says who made it: asked for once, and kept in the document.
void ask_for_author(App& app) {
  Question question;
  question.title = "Who made it?";
  question.words = "A .vrm says so. The document keeps the name.";
  question.asks_path = true;
  question.field = "Author";
  question.with_path = [&app](const std::string& author) {
    if (author.find_first_not_of(' ') == author.npos) return ask_for_author(app);
    app.session.commit("Name the author", with_author(app.document(), author));
    export_model(app);
  };
  question.answers = {{"Export", {}, true}, {"Cancel", {}}};
  app.question = std::move(question);
}

void save_export(App& app, const std::string& name, std::string bytes) {
  const auto done = [&app](Result<Platform::Saved> saved) {
    if (!saved) return complain(app, saved.error());
    Toast toast;
    toast.words = "Exported " + saved->name + ".";
    app.say(std::move(toast));
  };
  if (app.services.platform.has_dialogs())
    return app.services.platform.save_file(name, "", std::move(bytes), done);
  Question question;
  question.title = "Export";
  question.words = "Where to, and under which name?";
  question.asks_path = true;
  question.path = name;
  question.with_path = [&app, name, bytes = std::move(bytes), done](const std::string& path) {
    app.services.platform.save_file(name, path, bytes, done);
  };
  question.answers = {{"Export", {}, true}, {"Cancel", {}}};
  app.question = std::move(question);
}

// What the command line makes of the same model's GLB. It takes seconds: away from what draws.
void export_sprites(App& app) {
  if (app.busy()) {
    Toast toast;
    toast.words = "Something else is being made: export when it is there.";
    return app.say(std::move(toast));
  }
  Result<std::string> glb = app.session.built->clips_edited
                                ? glb_bytes(app.session.built->model)
                                : Result<std::string>(app.session.built->glb);
  if (!glb) return complain(app, glb.error());
  JobRequest request;
  request.glb = std::move(*glb);
  request.sprites = sprite_wish(app);
  request.name = export_stem(app);
  const std::string file = request.name + ".zip";
  start_sprites(app, std::move(request),
                [&app, file](JobResult made) { save_export(app, file, std::move(made.sprites)); });
}

}  // namespace

void export_model(App& app) {
  const ExportFormat& format = export_formats()[app.view.export_choice.format];
  if (!format.bytes) return export_sprites(app);
  if (format.bytes == as_vrm && !vrm_meta(app.document(), "")) return ask_for_author(app);
  Result<std::string> bytes = format.bytes(app);
  if (!bytes) return complain(app, bytes.error());
  save_export(app, export_name(app, format), std::move(*bytes));
}

}  // namespace artisketch
