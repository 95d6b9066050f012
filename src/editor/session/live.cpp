#include "editor/session/live.h"

#include <algorithm>
#include <cmath>

#include "document/edit.h"
#include "editor/session/part_fit.h"
#include "files/document_file.h"
#include "model/part_inputs.h"

namespace artisketch {
namespace {

constexpr int kGrid = 48;  // cells: coarse enough for a picture while the pointer moves

// The parts side by side, every vertex moved by its part's joint.
Model rigid_model(const Document& document, const std::vector<LivePart>& parts) {
  Model model;
  model.name = document.name;
  model.skeleton = document.skeleton;
  model.clips = clips_of(document);
  Eigen::Index vertices = 0, faces = 0;
  for (const LivePart& part : parts) {
    vertices += part.made->mesh.V.rows();
    faces += part.made->mesh.F.rows();
  }
  model.mesh.V.resize(vertices, 3);
  model.mesh.F.resize(faces, 3);
  model.weights.joints.setZero(vertices, 4);
  model.weights.weights.setZero(vertices, 4);
  Eigen::Index v = 0, f = 0;
  for (const LivePart& part : parts) {
    const Mesh& mesh = part.made->mesh;
    model.mesh.V.middleRows(v, mesh.V.rows()) = mesh.V;
    model.mesh.F.middleRows(f, mesh.F.rows()) = mesh.F.array() + int(v);
    model.weights.joints.col(0).segment(v, mesh.V.rows()).setConstant(part.made->joint);
    model.weights.weights.col(0).segment(v, mesh.V.rows()).setOnes();
    v += mesh.V.rows();
    f += mesh.F.rows();
  }
  return model;
}

// By drawing, from what each part says of its own.
std::vector<FrameFit> fits_of(const Document& document, const std::vector<LivePart>& parts) {
  std::vector<FrameFit> fits(document.frames.size());
  for (const LivePart& part : parts)
    for (std::size_t v = 0; v < part.made->distances.size(); ++v) {
      const std::size_t frame = std::size_t(part.made->frames[v]);
      if (frame < fits.size() && std::isfinite(part.made->distances[v]))
        fits[frame].parts.push_back({part.made->joint, part.made->distances[v]});
    }
  return fits;
}

// All parts that there are, as they come, until the person looks closer.
void keep_in_view(App& app, const Model& model) {
  Orbit& orbit = app.view.orbit;
  std::optional<Orbit>& framed = app.session.live.framed;
  if (framed && (orbit.distance != framed->distance || orbit.target != framed->target)) return;
  const Orbit before = orbit;
  orbit = orbit_round(model);
  if (framed) orbit.yaw = before.yaw, orbit.pitch = before.pitch;
  framed = orbit;
}

// What the parts are wanted of.
Document wanted(const App& app) {
  return with_shaping_contours(app.session.live.at_built_poses
                                   ? with_poses_of(app.document(), app.session.built->document)
                                   : app.document());
}

void take_proposals(App& app, long revision) {
  if (!app.session.proposal || app.session.proposal->revision != revision) return;
  Proposal& proposal = *app.session.proposal;
  proposal.parts = std::move(app.session.live.awaited);
  proposal.fits = fits_of(proposal.document, proposal.parts);
  if (!proposal.parts.empty())
    proposal.model = std::make_shared<BuiltModel>(
        built_of(rigid_model(proposal.document, proposal.parts), proposal.document));
  app.session.live.marks.forget();
}

// What was awaited of a state of the document is there.
void take_awaited(App& app, long revision) {
  Live& live = app.session.live;
  if (live.of_proposal) return take_proposals(app, revision);
  live.revision = revision;
  const bool more = live.awaited.size() != live.parts.size();
  live.parts = std::move(live.awaited);
  live.marks.forget();
  const Document document = wanted(app);
  live.fits = fits_of(document, live.parts);
  live.model.reset();
  if (live.parts.empty() || live.parts.back().made->joint >= document.skeleton.size()) return;
  live.model = std::make_shared<BuiltModel>(built_of(rigid_model(document, live.parts), document));
  if (more && !app.session.built) keep_in_view(app, live.model->model);
}

// Has those parts made that are not there yet, at a document's poses.
void ask_for_parts(App& app, const Document& document, bool of_proposal) {
  Live& live = app.session.live;
  JobRequest request;
  request.kind = JobRequest::Kind::parts;
  request.options.grid = kGrid;
  const SurfaceOptions options{request.options.method, kGrid, false};
  live.of_proposal = of_proposal;
  live.awaited.clear();
  for (Part& part : parts_of(document)) {
    LivePart wanted{surface_inputs(part, options), nullptr};
    const auto same = [&](const LivePart& have) { return have.inputs == wanted.inputs; };
    for (const std::vector<LivePart>* parts : {&live.parts, &live.others})
      if (const auto have = std::find_if(parts->begin(), parts->end(), same); have != parts->end())
        wanted.made = have->made;
    if (!wanted.made) request.parts.push_back(std::move(part));
    live.awaited.push_back(std::move(wanted));
  }
  const long revision = app.session.history.revision();
  if (request.parts.empty()) return take_awaited(app, revision);
  app.session.job = RunningJob{request.kind, revision, {}, {}};
  app.services.jobs.start(std::move(request));
}

// An example's model comes without the spheres that joined its parts.
void ask_for_spheres(App& app) {
  if (!app.session.built || !app.session.built->spheres.empty() ||
      app.session.built->spheres_sought)
    return;
  app.session.built->spheres_sought = true;
  JobRequest request;
  request.kind = JobRequest::Kind::spheres;
  request.document = document_text(app.session.built->document);
  request.options.grid = kGrid;
  app.session.job = RunningJob{request.kind, app.session.history.revision(), {}, {}};
  app.services.jobs.start(std::move(request));
}

}  // namespace

void keep_live(App& app) {
  Live& live = app.session.live;
  const long revision = app.session.history.revision();
  if (app.services.jobs.busy() || app.view.welcome) return;
  const bool result = app.view.mode == Mode::result;
  const bool parts_of_result = app.session.built && result && app.tool().shows_parts();
  if (const bool at_built_poses = parts_of_result || app.session.as_built();
      live.at_built_poses != at_built_poses) {
    live.at_built_poses = at_built_poses;
    std::swap(live.parts, live.others);
    live.revision = -1;
  }
  if (live.revision != revision) {
    if (drawn_joints(app.document()).empty())
      live = Live();
    else
      ask_for_parts(app, wanted(app), false);
  } else if (app.session.proposal && app.session.proposal->fits.empty()) {
    ask_for_parts(app, app.session.proposal->document, true);
  } else if (result && app.tool().shows_spheres()) {
    ask_for_spheres(app);
  }
}

void take_parts(App& app, const RunningJob& job, Result<JobResult> outcome) {
  Live& live = app.session.live;
  if (!outcome) {
    // Whatever it is, the next edit tries again; a whole model tells what is wrong.
    if (outcome.error().kind != Error::Kind::cancelled) live.revision = job.revision;
    return;
  }
  if (live.awaited.empty()) return;  // they were let go of meanwhile
  // In the order of what was asked for; what has no surface has no triangles.
  auto made = outcome->parts.begin();
  for (LivePart& part : live.awaited)
    if (!part.made && made != outcome->parts.end())
      part.made = std::make_shared<const PartMesh>(std::move(*made++));
  take_awaited(app, job.revision);
}

const std::vector<PartMarks>& marks_of_drawing(App& app) {
  Live& live = app.session.live;
  // A model shows whether it fits at its own poses; bones are drawn at the person's.
  const Document& posed = app.session.as_built() ? app.session.built->document : app.document();
  const Pose pose = app.session.as_built()
                        ? posed.frames[std::size_t(app.session.selection.frame)].pose
                        : app.drawn_pose();
  const bool theirs = app.session.proposal && app.session.proposal->theirs();
  const auto make = [&] {
    std::vector<PartMarks> all;
    const std::vector<Transform> motions = skinning_transforms(app.document().skeleton, pose);
    const FrameCamera camera = frame_camera(posed, app.session.selection.frame);
    for (const LivePart& part : theirs ? app.session.proposal->parts : live.parts) {
      const int joint = part.made->joint;
      if (joint >= int(motions.size()) ||
          fit_of(app, joint, app.session.selection.frame) == Fit::inside)
        continue;
      FitMarks marks =
          fit_marks(part.made->mesh, motions[std::size_t(joint)], camera, app.frame(), joint, kOff);
      if (!marks.edge.empty()) all.push_back({joint, std::move(marks)});
    }
    return all;
  };
  return live.marks.of(app.session.history.state(), {app.session.selection.frame, theirs, pose},
                       make);
}

}  // namespace artisketch
