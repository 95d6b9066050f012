#include "quality/colours.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/raster.h"
#include "figures/ink.h"

namespace artisketch::quality {
namespace {

using namespace figures;

// The figure's own colours: no ink, no shade, no wobble of the hand.
Image true_colours(const Figure& figure, const Pose& pose, const FrameCamera& camera, int size) {
  InkStyle flat;
  flat.line = flat.detail = flat.wobble = 0;
  flat.shadow = 0xffffff;
  return ink_drawing(figure, pose, camera, size, size, flat);
}

// The model's, unlit: the texel under each pixel's middle.
Image model_colours(const Model& model, const Pose& pose, const FrameCamera& camera, int size) {
  const Points3 posed = posed_vertices(model.mesh.V, model.weights, model.skeleton, pose);
  std::vector<Vec2> pixels(posed.rows());
  std::vector<double> depth(posed.rows());
  for (int v = 0; v < posed.rows(); ++v) {
    pixels[v] = camera.project(posed.row(v).transpose());
    depth[v] = -posed(v, 2);
  }
  const Visible seen = raster_triangles(pixels, depth, {}, model.mesh.F, size, size);
  Image image(size, size, 0);
  const Image& texture = *model.texture;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const int f = seen.face[std::size_t(y) * size + x];
      if (f < 0) continue;
      const auto corner = model.mesh.F.row(f);
      const Vec3 w = corner_weights(Vec2(x + 0.5, y + 0.5), pixels[corner[0]], pixels[corner[1]],
                                    pixels[corner[2]], Vec3::Ones());
      Vec2 at = Vec2::Zero();
      for (int k = 0; k < 3; ++k) at += w[k] * model.texcoords[corner[k]];
      const std::uint8_t* texel =
          texture.at(std::clamp(int(at.x() * texture.width), 0, texture.width - 1),
                     std::clamp(int(at.y() * texture.height), 0, texture.height - 1));
      std::copy_n(texel, 3, image.at(x, y));
      image.at(x, y)[3] = 255;
    }
  return image;
}

double wrong_share(const Image& truth, const Image& model, unsigned shadow) {
  int wrong = 0, both = 0;
  for (int y = 0; y < truth.height; ++y)
    for (int x = 0; x < truth.width; ++x) {
      const std::uint8_t *t = truth.at(x, y), *m = model.at(x, y);
      if (t[3] < 255 || m[3] < 255) continue;
      ++both;
      double lit = 0, shaded = 0;
      for (int k = 0; k < 3; ++k) {
        const double shade = double(shadow >> (16 - 8 * k) & 255) / 255;
        lit = std::max(lit, std::abs(t[k] - double(m[k])) / 255);
        shaded = std::max(shaded, std::abs(shade * t[k] - m[k]) / 255);
      }
      wrong += std::min(lit, shaded) > kWrongColour;
    }
  return both ? double(wrong) / both : 1;
}

}  // namespace

double wrong_colours(const Figure& figure, const Model& model, const Pose& pose,
                     const FrameCamera& camera, int size) {
  return wrong_share(true_colours(figure, pose, camera, size),
                     model_colours(model, pose, camera, size), InkStyle().shadow);
}

ColourCell colour_cell(const Figure& figure, int frames, std::uint64_t seed,
                       const ColourOptions& options) {
  const int size = options.size;
  const Camera camera = fitting_camera(figure, Camera::Type::orthographic, size, size);
  const Sketches sketches = draw(figure, random_views(figure, frames, seed), camera, size, size,
                                 {.pose_error_degrees = options.error}, seed);
  std::vector<Image> drawings;
  InkStyle style;
  for (int f = 0; f < frames; ++f) {
    style.seed = seed + std::uint64_t(f);
    drawings.push_back(ink_drawing(figure, sketches.truth.frames[f].pose,
                                   frame_camera(sketches.truth, f), size, size, style));
  }
  PipelineOptions pipeline = options.pipeline;
  pipeline.drawings = drawings;
  Run run;
  const auto made = reconstruct(sketches.given, pipeline, run);
  ColourCell cell{1, 1};
  if (!made || !made->model.texture) return cell;
  cell = {};
  const auto add = [&](const Pose& pose, const FrameCamera& seen) {
    return wrong_colours(figure, made->model, pose, seen, size);
  };
  for (int f = 0; f < frames; ++f)
    cell.drawn_wrong +=
        add(sketches.truth.frames[f].pose, frame_camera(sketches.truth, f)) / frames;
  const FrameCamera still{sketches.truth.camera, Vec2(size, size) / 2, 1};
  for (const View& v : random_views(figure, options.poses, seed + 5000))
    cell.wrong += add(v.pose, still) / options.poses;
  return cell;
}

void print_colours(const ColourOptions& options) {
  std::printf("%-12s %7s %8s %8s\n", "", "frames", "wrong %", "drawn %");
  double sum = 0, worst = 0;
  int count = 0;
  for (const Figure& figure : {hero(), fox(), robot(3), human(1), human(2), quadruped(1)})
    for (const int frames : options.frames) {
      const ColourCell cell = colour_cell(figure, frames, 1, options);
      std::printf("%-12s %7d %8.2f %8.2f\n", figure.name.c_str(), frames, 100 * cell.wrong,
                  100 * cell.drawn_wrong);
      std::fflush(stdout);
      sum += cell.wrong;
      worst = std::max(worst, cell.wrong);
      ++count;
    }
  std::printf("mean %.2f %%, worst %.2f %%\n", 100 * sum / std::max(count, 1), 100 * worst);
}

}  // namespace artisketch::quality
