// What every panel, command and tool is handed: the document being worked on, how it is looked at,
// and what serves both.
#pragma once

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "editor/pictures/drawings.h"
#include "editor/session/command.h"
#include "editor/session/picking.h"
#include "editor/session/platform.h"
#include "editor/session/session.h"
#include "editor/session/tool.h"
#include "editor/session/view.h"
#include "editor/ui/touch.h"

namespace artisketch {

// What outlives every document.
struct Services {
  Platform& platform;
  Jobs& jobs;
  Drawings drawings;
  std::vector<ExampleCard> examples;                    // of the first screen
  std::map<std::string, std::string> example_pictures;  // keys into `drawings`, once asked for
  // The model over the drawing, from all sides, and beside the drawing.
  RenderTarget over_sketch, model_seen, model_beside;
  double now = 0;                       // seconds, of the frame under way
  int frames = 0;                       // drawn so far
  std::vector<LooseOutline> clipboard;  // outlines, for any drawing of any document
  long openings = 0;  // documents opened or asked for: what comes late of an older one is dropped
  bool hurried = false;  // something is dragged, and the machine paints too slowly to follow

  Services(Platform& platform, Jobs& jobs, Graphics& graphics)
      : platform(platform),
        jobs(jobs),
        drawings(graphics),
        over_sketch(graphics),
        model_seen(graphics),
        model_beside(graphics) {}
};

inline constexpr double kToastSeconds = 6;
struct Toast {
  std::string words, action, other_action;
  std::function<void()> act, other_act;
  bool error = false;     // stays until it is dismissed
  bool outlives = false;  // its action is not about the document that is open
  double since = -1;      // set when it is shown first
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
  std::string path;            // being typed
  std::string field = "Path";  // what that is
  std::function<void(const std::string&)> with_path;
};

struct App {
  Services services;
  View view;
  Session session;
  std::span<const ToolRow> tools;
  std::vector<Command> commands;        // all of them, those that take up a tool among them
  std::vector<std::string_view> asked;  // by this frame's controls and keys
  std::vector<Toast> toasts;
  std::optional<Question> question;
  std::deque<Picking> picking;  // the first is shown
  Fingers fingers;
  bool closed = false;  // the person left

  App(Platform& platform, Jobs& jobs, Graphics& graphics, std::span<const ToolRow> tools,
      std::vector<Command> commands);

  const Document& document() const { return session.document(); }
  bool has_frame() const { return session.has_frame(); }
  const Frame& frame() const { return session.frame(); }

  // Another document in place of this one. What the old one waited for is not taken any more.
  void open(Document document);

  void ask(std::string_view command) { asked.push_back(command); }
  // What was said already is said once, anew.
  void say(Toast toast);

  // The tool in hand, and another one in its place.
  Tool& tool() { return *session.tools[view.armed[std::size_t(view.mode)]]; }
  const Tool& tool() const { return *session.tools[view.armed[std::size_t(view.mode)]]; }
  bool in_hand(const ToolRow& row) const {
    return &row == &tools[view.armed[std::size_t(row.mode)]];
  }
  void take_up(const ToolRow& row);
  void take_up(Mode mode, std::string_view id);

  // What the pointer has begun was meant otherwise: the document is as before.
  void drop_gesture();

  // A job that the person waits for is under way.
  bool busy() const { return services.jobs.busy() && session.job && session.job->awaited(); }

  // The model in view: the whole one, or while it is out of date, or not there yet, its parts.
  // Null: neither.
  const BuiltModel* shown() const;
  bool shows_parts() const { return shown() && shown() != session.built.get(); }
  // The pose that the model shows: of the clip, the person's, or the drawing's.
  Pose shown_pose() const;
  Vec3 shown_footing() const;
  // Poses of the drawing as the canvas shows them: the person's, or the proposal's.
  Pose drawn_pose() const;
  bool changing_pose() const;  // the proposal's animation is under way

 private:
  void lay_out_tools();
};

}  // namespace artisketch
