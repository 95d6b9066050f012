#include "app/cli.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <map>
#include <new>
#include <optional>

#include <CLI/CLI.hpp>
#include <unistd.h>

#include "app/command_words.h"
#include "app/job.h"
#include "app/progress_line.h"
#include "files/bytes.h"
#include "files/document_check.h"
#include "files/document_file.h"
#include "files/gltf.h"
#include "files/gltf_compress.h"
#include "files/image_file.h"
#include "files/inside_images.h"
#include "files/mesh_file.h"
#include "files/motion_file.h"
#include "files/preview.h"
#include "files/report_file.h"
#include "files/sprites.h"
#include "files/trace_file.h"
#include "files/vrm.h"
#include "model/calibrate/unseen_sides.h"
#include "model/rig/library.h"
#include "model/rig/own_skeleton.h"
#include "model/rig/retarget.h"
#include "model/rig/rig_profile.h"
#include "model/rig/t_pose.h"
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
  std::string in, out, calibrated, report, preview, trace, motion, method, size = "800x800";
  std::optional<int> grid, triangles;
  bool no_calibrate = false, no_texture = false, visual_hull = false, quiet = false,
       progress = false, compress = false;
  int frame = 0, turntable = 0;
  bool clear = false;
  double yaw = 0, pitch = 0;
  RetargetOptions retarget;
  std::vector<std::string> clips;
  SpriteOptions sprites;
  std::string json, rig;
};

// What will be written, all of it made before anything is.
struct Output {
  std::string path, bytes;
};

enum class Kind { model, document, picture, report, archive };

// A path to write to, and what it will hold.
struct Target {
  const char* option;
  std::string path;
  Kind kind;
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
  std::vector<NewFile> files;
  for (const Output& output : outputs) files.push_back({output.path, output.bytes});
  const Result<Done> written = write_files(files);
  return written ? kDone : fail(io_error(written.error().text()));
}

std::string lower_case(std::string words) {
  for (char& c : words) c = c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
  return words;
}

// The ending of an output says what will be in it: another kind's would lie.
std::optional<std::string> wrong_ending(const std::vector<Target>& targets) {
  constexpr struct {
    std::string_view ending;
    std::optional<Kind> kind;  // none: nothing that is written here
  } kEndings[] = {{".glb", Kind::model},
                  {".vrm", Kind::model},
                  {".obj", Kind::model},
                  {".stl", Kind::model},
                  {".ply", Kind::model},
                  {".png", Kind::picture},
                  {".json", Kind::report},
                  {".artisketch", Kind::document},
                  {".jpg", {}},
                  {".jpeg", {}},
                  {".gif", {}},
                  {".webp", {}},
                  {".bmp", {}},
                  {".tif", {}},
                  {".tiff", {}},
                  {".svg", {}},
                  {".pdf", {}},
                  {".gltf", {}},
                  {".fbx", {}},
                  {".bvh", {}},
                  {".zip", Kind::archive}};
  constexpr const char* kRight[] = {".glb, .vrm, .obj, .stl or .ply", ".artisketch", ".png",
                                    ".json", ".zip"};
  for (const Target& target : targets) {
    const std::string ending = lower_case(std::filesystem::path(target.path).extension().string());
    for (const auto& known : kEndings)
      if (ending == known.ending && known.kind != target.kind)
        return std::string(target.option) + " " + target.path + ": wanted a file that ends in " +
               kRight[int(target.kind)];
  }
  return std::nullopt;
}

// What a run reads stays as it is, and two of its results don't go to one place.
std::optional<std::string> overwritten(const std::vector<Target>& targets,
                                       const std::vector<std::string>& inputs) {
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (targets[i].path.empty()) continue;
    for (const std::string& input : inputs)
      if (!input.empty() && same_file(targets[i].path, input))
        return std::string(targets[i].option) + " " + targets[i].path +
               ": would replace what is read from " + input + "; name another file";
    for (std::size_t j = 0; j < i; ++j)
      if (!targets[j].path.empty() && same_file(targets[i].path, targets[j].path))
        return std::string(targets[i].option) + " " + targets[i].path + ": is the file of " +
               targets[j].option + ", too; name another";
  }
  return std::nullopt;
}

