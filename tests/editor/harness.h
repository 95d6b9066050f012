// The editor without a window: a test moves the pointer, types, answers dialogs, lets jobs run and
// time pass, and reads back the document, what undo would take back, the controls and what is said.
//
//   Harness h;
//   h.open_example("hero");
//   h.click("Pose mode");
//   h.drag(h.middle("Joint Hand L"), {20, 0});
//   EXPECT_EQ(h.state().undo, "Bend Forearm L");
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <imgui.h>

#include "app/job.h"
#include "editor/editor.h"
#include "editor/pictures/graphics.h"

namespace artisketch {

// ---------------------------------------------------------------- what the editor stands on

// Files in memory; dialogs answered as the test says.
class MemoryPlatform : public Platform {
 public:
  bool dialogs = true;
  std::deque<Result<std::vector<NamedBytes>>>
      to_open;                               // answers of coming dialogs; none: cancelled
  std::vector<Kind> asked;                   // that dialogs asked for
  std::map<std::string, std::string> files;  // by place: what was saved
  std::optional<Error> no_saving;            // why nothing can be saved
  std::vector<Recent> recent;
  std::map<std::string, std::string> kept;  // store() and load()
  std::vector<std::string> example_names;   // of assets/examples and gallery; the first greets
  bool with_models = true;                  // the examples come with models
  std::optional<Error> no_example;          // why an example can't be loaded
  std::string title;
  bool unsaved_shown = false;
  bool dark = true, mac = false;
  bool guide = true;  // comes with the program
  int guide_shown = 0;
  std::string speaks = "en";  // the system
  double clock = 100;         // seconds

  bool has_dialogs() override { return dialogs; }
  void open_files(Kind kind, Opened then) override;
  void save_file(const std::string& name, const std::string& place, std::string bytes,
                 std::function<void(Result<Saved>)> then) override;
  std::vector<Recent> recents() override { return recent; }
  void open_recent(const std::string& place, Opened then) override;
  void store(const std::string& key, std::string bytes) override;
  void load(const std::string& key, std::function<void(std::string)> then) override;
  std::vector<ExampleCard> examples() override;
  void load_example(const std::string& name, std::function<void(Result<Example>)> then) override;
  void load_example_picture(const std::string& name,
                            std::function<void(std::string)> then) override;
  std::string language() override { return speaks; }
  void load_words(const std::string& code, std::function<void(std::string)> then) override;
  void set_title(const std::string& words, bool unsaved) override;
  bool has_guide() override { return guide; }
  void show_guide() override { ++guide_shown; }
  bool prefers_dark() override { return dark; }
  int default_grid() override { return 24; }
  void request_frame() override {}
  bool mac_keys() override { return mac; }
  double now() override { return clock; }
};

// Jobs on this thread: each runs when its outcome is asked for, once in a process for each request,
// on a coarse grid. A test may hold them, and say how they end.
class StepJobs : public Jobs {
 public:
  bool held = false;                      // the job under way stays so
  std::optional<Result<JobResult>> ends;  // so the next job ends that isn't for live parts
  Progress shown;
  std::vector<JobRequest::Kind> started;

  void start(JobRequest request) override;
  bool busy() const override { return request_.has_value(); }
  Progress progress() const override { return shown; }
  std::optional<Result<JobResult>> poll() override;
  void cancel() override;

 private:
  std::optional<JobRequest> request_;
  bool cancelled_ = false;
};

// A card that paints nothing, and knows what it holds.
class NoGraphics : public Graphics {
 public:
  std::set<unsigned> textures;  // that are there
  int meshes = 0, painted = 0;  // there now; pictures so far
  MeshLook look;                // painted last

  unsigned add_texture(int width, int height, std::span<const std::uint8_t> rgba,
                       Beyond edge) override;
  void remove_texture(unsigned texture) override;
  std::unique_ptr<CardMesh> make_mesh() override;
  std::unique_ptr<CardPicture> make_picture() override;

 private:
  class Mesh;
  class Picture;
  unsigned add();
  unsigned last_ = 1;
};

// ---------------------------------------------------------------- the person

class Harness {
 public:
  struct Size {
    float width = 0, height = 0;  // points
  };
  // The first of the examples greets; `kept` is what was stored before; the system speaks
  // `language`.
  explicit Harness(std::vector<std::string> examples = {},
                   std::map<std::string, std::string> kept = {}, Size size = {1440, 900},
                   const std::string& language = "en");
  ~Harness();
  Harness(const Harness&) = delete;
  Harness& operator=(const Harness&) = delete;

  MemoryPlatform platform;
  StepJobs jobs;
  NoGraphics graphics;
  Size size;
  float pixel_ratio = 1;

  Editor& editor() { return *editor_; }
  // Draws a frame. Fails the test where what is drawn is broken: indices beyond their vertices,
  // places that aren't numbers, textures that aren't there.
  void frame(double seconds = 1.0 / 60);
  void frames(int count) {
    while (count-- > 0) frame();
  }
  void wait(double seconds);  // that pass, ten frames a second
  void settle();              // until no job is under way

  // Files.
  void open(const std::string& name, std::string bytes);  // dropped onto the window
  void open_example(const std::string& name);             // as a document, without a model
  void start_over();                                      // a new document, from the welcome

  // The pointer, in points.
  void point_at(Vec2 place);
  void press(ImGuiMouseButton button = ImGuiMouseButton_Left);
  void release(ImGuiMouseButton button = ImGuiMouseButton_Left);
  void click(Vec2 place, ImGuiMouseButton button = ImGuiMouseButton_Left);
  void click(const std::string& label);  // of a control that is enabled
  void double_click(Vec2 place);
  void right_click(const std::string& label);
  void drag(Vec2 from, Vec2 by, int steps = 6);
  void draw(const std::vector<Vec2>& places);  // from press to release
  void wheel(float notches);
  void touch(const Fingers& fingers);  // for one frame

  // The keyboard: with modifiers, ImGuiMod_Ctrl | ImGuiMod_Shift.
  void key(ImGuiKey key, int modifiers = 0);
  void keys_at_once(const std::vector<ImGuiKey>& keys);  // pressed and let go before the next frame
  void hold(ImGuiKey key, bool down);
  void type(const std::string& text);

  // Reading.
  EditorState state() const { return editor_->state(); }
  const Document& document() const { return editor_->document(); }
  bool says(const std::string& words) const;             // in a toast that is in view
  std::string said() const;                              // all of them, a line each
  const Widget* find(const std::string& label) const;    // null where there is none
  const Widget& widget(const std::string& label) const;  // fails the test where there is none
  Vec2 middle(const std::string& label) const;
  bool enabled(const std::string& label) const { return widget(label).enabled; }
  bool active(const std::string& label) const { return widget(label).active; }
  Vec2 on_screen(double x, double y) const;  // a pixel of the drawing in view
  std::vector<std::string> labels() const;
  // Of the pictures in a panel of that name; nothing where it shows none.
  std::optional<double> opacity(const std::string& panel) const;

 private:
  std::unique_ptr<Editor> editor_;
  Fingers fingers_;  // of the next frame
  ImGuiContext* context_ = nullptr;
};

// assets/examples/NAME, its drawings inside; a model of it, coarse, made once in a process.
std::string example_document(const std::string& name);
std::string example_model(const std::string& name);
inline const std::vector<std::string> kExamples = {"hero", "fox", "robot", "heart", "circles"};

}  // namespace artisketch
