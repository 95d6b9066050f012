#include "editor/gl/window.h"

#include <algorithm>
#include <cfloat>
#include <utility>

#include <GLES3/gl3.h>
#include <SDL.h>
#include <imgui.h>
#include <imgui_impl_sdl2.h>
#include <imgui_internal.h>

#include "editor/editor.h"
#include "editor/ui/fonts.h"
#include "editor/ui/keys.h"
#include "editor/ui/theme.h"

namespace artisketch {

Result<Window> Window::open(const std::string& title, int width, int height) {
  const auto failed = [](const char* what) { return io_error(std::string(what) + SDL_GetError()); };
  SDL_SetHint(SDL_HINT_MOUSE_FOCUS_CLICKTHROUGH, "1");
  SDL_SetHint(SDL_HINT_TOUCH_MOUSE_EVENTS, "1");
#ifdef SDL_HINT_IME_SHOW_UI
  SDL_SetHint(SDL_HINT_IME_SHOW_UI, "1");
#endif
  if (SDL_Init(SDL_INIT_VIDEO | SDL_INIT_TIMER) != 0) return failed("There is no screen: ");
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_PROFILE_MASK, SDL_GL_CONTEXT_PROFILE_ES);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MAJOR_VERSION, 3);
  SDL_GL_SetAttribute(SDL_GL_CONTEXT_MINOR_VERSION, 0);
  SDL_GL_SetAttribute(SDL_GL_DOUBLEBUFFER, 1);

  SDL_Rect screen;
  if (SDL_GetDisplayUsableBounds(0, &screen) == 0) {
    width = std::min(width, screen.w);
    height = std::min(height, screen.h);
  }
  Window window;
  window.window_ =
      SDL_CreateWindow(title.c_str(), SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, width, height,
                       SDL_WINDOW_OPENGL | SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI);
  if (!window.window_) return failed("The window could not be opened: ");
  window.context_ = SDL_GL_CreateContext(window.window_);
  if (!window.context_) return failed("OpenGL ES 3 could not be started: ");
  SDL_GL_SetSwapInterval(1);
  window.graphics_ = std::make_unique<OpenGl>();

  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  io.MouseDragThreshold = 4;
  ImGui_ImplSDL2_InitForOpenGL(window.window_, window.context_);
  return window;
}

Window::Window(Window&& other) noexcept
    : on_drop(std::move(other.on_drop)),
      lasting(other.lasting),
      window_(std::exchange(other.window_, nullptr)),
      context_(std::exchange(other.context_, nullptr)),
      stirred_(other.stirred_),
      graphics_(std::move(other.graphics_)),
      damage_(std::move(other.damage_)),
      painter_(std::move(other.painter_)),
      pointer_(other.pointer_) {}

Window::~Window() {
  if (context_ && ImGui::GetCurrentContext()) {
    painter_.release();
    graphics_.reset();
    ImGui_ImplSDL2_Shutdown();
    ImGui::DestroyContext();
  }
  if (context_) SDL_GL_DeleteContext(context_);
  if (window_) SDL_DestroyWindow(window_);
  if (window_) SDL_Quit();
}

bool Window::take_touch(const SDL_Event& event) {
  // A mouse that SDL makes of the first finger, or of a pen's tip.
  const bool motion = event.type == SDL_MOUSEMOTION,
             press = event.type == SDL_MOUSEBUTTONDOWN || event.type == SDL_MOUSEBUTTONUP;
  if ((motion && event.motion.which == SDL_TOUCH_MOUSEID) ||
      (press && event.button.which == SDL_TOUCH_MOUSEID))
    return touch_.points() || pen_;
  if (event.type != SDL_FINGERDOWN && event.type != SDL_FINGERMOTION && event.type != SDL_FINGERUP)
    return true;
  int width = 0, height = 0;
  SDL_GetWindowSize(window_, &width, &height);
  const SDL_TouchFingerEvent& finger = event.tfinger;
  if (pen_ == finger.fingerId) {  // it is the pointer, as a mouse
    if (event.type == SDL_FINGERUP) pen_.reset();
    return false;
  }
  const ImVec2 at{finger.x * float(width), finger.y * float(height)};
  const double time = finger.timestamp / 1000.0;
  if (event.type == SDL_FINGERMOTION) {
    touch_.move(finger.fingerId, at);
  } else if (event.type == SDL_FINGERUP) {
    touch_.up(finger.fingerId, time);
  } else {
    if (touch_.down(finger.fingerId, at, time)) {  // the pointer leaves without a click
      ImGui::GetIO().AddMousePosEvent(-FLT_MAX, -FLT_MAX);
      ImGui::GetIO().AddMouseButtonEvent(ImGuiMouseButton_Left, false);
      pointer_.reset();
    }
  }
  return false;
}

