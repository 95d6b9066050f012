#include "files/sprites.h"

#include <algorithm>
#include <cmath>

#include "files/json.h"
#include "files/palette.h"

namespace artisketch {
namespace {

constexpr int kLargestSheet = 16384;  // pixels, as graphics cards take them

const char* direction_name(int k, int of) {
  constexpr const char* kNames[16] = {
      "front", "front-front-right", "front-right", "right-front-right",
      "right", "right-back-right",  "back-right",  "back-back-right",
      "back",  "back-back-left",    "back-left",   "left-back-left",
      "left",  "left-front-left",   "front-left",  "front-front-left"};
  return kNames[16 / of * k];
}

Pose between(const Clip& clip, double time) {
  const auto after = std::upper_bound(clip.times.begin(), clip.times.end(), time);
  if (after == clip.times.begin()) return clip.poses.front();
  if (after == clip.times.end()) return clip.poses.back();
  const auto b = std::size_t(after - clip.times.begin()), a = b - 1;
  const double t = (time - clip.times[a]) / (clip.times[b] - clip.times[a]);
  Pose pose = clip.poses[a];
  pose.root_position += t * (clip.poses[b].root_position - pose.root_position);
  for (std::size_t j = 0; j < pose.rotations.size(); ++j)
    pose.rotations[j] = pose.rotations[j].slerp(t, clip.poses[b].rotations[j]);
  return pose;
}

// The clip's poses at the sheet's rate.
std::vector<Pose> poses_of(const Clip& clip, double rate) {
  const double length = clip.times.back() - clip.times.front();
  const bool round = clip.poses.size() > 1 && same_pose(clip.poses.front(), clip.poses.back());
  const int steps = std::max(1, int(std::lround(length * rate)));
  std::vector<Pose> poses;
  for (int k = 0; k < (round ? steps : steps + 1); ++k)
    poses.push_back(between(clip, clip.times.front() + length * k / steps));
  return poses;
}

Transform seen_from(double yaw, double pitch) {
  Transform view = Transform::Identity();
  view.rotate(Eigen::AngleAxisd(pitch, Vec3::UnitX()));
  view.rotate(Eigen::AngleAxisd(yaw, Vec3::UnitY()));
  return view;
}

// The texture's colours, and the ink's; a plain model's are shades, and stay so.
std::vector<Rgb> palette_for(const Model& model, const SpriteOptions& options) {
  if (!model.texture) return {};
  std::vector<Rgb> palette = palette_of(*model.texture);
  if (options.ink && !palette.empty()) palette.push_back(kInkColour);
  return palette;
}

// How many times larger what becomes pixel art is drawn.
constexpr int kFine = 3;

// The poses of a clip, and how all of them from every side lie in one sprite.
struct Stage {
  std::vector<Shape> shapes;  // per picture
  std::vector<Transform> views;
  int width = 0, height = 0;  // of a sprite, pixels
  double ground = 0;          // pixels from its top to y = 0
  FrameCamera camera;         // what is drawn at
  double nearest = 0, farthest = 0;
};

Stage stage_of(const Model& model, const Clip& clip, const SpriteOptions& options) {
  Stage stage;
  for (const Pose& pose : poses_of(clip, options.rate))
    stage.shapes.push_back(shape_of(model, &pose, false, options.light == Light::soft));
  for (int d = 0; d < options.directions; ++d)
    stage.views.push_back(seen_from(2 * kPi * d / options.directions, options.pitch));
  Box3 box;
  for (const Shape& shape : stage.shapes)
    for (const Transform& view : stage.views)
      for (Eigen::Index v = 0; v < shape.mesh.V.rows(); ++v)
        box.extend(Vec3(view * Vec3(shape.mesh.V.row(v).transpose())));
  stage.nearest = box.max().z();
  stage.farthest = std::min(box.min().z(), stage.nearest - 1e-9);
  // Pixel art is laid out in its own, larger pixels.
  const int unit = std::max(options.pixels, 1), size = std::max(options.size / unit, 4);
  const int room = options.pixels ? 1 : 2;  // for the ink
  const double scale = (size - 2 * room) / std::max({box.sizes().x(), box.sizes().y(), 1e-9});
  // Alike on both sides of the axis about which it turns.
  const double half = std::max(std::abs(box.min().x()), std::abs(box.max().x()));
  const int width = std::min(2 * int(std::ceil(half * scale)) + 2 * room, 4 * size);
  const int height = int(std::ceil(box.sizes().y() * scale)) + 2 * room;
  const double top = room + box.max().y() * scale;
  stage.width = width * unit;
  stage.height = height * unit;
  stage.ground = top * unit;
  const int fine = options.pixels ? kFine : 1;
  stage.camera.camera.pixels_per_unit = scale * fine;
  stage.camera.principal_point = Vec2(width / 2.0, top) * fine;
  return stage;
}

Pictures drawn(const Stage& stage, const SpriteOptions& options, const Shape& shape,
               const Transform& view, const std::vector<Rgb>& palette) {
  RenderLook look;
  look.light = options.light;
  look.ink = options.ink;
  look.normals = options.normals;
  look.depth = options.depth;
  look.nearest = stage.nearest;
  look.farthest = stage.farthest;
  if (!options.pixels)
    return render_pictures(shape, view, stage.camera, stage.width, stage.height, look);
  look.samples = 1;
  look.line_width = kFine;  // a pixel
  const int unit = options.pixels;
  Pictures out = render_pictures(shape, view, stage.camera, stage.width / unit * kFine,
                                 stage.height / unit * kFine, look);
  out.colours = in_pixels(out.colours, kFine, unit, palette);
  for (Image* map : {&out.normals, &out.depth})
    if (!map->empty()) *map = in_pixels(*map, kFine, unit);
  return out;
}

void lay(const Image& sprite, int x, int y, Image& sheet) {
  if (sprite.empty()) return;
  for (int row = 0; row < sprite.height; ++row)
    std::copy_n(sprite.at(0, row), 4 * sprite.width, sheet.at(x, y + row));
}

// What the sheet's JSON lists.
struct Listing {
  Json frames = Json::array(), tags = Json::array(), animations = Json::object();
};

Json listed(const Stage& stage, const SpriteOptions& options, int x, int y) {
  const int w = stage.width, h = stage.height;
  return {{"frame", {{"x", x}, {"y", y}, {"w", w}, {"h", h}}},
          {"rotated", false},
          {"trimmed", false},
          {"spriteSourceSize", {{"x", 0}, {"y", 0}, {"w", w}, {"h", h}}},
          {"sourceSize", {{"w", w}, {"h", h}}},
          {"duration", int(std::lround(1000 / options.rate))},
          {"pivot", {{"x", 0.5}, {"y", json_number(stage.ground / h)}}}};
}

std::string beside(const std::string& image_name, const char* what) {
  const std::size_t dot = image_name.rfind('.');
  return image_name.substr(0, dot) + what + ".png";
}

std::string json_of(const Listing& list, const SpriteOptions& options, const Image& image,
                    const std::string& image_name) {
  Json json;
  if (options.layout == SheetLayout::array) {
    json["frames"] = list.frames;
  } else {
    for (Json one : list.frames) {
      const std::string name = one["filename"].get<std::string>();
      one.erase("filename");
      json["frames"][name] = one;
    }
    json["animations"] = list.animations;
  }
  json["meta"] = {{"app", "ArtiSketch"},
                  {"version", ARTISKETCH_VERSION},
                  {"image", image_name},
                  {"format", "RGBA8888"},
                  {"size", {{"w", image.width}, {"h", image.height}}},
                  {"scale", "1"},
                  {"frameTags", list.tags}};
  if (options.normals) json["meta"]["normal_map"] = beside(image_name, "_n");
  if (options.depth) json["meta"]["depth_map"] = beside(image_name, "_d");
  return json_text(json);
}

Result<const Clip*> clip_named(const Model& model, const std::string& name) {
  std::string names;
  for (const Clip& one : model.clips) {
    if (one.name == name && !one.poses.empty()) return &one;
    names += (names.empty() ? "" : ", ") + one.name;
  }
  return bad_input("the model has no clip '" + name + "': there are " +
                   (names.empty() ? "none" : names));
}

}  // namespace

Result<SpriteSheet> sprite_sheet(const Model& model, const SpriteOptions& options,
                                 const std::string& image_name, Run* run) {
  const Result<const Clip*> clip = clip_named(model, options.clip);
  if (!clip) return clip.error();
  const Stage stage = stage_of(model, **clip, options);
  const int columns = int(stage.shapes.size()), gap = options.padding;
  const int across = columns * (stage.width + gap) + gap,
            down = options.directions * (stage.height + gap) + gap;
  if (std::max(across, down) > kLargestSheet)
    return bad_input("a sheet of " + std::to_string(across) + " x " + std::to_string(down) +
                     " pixels is larger than 16384: make sprites smaller or fewer");
  SpriteSheet sheet;
  sheet.image = Image(across, down, 0);
  if (options.normals) sheet.normals = sheet.image;
  if (options.depth) sheet.depth = sheet.image;
  const std::vector<Rgb> palette =
      options.pixels ? palette_for(model, options) : std::vector<Rgb>();
  Listing list;
  for (int d = 0; d < options.directions; ++d) {
    const std::string tag = options.clip + " " + direction_name(d, options.directions);
    list.tags.push_back({{"name", tag},
                         {"from", d * columns},
                         {"to", (d + 1) * columns - 1},
                         {"direction", "forward"}});
    for (int k = 0; k < columns; ++k) {
      if (run) {
        if (run->cancelled()) return cancelled();
        run->report(double(d * columns + k) / double(options.directions * columns));
      }
      const int x = gap + k * (stage.width + gap), y = gap + d * (stage.height + gap);
      const Pictures one =
          drawn(stage, options, stage.shapes[std::size_t(k)], stage.views[std::size_t(d)], palette);
      lay(one.colours, x, y, sheet.image);
      lay(one.normals, x, y, sheet.normals);
      lay(one.depth, x, y, sheet.depth);
      const std::string name = tag + " " + std::to_string(k) + ".png";
      Json frame = {{"filename", name}};
      frame.update(listed(stage, options, x, y));
      list.frames.push_back(std::move(frame));
      list.animations[tag].push_back(name);
    }
  }
  sheet.json = json_of(list, options, sheet.image, image_name);
  return sheet;
}

Result<std::vector<FileInside>> sprite_files(const Model& model, const SpriteOptions& options,
                                             const std::string& name, Run* run) {
  const std::string image = name + ".png";
  const Result<SpriteSheet> sheet = sprite_sheet(model, options, image, run);
  if (!sheet) return sheet.error();
  std::vector<FileInside> files{{image, png_bytes(sheet->image)}, {name + ".json", sheet->json}};
  if (options.normals) files.push_back({beside(image, "_n"), png_bytes(sheet->normals)});
  if (options.depth) files.push_back({beside(image, "_d"), png_bytes(sheet->depth)});
  return files;
}

Result<std::string> sprite_zip(const Model& model, const SpriteOptions& options,
                               const std::string& name, Run* run) {
  const Result<std::vector<FileInside>> files = sprite_files(model, options, name, run);
  if (!files) return files.error();
  return zip_bytes(*files);
}

}  // namespace artisketch
