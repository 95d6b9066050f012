#include "quality/baselines.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "figures/measure.h"
#include "quality/figure_of.h"

namespace artisketch::quality {
namespace {

using namespace figures;

constexpr int kWidth = 512, kHeight = 512;  // pixels

Sketches drawn(const Figure& figure, int frames, double baseline, const BaselineOptions& options,
               int seed) {
  std::vector<View> views;
  const View bent = random_views(figure, 2, std::uint64_t(seed))[1];
  for (int f = 0; f < frames; ++f) {
    views.push_back(view(figure, "turned", about_y(baseline * f / std::max(frames - 1, 1))));
    for (int j = 1; j < figure.skeleton.size(); ++j)
      views.back().pose.rotations[j] = bent.pose.rotations[j];
  }
  const Camera camera = fitting_camera(figure, Camera::Type::orthographic, kWidth, kHeight);
  return draw(figure, views, camera, kWidth, kHeight, {.contour_wobble_px = options.wobble},
              std::uint64_t(seed));
}

double extent(const Points3& V, const Vec3& direction) {
  const Eigen::VectorXd along = V * direction;
  return along.maxCoeff() - along.minCoeff();
}

// The parts' depths over the truth's, as a pose shows them.
std::vector<double> depths(const Figure& figure, const Pose& first,
                           const std::vector<PartSurface>& parts) {
  std::vector<double> ratios;
  const std::vector<Transform> posed = skinning_transforms(figure.skeleton, first);
  for (const PartSurface& part : parts) {
    const Mesh truth = mesh_of(figure.parts[part.joint], 0.02);
    const Vec3 away = posed[part.joint].linear().transpose() * Vec3::UnitZ();
    ratios.push_back(extent(part.mesh.V, away) / extent(truth.V, away));
  }
  return ratios;
}

}  // namespace

BaselineCell baseline_cell(int frames, double baseline, const BaselineOptions& options) {
  BaselineCell cell;
  Run run;
  for (int seed = 0; seed < options.figures; ++seed) {
    const Figure figure = figure_of(seed);
    const Sketches sketches = drawn(figure, frames, baseline, options, seed);
    const auto made = reconstruct(sketches.given, options.pipeline, run);
    if (!made) continue;  // counts as nothing
    const FrameCamera still{sketches.truth.camera, Vec2(kWidth, kHeight) / 2, 1};
    cell.novel +=
        unseen_silhouettes(figure, made->model, still, kWidth, kHeight, seed) / options.figures;
    cell.volume += volume_iou(figure, made->model.mesh) / options.figures;
    double logs = 0;
    const std::vector<double> ratios = depths(figure, sketches.truth.frames[0].pose, made->parts);
    for (const double ratio : ratios) {
      logs += std::log(ratio) / double(ratios.size());
      cell.deepest = std::max(cell.deepest, ratio);
    }
    cell.depth += std::exp(logs) / options.figures;
  }
  return cell;
}

void print_baselines(const BaselineOptions& options) {
  std::printf("%-16s | %5s %5s | %13s\n", "frames, baseline", "novel", "vol.", "depth, worst");
  BaselineCell sum;
  int cells = 0;
  for (const int frames : options.frames)
    for (const double baseline : options.baselines) {
      if (frames == 1 && baseline != options.baselines[0]) continue;
      const BaselineCell c = baseline_cell(frames, baseline, options);
      std::printf("%df %5g           | %.3f %.3f | %5.2f %6.2f\n", frames, baseline, c.novel,
                  c.volume, c.depth, c.deepest);
      std::fflush(stdout);
      if (frames == 1) continue;
      sum.novel += c.novel;
      sum.volume += c.volume;
      sum.depth += c.depth;
      ++cells;
    }
  if (cells)
    std::printf("mean             | %.3f %.3f | %5.2f\n", sum.novel / cells, sum.volume / cells,
                sum.depth / cells);
}

}  // namespace artisketch::quality
