// artisketch_quality: what the pipeline makes of figures whose truth is known, over seeds, numbers
// of drawings, cameras, errors of the poses and wobble of the hand.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>

#include "figures/measure.h"
#include "quality/baselines.h"
#include "quality/by_hand.h"
#include "quality/colours.h"
#include "quality/gallery.h"
#include "quality/inconsistent.h"

using namespace artisketch;
using namespace artisketch::figures;

namespace {

constexpr int kWidth = 512, kHeight = 512;  // pixels
constexpr const char* kUsage =
    "usage: artisketch_quality [--brief] [--figures N] [--frames N] [--error DEGREES]\n"
    "                          [--wobble PIXELS] [--method paper|rays] [--grid N]\n"
    "                          [--poses] [--no-calibrate] [--no-mirror] [--visual-hull]\n"
    "       artisketch_quality --inconsistent [--figures N] [--frames N] [--error DEGREES]\n"
    "                          [--baseline DEGREES] [--poses] [--grid N]\n"
    "       artisketch_quality --by-hand [--figures N] [--frames N] [--grid N]\n"
    "       artisketch_quality --depth [--figures N] [--frames N] [--baseline DEGREES]\n"
    "                          [--wobble PIXELS] [--grid N]\n"
    "       artisketch_quality --colours [--frames N] [--error DEGREES] [--no-calibrate]\n"
    "                          [--grid N]\n"
    "       artisketch_quality --gallery [NAME] [--grid N] [--no-calibrate]\n"
    "Every combination of the settings not named; --brief: one case per figure;\n"
    "--poses: calibration alone; --inconsistent: drawings that disagree as people's do,\n"
    "calibrated, with the poses given, and the first drawing alone; --by-hand: poses as a\n"
    "hand gives them, joints where they are seen and bones turned about themselves by\n"
    "guess; --depth: how deep bodies come out by how far apart the drawings see them;\n"
    "--colours: pixels that are wrongly coloured in poses and from sides that nobody drew;\n"
    "--gallery: the examples as they are given, one or all.\n";

struct Options {
  bool brief = false;
  bool poses = false;
  bool inconsistent = false;
  bool depth = false;
  bool colours = false;
  bool gallery = false;
  bool by_hand = false;
  std::vector<std::string> names;  // of examples; empty: all
  std::vector<double> baselines;   // degrees that the drawings span; empty: several
  int figures = 6;
  std::vector<int> frames = {2, 3, 4};
  std::vector<double> errors = {0, 8, 15};       // degrees
  std::vector<double> wobbles = {0, 0.75, 1.5};  // pixels
  PipelineOptions pipeline;
};

struct Case {
  int seed = 0;
  int frames = 3;
  Camera::Type camera = Camera::Type::orthographic;
  double pose_error = 0;  // degrees
  double wobble = 0;      // pixels
};

struct Row {
  PoseErrors before, after;
  double coverage_before = 1, coverage_after = 1;
  double drawn = 0, novel = 0, volume = 0, seconds = 0;
};

// The cast in turn, each time with another seed.
Figure figure_of(int seed) {
  switch (seed % 4) {
    case 1:
      return quadruped(seed);
    case 3:
      return robot(seed);
    default:
      return human(seed);
  }
}

template <class Get>
double mean(const std::vector<Row>& rows, const Get& get) {
  double sum = 0;
  for (const Row& row : rows) sum += get(row);
  return rows.empty() ? 0 : sum / double(rows.size());
}

// What calibration made of the poses.
void measure_poses(const Figure& figure, const Sketches& sketches, const Document& calibrated,
                   const std::vector<PartCoverage>& coverage, Row& row) {
  const int frames = int(calibrated.frames.size());
  for (int f = 1; f < frames; ++f) {  // the first is given
    const Pose& truth = sketches.truth.frames[f].pose;
    const FrameCamera seen = frame_camera(sketches.truth, f);
    const double share = 1.0 / (frames - 1);
    add(row.before, pose_errors(figure, seen, truth, sketches.given.frames[f].pose), share);
    add(row.after, pose_errors(figure, seen, truth, calibrated.frames[f].pose), share);
  }
  if (coverage.empty()) return;
  row.coverage_before = row.coverage_after = 0;
  for (const PartCoverage& one : coverage) {
    row.coverage_before += one.before / double(coverage.size());
    row.coverage_after += one.after / double(coverage.size());
  }
}

// What the whole made of the shape.
void measure_shape(const Case& c, const Figure& figure, const Sketches& sketches,
                   const Reconstruction& made, Row& row) {
  for (int f = 0; f < c.frames; ++f) {
    const FrameCamera seen = frame_camera(sketches.truth, f);
    row.drawn +=
        intersection_over_union(
            silhouette(figure, sketches.truth.frames[f].pose, seen, kWidth, kHeight),
            silhouette(made.model, made.calibrated.frames[f].pose, seen, kWidth, kHeight)) /
        c.frames;
  }
  const FrameCamera still{sketches.truth.camera, Vec2(kWidth, kHeight) / 2, 1};
  row.novel = unseen_silhouettes(figure, made.model, still, kWidth, kHeight, c.seed);
  row.volume = volume_iou(figure, made.model.mesh);
}

std::optional<Row> measure(const Case& c, const Options& options) {
  const Figure figure = figure_of(c.seed);
  const Camera camera = fitting_camera(figure, c.camera, kWidth, kHeight);
  const Sketches sketches =
      draw(figure, random_views(figure, c.frames, c.seed), camera, kWidth, kHeight,
           {.contour_wobble_px = c.wobble,
            .pose_error_degrees = c.pose_error,
            .root_error = c.pose_error / 400},
           c.seed);
  Run run;
  Row row;
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  if (options.poses) {
    const auto found = calibrate(sketches.given, {options.pipeline.method}, run);
    row.seconds = seconds();
    if (found)
      measure_poses(figure, sketches, with_poses(sketches.given, *found), found->coverage, row);
    if (found) return row;
    std::printf("failed: %s\n", found.error().text().c_str());
    return std::nullopt;
  }
  const Result<Reconstruction> made = reconstruct(sketches.given, options.pipeline, run);
  if (!made) {
    std::printf("failed: %s\n", made.error().text().c_str());
    return std::nullopt;
  }
  row.seconds = seconds();
  measure_poses(figure, sketches, made->calibrated,
                made->calibration ? made->calibration->coverage : std::vector<PartCoverage>{}, row);
  measure_shape(c, figure, sketches, *made, row);
  return row;
}

void print_head() {
  std::printf("%-30s | %11s | %11s | %17s | %13s | %5s %5s %5s | %6s\n", "", "joints, px",
              "rot., deg", "in / out / twist", "coverage", "drawn", "novel", "vol.", "s");
}

void print(const std::string& name, const std::vector<Row>& rows) {
  const auto m = [&](auto get) { return mean(rows, get); };
  std::printf(
      "%-30s | %5.1f %5.1f | %5.1f %5.1f | %5.1f %5.1f %5.1f | %6.3f %6.3f | %.3f %.3f %.3f | "
      "%6.2f\n",
      name.c_str(), m([](const Row& r) { return r.before.joint_px; }),
      m([](const Row& r) { return r.after.joint_px; }),
      m([](const Row& r) { return r.before.angle; }), m([](const Row& r) { return r.after.angle; }),
      m([](const Row& r) { return r.after.in_plane; }),
      m([](const Row& r) { return r.after.out_of_plane; }),
      m([](const Row& r) { return r.after.twist; }),
      m([](const Row& r) { return r.coverage_before; }),
      m([](const Row& r) { return r.coverage_after; }), m([](const Row& r) { return r.drawn; }),
      m([](const Row& r) { return r.novel; }), m([](const Row& r) { return r.volume; }),
      m([](const Row& r) { return r.seconds; }));
  std::fflush(stdout);
}

std::vector<Case> cases(Options options) {
  // In brief each figure gets the middle of every setting, and one camera.
  if (options.brief)
    for (auto* range : {&options.errors, &options.wobbles}) *range = {(*range)[range->size() / 2]};
  if (options.brief) options.frames = {options.frames[options.frames.size() / 2]};
  std::vector<Case> all;
  for (int seed = 0; seed < options.figures; ++seed)
    for (const auto camera : {Camera::Type::orthographic, Camera::Type::perspective}) {
      if (options.brief && (camera == Camera::Type::perspective) != (seed % 4 > 1)) continue;
      for (const int frames : options.frames)
        for (const double error : options.errors)
          for (const double wobble : options.wobbles)
            all.push_back({seed, frames, camera, error, wobble});
    }
  return all;
}

bool read_options(int count, char** words, Options& options) {
  for (int i = 1; i < count; ++i) {
    const std::string word = words[i];
    const auto value = [&]() -> std::string { return i + 1 < count ? words[++i] : ""; };
    if (word == "--brief") {
      options.brief = true;
    } else if (word == "--depth") {
      options.depth = true;
    } else if (word == "--colours") {
      options.colours = true;
    } else if (word == "--poses") {
      options.poses = true;
    } else if (word == "--inconsistent") {
      options.inconsistent = true;
    } else if (word == "--gallery") {
      options.gallery = true;
    } else if (word == "--by-hand") {
      options.by_hand = true;
    } else if (options.gallery && word[0] != '-') {
      options.names.push_back(word);
    } else if (word == "--baseline") {
      options.baselines = {std::atof(value().c_str())};
    } else if (word == "--figures") {
      options.figures = std::atoi(value().c_str());
    } else if (word == "--frames") {
      options.frames = {std::max(1, std::atoi(value().c_str()))};
    } else if (word == "--error") {
      options.errors = {std::atof(value().c_str())};
    } else if (word == "--wobble") {
      options.wobbles = {std::atof(value().c_str())};
    } else if (word == "--grid") {
      options.pipeline.grid = std::atoi(value().c_str());
    } else if (word == "--no-calibrate") {
      options.pipeline.calibrate = false;
    } else if (word == "--no-mirror") {
      options.pipeline.mirror = false;
    } else if (word == "--visual-hull") {
      options.pipeline.visual_hull = true;
    } else if (word == "--method") {
      const std::string method = value();
      options.pipeline.method = method_named(method, kDefaultMethod);
      if (method != kMethodNames[int(options.pipeline.method)]) return false;
    } else {
      return false;
    }
  }
  return options.figures > 0 && options.pipeline.grid > 0;
}

}  // namespace

