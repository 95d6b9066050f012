#include <cstdio>
#include <filesystem>
#include <string>
#include <thread>

#include "app/job_thread.h"
#include "desktop.h"
#include "editor/editor.h"
#include "editor/window.h"

namespace {

constexpr double kRest = 0.5;  // seconds between looks at the clock while nothing moves

int run(const char* program, const char* document) {
  using namespace artisketch;
  Result<Window> window = Window::open("ArtiSketch", 1600, 1000);
  if (!window) {
    std::fprintf(stderr, "%s\n", window.error().text().c_str());
    return 1;
  }
  std::error_code ignored;
  const std::filesystem::path self = std::filesystem::canonical("/proc/self/exe", ignored);
  Desktop desktop((self.empty() ? program : self).parent_path() / "examples");
  desktop.attach(window->handle());
  ThreadJobs jobs([&desktop] { desktop.request_frame(); });
  Editor editor(desktop, jobs);

  const auto open = [&](const std::string& path) {
    desktop.open_recent(
        path, [&](Result<std::vector<NamedBytes>> files) { editor.open(std::move(files)); });
  };
  window->on_drop = open;
  if (document) open(document);

  int due = 3;  // frames: widgets settle, tooltips appear and hover fades in the frames after
  bool closing = false;
  while (!closing) {
    const bool moving = due > 0 || editor.wants_frame();
    if (!window->take_events(moving ? 0 : kRest)) closing = editor.close();
    desktop.deliver();
    if (window->stirred()) due = 3;
    if (due > 0 || editor.wants_frame()) {
      window->draw(editor);
      --due;
    }
    if (editor.closed()) closing = true;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 2) {
    std::fprintf(stderr, "usage: artisketch-editor [DOCUMENT]\n");
    return 2;
  }
  return run(argv[0], argc == 2 ? argv[1] : nullptr);
}
