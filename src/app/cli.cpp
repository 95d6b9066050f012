#include "app/cli.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <optional>

#include <CLI/CLI.hpp>
#include <unistd.h>

#include "app/progress_line.h"
#include "files/bvh_file.h"
#include "files/bytes.h"
#include "files/document_file.h"
#include "files/gltf.h"
#include "files/image_file.h"
#include "files/mesh_file.h"
#include "files/preview.h"
#include "files/report_file.h"
#include "model/calibrate/unseen_sides.h"
#include "model/rig/retarget.h"
#include "model/stages.h"

namespace artisketch {
namespace {

enum Exit { kDone = 0, kBadInput = 1, kBadCommandLine = 2, kNotWritten = 3, kStopped = 130 };

std::atomic<bool> stop_asked = false;
static_assert(std::atomic<bool>::is_always_lock_free, "set by a signal handler");

void ask_to_stop(int) {
  stop_asked = true;
}

struct Arguments {
  std::string in, out, calibrated, report, preview, motion, method, size = "800x800";
  std::optional<int> grid, triangles;
  bool no_calibrate = false, no_texture = false, visual_hull = false, quiet = false,
       progress = false;
  int frame = 0, turntable = 0;
  bool clear = false;
  double yaw = 0, pitch = 0;
};

// What will be written, all of it made before anything is.
struct Output {
  std::string path, bytes;
};

int fail(const Error& error) {
  std::fprintf(stderr, "%s\n", error.text().c_str());
  switch (error.kind) {
    case Error::Kind::cancelled:
      return kStopped;
    case Error::Kind::io:
      return kNotWritten;
    case Error::Kind::bad_input:
    case Error::Kind::out_of_memory:
    case Error::Kind::crashed:
      break;
  }
  return kBadInput;
}

int write_all(const std::vector<Output>& outputs) {
  for (const Output& output : outputs)
    if (const auto written = write_file(output.path, output.bytes); !written)
      return fail(io_error(written.error().text()));
  return kDone;
}

// A result that has nowhere to go is better known before the work than after it.
std::optional<Error> unwritable(const std::vector<std::string>& paths) {
  for (const std::string& path : paths) {
    if (path.empty()) continue;
    std::error_code ignored;
    std::filesystem::path folder = std::filesystem::path(path).parent_path();
    if (folder.empty()) folder = ".";
    if (!std::filesystem::is_directory(folder, ignored))
      return io_error(path + ": the folder '" + folder.string() +
                      "' does not exist; make it, or name another");
    if (std::filesystem::is_directory(path, ignored))
      return io_error(path + ": is a folder; name a file in it");
    if (access(folder.c_str(), W_OK) != 0)
      return io_error(path + ": the folder '" + folder.string() + "' can't be written to");
  }
  return std::nullopt;
}

// Runs with progress on the terminal; Ctrl-C asks it to stop.
class CommandRun {
 public:
  explicit CommandRun(const Arguments& a)
      : line_(!a.quiet && (a.progress || isatty(STDERR_FILENO))) {
    stop_asked = false;
    std::signal(SIGINT, ask_to_stop);
    std::signal(SIGTERM, ask_to_stop);
    run.cancel = &stop_asked;
    run.on_progress = [this](const Progress& progress) { line_.show(progress); };
  }
  ~CommandRun() {
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
  }
  void finish() { line_.wipe(); }
  Run run;

 private:
  ProgressLine line_;
};

Method method_of(const Arguments& a, const Document& document) {
  const std::string name = !a.method.empty() ? a.method : document.settings.method.value_or("");
  return name == "paper" ? Method::paper : name == "rays" ? Method::rays : kDefaultMethod;
}

void print_warnings(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings)
    std::fprintf(stderr, "warning: %s\n", warning.c_str());
}

std::string seconds_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, seconds < 1 ? "%.0f ms" : "%.1f s",
                seconds < 1 ? 1000 * seconds : seconds);
  return text;
}

