#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include "app/job_thread.h"
#include "desktop.h"
#include "editor/editor.h"
#include "editor/gl/window.h"
#include "script.h"

namespace {

constexpr double kRest = 0.5;  // seconds between looks round while nothing moves

int run(const char* program, const char* document, bool scripted) {
  using namespace artisketch;
  Result<Window> window = Window::open("ArtiSketch", 1600, 1000);
  if (!window) {
    std::fprintf(stderr, "%s\n", window.error().text().c_str());
    return 1;
  }
  std::error_code ignored;
  const std::filesystem::path self = std::filesystem::canonical("/proc/self/exe", ignored);
  const std::filesystem::path folder = (self.empty() ? program : self).parent_path();
  std::filesystem::path assets = folder;  // where it was built
  if (!std::filesystem::is_directory(assets / "languages", ignored))
    assets = folder.parent_path() / "share/artisketch";
  Desktop desktop(assets);
  desktop.attach(window->handle());
  ThreadJobs jobs([&desktop] { desktop.request_frame(); });
  Editor editor(desktop, jobs, window->graphics());

  const auto open = [&](const std::string& path) {
    desktop.open_recent(
        path, [&](Result<std::vector<NamedBytes>> files) { editor.open(std::move(files)); });
  };
  window->on_drop = open;
  if (document) open(document);
  std::optional<Script> script;
  if (scripted) script.emplace(desktop);

  int due = 3;  // frames: widgets settle and hover shows in the frames after an event
  bool closing = false;
  while (!closing) {
    const double rest = due > 0 ? 0 : std::clamp(editor.next_frame_in(), 0.0, kRest);
    if (!window->take_events(rest)) closing = editor.close();
    desktop.deliver();
    if (window->stirred()) due = 3;
    if (due > 0 || editor.wants_frame()) {
      window->draw(editor);
      if (script) script->drawn();
      --due;
    }
    if (editor.closed()) closing = true;
    if (script) closing = script->answer(editor) || closing;
    if (script && script->waits()) due = std::max(due, 1);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const char* document = nullptr;
  bool scripted = false, bad = false;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    if (argument == "--script")
      scripted = true;
    else if (!document && !argument.starts_with("--"))
      document = argv[i];
    else
      bad = true;
  }
  if (bad) {
    std::fprintf(stderr,
                 "usage: artisketch-editor [--script] [DOCUMENT]\n"
                 "  --script  answers questions on standard input (native_main/script.h)\n");
    return 2;
  }
  return run(argv[0], document, scripted);
}