int main(int count, char** words) {
  Options options;
  options.pipeline.method = Method::rays;
  if (!read_options(count, words, options)) {
    std::fputs(kUsage, stderr);
    return 2;
  }
  if (options.inconsistent) {
    quality::InconsistentOptions table;
    table.figures = options.figures;
    table.poses = options.poses;
    table.pipeline = options.pipeline;
    if (options.frames.size() == 1) table.frames = options.frames;
    if (options.errors.size() == 1) table.errors = options.errors;
    if (!options.baselines.empty()) table.baselines = options.baselines;
    quality::print_inconsistent(table);
    return 0;
  }
  if (options.by_hand) {
    quality::ByHandOptions table;
    table.figures = options.figures;
    table.pipeline = options.pipeline;
    if (options.frames.size() == 1) table.frames = options.frames;
    quality::print_by_hand(table);
    return 0;
  }
  if (options.depth) {
    quality::BaselineOptions table;
    table.figures = options.figures;
    table.pipeline = options.pipeline;
    table.pipeline.calibrate = false;
    if (options.frames.size() == 1) table.frames = options.frames;
    if (options.wobbles.size() == 1) table.wobble = options.wobbles[0];
    if (!options.baselines.empty()) table.baselines = options.baselines;
    quality::print_baselines(table);
    return 0;
  }
  if (options.gallery) {
    quality::print_gallery(options.pipeline, options.names);
    return 0;
  }
  if (options.colours) {
    quality::ColourOptions table;
    table.pipeline = options.pipeline;
    if (options.frames.size() == 1) table.frames = options.frames;
    if (options.errors.size() == 1) table.error = options.errors[0];
    quality::print_colours(table);
    return 0;
  }
  print_head();
  std::map<std::string, std::vector<Row>> groups;  // by one setting, over all others
  std::vector<Row> all;
  for (const Case& c : cases(options)) {
    const std::optional<Row> row = measure(c, options);
    if (!row) continue;
    all.push_back(*row);
    const bool perspective = c.camera == Camera::Type::perspective;
    char name[80], error[40], wobble[40];
    std::snprintf(name, sizeof name, "%-10s %2d %df %s %2gdeg %.2gpx",
                  figure_of(c.seed).name.c_str(), c.seed, c.frames, perspective ? "persp" : "ortho",
                  c.pose_error, c.wobble);
    print(name, {*row});
    std::snprintf(error, sizeof error, "poses %2g deg off", c.pose_error);
    std::snprintf(wobble, sizeof wobble, "wobble %.2f px", c.wobble);
    for (const std::string& group : {std::to_string(c.frames) + " frames",
                                     std::string(perspective ? "perspective" : "orthographic"),
                                     std::string(error), std::string(wobble)})
      groups[group].push_back(*row);
  }
  std::printf("\n");
  print_head();
  for (const auto& group : groups) print(group.first, group.second);
  print("all", all);
  return 0;
}
