// From a document to a model in a file, with all that goes beside it.
#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/command_run.h"
#include "app/many_documents.h"
#include "app/outputs.h"
#include "app/verbs.h"
#include "base/at_once.h"
#include "files/bytes.h"
#include "files/document_file.h"
#include "files/gltf.h"
#include "files/gltf_compress.h"
#include "files/image_file.h"
#include "files/mesh_file.h"
#include "files/motion_file.h"
#include "files/preview.h"
#include "files/report_file.h"
#include "files/trace_file.h"
#include "files/vrm.h"
#include "model/calibrate/unseen_sides.h"
#include "model/rig/library.h"
#include "model/rig/rig_profile.h"
#include "model/rig/t_pose.h"

namespace artisketch {
namespace {

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

// All that the work needs, found sound before it begins.
struct Order {
  std::string ending;  // of the model's file
  Document document;
  std::optional<VrmMeta> about;  // of an avatar
  std::vector<MovedBy> moved;    // clips from recorded motions
  std::vector<Clip> library;
};

std::vector<Target> targets_of(const Arguments& a) {
  return {{"-o", a.out, Kind::model},
          {"--calibrated", a.calibrated, Kind::document},
          {"--report", a.report, Kind::report},
          {"--preview", a.preview, Kind::picture}};
}

int judge_paths(const Arguments& a) {
  if (model_ending(a.out).empty())
    return bad_command_line("-o " + a.out + ": wanted a file that ends in " + model_endings());
  if (const int status = judge_endings(targets_of(a))) return status;
  if (const int status = judge_places(targets_of(a))) return status;
  // The trace's folder is made at the end, where it isn't there yet.
  std::error_code ignored;
  const bool folder_is_there = std::filesystem::is_directory(a.trace, ignored);
  const std::string in_trace = folder_is_there ? a.trace + "/001" : a.trace;
  return judge_places({{"--trace", in_trace, Kind::model}});
}

// What its ending and its engine ask of a model.
int judge_wishes(const Arguments& a, Order& order) {
  const bool avatar = order.ending == ".vrm";
  if (a.compress && order.ending != ".glb" && !avatar)
    return bad_command_line("--compress: there is nothing to pack in a " + order.ending +
                            "; name a .glb or .vrm");
  if (avatar && !a.rig.empty())
    return bad_command_line("--rig " + a.rig +
                            ": a .vrm names joints in its own way; leave --rig out");
  if (avatar) {
    Result<VrmMeta> meta = vrm_meta(order.document, a.in);
    if (!meta) return fail(meta.error());
    order.about = std::move(*meta);
  }
  if (const auto fault = unfit(order.document, avatar ? "unity" : a.rig))
    return fail(bad_input((avatar ? "-o " + a.out : "--rig " + a.rig) + ": " + *fault));
  return kDone;
}

int take_clips(const Arguments& a, Order& order) {
  if (!a.motion.empty() && order.ending != ".glb" && order.ending != ".vrm") {
    print_warnings({"--motion " + a.motion + ": is left out, since " + order.ending +
                    " holds the surface alone; name a .glb to have it"});
  } else if (!a.motion.empty()) {
    Result<std::vector<MovedBy>> moved = moved_by(a.motion, order.document, a.retarget);
    if (!moved) return fail(moved.error());
    order.moved = std::move(*moved);
  }
  Result<std::vector<Clip>> library = clips_wanted(a.clips, order.document.skeleton);
  if (!library) return bad_command_line(library.error().text());
  order.library = std::move(*library);
  return kDone;
}

int take_order(const Arguments& a, Order& order) {
  if (const int status = judge_paths(a)) return status;
  Result<Document> document = sound_document(a.in);
  if (!document) return fail(document.error());
  order.document = std::move(*document);
  std::vector<std::string> inputs = files_of(order.document, a.in);
  inputs.push_back(a.motion);
  if (const int status = judge_overwriting(targets_of(a), inputs)) return status;
  order.ending = model_ending(a.out);
  if (const int status = judge_wishes(a, order)) return status;
  return take_clips(a, order);
}

// The model's clips: the drawings' poses, then recorded motions, then the library's.
void add_clips(const Order& order, std::vector<Clip>& clips) {
  std::vector<Clip> more;
  for (const MovedBy& one : order.moved) more.push_back(one.result.clip);
  more.insert(more.end(), order.library.begin(), order.library.end());
  clips.insert(clips.begin() + 1, more.begin(), more.end());
}

Result<std::string> bytes_of(const Arguments& a, const Order& order, const Model& model) {
  std::optional<Model> rigged;
  if (!a.rig.empty()) {
    Result<Model> made = for_engine(model, a.rig);
    if (!made) return bad_input("--rig " + a.rig + ": " + made.error().text());
    rigged = std::move(*made);
  }
  Result<std::string> bytes = order.about ? vrm_bytes(model, *order.about)
                                          : model_bytes_for(order.ending, rigged ? *rigged : model);
  if (!bytes) return bad_input(a.out + ": " + bytes.error().text());
  return a.compress ? compressed_glb(*bytes) : bytes;
}

}  // namespace

int reconstruct_verb(Arguments& a) {
  if (names_folder(a)) return reconstruct_many(a);
  a.in = a.documents.front();
  std::error_code ignored;
  if (!a.skip_existing || !std::filesystem::exists(a.out, ignored)) return reconstruct_one(a);
  if (!a.quiet) std::printf("%s: is there already\n", a.out.c_str());
  return kDone;
}

int reconstruct_one(Arguments& a, std::string* report) {
  Order order;
  if (const int status = take_order(a, order)) return status;
  const Document& document = order.document;
  PipelineOptions options = options_of(a, document);
  a.grid = options.grid;
  std::vector<Image> drawings;
  std::vector<std::string> missing;
  if (options.texture || !a.preview.empty()) drawings = load_drawings(document, a.in, missing);
  print_warnings(missing);
  print_warnings(drawing_words(document, a.in));
  options.drawings = drawings;
  CommandRun command(shows_progress(a));
  Trace trace;
  if (!a.trace.empty()) command.run.trace = &trace;
  command.run.threads = a.threads.value_or(std::max(1, threads_here() / a.jobs));
  Result<Reconstruction> result = reconstruct(document, options, command.run);
  command.finish();
  // What a failed run found before it failed is wanted most of all.
  if (const int status = write_trace(a.trace, trace)) return status;
  if (!result) return fail(said_of(a.in, result.error()));
  print_warnings(result->warnings);
  add_clips(order, result->model.clips);

  Result<std::string> model = bytes_of(a, order, result->model);
  if (!model) return fail(model.error());
  const std::size_t size = model->size();
  std::vector<Output> outputs;
  if (!a.calibrated.empty())
    outputs.push_back({a.calibrated, text_beside(result->calibrated, a.in, a.calibrated)});
  if (report) *report = report_text(document, *result, order.moved);
  if (!a.report.empty()) outputs.push_back({a.report, report_text(document, *result, order.moved)});
  if (!a.preview.empty())
    outputs.push_back({a.preview, png_bytes(contact_sheet(document, drawings, *result))});
  outputs.push_back({a.out, std::move(*model)});
  if (CommandRun::asked_to_stop()) return fail(cancelled());
  if (const int status = write_all(outputs)) return status;
  if (a.quiet) return kDone;
  print_summary(a.out, size, document, *result);
  for (const MovedBy& one : order.moved)
    std::printf("%s\n", mapping_words(document, one.motion, one.result).c_str());
  return kDone;
}

}  // namespace artisketch
