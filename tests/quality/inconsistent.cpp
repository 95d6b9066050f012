#include "quality/inconsistent.h"

#include <cstdio>

#include "figures/measure.h"
#include "quality/figure_of.h"

namespace artisketch::quality {
namespace {

using namespace figures;

constexpr int kWidth = 512, kHeight = 512;                           // pixels
constexpr double kPartSize = 0.1, kDrawingSize = 0.04, kWobble = 1;  // shares; pixels

Sketches drawn(const Figure& figure, int frames, double baseline, double error, int seed) {
  const Camera camera = fitting_camera(figure, Camera::Type::orthographic, kWidth, kHeight);
  Sketches sketches =
      draw(figure, spread_views(figure, frames, radians(baseline), seed), camera, kWidth, kHeight,
           {.contour_wobble_px = kWobble,
            .pose_error_degrees = error,
            .root_error = error / 400,
            .part_size = kPartSize,
            .drawing_size = kDrawingSize},
           seed);
  sketches.given.calibration = {};  // nobody tells how far the poses are off
  return sketches;
}

// Means over the frames after the first, whose pose is given.
PoseErrors off(const Figure& figure, const Document& truth, const std::vector<Pose>& poses) {
  PoseErrors mean;
  for (std::size_t f = 1; f < poses.size(); ++f)
    add(mean, pose_errors(figure, frame_camera(truth, int(f)), truth.frames[f].pose, poses[f]),
        1 / double(poses.size() - 1));
  return mean;
}

std::vector<Pose> poses_of(const Document& document) {
  std::vector<Pose> poses;
  for (const Frame& frame : document.frames) poses.push_back(frame.pose);
  return poses;
}

}  // namespace

InconsistentCell inconsistent_cell(int frames, double baseline, double error, int figures,
                                   bool poses, const PipelineOptions& pipeline) {
  InconsistentCell cell;
  Run run;
  for (int seed = 0; seed < figures; ++seed) {
    const Figure figure = figure_of(seed);
    const Sketches sketches = drawn(figure, frames, baseline, error, seed);
    add(cell.before, off(figure, sketches.truth, poses_of(sketches.given)), 1.0 / figures);
    if (poses) {
      const auto found = calibrate(sketches.given, {pipeline.method}, run);
      if (found) add(cell.after, off(figure, sketches.truth, found->poses), 1.0 / figures);
      continue;
    }
    Document one = sketches.given;
    one.frames.resize(1);
    const FrameCamera still{sketches.truth.camera, Vec2(kWidth, kHeight) / 2, 1};
    for (int way = 0; way < 3; ++way) {
      PipelineOptions options = pipeline;
      options.calibrate = way == 0;
      const auto made = reconstruct(way == 2 ? one : sketches.given, options, run);
      if (!made) continue;  // counts as nothing
      if (way == 0)
        add(cell.after, off(figure, sketches.truth, poses_of(made->calibrated)), 1.0 / figures);
      cell.novel[way] +=
          unseen_silhouettes(figure, made->model, still, kWidth, kHeight, seed) / figures;
      cell.volume[way] += volume_iou(figure, made->model.mesh) / figures;
    }
  }
  return cell;
}

void print_inconsistent(const InconsistentOptions& options) {
  std::printf("%-18s | %11s | %11s | %-20s | %-20s\n", "frames base error", "joints, px",
              "rot., deg", "novel: cal user one", "vol.: cal user one");
  InconsistentCell sum;
  int cells = 0;
  const auto print = [](const char* name, const InconsistentCell& c, double n) {
    std::printf("%-18s | %5.2f %5.2f | %5.2f %5.2f | %6.3f %6.3f %6.3f | %6.3f %6.3f %6.3f\n", name,
                c.before.joint_px / n, c.after.joint_px / n, c.before.angle / n, c.after.angle / n,
                c.novel[0] / n, c.novel[1] / n, c.novel[2] / n, c.volume[0] / n, c.volume[1] / n,
                c.volume[2] / n);
    std::fflush(stdout);
  };
  for (const int frames : options.frames)
    for (const double baseline : options.baselines)
      for (const double error : options.errors) {
        const InconsistentCell c = inconsistent_cell(frames, baseline, error, options.figures,
                                                     options.poses, options.pipeline);
        char name[40];
        std::snprintf(name, sizeof name, "%df %5g %5g", frames, baseline, error);
        print(name, c, 1);
        add(sum.before, c.before, 1);
        add(sum.after, c.after, 1);
        for (int k = 0; k < 3; ++k) {
          sum.novel[k] += c.novel[k];
          sum.volume[k] += c.volume[k];
        }
        ++cells;
      }
  print("mean", sum, cells);
}

}  // namespace artisketch::quality
