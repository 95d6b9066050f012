#include "editor/session/work.h"

#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "document/animate.h"
#include "document/edit.h"
#include "files/document_file.h"
#include "files/gltf.h"

namespace artisketch {
namespace {

// The two keys about a time and how far between them it is.
struct Between {
  std::size_t a = 0, b = 0;
  double t = 0;
};
Between between(const std::vector<double>& times, double time) {
  const std::size_t after =
      std::size_t(std::upper_bound(times.begin(), times.end(), time) - times.begin());
  if (after == 0) return {};
  if (after == times.size()) return {after - 1, after - 1, 0};
  return {after - 1, after, (time - times[after - 1]) / (times[after] - times[after - 1])};
}

}  // namespace

Pose pose_at(const Clip& clip, double time) {
  const Between at = between(clip.times, time);
  Pose pose = clip.poses[at.a];
  const Pose& next = clip.poses[at.b];
  pose.root_position += at.t * (next.root_position - pose.root_position);
  for (std::size_t j = 0; j < pose.rotations.size(); ++j)
    pose.rotations[j] = pose.rotations[j].slerp(at.t, next.rotations[j]);
  return pose;
}

Vec3 footing_at(const Built& built, int clip, double time) {
  const Between at = between(built.model.clips[std::size_t(clip)].times, time);
  const std::vector<Vec3>& footing = built.footing[std::size_t(clip)];
  return footing[at.a] + at.t * (footing[at.b] - footing[at.a]);
}

Result<Built> built_from(const std::string& glb, const std::string& document) {
  Result<Model> model = read_glb(glb, "the model");
  if (!model) return model.error();
  Result<Document> made_from = parse_document(document, "the document");
  if (!made_from) return made_from.error();
  // Its first clip holds the poses that it was made at.
  const std::vector<Pose> poses =
      model->clips.empty() ? std::vector<Pose>() : model->clips[0].poses;
  for (std::size_t f = 0; f < made_from->frames.size() && f < poses.size(); ++f)
    if (int(poses[f].rotations.size()) == made_from->skeleton.size())
      made_from->frames[f].pose = poses[f];
  Built built = built_of(std::move(*model), std::move(*made_from));
  built.glb = glb;
  return built;
}

namespace {

// Per clip and key: what sets the posed model's feet on the middle of the ground.
std::vector<std::vector<Vec3>> footing_of(const Model& model) {
  std::vector<std::vector<Vec3>> footing(model.clips.size());
  for (std::size_t c = 0; c < model.clips.size(); ++c)
    for (const Pose& pose : model.clips[c].poses) {
      const Box3 box = bounds(posed_vertices(model.mesh.V, model.weights, model.skeleton, pose));
      footing[c].push_back(-Vec3(box.center().x(), box.min().y(), box.center().z()));
    }
  return footing;
}

}  // namespace

Built built_of(Model model, Document document) {
  Built built{};
  built.model = std::move(model);
  built.document = std::move(document);
  built.picture = std::make_unique<ModelPicture>();
  built.footing = footing_of(built.model);
  built.picture->load(built.model);
  return built;
}

void Work::commit(std::string undo_name, Document next) {
  history.commit(std::move(undo_name), std::move(next));
  changed_at = ImGui::GetTime();
  settle();
}

void Work::drop_gesture() {
  stroke.clear();
  if (gesture.moved) undo();
  gesture = {};
}

void Work::change(const std::string& undo_name, Document next) {
  if (std::exchange(gesture.moved, true)) {
    history.amend(std::move(next));
    changed_at = ImGui::GetTime();
    settle();
  } else {
    commit(undo_name, std::move(next));
  }
}

void Work::undo() {
  history.undo();
  gesture = {};
  changed_at = ImGui::GetTime();
  settle();
}

void Work::redo() {
  history.redo();
  gesture = {};
  changed_at = ImGui::GetTime();
  settle();
}

namespace {
bool same_joints(const Skeleton& a, const Skeleton& b) {
  return std::equal(a.joints.begin(), a.joints.end(), b.joints.begin(), b.joints.end(),
                    [](const Joint& p, const Joint& q) { return p.parent == q.parent; });
}
}  // namespace

void Work::settle() {
  const Document& now = document();
  view.frame = std::clamp(view.frame, 0, std::max(0, int(now.frames.size()) - 1));
  if (view.joint >= now.skeleton.size()) view.joint = -1;
  if (!has_frame() || view.contour >= int(frame().contours.size())) view.contour = -1;
  // Parts of another skeleton stand in no pose of this one.
  if (live.model && !same_joints(live.model->model.skeleton, now.skeleton)) live = Live();
  follow_document();
  if (proposal && proposal->revision != history.revision()) proposal.reset();
  if (outline && outline->frame >= int(now.frames.size())) outline.reset();
}

void Work::follow_document() {
  if (!built) return;
  built->fresh = same_model(document(), built->source);
  std::vector<Clip> clips = clips_of(document());
  Model& model = built->model;
  std::vector<Clip> own(model.clips.begin() + std::min<std::ptrdiff_t>(1, std::ssize(model.clips)),
                        model.clips.end());
  clips.erase(clips.begin());
  std::erase_if(clips, [&](const Clip& clip) {
    return clip.poses.empty() || int(clip.poses[0].rotations.size()) != model.skeleton.size();
  });
  const auto same = [](const Clip& a, const Clip& b) {
    return a.name == b.name && a.times == b.times &&
           std::equal(a.poses.begin(), a.poses.end(), b.poses.begin(), b.poses.end(), same_pose);
  };
  if (!std::equal(own.begin(), own.end(), clips.begin(), clips.end(), same)) {
    model.clips.resize(std::min<std::size_t>(1, model.clips.size()));
    model.clips.insert(model.clips.end(), clips.begin(), clips.end());
    built->footing = footing_of(model);
    built->clips_edited = true;
  }
  if (view.clip >= int(model.clips.size())) view.clip = 0, view.key = -1;
}

const Built* Work::shown() const {
  const bool result = view.mode == Mode::result || view.welcome;
  // A part's fatness shows while it is dragged.
  if (result && !view.welcome && view.tool() == Tool::fatness && stale() && live.model)
    return live.model.get();
  if (built && (result || !stale() || !live.model)) return built.get();
  if (view.mode == Mode::pose && proposal && proposal->model && proposal->theirs())
    return proposal->model.get();
  return live.model.get();
}

Pose Work::shown_pose() const {
  const Built& model = *shown();
  const std::vector<Clip>& clips = model.model.clips;
  if (view.mode == Mode::result || view.welcome) {
    if (view.posed) return *view.posed;
    return clips.empty()
               ? rest_pose(model.model.skeleton)
               : pose_at(clips[std::min(std::size_t(view.clip), clips.size() - 1)], view.time);
  }
  if (shows_parts() && has_frame()) return drawn_pose();
  if (clips.empty() || clips[0].poses.empty()) return rest_pose(model.model.skeleton);
  return clips[0].poses[std::min(std::size_t(view.frame), clips[0].poses.size() - 1)];
}

Vec3 Work::shown_footing() const {
  const Built& model = *shown();
  if (model.footing.empty() || model.footing[0].empty()) return Vec3::Zero();
  if (view.mode == Mode::result || view.welcome)
    return footing_at(model, std::min(view.clip, int(model.footing.size()) - 1), view.time);
  return model.footing[0][std::min(std::size_t(view.frame), model.footing[0].size() - 1)];
}

namespace {
constexpr double kCalibrating = 0.6;  // seconds from the person's pose to the calibrated one
}

bool Work::changing_pose() const {
  return proposal && ImGui::GetTime() < proposal->since + kCalibrating;
}

Pose Work::drawn_pose() const {
  if (view.mode == Mode::skeleton) {
    // The rest pose, as the body stands in this drawing.
    Pose rest = frame().pose;
    for (std::size_t j = 1; j < rest.rotations.size(); ++j) rest.rotations[j].setIdentity();
    return rest;
  }
  const Pose& mine = frame().pose;
  if (!proposal || !proposal->theirs()) return mine;
  const Pose& theirs = proposal->document.frames[std::size_t(view.frame)].pose;
  const double t = std::clamp((ImGui::GetTime() - proposal->since) / kCalibrating, 0.0, 1.0);
  return pose_at({"", {0, 1}, {mine, theirs}}, t * t * (3 - 2 * t));
}

double distance_in(const std::vector<FrameFit>& fits, int joint, int frame) {
  if (frame >= int(fits.size())) return -1;
  for (const FrameFit::PartFit& fit : fits[std::size_t(frame)].parts)
    if (fit.joint == joint) return fit.distance;
  return -1;
}

double distance_of(const Work& work, int joint, int frame) {
  const bool measured = work.built && !work.built->fits.empty();
  if (measured && (work.view.mode == Mode::result || work.as_built()))
    return distance_in(work.built->fits, joint, frame);
  // Until the parts are there at the model's poses, those at the person's tell of something else.
  const bool other = work.as_built() &&
                     (!work.live.at_built_poses || work.live.revision != work.history.revision());
  return work.live.model && !other ? distance_in(work.live.fits, joint, frame) : -1;
}

namespace {

// Found once for each state of the document.
bool is_inside(const Work& work, int joint, int frame) {
  const std::vector<std::vector<bool>>& inside = work.insides.of(work.history.state(), [&] {
    std::vector<std::vector<bool>> all;
    for (const Frame& each : work.document().frames) {
      std::vector<bool>& of = all.emplace_back();
      for (int j = 0; j < work.document().skeleton.size(); ++j)
        of.push_back(inside_other_parts(each, j));
    }
    return all;
  });
  return inside[std::size_t(frame)][std::size_t(joint)];
}

}  // namespace

Fit fit_of(const Work& work, int joint, int frame) {
  const Frame& drawing = work.document().frames[std::size_t(frame)];
  if (is_hidden(drawing, joint)) return Fit::hidden;
  for (const Contour& contour : drawing.contours)
    if (contour.joint == joint)
      return is_inside(work, joint, frame)            ? Fit::inside
             : distance_of(work, joint, frame) > kOff ? Fit::off
                                                      : Fit::outlined;
  return Fit::missing;
}

PartCount count_parts(const Work& work, int frame) {
  PartCount count;
  for (const int joint : parts_to_draw(work.document())) {
    const Fit fit = fit_of(work, joint, frame);
    if (fit == Fit::hidden) continue;
    ++count.all;
    count.outlined += fit != Fit::missing;
    count.off += fit == Fit::off;
  }
  return count;
}

}  // namespace artisketch
