// What is being worked on, and how it is looked at. Panels read it and draw; commands change it.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/job.h"
#include "document/derived.h"
#include "document/edit.h"
#include "document/history.h"
#include "document/trace.h"
#include "editor/pictures/drawings.h"
#include "editor/pictures/eye.h"
#include "editor/pictures/model_picture.h"
#include "editor/session/commands.h"
#include "editor/session/platform.h"
#include "editor/ui/touch.h"
#include "model/fit/fit_marks.h"

namespace artisketch {

enum class Mode { outline, skeleton, pose, result };
inline constexpr int kModes = 4;
enum class Tool { edit, draw, points, trace, cut, pose, twist, turn, orbit, joints, fatness };

// A finished model, and the document at the poses that it was made from.
struct Built {
  Model model;
  Document document;
  std::vector<FrameFit> fits;
  std::vector<std::string> warnings;
  std::string glb;
  Document source;                   // that it was made from
  std::vector<JointSphere> spheres;  // that join its parts
  bool spheres_sought = false;       // where they didn't come with the model
  bool fresh = true;                 // the document makes just this, as far as its shape goes
  bool clips_edited = false;         // since the bytes were made
  // Per clip and key: moves the posed model's feet to the middle of the ground.
  std::vector<std::vector<Vec3>> footing;
  std::unique_ptr<ModelPicture> picture;
};
Result<Built> built_from(const std::string& glb, const std::string& document);
Built built_of(Model model, Document document);  // without fits and bytes

struct PartMarks {
  int joint = 0;
  FitMarks marks;
};

// A part as the document has it by now, coarse and on its own.
struct LivePart {
  std::string inputs;                    // all that it is made of (surface_inputs)
  std::shared_ptr<const PartMesh> made;  // null until it is there
};

// What marks depend on beside the document and the parts.
struct MarksKey {
  int frame = -1;
  bool theirs = false;  // the proposal's parts rather than the person's
  Pose pose;
  bool operator==(const MarksKey& other) const {
    return frame == other.frame && theirs == other.theirs && same_pose(pose, other.pose);
  }
};

// The parts (live.h).
struct Live {
  std::shared_ptr<Built> model;
  std::vector<LivePart> parts;
  std::vector<LivePart> awaited;  // as they will be; those that are being made have nothing yet
  std::vector<FrameFit> fits;
  long revision = -1;            // that they were made from
  bool of_proposal = false;      // what is under way: the proposal's fit rather than the parts
  bool at_built_poses = false;   // the parts are made at the model's poses, not at the person's
  std::vector<LivePart> others;  // the last ones made the other way
  std::optional<Orbit> framed;   // the view that took in all of them
  Derived<std::vector<PartMarks>, MarksKey> marks;  // of the drawing shown last
};

// Where a clip stands at a time; between keys as glTF interpolates.
Pose pose_at(const Clip& clip, double time);
Vec3 footing_at(const Built& built, int clip, double time);

// A calibrated pose per drawing that waits for the person's word.
struct Proposal {
  Document document;
  std::vector<PartCoverage> coverage;
  // At the calibrated poses; nothing until they are made.
  std::vector<FrameFit> fits;
  std::vector<LivePart> parts;
  std::shared_ptr<Built> model;
  std::vector<bool> taken;  // per joint
  bool shown = true;        // the calibrated pose rather than the person's own
  bool peeking = false;     // the other one, as long as a key is held
  bool theirs() const { return shown != peeking; }
  double since = 0;  // when it was shown: the change is animated
  long revision = -1;
};

// Which way a bone of a suggested pose leans: the two poses to choose from.
struct Bend {
  int frame = -1;  // that a pose was suggested for; −1: nothing to choose
  long revision = -1;
  int joint = -1;
  Pose toward, away;
};

struct Layers {
  bool drawing = true, outlines = true, bones = true, model = false;
  float drawing_opacity = 0.85f, model_opacity = 1;
};

// What the pointer holds on the canvas from press to release. One gesture is one step of undo: the
// first move commits, the others amend.
struct Gesture {
  bool moved = false;
  int point = -1, contour = -1, joint = -1;
  Vec2 from = Vec2::Zero();
  std::vector<Vec2> points;  // as the gesture found them
};

// What the export sheet chose.
struct ExportWish {
  std::size_t format = 0;
  bool texture = true;
  int halvings = 0;               // of the texture's sides
  bool sides = false;             // sprites all round in place of one picture
  std::set<std::string> without;  // clips that stay behind
  bool waits = false;             // for the model under way
};

// How far panels were dragged from their usual sizes, in points.
struct Splits {
  float inspector = 0, model = 0, strip = 0;
  float grabbed = 0;  // how far the one under the pointer was when it was grabbed
};

struct View {
  bool welcome = true;
  Mode mode = Mode::outline;
  std::array<Tool, kModes> tools = {Tool::edit, Tool::edit, Tool::pose, Tool::pose};
  std::array<Layers, kModes> layers;
  int frame = 0;
  int joint = -1;    // chosen part, −1: none
  int contour = -1;  // chosen outline of the frame, −1: none

