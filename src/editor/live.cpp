#include "editor/live.h"

#include "document/edit.h"
#include "editor/panels.h"
#include "files/document_file.h"

namespace artisketch {
namespace {

constexpr int kGrid = 48;  // cells: coarse enough for a picture while the pointer moves

// Parts don't depend on the drawings' pixels.
std::string without_drawings(Document document) {
  for (Frame& frame : document.frames) frame.image.clear();
  return document_text(document);
}

void ask_for_parts(Work& work, const Document& document, bool of_proposal) {
  JobRequest request;
  request.kind = JobRequest::Kind::parts;
  request.document = without_drawings(document);
  request.options.grid = kGrid;
  request.options.mirror = false;
  work.running = request.kind;
  work.running_revision = work.history.revision();
  work.live.of_proposal = of_proposal;
  work.jobs.start(std::move(request));
}

// The parts side by side, every vertex moved by its part's joint.
Model rigid_model(const Document& document, const std::vector<PartMesh>& parts) {
  Model model;
  model.name = document.name;
  model.skeleton = document.skeleton;
  model.clips = clips_of(document);
  Eigen::Index vertices = 0, faces = 0;
  for (const PartMesh& part : parts) vertices += part.mesh.V.rows(), faces += part.mesh.F.rows();
  model.mesh.V.resize(vertices, 3);
  model.mesh.F.resize(faces, 3);
  model.weights.joints.setZero(vertices, 4);
  model.weights.weights.setZero(vertices, 4);
  Eigen::Index v = 0, f = 0;
  for (const PartMesh& part : parts) {
    model.mesh.V.middleRows(v, part.mesh.V.rows()) = part.mesh.V;
    model.mesh.F.middleRows(f, part.mesh.F.rows()) = part.mesh.F.array() + int(v);
    model.weights.joints.col(0).segment(v, part.mesh.V.rows()).setConstant(part.joint);
    model.weights.weights.col(0).segment(v, part.mesh.V.rows()).setOnes();
    v += part.mesh.V.rows();
    f += part.mesh.F.rows();
  }
  return model;
}

// The document at the poses that the model was made at.
Document at_models_poses(Document document, const Document& made) {
  if (made.frames.size() != document.frames.size() ||
      made.skeleton.size() != document.skeleton.size())
    return document;
  for (std::size_t f = 0; f < document.frames.size(); ++f) {
    document.frames[f].pose = made.frames[f].pose;
    document.frames[f].scale = made.frames[f].scale;
  }
  return document;
}

// What the parts are wanted of.
Document wanted(const Work& work) {
  return work.live.of_result ? at_models_poses(work.document(), work.built->document)
                             : work.document();
}

}  // namespace

void keep_live(Work& work) {
  Live& live = work.live;
  const long revision = work.history.revision();
  if (work.jobs.busy() || work.view.welcome) return;
  const bool of_result =
      work.built && work.view.mode == Mode::result && work.view.tool() == Tool::fatness;
  if (live.of_result != of_result) live.revision = -1;
  live.of_result = of_result;
  if (live.revision != revision) {
    if (drawn_joints(work.document()).empty())
      live = Live();
    else
      ask_for_parts(work, wanted(work), false);
  } else if (work.proposal && work.proposal->fits.empty()) {
    ask_for_parts(work, work.proposal->document, true);
  }
}

void take_parts(Work& work, Result<JobResult> outcome) {
  Live& live = work.live;
  if (!outcome) {
    // Whatever it is, the next edit tries again; a whole model tells what is wrong.
    if (outcome.error().kind != Error::Kind::cancelled) live.revision = work.running_revision;
    return;
  }
  if (live.of_proposal) {
    if (!work.proposal || work.proposal->revision != work.running_revision) return;
    Proposal& proposal = *work.proposal;
    proposal.fits = std::move(outcome->fits);
    proposal.parts = std::move(outcome->parts);
    if (!proposal.parts.empty())
      proposal.model = std::make_shared<Built>(
          built_of(rigid_model(proposal.document, proposal.parts), proposal.document));
    live.marks_stale = true;
    return;
  }
  live.revision = work.running_revision;
  live.parts = std::move(outcome->parts);
  live.fits = std::move(outcome->fits);
  live.marks_stale = true;
  const bool first = !live.model && !work.built;
  const Document document = wanted(work);
  live.model.reset();
  if (live.parts.empty() || live.parts.back().joint >= document.skeleton.size()) return;
  live.model = std::make_shared<Built>(built_of(rigid_model(document, live.parts), document));
  if (first) look_at(work, live.model->model);
}

const std::vector<PartMarks>& marks_of_drawing(Work& work) {
  Live& live = work.live;
  const Pose pose = work.drawn_pose();
  const long revision = work.history.revision();
  const bool theirs = work.proposal && work.proposal->theirs();
  if (!live.marks_stale && live.marks_theirs == theirs && live.marks_revision == revision &&
      live.marks_frame == work.view.frame && same_pose(live.marks_pose, pose))
    return live.marks;
  live.marks_stale = false;
  live.marks_revision = revision;
  live.marks_frame = work.view.frame;
  live.marks_theirs = theirs;
  live.marks_pose = pose;
  live.marks.clear();
  const std::vector<Transform> motions = skinning_transforms(work.document().skeleton, pose);
  const FrameCamera camera = frame_camera(work.document(), work.view.frame);
  for (const PartMesh& part : theirs ? work.proposal->parts : live.parts) {
    if (part.joint >= int(motions.size())) continue;
    FitMarks marks = fit_marks(part.mesh, motions[std::size_t(part.joint)], camera, work.frame(),
                               part.joint, kOff);
    if (!marks.edge.empty()) live.marks.push_back({part.joint, std::move(marks)});
  }
  return live.marks;
}

}  // namespace artisketch
