#include "files/sprites.h"

#include <algorithm>
#include <cmath>

#include "files/json.h"
#include "files/render.h"

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

}  // namespace

Result<SpriteSheet> sprite_sheet(const Model& model, const SpriteOptions& options,
                                 const std::string& image_name) {
  const auto clip = std::find_if(model.clips.begin(), model.clips.end(),
                                 [&](const Clip& one) { return one.name == options.clip; });
  if (clip == model.clips.end() || clip->poses.empty()) {
    std::string names;
    for (const Clip& one : model.clips) names += (names.empty() ? "" : ", ") + one.name;
    return bad_input("the model has no clip '" + options.clip + "': there are " +
                     (names.empty() ? "none" : names));
  }
  std::vector<Shape> shapes;
  for (const Pose& pose : poses_of(*clip, options.rate))
    shapes.push_back(shape_of(model, &pose, false));

  // What the figure takes up over the whole clip, from every side.
  Box2 box;
  for (const Shape& shape : shapes)
    for (int d = 0; d < options.directions; ++d) {
      const Transform view = seen_from(2 * kPi * d / options.directions, options.pitch);
      for (Eigen::Index v = 0; v < shape.mesh.V.rows(); ++v)
        box.extend(Vec3(view * Vec3(shape.mesh.V.row(v).transpose())).head<2>());
    }
  constexpr int kRoom = 2;  // pixels, for the ink
  const double scale = (options.size - 2 * kRoom) / std::max(box.sizes().maxCoeff(), 1e-9);
  // Alike on both sides of the axis about which it turns.
  const double half = std::max(std::abs(box.min().x()), std::abs(box.max().x()));
  const int width = std::min(2 * int(std::ceil(half * scale)) + 2 * kRoom, 4 * options.size);
  const int height = int(std::ceil(box.sizes().y() * scale)) + 2 * kRoom;
  FrameCamera camera;
  camera.camera.pixels_per_unit = scale;
  camera.principal_point = Vec2(width / 2.0, kRoom + box.max().y() * scale);

  const int columns = int(shapes.size()), gap = options.padding;
  SpriteSheet sheet;
  const int across = columns * (width + gap) + gap,
            down = options.directions * (height + gap) + gap;
  if (std::max(across, down) > kLargestSheet)
    return bad_input("a sheet of " + std::to_string(across) + " x " + std::to_string(down) +
                     " pixels is larger than 16384: make sprites smaller or fewer");
  sheet.image = Image(across, down, 0);
  Json frames = Json::array(), tags = Json::array();
  for (int d = 0; d < options.directions; ++d) {
    const Transform view = seen_from(2 * kPi * d / options.directions, options.pitch);
    const std::string side = direction_name(d, options.directions);
    tags.push_back({{"name", clip->name + " " + side},
                    {"from", d * columns},
                    {"to", (d + 1) * columns - 1},
                    {"direction", "forward"}});
    for (int k = 0; k < columns; ++k) {
      const Image one = render_shape(shapes[std::size_t(k)], view, camera, width, height);
      const int x = gap + k * (width + gap), y = gap + d * (height + gap);
      for (int row = 0; row < height; ++row)
        std::copy_n(one.at(0, row), 4 * width, sheet.image.at(x, y + row));
      const Json size = {{"w", width}, {"h", height}};
      frames.push_back(
          {{"filename", clip->name + " " + side + " " + std::to_string(k) + ".png"},
           {"frame", {{"x", x}, {"y", y}, {"w", width}, {"h", height}}},
           {"rotated", false},
           {"trimmed", false},
           {"spriteSourceSize", {{"x", 0}, {"y", 0}, {"w", width}, {"h", height}}},
           {"sourceSize", size},
           {"duration", int(std::lround(1000 / options.rate))},
           {"pivot", {{"x", 0.5}, {"y", json_number((kRoom + box.max().y() * scale) / height)}}}});
    }
  }
  sheet.json = json_text({{"frames", frames},
                          {"meta",
                           {{"app", "ArtiSketch"},
                            {"version", ARTISKETCH_VERSION},
                            {"image", image_name},
                            {"format", "RGBA8888"},
                            {"size", {{"w", across}, {"h", down}}},
                            {"scale", "1"},
                            {"frameTags", tags}}}});
  return sheet;
}

}  // namespace artisketch
