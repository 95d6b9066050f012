// The page's module: the editor in a canvas. page.js calls the functions below, and nothing here
// runs unless it does: it asks for a frame when something came in or moves.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <SDL.h>
#include <emscripten.h>
#include <imgui.h>

#include "app/job_worker.h"
#include "browser.h"
#include "editor/gl/window.h"
#include "editor/introspection.h"

// clang-format off
EM_JS(void, host_post, (const char* bytes, std::size_t size), {
  Module.host.post(HEAPU8.slice(bytes, bytes + size));
});
EM_JS(void, host_restart, (), { Module.host.restart(); });
EM_JS(void, host_copy, (const char* text), { Module.host.copy(UTF8ToString(text)); });
// clang-format on

namespace artisketch {
namespace {

struct Page {
  Browser browser;
  WorkerJobs jobs{{[](const std::string& bytes) { host_post(bytes.data(), bytes.size()); },
                   [] { host_restart(); }}};
  Window window;
  Editor editor{browser, jobs, window.graphics()};
  std::vector<NamedBytes> files;  // on their way in
  int due = 3;  // frames: widgets settle and hover fades in the frames after something came in
  std::string answer;  // text that page.js reads before it calls again

  Page(Window opened, std::vector<ExampleCard> examples, std::vector<Platform::Recent> recents,
       std::string language)
      : browser(std::move(examples), std::move(recents), std::move(language)),
        window(std::move(opened)) {}
};

Page* page = nullptr;  // from page_start() on, for as long as the tab lives

std::string text(const char* bytes, std::size_t size) {
  return {bytes, size};
}

const char* answered(const Json& json) {
  page->answer = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return page->answer.c_str();
}

}  // namespace
}  // namespace artisketch

using namespace artisketch;

extern "C" {

// Opens the editor in the canvas, its size in CSS pixels; what is wrong in words, or null.
// known: JSON {examples: [[name, drawings, shelf]…], recents: [[name, place]…], language: "de-AT"}.
EMSCRIPTEN_KEEPALIVE const char* page_start(int width, int height, const char* known) {
  SDL_SetHint(SDL_HINT_EMSCRIPTEN_KEYBOARD_ELEMENT, "#canvas");
  static std::string fault;
  Result<Window> window = Window::open("ArtiSketch", width, height);
  if (!window) {
    fault = window.error().text();
    return fault.c_str();
  }
  const Json listed = Json::parse(known);
  std::vector<Platform::Recent> recents;
  for (const Json& recent : listed["recents"]) recents.push_back({recent[0], recent[1]});
  std::vector<ExampleCard> examples;
  for (const Json& example : listed["examples"])
    examples.push_back({example[0], example[1], ExampleCard::Shelf(int(example[2]))});
  window->lasting = true;  // page.js asks for such a canvas
  page = new Page(std::move(*window), std::move(examples), std::move(recents), listed["language"]);
  ImGui::GetIO().SetClipboardTextFn = [](void*, const char* text) {
    SDL_SetClipboardText(text);
    host_copy(text);
  };
  return nullptr;
}

// Draws if there is anything to draw; seconds until another frame is due.
EMSCRIPTEN_KEEPALIVE double page_frame() {
  constexpr double kEarly = 0.004;  // seconds: the screen's frames are not as even as a clock
  page->window.take_events(0);
  if (page->window.stirred()) page->due = 3;
  if (page->due > 0 || page->editor.next_frame_in() < kEarly) {
    page->window.draw(page->editor);
    page->due = std::max(page->due - 1, 0);
  }
  return page->due > 0 ? 0 : std::max(0.0, page->editor.next_frame_in());
}

// A pen came near the screen, or left.
EMSCRIPTEN_KEEPALIVE void page_pen(bool near) {
  page->window.pen_near(near);
}

// The touch of that identifier is the pen's tip.
EMSCRIPTEN_KEEPALIVE void page_pen_touches(int identifier) {
  page->window.pen_touches(identifier);
}

EMSCRIPTEN_KEEPALIVE void page_stir() {
  page->due = 3;
}

// Files on their way in, one by one, then the question that they answer; 0: they were dropped. With
// what was wrong with others.
EMSCRIPTEN_KEEPALIVE void page_file(const char* name, const char* place, const char* bytes,
                                    std::size_t size) {
  page->files.push_back({name, text(bytes, size), place});
}

EMSCRIPTEN_KEEPALIVE void page_opened(int question, const char* fault) {
  const auto answer = [question](Result<std::vector<NamedBytes>> files) {
    if (question)
      page->browser.opened(question, std::move(files));
    else
      page->editor.open(std::move(files));
  };
  std::vector<NamedBytes> files = std::exchange(page->files, {});
  if (!*fault) {
    answer(std::move(files));
  } else if (files.empty()) {
    answer(io_error(fault));
  } else {
    answer(std::move(files));
    page->editor.open(io_error(fault));
  }
  page_stir();
}

EMSCRIPTEN_KEEPALIVE void page_saved(int question, const char* name, const char* place,
                                     const char* fault) {
  if (*fault)
    page->browser.saved(question, io_error(fault));
  else
    page->browser.saved(question, Platform::Saved{name, place});
  page_stir();
}

EMSCRIPTEN_KEEPALIVE void page_loaded(int question, const char* bytes, std::size_t size) {
  page->browser.loaded(question, text(bytes, size));
  page_stir();
}

EMSCRIPTEN_KEEPALIVE void page_example(int question, const char* document,
                                       std::size_t document_size, const char* glb,
                                       std::size_t glb_size, const char* fault) {
  if (*fault)
    page->browser.example_loaded(question, io_error(fault));
  else
    page->browser.example_loaded(question,
                                 Example{text(document, document_size), text(glb, glb_size)});
  page_stir();
}

EMSCRIPTEN_KEEPALIVE void page_progress(const char* bytes, std::size_t size) {
  page->jobs.progressed({bytes, size});
  page_stir();
}

EMSCRIPTEN_KEEPALIVE void page_outcome(const char* bytes, std::size_t size) {
  page->jobs.finished({bytes, size});
  page_stir();
}

EMSCRIPTEN_KEEPALIVE void page_died(bool of_memory, const char* why) {
  page->jobs.died(of_memory, why);
  page_stir();
}

// Text from the browser's clipboard: ImGui asks SDL for it when Ctrl+V comes in.
EMSCRIPTEN_KEEPALIVE void page_paste(const char* text) {
  SDL_SetClipboardText(text);
  ImGuiIO& io = ImGui::GetIO();
  const ImGuiKey modifier = io.ConfigMacOSXBehaviors ? ImGuiMod_Super : ImGuiMod_Ctrl;
  for (const bool down : {true, false}) {
    io.AddKeyEvent(modifier, down);
    io.AddKeyEvent(ImGuiKey_V, down);
  }
  page_stir();
}

EMSCRIPTEN_KEEPALIVE const char* page_widgets() {
  return answered(widgets_json(page->editor));
}

EMSCRIPTEN_KEEPALIVE const char* page_state() {
  return answered(state_json(page->editor));
}

EMSCRIPTEN_KEEPALIVE const char* page_project(int frame, double x, double y) {
  const std::optional<Vec2> at = page->editor.project(frame, x, y);
  return answered(at ? Json{{"x", at->x()}, {"y", at->y()}} : Json(nullptr));
}

}  // extern "C"