// Four lines: what was made, how well it fits what was drawn, how well it will hold from other
// sides, how long each stage took.
void print_summary(const std::string& out, std::size_t bytes, const Document& document,
                   const Reconstruction& result) {
  std::printf("%s: %d drawings, %d parts -> %d triangles on %d joints, %.1f MB\n", out.c_str(),
              int(document.frames.size()), int(result.parts.size()),
              int(result.model.mesh.F.rows()), document.skeleton.size(), bytes / 1e6);
  std::printf("fit to the drawings:");
  for (std::size_t f = 0; f < result.fits.size(); ++f)
    std::printf("%s %s %.1f %%", f ? "," : "", document.frames[f].name.c_str(),
                100 * result.fits[f].iou);
  std::printf("\n%s\n", unseen_sides_words(document, unseen_sides(result.calibrated)).c_str());
  std::printf("time:");
  double total = 0;
  for (const StageTime& stage : result.stages) {
    std::printf(" %s %s,", stage.stage.c_str(), seconds_text(stage.seconds).c_str());
    total += stage.seconds;
  }
  std::printf(" total %s\n", seconds_text(total).c_str());
}

// The document's text for a file at `to`: drawings are named relative to the file that names them.
std::string text_beside(Document document, const std::string& from, const std::string& to) {
  namespace fs = std::filesystem;
  for (Frame& frame : document.frames) {
    if (frame.image.empty() || frame.image.rfind("data:", 0) == 0) continue;
    std::error_code failed;
    const fs::path image = fs::absolute(fs::path(from).parent_path() / frame.image, failed);
    const fs::path beside =
        fs::relative(image, fs::absolute(fs::path(to), failed).parent_path(), failed);
    if (!failed && !beside.empty()) frame.image = beside.generic_string();
  }
  return document_text(document);
}

int reconstruct_verb(const Arguments& a) {
  const std::string ending = model_ending(a.out);
  if (ending.empty()) {
    std::fprintf(stderr, "-o %s: wanted a file that ends in .glb, .obj, .stl or .ply\n",
                 a.out.c_str());
    return kBadCommandLine;
  }
  if (const auto error = unwritable({a.out, a.calibrated, a.report, a.preview}))
    return fail(*error);
  const Result<Document> document = read_document(a.in);
  if (!document) return fail(bad_input(document.error().text()));
  std::optional<Clip> clip;
  if (!a.motion.empty()) {
    Result<Motion> motion = read_bvh(a.motion);
    if (!motion) return fail(motion.error());
    Result<Clip> moved = retargeted(*document, *motion);
    if (!moved) return fail(bad_input(a.motion + ": " + moved.error().text()));
    clip = std::move(*moved);
  }
  PipelineOptions options;
  options.method = method_of(a, *document);
  options.grid = a.grid.value_or(document->settings.grid.value_or(options.grid));
  options.triangles =
      a.triangles.value_or(document->settings.triangles.value_or(options.triangles));
  options.mirror = document->settings.mirror.value_or(options.mirror);
  options.calibrate = !a.no_calibrate;
  options.visual_hull = a.visual_hull;
  std::vector<Image> drawings;
  const bool texture = !a.no_texture && document->settings.texture.value_or(true);
  std::vector<std::string> missing;
  if (texture || !a.preview.empty()) drawings = load_drawings(*document, a.in, missing);
  print_warnings(missing);
  if (texture) options.drawings = pictures(drawings);
  CommandRun command(a);
  Result<Reconstruction> result = reconstruct(*document, options, command.run);
  command.finish();
  if (!result) return fail(result.error());
  print_warnings(result->warnings);
  if (clip) result->model.clips.insert(result->model.clips.begin() + 1, std::move(*clip));

  std::vector<Output> outputs;
  Result<std::string> model = model_bytes_for(ending, result->model);
  if (!model) return fail(model.error());
  const std::size_t size = model->size();
  if (!a.calibrated.empty())
    outputs.push_back({a.calibrated, text_beside(result->calibrated, a.in, a.calibrated)});
  if (!a.report.empty()) outputs.push_back({a.report, report_text(*document, *result)});
  if (!a.preview.empty())
    outputs.push_back({a.preview, png_bytes(contact_sheet(*document, drawings, *result))});
  outputs.push_back({a.out, std::move(*model)});
  if (stop_asked) return fail(cancelled());
  if (const int status = write_all(outputs)) return status;
  if (!a.quiet) print_summary(a.out, size, *document, *result);
  return kDone;
}