  double tolerance = kUsualTolerance;  // of Trace, as it was used last
  bool both_sides = true;              // Skeleton: what is done to one side is done to the other
  std::optional<int> moving_drawing;   // dragged along the strip
  int point = -1;                      // the chosen outline's, under the pointer
  bool redrawing = false;              // the next outline takes the place of the chosen one
  bool joining = false;                // the next outline that is clicked is joined to it
  bool picking_joint = false;          // the next joint that is clicked gets the chosen outline

  bool fit = true;  // the drawing fills the canvas
  // On tablets it keeps its place while its figure changes.
  int fitted_frame = -1;
  Mode fitted_mode = Mode::outline;
  ImVec2 fitted_size;
  float zoom = 1;  // points per pixel of the sketch
  ImVec2 origin;   // where the sketch's corner stands in the window

  Orbit orbit;
  Surface surface = Surface::textured;
  bool model_bones = false;
  std::array<bool, kModes> swapped{};  // tablets: the model is large, the drawing its inset
  Splits splits;
  std::set<int> missing_seen;  // drawings whose missing parts need no more words (tablets)

  bool playing = false, looping = true;
  int clip = 0;
  int key = -1;               // chosen, of the clip
  double time = 0;            // seconds
  std::optional<Pose> posed;  // the result as the person dragged it

  bool choosing_pose = false;  // to copy: the drawings are listed
  bool exporting = false, all_drawings = false;
  ExportWish wish;
  float strip_scroll = 0;  // points
  bool dark = true;
  bool help = false;

  void fit_again() { fit = true, fitted_frame = -1; }
  void swap() { swapped[std::size_t(mode)] ^= true, fit_again(); }
  Layers& layer() { return layers[std::size_t(mode)]; }
  const Layers& layer() const { return layers[std::size_t(mode)]; }
  Tool& tool() { return tools[std::size_t(mode)]; }
  Tool tool() const { return tools[std::size_t(mode)]; }
};

inline constexpr double kToastSeconds = 6;
struct Toast {
  std::string words, action, other_action;
  std::function<void()> act, other_act;
  bool error = false;  // stays until it is dismissed
  double since = -1;   // set when it is shown first
};

// A joint's name while it is typed.
struct Naming {
  int joint = -1;
  std::string of, typed;  // the name that it has, and the words that it gets
  bool begin = false;     // the keyboard goes there
};

// What must be answered before work goes on; Esc is the last answer.
struct Question {
  std::string title, words;
  struct Answer {
    std::string words;
    std::function<void()> act;  // may be empty
    bool primary = false;
  };
  std::vector<Answer> answers;
  bool asks_path = false;
  std::string path;  // being typed
  std::function<void(const std::string&)> with_path;
};

// What a traced outline came from: it can be traced again with another tolerance.
struct Tracing {
  TraceImage image;
  FloodLevels levels;
  double from = 0;  // the tolerance when the gesture began
};

// An outline that was just drawn, and whose part it may be.
struct NewOutline {
  Polyline line;
  std::vector<Polyline> holes;
  int frame = 0;
  int choice = 0;  // of the candidates
  std::vector<int> joints;
  std::vector<std::string> reasons;
  std::string verb = "Draw";  // as undo says it
  std::vector<Vec2> stroke;   // it was drawn so, where it was
  StrokeOptions options;
  std::shared_ptr<Tracing> tracing;  // it was traced so, where it was
  int arrived = 0;                   // ImGui's count of frames
};

struct Work {
  Platform& platform;
  Jobs& jobs;

