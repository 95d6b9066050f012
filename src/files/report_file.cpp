#include "files/report_file.h"

#include <cmath>

#include "files/json.h"
#include "model/calibrate/unseen_sides.h"

namespace artisketch {
namespace {

Json number(double value) {
  return std::isfinite(value) ? json_number(value) : Json(nullptr);
}

Json joint_name(const Document& document, int joint) {
  return joint < 0 ? Json(nullptr) : Json(document.skeleton.joints[joint].name);
}

Json frame_name(const Document& document, std::size_t frame) {
  const std::string& name = document.frames[frame].name;
  return name.empty() ? Json(frame + 1) : Json(name);
}

Json words(const std::vector<std::string>& lines) {
  Json all = Json::array();
  for (const std::string& line : lines) all.push_back(line);
  return all;
}

Json stages_json(const std::vector<StageTime>& stages) {
  Json all = Json::array();
  for (const StageTime& stage : stages) {
    Json one = {{"stage", stage.stage}, {"seconds", number(stage.seconds)}};
    one["cpu_seconds"] = number(stage.cpu_seconds);
    if (stage.peak_bytes > 0) one["peak_bytes"] = number(stage.peak_bytes);
    for (const auto& [name, size] : stage.sizes) one["sizes"][name] = number(size);
    all.push_back(std::move(one));
  }
  return all;
}

Json frames_json(const Document& document, const Reconstruction& result) {
  const std::vector<FrameFit>& fits = result.fits;
  Json all = Json::array();
  for (std::size_t f = 0; f < fits.size(); ++f) {
    Json one = {{"frame", frame_name(document, f)}, {"iou", number(fits[f].iou)}};
    if (f < result.coloured.size()) one["coloured"] = number(result.coloured[f]);
    Json& parts = one["parts"] = Json::array();
    for (const FrameFit::PartFit& part : fits[f].parts)
      parts.push_back({{"joint", joint_name(document, part.joint)},
                       {"contour_distance", number(part.distance)}});
    all.push_back(std::move(one));
  }
  return all;
}

Json unseen_sides_json(const Document& document, const Document& calibrated) {
  const UnseenSides sides = unseen_sides(calibrated);
  Json out = {{"hold", trust_word(sides.whole)}};
  Json& parts = out["parts"] = Json::array();
  for (const PartTrust& part : sides.parts)
    parts.push_back({{"joint", joint_name(document, part.joint)},
                     {"hold", trust_word(part.trust)},
                     {"spread", number(degrees(part.spread))},
                     {"disagreement", number(part.disagreement)}});
  return out;
}

Json calibration_json(const Document& document, const Calibration& result) {
  Json out = Json::object();
  out["energy_before"] = number(result.energy_before);
  out["energy_after"] = number(result.energy_after);
  out["iterations"] = result.iterations;
  out["largest_rotation"] = {{"joint", joint_name(document, result.largest_rotation_joint)},
                             {"degrees", number(degrees(result.largest_rotation))}};
  out["largest_translation"] = number(result.largest_translation);
  if (document.camera.type == Camera::Type::orthographic) {
    Json& scales = out["scales"] = Json::array();
    for (const double scale : result.scales) scales.push_back(number(scale));
  }
  Json& coverage = out["coverage"] = Json::array();
  for (const PartCoverage& part : result.coverage)
    coverage.push_back({{"joint", joint_name(document, part.joint)},
                        {"frame", frame_name(document, std::size_t(part.frame))},
                        {"before", number(part.before)},
                        {"after", number(part.after)}});
  out["undetermined"] = words(result.undetermined);
  out["warnings"] = words(result.warnings);
  return out;
}

// The motions of a file share their joints: what moves what is the same for all.
Json motion_json(const Document& document, std::span<const MovedBy> all) {
  if (all.empty()) return nullptr;
  const Motion& motion = all[0].motion;
  const Retargeted& moved = all[0].result;
  const auto theirs = [&](int joint) { return Json(motion.skeleton.joints[joint].name); };
  Json out = {{"up", moved.z_up ? "z" : "y"}, {"scale", number(moved.scale)}};
  Json& clips = out["clips"] = Json::array();
  for (const MovedBy& one : all)
    clips.push_back({{"name", one.motion.name}, {"loops", one.result.loops}});
  Json& joints = out["joints"] = Json::array();
  for (const JointMatch& match : moved.map.matches)
    joints.push_back({{"joint", joint_name(document, match.joint)},
                      {"by", theirs(match.mover)},
                      {"how", match_word(match.how)}});
  Json &still = out["still"] = Json::array(), &unused = out["unused"] = Json::array();
  for (const int joint : moved.map.still) still.push_back(joint_name(document, joint));
  for (const int joint : moved.map.unused) unused.push_back(theirs(joint));
  out["warnings"] = words(moved.warnings);
  return out;
}

Json head(const Document& document) {
  return {{"document", document.name}, {"generator", "ArtiSketch " ARTISKETCH_VERSION}};
}

}  // namespace

std::string report_text(const Document& document, const Reconstruction& result,
                        std::span<const MovedBy> moved) {
  Json report = head(document);
  report["stages"] = stages_json(result.stages);
  report["frames"] = frames_json(document, result);
  report["unseen_sides"] = unseen_sides_json(document, result.calibrated);
  report["calibration"] =
      result.calibration ? calibration_json(document, *result.calibration) : Json(nullptr);
  report["motion"] = motion_json(document, moved);
  report["model"] = {{"vertices", result.model.mesh.V.rows()},
                     {"triangles", result.model.mesh.F.rows()},
                     {"joints", result.model.skeleton.size()}};
  report["warnings"] = words(result.warnings);
  return json_text(report);
}

std::string report_text(const Document& document, const Calibration& result,
                        const StageTime& stage) {
  Json report = head(document);
  report["stages"] = stages_json({stage});
  report["calibration"] = calibration_json(document, result);
  report["warnings"] = words(result.warnings);
  return json_text(report);
}

std::string reports_text(const std::vector<DocumentOutcome>& outcomes) {
  constexpr const char* kBecame[] = {"not begun", "there already", "made", "failed"};
  Json all = {{"generator", "ArtiSketch " ARTISKETCH_VERSION}, {"documents", Json::array()}};
  for (const DocumentOutcome& outcome : outcomes) {
    Faults none(outcome.in);
    const std::optional<Json> report =
        outcome.report.empty() ? std::nullopt : parse_json(outcome.report, none);
    all["documents"].push_back({{"in", outcome.in},
                                {"out", outcome.out},
                                {"became", kBecame[int(outcome.became)]},
                                {"exit", outcome.exit},
                                {"errors", words(outcome.errors)},
                                {"report", report.value_or(Json(nullptr))}});
  }
  return json_text(all);
}

}  // namespace artisketch