int calibrate_verb(const Arguments& a) {
  if (const auto error = unwritable({a.out, a.report})) return fail(*error);
  const Result<Document> document = read_document(a.in);
  if (!document) return fail(bad_input(document.error().text()));
  CommandRun command(a);
  command.run.now.stage = "calibrate";
  const auto began = std::chrono::steady_clock::now();
  const Result<Calibration> result = calibrate(*document, {method_of(a, *document)}, command.run);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  command.finish();
  if (!result) return fail(result.error());
  print_warnings(result->warnings);
  std::vector<Output> outputs;
  if (!a.report.empty()) outputs.push_back({a.report, report_text(*document, *result, seconds)});
  outputs.push_back({a.out, text_beside(with_poses(*document, *result), a.in, a.out)});
  if (const int status = write_all(outputs)) return status;
  if (!a.quiet)
    std::printf("%s: energy %.4g -> %.4g px\302\262 in %d iterations, %s\n", a.out.c_str(),
                result->energy_before, result->energy_after, result->iterations,
                seconds_text(seconds).c_str());
  return kDone;
}

int check_verb(const Arguments& a) {
  const Result<Document> document = read_document(a.in);
  if (!document) return fail(bad_input(document.error().text()));
  // The drawings are part of the document: a missing one shows here and not half-way through.
  std::vector<std::string> faults;
  for (const Frame& frame : document->frames)
    if (const Result<Image> image = load_frame_image(frame, a.in); !image)
      faults.push_back(image.error().text());
  if (!faults.empty()) return fail({Error::Kind::bad_input, faults});
  if (!a.quiet)
    std::printf("%s: fine: %d drawings, %d joints, %d parts\n", a.in.c_str(),
                int(document->frames.size()), document->skeleton.size(),
                int(drawn_joints(*document).size()));
  return kDone;
}

int render_verb(const Arguments& a) {
  RenderOptions options;
  char extra = 0;
  if (std::sscanf(a.size.c_str(), "%dx%d%c", &options.width, &options.height, &extra) != 2 ||
      std::min(options.width, options.height) < 16 ||
      std::max(options.width, options.height) > 8192) {
    std::fprintf(stderr,
                 "--size %s: wanted WIDTHxHEIGHT in pixels, 16 to 8192 each, like 800x600\n",
                 a.size.c_str());
    return kBadCommandLine;
  }
  if (const auto error = unwritable({a.out})) return fail(*error);
  const Result<std::string> bytes = read_file(a.in);
  if (!bytes) return fail(bad_input(bytes.error().text()));
  const Result<Model> model = read_glb(*bytes, a.in);
  if (!model) return fail(bad_input(model.error().text()));
  if (a.frame) {
    const int keys = model->clips.empty() ? 0 : int(model->clips[0].poses.size());
    if (a.frame > keys) {
      std::fprintf(stderr, "--frame %d: %s has %d frames; name one from 1 to %d\n", a.frame,
                   a.in.c_str(), keys, keys);
      return kBadCommandLine;
    }
    options.frame = a.frame - 1;
  }
  options.clear = a.clear;
  options.yaw = radians(a.yaw);
  options.pitch = radians(a.pitch);
  const Image image =
      a.turntable ? render_turntable(*model, options, a.turntable) : render_model(*model, options);
  return write_all({{a.out, png_bytes(image)}});
}

