// An SDL window or the page's canvas with OpenGL ES 3 (WebGL2), and Dear ImGui in it.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "base/result.h"
#include "editor/gl/damage.h"
#include "editor/gl/list_painter.h"
#include "editor/gl/open_gl.h"
#include "editor/ui/touch.h"

struct SDL_Window;
union SDL_Event;

namespace artisketch {

class Editor;
struct NamedBytes;

class Window {
 public:
  // Size in points. Fails where there is no screen or no OpenGL ES 3.
  static Result<Window> open(const std::string& title, int width, int height);
  Window(Window&& other) noexcept;
  Window& operator=(Window&&) = delete;
  ~Window();

  // Takes what came in; waits for it up to `seconds`. False once the person closed the window.
  bool take_events(double seconds);
  // True if anything came in since the last draw.
  bool stirred() const { return stirred_; }
  void draw(Editor& editor);
  // What the editor paints with; for as long as the window is there.
  Graphics& graphics() { return *graphics_; }

  std::function<void(const std::string& path)> on_drop;  // of a file onto the window
  // A pen came near or left; and the finger that SDL takes its tip for.
  void pen_near(bool near) { touch_.pen_near(near); }
  void pen_touches(long long finger) { pen_ = finger; }
  // Whether what was drawn stays until it is drawn over: then only what changed is.
  bool lasting = false;
  SDL_Window* handle() const { return window_; }

 private:
  Window() = default;
  // Whether the pointer is to know of it.
  bool take_touch(const SDL_Event& event);
  SDL_Window* window_ = nullptr;
  void* context_ = nullptr;
  bool stirred_ = true;
  std::unique_ptr<OpenGl> graphics_;
  Damage damage_;
  ListPainter painter_;
  int pixels_wide_ = 0, pixels_high_ = 0;  // of the frame drawn last
  Touch touch_;
  std::optional<long long> pen_;
  std::optional<std::pair<float, float>> pointer_;  // where it is over the window
};

}  // namespace artisketch