bool Window::take_events(double seconds) {
  SDL_Event event;
  bool open = true;
  int got = seconds > 0 ? SDL_WaitEventTimeout(&event, int(seconds * 1000)) : SDL_PollEvent(&event);
  for (; got; got = SDL_PollEvent(&event)) {
    stirred_ = true;
    if (!take_touch(event)) continue;
    ImGui_ImplSDL2_ProcessEvent(&event);
    if (event.type == SDL_QUIT) open = false;
    if (event.type == SDL_MOUSEMOTION) pointer_ = {float(event.motion.x), float(event.motion.y)};
    if (event.type == SDL_WINDOWEVENT && event.window.event == SDL_WINDOWEVENT_LEAVE)
      pointer_.reset();
    if (event.type == SDL_DROPFILE) {
      if (on_drop) on_drop(event.drop.file);
      SDL_free(event.drop.file);
    }
  }
  return open;
}

void Window::draw(Editor& editor) {
  int width = 0, height = 0, pixels_wide = 0, pixels_high = 0;
  SDL_GetWindowSize(window_, &width, &height);
  SDL_GL_GetDrawableSize(window_, &pixels_wide, &pixels_high);
  const float ratio = width > 0 ? float(pixels_wide) / float(width) : 1;
  bool afresh = !lasting || pixels_wide != pixels_wide_ || pixels_high != pixels_high_;
  pixels_wide_ = pixels_wide;
  pixels_high_ = pixels_high;
  if (fit_fonts(ratio)) {
    painter_.drop_fonts();
    afresh = true;
  }
  painter_.load_fonts();
  ImGui_ImplSDL2_NewFrame();
  // The back end asks SDL for the pointer on the whole screen, which goes stale on X servers that
  // send no raw events (VNC, Xvfb).
  if (pointer_) ImGui::GetIO().AddMousePosEvent(pointer_->first, pointer_->second);
  begin_frame();
  const Fingers fingers = touch_.take();
  if (fingers.tapped == 1) {  // beside a pen
    ImGuiIO& io = ImGui::GetIO();
    io.AddMousePosEvent(fingers.at.x, fingers.at.y);
    for (const bool down : {true, false}) io.AddMouseButtonEvent(ImGuiMouseButton_Left, down);
  }
  editor.touch(fingers);
  editor.frame(float(width), float(height), ratio);
  ImGui::Render();
  const ImVec4 ground = ImGui::ColorConvertU32ToFloat4(theme().panel);
  glClearColor(ground.x, ground.y, ground.z, 1);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, pixels_wide, pixels_high);
  ImDrawData& data = *ImGui::GetDrawData();
  const std::vector<Rect> changed = damage_.narrow(data, graphics_->take_painted(), afresh);
  glEnable(GL_SCISSOR_TEST);
  for (const Rect& r : changed) {
    // The pixels that Dear ImGui's renderer takes for such a rectangle.
    glScissor(int(r.x * ratio), int(float(pixels_high) - r.bottom() * ratio), int(r.w * ratio),
              int(r.h * ratio));
    glClear(GL_COLOR_BUFFER_BIT);
  }
  glDisable(GL_SCISSOR_TEST);
  if (!changed.empty()) {
    painter_.paint(data, pixels_wide, pixels_high);
    SDL_GL_SwapWindow(window_);
  }
  // Fast typing: a frame takes one key, and leaves the others for the next.
  stirred_ = !ImGui::GetCurrentContext()->InputEventsQueue.empty();
}

}  // namespace artisketch