  History history;
  Drawings drawings;
  std::vector<ExampleCard> examples;                    // the gallery's
  std::map<std::string, std::string> example_pictures;  // keys into `drawings`, once asked for
  std::string name, place;                              // of the file; empty before the first save
  long saved = 0, autosaved = 0;                        // revisions
  double changed_at = 0;                                // when the document changed last
  double unkept_since = -1;  // when it first differed from what is kept for a crash

  std::shared_ptr<Built> built;
  Live live;
  std::optional<Proposal> proposal;
  std::optional<NewOutline> outline;
  Bend bend;
  Gesture gesture;
  Naming naming;
  Fingers fingers;
  bool hurried = false;      // something is dragged, and the machine paints too slowly to follow
  int model_joint = -1;      // of the result, while it is dragged
  bool sphere_rim = false;   // it is its sphere's rim
  double fatness_from = 1;   // as the drag found it
  std::vector<Vec2> stroke;  // under the pointer, in the sketch's pixels
  JobRequest::Kind running = JobRequest::Kind::reconstruct;
  long running_revision = -1;
  Document running_document;

  // Where each contour of a frame crosses itself; and per frame and joint: inside_other_parts.
  mutable Derived<std::vector<std::optional<Vec2>>, int> crossings;
  mutable Derived<std::vector<std::vector<bool>>> insides;

  std::vector<Vec2> handles;  // of the stroke's points, where it is made point by point

  View view;
  // The model over the drawing, from all sides, and beside the drawing.
  RenderTarget over_sketch, model_seen, model_beside;
  std::vector<Toast> toasts;
  std::optional<Question> question;
  bool closed = false;         // the person left
  std::vector<Command> asked;  // by this frame's controls and keys

  Work(Platform& platform, Jobs& jobs, Graphics& graphics)
      : platform(platform),
        jobs(jobs),
        drawings(graphics),
        over_sketch(graphics),
        model_seen(graphics),
        model_beside(graphics) {}

  const Document& document() const { return history.now(); }
  bool has_frame() const { return view.frame < int(document().frames.size()); }
  const Frame& frame() const { return document().frames[std::size_t(view.frame)]; }
  bool unsaved() const { return history.revision() != saved; }
  bool stale() const { return !built || !built->fresh; }
  void ask(Command command) { asked.push_back(command); }
  // What was said already is said once, anew.
  void say(Toast toast) {
    std::erase_if(toasts, [&](const Toast& said) { return said.words == toast.words; });
    toasts.push_back(std::move(toast));
  }
  // The next state of the document, by its undo name.
  void commit(std::string undo_name, Document next);
  // What the pointer has begun was meant otherwise: the document is as before.
  void drop_gesture();
  // The same for a gesture: its first change is a step of undo, which the others amend.
  void change(const std::string& undo_name, Document next);
  // What is still held begins anew.
  void undo();
  void redo();
  // Keeps what is chosen within the document, and the model's clips as the document has them.
  void settle();
  void follow_document();

  // A job that the person waits for is under way.
  bool busy() const {
    return jobs.busy() && running != JobRequest::Kind::parts &&
           running != JobRequest::Kind::spheres;
  }
  // The model in view: the whole one, or while it is out of date, or not there yet, its parts.
  // Null: neither.
  const Built* shown() const;
  bool shows_parts() const { return shown() && shown() != built.get(); }
  // The document is as the model was made from it, and no other pose stands beside: what fits is
  // told of the poses that the model was made at, also where the person didn't keep them.
  bool as_built() const { return built && built->fresh && !proposal; }

  // The pose that the model shows: of the clip, the person's, or the drawing's.
  Pose shown_pose() const;
  Vec3 shown_footing() const;
  // Poses of the drawing as the canvas shows them: the person's, or the proposal's.
  Pose drawn_pose() const;
  bool changing_pose() const;  // the proposal's animation is under way
};

// How a part fits a drawing: missing and hidden without an outline, the others with one. Of a part
// inside others nothing can be told.
enum class Fit { outlined, missing, hidden, off, inside };
Fit fit_of(const Work& work, int joint, int frame);
struct PartCount {
  int outlined = 0, off = 0, all = 0;  // all: that are to be outlined
};
PartCount count_parts(const Work& work, int frame);
double distance_in(const std::vector<FrameFit>& fits, int joint, int frame);  // as distance_of
double distance_of(const Work& work, int joint, int frame);  // pixels; −1 where unknown
inline constexpr double kOff = 3.5, kFarOff = 9;             // pixels: amber, red

}  // namespace artisketch
