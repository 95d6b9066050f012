#include "files/preview.h"

#include <algorithm>
#include <cmath>

#include "files/canvas.h"
#include "files/marks.h"
#include "files/occlusion.h"
#include "files/render.h"

namespace artisketch {
namespace {

constexpr unsigned kBackgroundTop = 0xF8F9FB, kBackgroundBottom = 0xE6E9ED, kShadow = 0x2C3038;
constexpr double kFilled = 0.86;  // of the picture's width and height at most

// A model on its ground, ready to be drawn from any side.
struct Figure {
  Shape shape;
  GroundShadow shadow;
  Pose pose;
  Vec3 centre = Vec3::Zero();
  double radius = 0, height = 0;  // of the upright cylinder round it
};

const Clip* frames_clip(const Model& model) {
  for (const Clip& clip : model.clips)
    if (clip.name == "frames") return &clip;
  return nullptr;
}

Figure figure_of(const Model& model, const RenderOptions& options) {
  Figure figure;
  const Clip* clip = frames_clip(model);
  const bool framed =
      options.frame && clip && *options.frame >= 0 && *options.frame < int(clip->poses.size());
  figure.pose = options.pose ? *options.pose
                : framed     ? clip->poses[*options.frame]
                             : rest_pose(model.skeleton);
  figure.shape = shape_of(model, options.pose || framed ? &figure.pose : nullptr, options.by_joint);
  figure.shadow = ground_shadow(figure.shape.mesh);
  const Points3& V = figure.shape.mesh.V;
  const Box3 box = bounds(V);
  if (box.isEmpty()) return figure;
  figure.centre = box.center();
  figure.height = box.sizes().y();
  for (int v = 0; v < V.rows(); ++v)
    figure.radius = std::max(figure.radius,
                             std::hypot(V(v, 0) - figure.centre.x(), V(v, 2) - figure.centre.z()));
  return figure;
}

Image background(int width, int height) {
  Image image(width, height);
  const Colour top = colour(kBackgroundTop), bottom = colour(kBackgroundBottom);
  for (int y = 0; y < height; ++y) {
    const float t = (y + 0.5f) / float(height);
    const Colour c{top.r + t * (bottom.r - top.r), top.g + t * (bottom.g - top.g),
                   top.b + t * (bottom.b - top.b)};
    for (int x = 0; x < width; ++x) blend(image, x, y, c, 1);
  }
  return image;
}

FrameCamera fitting_camera(const Figure& figure, double pitch, int width, int height) {
  const double across = 2 * figure.radius;
  const double up = figure.height * std::abs(std::cos(pitch)) + across * std::abs(std::sin(pitch));
  FrameCamera camera;
  camera.camera.pixels_per_unit =
      kFilled * std::min(width / std::max(across, 1e-9), height / std::max(up, 1e-9));
  camera.principal_point = Vec2(width, height) / 2;
  return camera;
}

void draw_ground_shadow(Image& image, const Figure& figure, double yaw, double pitch,
                        const FrameCamera& camera) {
  // Seen level, the ground is a line: show it as from a little above, as illustrators do.
  constexpr double kLeastPitch = 0.16;
  constexpr double kDarkest = 0.6;
  if (pitch < 0) return;
  const double scale = camera.pixels_per_unit(0), slant = std::sin(std::max(pitch, kLeastPitch));
  const double ground = (figure.shadow.height - figure.centre.y()) * std::cos(pitch);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const double right = (x + 0.5 - camera.principal_point.x()) / scale;
      const double toward = (ground + (y + 0.5 - camera.principal_point.y()) / scale) / slant;
      const double dark =
          figure.shadow.at(figure.centre.x() + right * std::cos(yaw) - toward * std::sin(yaw),
                           figure.centre.z() + right * std::sin(yaw) + toward * std::cos(yaw));
      blend(image, x, y, colour(kShadow), kDarkest * dark);
    }
}

Image picture(const Model& model, const Figure& figure, const RenderOptions& options, double yaw) {
  Image image = options.clear ? Image(options.width, options.height, 0)
                              : background(options.width, options.height);
  if (figure.shape.mesh.F.rows() == 0) return image;
  const FrameCamera camera = fitting_camera(figure, options.pitch, options.width, options.height);
  Transform view = Transform::Identity();
  view.rotate(Eigen::AngleAxisd(options.pitch, Vec3::UnitX()));
  view.rotate(Eigen::AngleAxisd(yaw, Vec3::UnitY()));
  view.translate(-figure.centre);
  Image shape = render_shape(figure.shape, view, camera, options.width, options.height);
  if (options.clear) {
    image = std::move(shape);
  } else {
    draw_ground_shadow(image, figure, yaw, options.pitch, camera);
    draw_image(image, shape, 0, 0);
  }
  if (options.skeleton)
    draw_skeleton(image, model.skeleton, joint_pixels(model.skeleton, figure.pose, view, camera));
  return image;
}

}  // namespace

Image render_model(const Model& model, const RenderOptions& options) {
  return render_turntable(model, options, 1);
}

Image render_turntable(const Model& model, const RenderOptions& options, int count) {
  Image strip(options.width * count, options.height);
  const Figure figure = figure_of(model, options);
  for (int i = 0; i < count; ++i) {
    const Image one = picture(model, figure, options, options.yaw + 2 * kPi * i / count);
    for (int y = 0; y < one.height; ++y)
      std::copy_n(one.at(0, y), 4 * one.width, strip.at(i * options.width, y));
  }
  return strip;
}

}  // namespace artisketch
