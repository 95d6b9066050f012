// All that goes with one document: opening or making a document replaces it whole.
#pragma once

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
#include "document/outline_edit.h"
#include "document/region_outline.h"
#include "editor/session/built_model.h"
#include "editor/session/tool.h"
#include "editor/session/view.h"
#include "model/fit/fit_marks.h"
#include "model/rig/retarget.h"

namespace artisketch {

// ---------------------------------------------------------------- the model while it is edited

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
  std::shared_ptr<BuiltModel> model;
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

// ---------------------------------------------------------------- what waits for the person's word

// A calibrated pose per drawing.
struct Proposal {
  Document document;
  std::vector<PartCoverage> coverage;
  // At the calibrated poses; nothing until they are made.
  std::vector<FrameFit> fits;
  std::vector<std::string> warnings;
  std::vector<LivePart> parts;
  std::shared_ptr<BuiltModel> model;
  std::vector<bool> taken;  // per joint
  bool shown = true;        // the calibrated pose rather than the person's own
  bool peeking = false;     // the other one, as long as a key is held
  bool theirs() const { return shown != peeking; }
  double since = 0;  // when it was shown: the change is animated
  long revision = -1;
};

// Which way a bone of a suggested pose leans: the two poses to choose from.
struct Leanings {
  Pose toward, away;
};
struct Bend {
  int frame = -1;             // that a pose was suggested for; −1: nothing to choose
  Derived<Leanings, int> of;  // by joint
};

// Poses that were suggested for a drawing, to choose from while one of them is its pose.
struct Rivals {
  int frame = -1;
  std::vector<Pose> poses;  // the best first
};

// What a traced outline came from: it can be traced again with another tolerance.
struct Tracing {
  SegmentedImage image;
  FloodLevels levels;
  double from = 0;  // the tolerance when the drag began
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

// ---------------------------------------------------------------- the session

// What is chosen, or under the pointer.
struct Selection {
  int frame = 0;     // the drawing in view
  int joint = -1;    // chosen part, −1: none
  int contour = -1;  // chosen outline of the frame, −1: none
  int point = -1;    // the chosen outline's, under the pointer

  // More outlines of the frame, chosen along with that one for as long as it is the chosen one
  // (Session::chosen_outlines).
  struct Along {
    int frame = -1, contour = -1;
    ContourSet which;
  };
  Along along;
};

// Arrow keys, one after the other, are one step of undo.
struct Nudging {
  long gesture = -1, revision = -1;
};

// What the next click or stroke is for, where a command asked for it.
struct NextClick {
  bool redraws = false;      // the next outline takes the place of the chosen one
  bool joins = false;        // the next outline that is clicked is joined to it
  bool picks_joint = false;  // the next joint that is clicked gets the chosen outline
  bool any() const { return redraws || joins || picks_joint; }
};

// The model's clips in time.
struct Playback {
  bool playing = false;
  int clip = 0;
  int key = -1;               // chosen, of the clip
  double time = 0;            // seconds
  int first_row = 0;          // in view, of the clips besides the drawings'
  int followed = 0;           // the clip that was last brought into view
  std::optional<Pose> posed;  // the result as the person dragged it
};

// What was dropped on the window and became clips.
struct DroppedMotion {
  std::vector<Motion> motions;
  std::vector<Retargeted> made;    // of each, for the document as it was at `revision`
  std::vector<std::string> clips;  // their names
  std::size_t first = 0;           // animation of the document's; the others follow
  RetargetOptions options;
  long revision = -1;
  int first_row = 0;  // in view, of the joints
};

// A joint's name while it is typed.
struct Naming {
  int joint = -1;
  std::string of, typed;  // the name that it has, and the words that it gets
  bool begin = false;     // the keyboard goes there
};

// A joint under the pointer in Pose's view from the side.
struct SideDrag {
  long gesture = 0;
  int joint = -1;
};

struct DocumentFile {
  std::string name, place;  // empty before the first save
  long saved = 0;           // revision
};

// What is kept for a crash.
struct Backup {
  long revision = 0;
  long seen = 0;             // revision when it was looked at last
  double changed_at = 0;     // when that was another one, last
  double unkept_since = -1;  // when the document first differed from what is kept
};

struct RunningJob {
  JobRequest::Kind kind = JobRequest::Kind::reconstruct;
  long revision = -1;
  Document document;                    // of a model
  std::function<void(JobResult)> then;  // what becomes of sprites
  // The person waits for it.
  bool awaited() const {
    return kind == JobRequest::Kind::reconstruct || kind == JobRequest::Kind::calibrate ||
           kind == JobRequest::Kind::sprites;
  }
};

// What an export leaves out, and whether it waits for the model under way.
struct PendingExport {
  std::set<std::string> without;  // clips
  int first_row = 0;              // in view, of the clips
  bool waits = false;
};

struct Session {
  explicit Session(Document document = {});

