#include "quality/gallery.h"

#include <chrono>
#include <cstdio>

#include "base/face_neighbours.h"
#include "figures/measure.h"
#include "model/consolidate/unfold.h"
#include "quality/colours.h"

namespace artisketch::quality {

using namespace figures;

GalleryCell gallery_cell(const Example& example, const GalleryOptions& options) {
  const Figure& figure = example.figure;
  const Document &given = example.sketches.given, &truth = example.sketches.truth;
  const int frames = int(truth.frames.size());
  Run run;
  const auto start = std::chrono::steady_clock::now();
  const auto made = reconstruct(given, options.pipeline, run);
  GalleryCell cell;
  cell.wrong = 1;
  if (!made || !made->model.texture) return cell;
  cell.wrong = 0;
  cell.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();

  for (int f = 0; f < frames; ++f) {
    const FrameCamera seen = frame_camera(truth, f);
    const Pose& pose = truth.frames[f].pose;
    const int w = truth.frames[f].width, h = truth.frames[f].height;
    if (f > 0) {  // the first is given
      cell.drawn_joint_px +=
          pose_errors(figure, seen, pose, given.frames[f].pose).joint_px / (frames - 1);
      cell.joint_px +=
          pose_errors(figure, seen, pose, made->calibrated.frames[f].pose).joint_px / (frames - 1);
    }
    cell.drawn += intersection_over_union(
                      silhouette(figure, pose, seen, w, h),
                      silhouette(made->model, made->calibrated.frames[f].pose, seen, w, h)) /
                  frames;
  }
  const int size = options.size, poses = options.poses;
  const FrameCamera still{fitting_camera(figure, Camera::Type::orthographic, size, size),
                          Vec2(size, size) / 2, 1};
  for (const View& v : random_views(figure, poses, 5000)) {
    cell.novel += intersection_over_union(silhouette(figure, v.pose, still, size, size),
                                          silhouette(made->model, v.pose, still, size, size)) /
                  poses;
    cell.wrong += wrong_colours(figure, made->model, v.pose, still, size) / poses;
  }
  const Mesh mesh = welded(made->model.mesh);  // the texture's seams
  cell.volume = volume_iou(figure, mesh);
  cell.folds = int(folds(mesh, face_neighbours(mesh.F)).size());
  cell.genus = topology(mesh).genus();
  cell.components = topology(mesh).components;
  return cell;
}

void print_gallery(const PipelineOptions& pipeline, const std::vector<std::string>& names) {
  std::printf("%-12s | %11s | %5s %5s %5s | %7s | %5s %5s %6s | %6s\n", "", "joints, px", "drawn",
              "novel", "vol.", "wrong %", "folds", "genus", "pieces", "s");
  for (const std::string& name : names.empty() ? example_names() : names) {
    const Example made = example(name);
    const Document& truth = made.sketches.truth;
    std::vector<Image> drawings;
    for (int f = 0; f < int(truth.frames.size()); ++f)
      drawings.push_back(ink_drawing(made.figure, truth.frames[f].pose, frame_camera(truth, f),
                                     truth.frames[f].width, truth.frames[f].height, made.ink));
    GalleryOptions options;
    options.pipeline = pipeline;
    options.pipeline.drawings = drawings;
    const GalleryCell c = gallery_cell(made, options);
    std::printf("%-12s | %5.1f %5.1f | %.3f %.3f %.3f | %7.2f | %5d %5d %6d | %6.1f\n",
                name.c_str(), c.drawn_joint_px, c.joint_px, c.drawn, c.novel, c.volume,
                100 * c.wrong, c.folds, c.genus, c.components, c.seconds);
    std::fflush(stdout);
  }
}

}  // namespace artisketch::quality
