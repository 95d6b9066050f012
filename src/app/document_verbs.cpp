// What is done with a document alone: calibrate, check, and begin one with a skeleton.
#include <cstdio>
#include <filesystem>

#include <unistd.h>

#include "app/command_run.h"
#include "app/outputs.h"
#include "app/verbs.h"
#include "base/at_once.h"
#include "files/bytes.h"
#include "files/document_check.h"
#include "files/document_file.h"
#include "files/image_file.h"
#include "files/inside_images.h"
#include "files/motion_file.h"
#include "files/report_file.h"
#include "model/rig/own_skeleton.h"
#include "model/stage_clock.h"

namespace artisketch {

std::vector<std::string> files_of(const Document& document, const std::string& path) {
  std::vector<std::string> files{path};
  for (const Frame& frame : document.frames)
    if (!frame.image.empty() && !frame.image.starts_with("data:"))
      files.push_back((std::filesystem::path(path).parent_path() / frame.image).string());
  return files;
}

Result<Document> sound_document(const std::string& path) {
  Result<Document> document = read_document(path);
  if (!document) return bad_input(document.error().text());
  if (const Result<Done> sound = check_document(*document, path); !sound) return sound.error();
  return document;
}

PipelineOptions options_of(const Arguments& a, const Document& document) {
  PipelineOptions options = with_settings({}, document.settings);
  options.method = method_named(a.method, options.method);
  options.grid = a.grid.value_or(options.grid);
  options.triangles = a.triangles.value_or(options.triangles);
  options.texture = options.texture && !a.no_texture;
  options.calibrate = !a.no_calibrate;
  options.visual_hull = a.visual_hull;
  return options;
}

bool shows_progress(const Arguments& a) {
  return !a.quiet && (a.progress || isatty(STDERR_FILENO));
}

std::string text_beside(Document document, const std::string& from, const std::string& to) {
  namespace fs = std::filesystem;
  for (Frame& frame : document.frames) {
    if (frame.image.empty() || frame.image.rfind("data:", 0) == 0) continue;
    std::error_code failed;
    const fs::path image = fs::absolute(fs::path(from).parent_path() / frame.image, failed);
    const fs::path beside =
        fs::relative(image, fs::absolute(fs::path(to), failed).parent_path(), failed);
    if (failed || beside.empty()) continue;
    const bool moves_in = leaves_folder(beside.generic_string()) && !leaves_folder(frame.image);
    const Result<std::string> bytes = moves_in ? read_file(image.string()) : io_error("");
    if (bytes && decode_image(*bytes, ""))
      frame.image = data_uri(*bytes);
    else
      frame.image = beside.generic_string();
  }
  return document_text(document);
}

Error said_of(const std::string& file, Error error) {
  if (error.kind == Error::Kind::bad_input)
    for (std::string& fault : error.faults) fault = file + ": " + fault;
  return error;
}

std::string seconds_text(double seconds) {
  char text[32];
  std::snprintf(text, sizeof text, seconds < 1 ? "%.0f ms" : "%.1f s",
                seconds < 1 ? 1000 * seconds : seconds);
  return text;
}

int calibrate_verb(const Arguments& a) {
  const std::vector<Target> targets{{"-o", a.out, Kind::document},
                                    {"--report", a.report, Kind::report}};
  if (const int status = judge_endings(targets)) return status;
  if (const int status = judge_places(targets)) return status;
  const Result<Document> document = sound_document(a.in);
  if (!document) return fail(document.error());
  if (const int status = judge_overwriting(targets, files_of(*document, a.in))) return status;
  CommandRun command(shows_progress(a));
  command.run.threads = a.threads.value_or(threads_here());
  std::vector<StageTime> stages;
  StageClock clock(command.run, stages);
  clock.start("calibrate", 0, 1);
  const Result<Calibration> result =
      calibrate(*document, {options_of(a, *document).method}, command.run);
  clock.finish({});
  command.finish();
  if (!result) return fail(said_of(a.in, result.error()));
  print_warnings(result->warnings);
  std::vector<Output> outputs;
  if (!a.report.empty()) outputs.push_back({a.report, report_text(*document, *result, stages[0])});
  outputs.push_back({a.out, text_beside(with_poses(*document, *result), a.in, a.out)});
  if (const int status = write_all(outputs)) return status;
  if (!a.quiet)
    std::printf("%s: energy %.4g -> %.4g px\302\262 in %d iterations, %s\n", a.out.c_str(),
                result->energy_before, result->energy_after, result->iterations,
                seconds_text(stages[0].seconds).c_str());
  return kDone;
}

int check_verb(const Arguments& a) {
  const Result<Document> document = read_document(a.in);
  if (!document) return fail(bad_input(document.error().text()));
  std::vector<std::string> faults;
  if (const Result<Done> sound = check_document(*document, a.in); !sound)
    faults = sound.error().faults;
  // The drawings are part of the document: a missing one shows here and not half-way through.
  for (const Frame& frame : document->frames)
    if (const Result<Image> image = load_frame_image(frame, a.in); !image)
      faults.push_back(image.error().text());
  if (!faults.empty()) return fail({Error::Kind::bad_input, faults});
  print_warnings(drawing_words(*document, a.in));
  print_warnings(open_contour_words(*document));
  if (!a.quiet)
    std::printf("%s: fine: %d drawings, %d joints, %d parts\n", a.in.c_str(),
                int(document->frames.size()), document->skeleton.size(),
                int(drawn_joints(*document).size()));
  return kDone;
}

int skeleton_verb(const Arguments& a) {
  const std::vector<Target> targets{{"-o", a.out, Kind::document}};
  if (const int status = judge_endings(targets)) return status;
  if (const int status = judge_places(targets)) return status;
  if (const int status = judge_overwriting(targets, {a.in})) return status;
  const Result<Motion> motion = read_skeleton(a.in);
  if (!motion) return fail(motion.error());
  const Document document = document_with_skeleton(*motion);
  if (const int status = write_all({{a.out, document_text(document)}})) return status;
  if (!a.quiet)
    std::printf("%s: %d joints; add drawings in the editor\n", a.out.c_str(),
                document.skeleton.size());
  return kDone;
}

}  // namespace artisketch