  History history;
  DocumentFile file;
  Backup backup;
  Selection selection;
  NextClick next;
  Nudging nudging;
  std::vector<std::unique_ptr<Tool>>
      tools;  // by row of App::tools; with what each is in the midst of
  std::optional<NewOutline> new_outline;
  std::optional<Proposal> proposal;
  Bend bend;
  Rivals rivals;
  Naming naming;
  SideDrag side_drag;
  bool notes_shown = false;
  float notes_scroll = 0;             // points
  std::set<int> notes_unfolded;       // drawings of notes that show what follows from them
  std::optional<int> moving_drawing;  // dragged along the strip
  std::set<int> missing_seen;         // drawings whose missing parts need no more words (tablets)
  std::shared_ptr<BuiltModel> built;
  Live live;
  std::optional<RunningJob> job;
  Playback playback;
  std::optional<DroppedMotion> dropped;
  PendingExport export_wish;
  // Where each contour of a frame crosses itself; and per frame and joint: inside_other_parts.
  mutable Derived<std::vector<std::optional<Vec2>>, int> crossings;
  mutable Derived<std::vector<std::vector<bool>>> insides;
  mutable Derived<std::vector<double>> offered_scales;                 // per frame
  mutable Derived<std::vector<int>, std::vector<int>> offered_splits;  // by the joints looked at
  std::optional<Vec2> menu_over;  // the drawing's pixel that the menu was opened over

  // No other session's: what was begun for one document and comes late is not taken by the next.
  long id() const { return id_; }
  const Document& document() const { return history.now(); }
  bool has_frame() const { return selection.frame < int(document().frames.size()); }
  const Frame& frame() const { return document().frames[std::size_t(selection.frame)]; }
  // Another drawing comes into view: what was chosen of the last one is let go.
  void show_frame(int frame);
  // All that are chosen; empty: none.
  ContourSet chosen_outlines() const;
  void choose_outlines(const ContourSet& which);
  bool unsaved() const { return new_outline || history.revision() != file.saved; }
  // The document is no longer as the model was made from it, or there is none.
  bool stale() const { return !built || !built->fresh; }
  // The document is as the model was made from it, and no other pose stands beside: what fits is
  // told of the poses that the model was made at, also where the person didn't keep them.
  bool as_built() const { return built && built->fresh && !proposal; }

  // The next state of the document, by its undo name.
  void commit(std::string undo_name, Document next);
  // The same for a gesture, from press to release: its first change is a step of undo, which the
  // others amend. A gesture goes on until another one begins, or something is undone.
  long begin_gesture();
  bool goes_on(long gesture) const { return gesture == gesture_; }
  void change(const std::string& undo_name, Document next);
  // What follows amends the step committed last.
  void go_on_amending() { gesture_moved_ = true; }
  // The gesture was meant otherwise: the document is as before.
  void drop_gesture();
  // An outline that waits, if one does, is its part's. What reads the document as a whole, a job or
  // a file, would lose it otherwise.
  void keep_new_outline();
  // An outline that waits to be kept is the last thing that was done: undo takes that back first.
  bool can_undo() const { return new_outline || history.can_undo(); }
  bool can_redo() const { return brings_back_outline() || history.can_redo(); }
  std::string undo_name() const;
  std::string redo_name() const;
  void undo();
  void redo();
  // Keeps what is chosen within the document, and the model's clips as the document has them.
  void settle();
  void follow_document();

 private:
  bool brings_back_outline() const;
  // Undone before it was kept, with the state that it was drawn over.
  struct TakenBack {
    NewOutline outline;
    std::shared_ptr<const Document> over;
  };
  std::optional<TakenBack> taken_back_;
  long id_ = 0;
  long gesture_ = 0;
  bool gesture_moved_ = false;
};

}  // namespace artisketch
