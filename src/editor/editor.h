// The editor: one document, one character. The window or the page calls frame() between
// ImGui::NewFrame and ImGui::Render; everything else follows from the person's input.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "base/types.h"
#include "document/document.h"
#include "editor/session/platform.h"
#include "editor/ui/touch.h"
#include "editor/ui/widget.h"

namespace artisketch {

class Graphics;
class Jobs;

// What scripts may count on (page: artisketch.state()).
struct EditorState {
  std::string mode;  // "outline", "skeleton", "pose", "result", "welcome"
  bool busy = false;
  std::string stage;    // of the job under way
  double progress = 0;  // 0 … 1
  int frame = 0, frames = 0;
  std::vector<std::string> joints;
  bool has_model = false;
  int live_parts = 0;       // of the model as it is edited
  long revision = 0;        // names the state of the document
  long live_revision = -1;  // that the live parts, as they were drawn last, were made of
  bool can_undo = false;
  std::string undo;                   // what undo would take back: "Bend Forearm L"
  std::string message;                // the toast shown last
  std::vector<std::string> messages;  // the toasts in view
};

class Editor {
 public:
  // These outlive it.
  Editor(Platform& platform, Jobs& jobs, Graphics& graphics);
  ~Editor();

  // Opens a document, or adds drawings to the one that is open, by what the bytes are; says in a
  // toast what failed.
  void open(Result<std::vector<NamedBytes>> files);

  // The person wants to leave: true where nothing would be lost, else the editor asks, and closed()
  // becomes true once that is settled.
  bool close();
  bool closed() const;

  // What several fingers did since the last frame.
  void touch(const Fingers& fingers);

  // What can be asked for by name: "undo", "outline.draw". It is done at the end of the next frame,
  // as by its key: what can't be done says what it lacks.
  std::vector<std::string> commands() const;
  void ask(const std::string& command);

  // Draws the whole window; size in points.
  void frame(float width, float height, float pixel_ratio);
  // Seconds until another frame is due without input: nothing moves, nothing is drawn. A job's
  // progress is drawn seldom enough to leave the processor to the job.
  double next_frame_in() const;
  bool wants_frame() const { return next_frame_in() <= 0; }

  const std::vector<Widget>& widgets() const;
  EditorState state() const;
  // Where a sketch's pixel stands in the window, in points; nothing where that frame isn't shown.
  std::optional<Vec2> project(int frame, double x, double y) const;
  bool unsaved() const;
  const Document& document() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace artisketch
