#include "quality/by_hand.h"

#include <cstdio>

#include "quality/figure_of.h"

namespace artisketch::quality {

using namespace figures;

namespace {

// Adds a share of how far poses are off, of frames after the first.
void add_errors(const Figure& figure, const Document& truth, const Document& posed, double share,
                PoseErrors& sum) {
  for (std::size_t f = 1; f < truth.frames.size(); ++f)
    add(sum,
        pose_errors(figure, frame_camera(truth, int(f)), truth.frames[f].pose,
                    posed.frames[f].pose),
        share / double(truth.frames.size() - 1));
}

}  // namespace

ByHandCell by_hand_cell(int frames, const Hand& hand, double part_size, int figures,
                        const PipelineOptions& pipeline) {
  constexpr int kSide = 512;  // pixels
  ByHandCell cell;
  Run run;
  for (int seed = 0; seed < figures; ++seed) {
    const Figure figure = figure_of(seed);
    const Camera camera = fitting_camera(figure, Camera::Type::orthographic, kSide, kSide);
    const Sketches sketches = draw(
        figure, random_views(figure, frames, seed), camera, kSide, kSide,
        {.contour_wobble_px = 0.75, .part_size = part_size, .drawing_size = 0.4 * part_size}, seed);
    const Document given = posed_by_hand(sketches.truth, hand, seed);
    add_errors(figure, sketches.truth, given, 1.0 / figures, cell.before);
    const FrameCamera still{camera, Vec2(kSide, kSide) / 2, 1};
    for (int way = 0; way < 2; ++way) {
      PipelineOptions options = pipeline;
      options.calibrate = way == 0;
      const auto made = reconstruct(given, options, run);
      if (!made) continue;  // counts as nothing
      if (way == 0) add_errors(figure, sketches.truth, made->calibrated, 1.0 / figures, cell.after);
      cell.novel[way] +=
          unseen_silhouettes(figure, made->model, still, kSide, kSide, seed) / figures;
      cell.volume[way] += volume_iou(figure, made->model.mesh) / figures;
    }
  }
  return cell;
}

void print_by_hand(const ByHandOptions& options) {
  std::printf("%-20s | %5s %4s %4s %5s    %4s %4s %4s %5s | %-12s | %-12s\n",
              "frames twist bones part", "px", "in", "out", "twist", "px", "in", "out", "twist",
              "novel", "volume");
  const auto print = [](const char* name, const ByHandCell& c, double n) {
    std::printf(
        "%-20s | %5.1f %4.1f %4.1f %5.1f -> %4.1f %4.1f %4.1f %5.1f | %.3f, %.3f | %.3f, %.3f\n",
        name, c.before.joint_px / n, c.before.in_plane / n, c.before.out_of_plane / n,
        c.before.twist / n, c.after.joint_px / n, c.after.in_plane / n, c.after.out_of_plane / n,
        c.after.twist / n, c.novel[0] / n, c.novel[1] / n, c.volume[0] / n, c.volume[1] / n);
    std::fflush(stdout);
  };
  ByHandCell sum;
  int cells = 0;
  for (const double part_size : options.part_sizes)
    for (const auto& [twist, bones] : options.hands)
      for (const int frames : options.frames) {
        const Hand hand{.bone_error = bones, .place_error_px = 5, .twist_degrees = twist};
        const ByHandCell c =
            by_hand_cell(frames, hand, part_size, options.figures, options.pipeline);
        char name[80];
        std::snprintf(name, sizeof name, "%df %5g %6g %5g", frames, twist, bones, part_size);
        print(name, c, 1);
        add(sum.before, c.before, 1);
        add(sum.after, c.after, 1);
        for (int way = 0; way < 2; ++way) {
          sum.novel[way] += c.novel[way];
          sum.volume[way] += c.volume[way];
        }
        ++cells;
      }
  print("mean", sum, cells);
}

}  // namespace artisketch::quality