int bad_command_line(const std::string& words) {
  std::fprintf(stderr, "%s\n", words.c_str());
  return kBadCommandLine;
}

// A document and the files of its drawings.
std::vector<std::string> files_of(const Document& document, const std::string& path) {
  std::vector<std::string> files{path};
  for (const Frame& frame : document.frames)
    if (!frame.image.empty() && !frame.image.starts_with("data:"))
      files.push_back((std::filesystem::path(path).parent_path() / frame.image).string());
  return files;
}

// A document that can be worked on.
Result<Document> sound_document(const std::string& path) {
  Result<Document> document = read_document(path);
  if (!document) return bad_input(document.error().text());
  if (const Result<Done> sound = check_document(*document, path); !sound) return sound.error();
  return document;
}

// A result that has nowhere to go is better known before the work than after it.
std::optional<Error> unwritable(const std::vector<Target>& targets) {
  for (const Target& target : targets) {
    const std::string& path = target.path;
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

// The document's settings, and the flags over them.
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
  for (std::size_t f = 0; f < result.fits.size(); ++f) {
    std::printf("%s %s ", f ? "," : "", document.frames[f].name.c_str());
    if (is_posed(document, int(f)))
      std::printf("%.1f %%", 100 * result.fits[f].iou);
    else
      std::printf("not posed yet");
  }
  std::printf("\n%s\n", unseen_sides_words(document, unseen_sides(result.calibrated)).c_str());
  std::printf("time:");
  double total = 0;
  for (const StageTime& stage : result.stages) {
    std::printf(" %s %s,", stage.stage.c_str(), seconds_text(stage.seconds).c_str());
    total += stage.seconds;
  }
  std::printf(" total %s\n", seconds_text(total).c_str());
}

// The document's text for a file at `to`: drawings are named relative to the file that names them,
// or go into it where that would lead out of its folder.
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

// What a stage finds wrong says of which file: it knows none.
Error said_of(const std::string& file, Error error) {
  if (error.kind == Error::Kind::bad_input)
    for (std::string& fault : error.faults) fault = file + ": " + fault;
  return error;
}

int write_trace(const std::string& folder, const Trace& trace) {
  if (folder.empty()) return kDone;
  std::error_code failed;
  std::filesystem::create_directory(folder, failed);
  for (const NamedFile& file : trace_files(trace))
    if (const auto written = write_file(folder + "/" + file.name, file.bytes); !written)
      return fail(io_error(written.error().text()));
  return kDone;
}

// The library's clips as the command line names them: "walk", "walk:stride=1.2".
Result<std::vector<Clip>> clips_wanted(const std::vector<std::string>& words,
                                       const Skeleton& skeleton) {
  std::vector<Clip> clips;
  for (const std::string& one : words) {
    const Result<ClipWish> wish = clip_wish(one);
    if (!wish) return bad_input("--clip " + one + ": " + wish.error().text());
    Result<Clip> clip = library_clip(skeleton, wish->name, wish->style);
    if (!clip) return bad_input("--clip " + one + ": " + clip.error().text());
    clips.push_back(std::move(*clip));
  }
  return clips;
}

// Every motion in a file as a clip for the document; what is odd about them is said, once.
Result<std::vector<MovedBy>> moved_by(const std::string& file, const Document& document,
                                      const RetargetOptions& options) {
  Result<std::vector<Motion>> motions = read_motions(file);
  if (!motions) return motions.error();
  std::vector<MovedBy> all;
  std::vector<std::string> warnings;
  for (Motion& motion : *motions) {
    Result<Retargeted> made = retargeted(document, motion, options);
    if (!made) return bad_input(file + ": " + made.error().text());
    for (const std::string& warning : made->warnings)
      if (const std::string words = file + ": " + warning;
          std::find(warnings.begin(), warnings.end(), words) == warnings.end())
        warnings.push_back(words);
    all.push_back({std::move(motion), std::move(*made)});
  }
  print_warnings(warnings);
  return all;
}

// Why an engine's rig doesn't fit the document's skeleton, before anything is made.
std::optional<std::string> unfit(const Document& document, const std::string& rig) {
  if (rig.empty()) return std::nullopt;
  Model bare;
  bare.skeleton = document.skeleton;
  const Result<Model> rigged = with_rig(bare, rig);
  if (rigged) return std::nullopt;
  return rigged.error().text();
}

int reconstruct_verb(Arguments& a) {
  const std::string ending = model_ending(a.out);
  if (ending.empty())
    return bad_command_line("-o " + a.out +
                            ": wanted a file that ends in .glb, .vrm, .obj, .stl or .ply");
  const std::vector<Target> targets{{"-o", a.out, Kind::model},
                                    {"--calibrated", a.calibrated, Kind::document},
                                    {"--report", a.report, Kind::report},
                                    {"--preview", a.preview, Kind::picture}};
  if (const auto words = wrong_ending(targets)) return bad_command_line(*words);
  if (const auto error = unwritable(targets)) return fail(*error);
  // The trace's folder is made at the end, where it isn't there yet.
  std::error_code ignored;
  const bool folder_is_there = std::filesystem::is_directory(a.trace, ignored);
  const std::string in_trace = folder_is_there ? a.trace + "/001" : a.trace;
  if (const auto error = unwritable({{"--trace", in_trace, Kind::model}})) return fail(*error);
  const Result<Document> document = sound_document(a.in);
  if (!document) return fail(document.error());
  std::vector<std::string> inputs = files_of(*document, a.in);
  inputs.push_back(a.motion);
  if (const auto words = overwritten(targets, inputs)) return bad_command_line(*words);
  if (a.compress && ending != ".glb" && ending != ".vrm")
    return bad_command_line("--compress: there is nothing to pack in a " + ending +
                            "; name a .glb or .vrm");
  std::optional<VrmMeta> about;
  if (ending == ".vrm") {
    if (!a.rig.empty())
      return bad_command_line("--rig " + a.rig +
                              ": a .vrm names joints in its own way; leave --rig out");
    Result<VrmMeta> meta = vrm_meta(*document, a.in);
    if (!meta) return fail(meta.error());
    about = std::move(*meta);
  }
  if (const auto fault = unfit(*document, about ? "unity" : a.rig))
    return fail(bad_input((about ? "-o " + a.out : "--rig " + a.rig) + ": " + *fault));
  Result<std::vector<MovedBy>> moved = std::vector<MovedBy>();
  if (!a.motion.empty() && ending != ".glb" && ending != ".vrm")
    print_warnings({"--motion " + a.motion + ": is left out, since " + ending +
                    " holds the surface alone; name a .glb to have it"});
  else if (!a.motion.empty())
    moved = moved_by(a.motion, *document, a.retarget);
  if (!moved) return fail(moved.error());
  Result<std::vector<Clip>> library = clips_wanted(a.clips, document->skeleton);
  if (!library) return bad_command_line(library.error().text());
  PipelineOptions options = options_of(a, *document);
  a.grid = options.grid;
  std::vector<Image> drawings;
  std::vector<std::string> missing;
  if (options.texture || !a.preview.empty()) drawings = load_drawings(*document, a.in, missing);
  print_warnings(missing);
  print_warnings(drawing_words(*document, a.in));
  options.drawings = drawings;
  CommandRun command(a);
  Trace trace;
  if (!a.trace.empty()) command.run.trace = &trace;
  Result<Reconstruction> result = reconstruct(*document, options, command.run);
  command.finish();
  // What a failed run found before it failed is wanted most of all.
  if (const int status = write_trace(a.trace, trace)) return status;
  if (!result) return fail(said_of(a.in, result.error()));
  print_warnings(result->warnings);
  std::vector<Clip>& clips = result->model.clips;
  clips.insert(clips.begin() + 1, library->begin(), library->end());
  for (std::size_t i = 0; i < moved->size(); ++i)
    clips.insert(clips.begin() + 1 + std::ptrdiff_t(i), (*moved)[i].result.clip);

  std::optional<Model> rigged;
  if (!a.rig.empty()) {
    Result<Model> made = for_engine(result->model, a.rig);
    if (!made) return fail(bad_input("--rig " + a.rig + ": " + made.error().text()));
    rigged = std::move(*made);
  }
  std::vector<Output> outputs;
  Result<std::string> model = about ? vrm_bytes(result->model, *about)
                                    : model_bytes_for(ending, rigged ? *rigged : result->model);
  if (!model) return fail(bad_input(a.out + ": " + model.error().text()));
  if (a.compress) model = compressed_glb(*model);
  const std::size_t size = model->size();
  if (!a.calibrated.empty())
    outputs.push_back({a.calibrated, text_beside(result->calibrated, a.in, a.calibrated)});
  if (!a.report.empty()) outputs.push_back({a.report, report_text(*document, *result, *moved)});
  if (!a.preview.empty())
    outputs.push_back({a.preview, png_bytes(contact_sheet(*document, drawings, *result))});
  outputs.push_back({a.out, std::move(*model)});
  if (stop_asked) return fail(cancelled());
  if (const int status = write_all(outputs)) return status;
  if (!a.quiet) print_summary(a.out, size, *document, *result);
  if (!a.quiet)
    for (const MovedBy& one : *moved)
      std::printf("%s\n", mapping_words(*document, one.motion, one.result).c_str());
  return kDone;
}

int calibrate_verb(const Arguments& a) {
  const std::vector<Target> targets{{"-o", a.out, Kind::document},
                                    {"--report", a.report, Kind::report}};
  if (const auto words = wrong_ending(targets)) return bad_command_line(*words);
  if (const auto error = unwritable(targets)) return fail(*error);
  const Result<Document> document = sound_document(a.in);
  if (!document) return fail(document.error());
  if (const auto words = overwritten(targets, files_of(*document, a.in)))
    return bad_command_line(*words);
  CommandRun command(a);
  command.run.now.stage = "calibrate";
  const auto began = std::chrono::steady_clock::now();
  const Result<Calibration> result =
      calibrate(*document, {options_of(a, *document).method}, command.run);
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  command.finish();
  if (!result) return fail(said_of(a.in, result.error()));
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
  std::vector<std::string> faults;
  if (const Result<Done> sound = check_document(*document, a.in); !sound)
    faults = sound.error().faults;
  // The drawings are part of the document: a missing one shows here and not half-way through.
  for (const Frame& frame : document->frames)
    if (const Result<Image> image = load_frame_image(frame, a.in); !image)
      faults.push_back(image.error().text());
  if (!faults.empty()) return fail({Error::Kind::bad_input, faults});
  print_warnings(drawing_words(*document, a.in));
  if (!a.quiet)
    std::printf("%s: fine: %d drawings, %d joints, %d parts\n", a.in.c_str(),
                int(document->frames.size()), document->skeleton.size(),
                int(drawn_joints(*document).size()));
  return kDone;
}

// The model that a picture is drawn of, once it is sure where that can go; else the exit status.
std::optional<Model> model_to_draw(const Arguments& a, const std::vector<Target>& targets,
                                   int& status) {
  if (const auto words = wrong_ending(targets))
    return status = bad_command_line(*words), std::nullopt;
  if (const auto error = unwritable(targets)) return status = fail(*error), std::nullopt;
  if (const auto words = overwritten(targets, {a.in}))
    return status = bad_command_line(*words), std::nullopt;
  const Result<std::string> bytes = read_file(a.in);
  if (!bytes) return status = fail(bad_input(bytes.error().text())), std::nullopt;
  Result<Model> model = read_glb(*bytes, a.in);
  if (!model) return status = fail(bad_input(model.error().text())), std::nullopt;
  return std::move(*model);
}

int render_verb(const Arguments& a) {
  RenderOptions options;
  char extra = 0;
  if (std::sscanf(a.size.c_str(), "%dx%d%c", &options.width, &options.height, &extra) != 2 ||
      std::min(options.width, options.height) < 16 ||
      std::max(options.width, options.height) > 8192)
    return bad_command_line("--size " + a.size +
                            ": wanted WIDTHxHEIGHT in pixels, 16 to 8192 each, like 800x600");
  int status = kDone;
  const std::optional<Model> model = model_to_draw(a, {{"-o", a.out, Kind::picture}}, status);
  if (!model) return status;
  if (a.frame) {
    const int keys = model->clips.empty() ? 0 : int(model->clips[0].poses.size());
    if (a.frame > keys)
      return bad_command_line("--frame " + std::to_string(a.frame) + ": " + a.in + " has " +
                              std::to_string(keys) + " frames; name one from 1 to " +
                              std::to_string(keys));
    options.frame = a.frame - 1;
  }
  options.clear = a.clear;
  options.yaw = radians(a.yaw);
  options.pitch = radians(a.pitch);
  const Image image =
      a.turntable ? render_turntable(*model, options, a.turntable) : render_model(*model, options);
  return write_all({{a.out, png_bytes(image)}});
}

// The sheet's files go beside each other, or into one archive.
int sprites_verb(Arguments& a) {
  namespace fs = std::filesystem;
  const fs::path out(a.out);
  const std::string folder = out.parent_path().empty() ? "" : out.parent_path().string() + "/",
                    name = out.stem().string();
  const bool archive = lower_case(out.extension().string()) == ".zip";
  if (archive && !a.json.empty())
    return bad_command_line("--json " + a.json + ": goes into the archive; leave it out");
  std::vector<Target> targets{{"-o", a.out, archive ? Kind::archive : Kind::picture}};
  if (!archive) {
    if (a.json.empty()) a.json = folder + name + ".json";
    targets.push_back({"--json", a.json, Kind::report});
    if (a.sprites.normals)
      targets.push_back({"--normals", folder + name + "_n.png", Kind::picture});
    if (a.sprites.depth) targets.push_back({"--depth", folder + name + "_d.png", Kind::picture});
  }
  int status = kDone;
  const std::optional<Model> model = model_to_draw(a, targets, status);
  if (!model) return status;
  a.sprites.pitch = radians(a.pitch);
  if (archive) {
    const Result<std::string> bytes = sprite_zip(*model, a.sprites, name);
    if (!bytes) return fail(bad_input(a.in + ": " + bytes.error().text()));
    return write_all({{a.out, *bytes}});
  }
  const Result<std::vector<FileInside>> files = sprite_files(*model, a.sprites, name);
  if (!files) return fail(bad_input(a.in + ": " + files.error().text()));
  std::vector<Output> outputs;
  for (std::size_t i = 0; i < files->size(); ++i)
    outputs.push_back({targets[i].path, (*files)[i].bytes});
  return write_all(outputs);
}

int skeleton_verb(const Arguments& a) {
  const std::vector<Target> targets{{"-o", a.out, Kind::document}};
  if (const auto words = wrong_ending(targets)) return bad_command_line(*words);
  if (const auto error = unwritable(targets)) return fail(*error);
  if (const auto words = overwritten(targets, {a.in})) return bad_command_line(*words);
  const Result<Motion> motion = read_skeleton(a.in);
  if (!motion) return fail(motion.error());
  const Document document = document_with_skeleton(*motion);
  if (const int status = write_all({{a.out, document_text(document)}})) return status;
  if (!a.quiet)
    std::printf("%s: %d joints; add drawings in the editor\n", a.out.c_str(),
                document.skeleton.size());
  return kDone;
}

void add_run_flags(CLI::App& verb, Arguments& a) {
  verb.add_option("IN", a.in, "the sketch document (.artisketch)")->required();
  verb.add_option("--method", a.method, "paper: every step as published; rays: ours")
      ->check(CLI::IsMember(
          std::vector<std::string>(std::begin(kMethodNames), std::end(kMethodNames))));
  verb.add_option("--report", a.report, "what was done and how well it fits, as JSON");
  verb.add_flag("--quiet", a.quiet, "print nothing but warnings and errors");
  verb.add_flag("--progress", a.progress, "show progress even where standard error is no terminal");
}

// What a verb doesn't know, with what it may have been meant to be.
int unknown_words(const CLI::App& app) {
  const CLI::App* verb = app.get_subcommands().empty() ? &app : app.get_subcommands()[0];
  std::vector<std::string> options;
  for (const CLI::Option* option : verb->get_options())
    for (const std::string& name : option->get_lnames()) options.push_back("--" + name);
  std::string words;
  bool after_option = false;  // what follows one is its value
  for (const std::string& word : app.remaining(true)) {
    if (!word.starts_with("-") && after_option) continue;
    after_option = word.starts_with("-");
    const std::string near =
        word.starts_with("--") ? meant(word.substr(0, word.find('=')), options) : std::string();
    words += (words.empty() ? "" : "\n") + ("artisketch " + verb->get_name()) + ": " +
             (word.starts_with("-") ? "there is no option " : "what is to be done with ") + word +
             (word.starts_with("-") ? "" : "?") +
             (near.empty() ? "" : "; did you mean " + near + "?");
  }
  return bad_command_line(words + "\nartisketch " + verb->get_name() +
                          " --help lists what it takes");
}

CLI::App& add_reconstruct(CLI::App& app, Arguments& a) {
  CLI::App& make = *app.add_subcommand("reconstruct", "Make a rigged model from a sketch document");
  add_run_flags(make, a);
  make.add_option("-o,--output", a.out,
                  "the model to write (.glb; .vrm, an avatar; its surface alone: .obj, .stl, .ply)")
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
  make.add_option("--motion", a.motion,
                  "recorded motions to add as clips (.bvh; .glb, .vrm: its animations)");
  make.add_option("--clip", a.clips,
                  "a clip of the library, like walk or walk:stride=1.2,bounce=0.5; again for more");
  std::vector<std::string> rigs;
  for (const RigProfile& profile : rig_profiles()) rigs.push_back(profile.name);
  make.add_option("--rig", a.rig, "name and complete a person's joints as an engine has them")
      ->check(CLI::IsMember(rigs));
  make.add_flag("--in-place", a.retarget.in_place, "leave out the motion's way over the ground");
  make.add_flag("--raw-feet{false}", a.retarget.plant_feet,
                "feet as the motion has them: they may slide and float");
  make.add_flag("--compress", a.compress,
                "a smaller .glb or .vrm, for three.js and its like: Godot refuses it");
  make.add_flag("--no-texture", a.no_texture, "leave the model plain");
  make.add_option("--calibrated", a.calibrated, "the document at the calibrated poses");
  make.add_option("--preview", a.preview,
                  "a contact sheet: drawings, result over them, four sides (.png)");
  make.add_option("--trace", a.trace,
                  "a folder for what is found on the way: meshes (.ply), curves (.obj), "
                  "fields (.nrrd)");
  make.add_flag("--visual-hull", a.visual_hull, "stop after carving: the plain hull of each part");
  return make;
}

// Not CLI::Range, which lets nan through: no comparison with it holds.
CLI::Validator degrees_of_an_angle() {
  return CLI::Validator(
      [](const std::string& text) {
        double degrees = 0;
        const bool number = CLI::detail::lexical_cast(text, degrees);
        return number && std::abs(degrees) <= 1e6 ? "" : text + ": wanted a number of degrees";
      },
      "DEGREES");
}

CLI::App& add_render(CLI::App& app, Arguments& a) {
  CLI::App& draw = *app.add_subcommand("render", "Draw a model to a picture");
  draw.add_option("IN", a.in, "the model (.glb)")->required();
  draw.add_option("-o,--output", a.out, "the picture (.png)")->required();
  draw.add_option("--frame", a.frame, "the pose of drawing N (default: the rest pose)")
      ->check(CLI::Range(1, 100000));
  draw.add_option("--yaw", a.yaw, "degrees about the vertical")->check(degrees_of_an_angle());
  draw.add_option("--pitch", a.pitch, "degrees about the horizontal")->check(degrees_of_an_angle());
  draw.add_option("--size", a.size, "WIDTHxHEIGHT in pixels (default 800x800)");
  draw.add_flag("--clear", a.clear, "nothing behind the model: a picture with transparency");
  draw.add_option("--turntable", a.turntable, "N pictures round the model, side by side")
      ->check(CLI::Range(1, 64));
  return draw;
}

CLI::App& add_sprites(CLI::App& app, Arguments& a) {
  CLI::App& cut = *app.add_subcommand("sprites", "Draw a clip of a model as a sheet of sprites");
  cut.add_option("IN", a.in, "the model (.glb)")->required();
  cut.add_option("-o,--output", a.out, "the sheet (.png), or all its files in one (.zip)")
      ->required();
  cut.add_option("--json", a.json,
                 "where each sprite is, as Aseprite and TexturePacker say it "
                 "(default: beside the sheet)");
  cut.add_option("--clip", a.sprites.clip, "the clip, by its name in the model")->required();
  cut.add_option("--directions", a.sprites.directions, "sides it is seen from (default 8)")
      ->check(CLI::IsMember({1, 4, 8, 16}));
  cut.add_option("--size", a.sprites.size, "of a sprite's longer side in pixels (default 128)")
      ->check(CLI::Range(8, 1024));
  cut.add_option("--rate", a.sprites.rate, "pictures a second (default 12)")
      ->check(CLI::Range(1, 60));
  cut.add_option("--padding", a.sprites.padding, "pixels between sprites (default 0)")
      ->check(CLI::Range(0, 64));
  cut.add_option("--pitch", a.pitch, "degrees that it is seen from above")
      ->check(degrees_of_an_angle());
  cut.add_option("--light", a.sprites.light, "soft (default), toon: two tones, or plain: none")
      ->transform(CLI::CheckedTransformer(std::map<std::string, Light>{
          {"soft", Light::soft}, {"plain", Light::plain}, {"toon", Light::toon}}));
  cut.add_flag("--no-ink{false}", a.sprites.ink, "no outline");
  cut.add_option("--pixels", a.sprites.pixels,
                 "pixel art in the drawings' colours: each pixel N by N, hard edges")
      ->check(CLI::Range(1, 16));
  cut.add_flag("--normals", a.sprites.normals, "a sheet of normals too (NAME_n.png)");
  cut.add_flag("--depth", a.sprites.depth, "a sheet of depths too (NAME_d.png)");
  cut.add_option("--layout", a.sprites.layout, "of the JSON: array (default), or hash, by name")
      ->transform(CLI::CheckedTransformer(std::map<std::string, SheetLayout>{
          {"array", SheetLayout::array}, {"hash", SheetLayout::hash}}));
  return cut;
}

int run_verbs(const std::vector<std::string>& arguments, Arguments& a) {
  if (const std::string fault = verb_fault(arguments); !fault.empty())
    return bad_command_line(fault);
  CLI::App app{"ArtiSketch: from a few drawings of a character to a 3D model that moves.",
               "artisketch"};
  app.set_version_flag("--version", "ArtiSketch " ARTISKETCH_VERSION);
  app.require_subcommand(1);
  const CLI::App& make = add_reconstruct(app, a);
  CLI::App& pose = *app.add_subcommand("calibrate", "Refine a document's poses and write it again");
  add_run_flags(pose, a);
  pose.add_option("-o,--output", a.out, "the calibrated document (.artisketch)")->required();
  CLI::App& check = *app.add_subcommand("check", "Check a document and name its faults");
  check.add_option("IN", a.in, "the sketch document (.artisketch)")->required();
  check.add_flag("--quiet", a.quiet, "print nothing but errors");
  CLI::App& own = *app.add_subcommand("skeleton", "Begin a document with a skeleton of one's own");
  own.add_option("IN", a.in, "a rig or a motion (.glb, .vrm, .bvh)")->required();
  own.add_option("-o,--output", a.out, "the document (.artisketch)")->required();
  own.add_flag("--quiet", a.quiet, "print nothing but errors");
  add_render(app, a);
  const CLI::App& cut = add_sprites(app, a);
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ExtrasError&) {
    return unknown_words(app);
  } catch (const CLI::RequiredError& error) {
    // What is missing may be there, mistyped.
    return app.remaining(true).empty() ? (app.exit(error), kBadCommandLine) : unknown_words(app);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) ? kBadCommandLine : kDone;
  }
  if (make.parsed()) return reconstruct_verb(a);
  if (pose.parsed()) return calibrate_verb(a);
  if (check.parsed()) return check_verb(a);
  if (own.parsed()) return skeleton_verb(a);
  if (cut.parsed()) return sprites_verb(a);
  return render_verb(a);
}

}  // namespace

int run_cli(const std::vector<std::string>& arguments) {
  // A file that may not grow further is an error of writing, not the end of the program.
  std::signal(SIGXFSZ, SIG_IGN);
  Arguments a;
  try {
    return run_verbs(arguments, a);
  } catch (const std::bad_alloc&) {
    return fail(out_of_memory(a.grid));
  } catch (const std::exception& thrown) {
    return fail(broke_off(thrown.what()));
  }
}

}  // namespace artisketch
