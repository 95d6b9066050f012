#include "editor/session/built_model.h"

#include <algorithm>

#include "document/animate.h"
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

Vec3 footing_at(const BuiltModel& built, int clip, double time) {
  const Between at = between(built.model.clips[std::size_t(clip)].times, time);
  const std::vector<Vec3>& footing = built.footing[std::size_t(clip)];
  return footing[at.a] + at.t * (footing[at.b] - footing[at.a]);
}

Result<BuiltModel> built_from(const std::string& glb, const std::string& document) {
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
  BuiltModel built = built_of(std::move(*model), std::move(*made_from));
  built.glb = glb;
  built.unseen_sides = unseen_sides(with_shaping_contours(built.document));
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

BuiltModel built_of(Model model, Document document) {
  BuiltModel built{};
  built.model = std::move(model);
  built.document = std::move(document);
  built.picture = std::make_unique<ModelPicture>();
  built.footing = footing_of(built.model);
  built.picture->load(built.model);
  return built;
}

bool BuiltModel::take_clips(const Document& from) {
  std::vector<Clip> clips = clips_of(from);
  clips.erase(clips.begin());  // of the drawings: the model's own stays
  std::erase_if(clips, [&](const Clip& clip) {
    return clip.poses.empty() || int(clip.poses[0].rotations.size()) != model.skeleton.size();
  });
  const auto same = [](const Clip& a, const Clip& b) {
    return a.name == b.name && a.times == b.times &&
           std::equal(a.poses.begin(), a.poses.end(), b.poses.begin(), b.poses.end(), same_pose);
  };
  const auto own = model.clips.begin() + std::min<std::ptrdiff_t>(1, std::ssize(model.clips));
  if (std::equal(own, model.clips.end(), clips.begin(), clips.end(), same)) return false;
  model.clips.erase(own, model.clips.end());
  model.clips.insert(model.clips.end(), clips.begin(), clips.end());
  footing = footing_of(model);
  clips_edited = true;
  return true;
}

}  // namespace artisketch