void add_run_flags(CLI::App& verb, Arguments& a) {
  verb.add_option("IN", a.in, "the sketch document (.artisketch)")->required();
  verb.add_option("--method", a.method, "paper: every step as published; rays: ours")
      ->check(CLI::IsMember({"paper", "rays"}));
  verb.add_option("--report", a.report, "what was done and how well it fits, as JSON");
  verb.add_flag("--quiet", a.quiet, "print nothing but warnings and errors");
  verb.add_flag("--progress", a.progress, "show progress even where standard error is no terminal");
}

}  // namespace

int run_cli(const std::vector<std::string>& arguments) {
  Arguments a;
  CLI::App app{"ArtiSketch: from a few drawings of a character to a 3D model that moves.",
               "artisketch"};
  app.set_version_flag("--version", "ArtiSketch " ARTISKETCH_VERSION);
  app.require_subcommand(1);
  CLI::App& make = *app.add_subcommand("reconstruct", "Make a rigged model from a sketch document");
  add_run_flags(make, a);
  make.add_option("-o,--output", a.out,
                  "the model to write (.glb, or its surface alone: .obj, .stl, .ply)")
      ->required();
  make.add_option("--grid", a.grid, "cells along a part's longest side (default 100)")
      ->check(CLI::Range(16, 400));
  make.add_option("--triangles", a.triangles,
                  "of the model (default 15000), or auto: as few as half a pixel allows")
      ->transform(CLI::Validator(
          [](std::string& text) {
            if (text == "auto") return text = "0", std::string();
            return CLI::Range(100, 10000000)(text);
          },
          "auto or INT in [100 - 10000000]", "triangles"));
  make.add_flag("--no-calibrate", a.no_calibrate, "trust the document's poses");
  make.add_option("--motion", a.motion, "a recorded motion to add as a clip (.bvh)");
  make.add_flag("--no-texture", a.no_texture, "leave the model plain");
  make.add_option("--calibrated", a.calibrated, "the document at the calibrated poses");
  make.add_option("--preview", a.preview,
                  "a contact sheet: drawings, result over them, four sides (.png)");
  make.add_flag("--visual-hull", a.visual_hull, "stop after carving: the plain hull of each part");
  CLI::App& pose = *app.add_subcommand("calibrate", "Refine a document's poses and write it again");
  add_run_flags(pose, a);
  pose.add_option("-o,--output", a.out, "the calibrated document (.artisketch)")->required();
  CLI::App& check = *app.add_subcommand("check", "Check a document and name its faults");
  check.add_option("IN", a.in, "the sketch document (.artisketch)")->required();
  check.add_flag("--quiet", a.quiet, "print nothing but errors");
  CLI::App& draw = *app.add_subcommand("render", "Draw a model to a picture");
  draw.add_option("IN", a.in, "the model (.glb)")->required();
  draw.add_option("-o,--output", a.out, "the picture (.png)")->required();
  draw.add_option("--frame", a.frame, "the pose of drawing N (default: the rest pose)")
      ->check(CLI::Range(1, 100000));
  draw.add_option("--yaw", a.yaw, "degrees about the vertical");
  draw.add_option("--pitch", a.pitch, "degrees about the horizontal");
  draw.add_option("--size", a.size, "WIDTHxHEIGHT in pixels (default 800x800)");
  draw.add_flag("--clear", a.clear, "nothing behind the model: a picture with transparency");
  draw.add_option("--turntable", a.turntable, "N pictures round the model, side by side")
      ->check(CLI::Range(1, 64));
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ParseError& error) {
    return app.exit(error) ? kBadCommandLine : kDone;
  }
  if (make.parsed()) return reconstruct_verb(a);
  if (pose.parsed()) return calibrate_verb(a);
  if (check.parsed()) return check_verb(a);
  return render_verb(a);
}

}  // namespace artisketch
