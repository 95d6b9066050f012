#include "script.h"

#include <cstdio>
#include <iostream>
#include <sstream>
#include <thread>

#include "editor/editor.h"
#include "files/json.h"

namespace artisketch {
namespace {

Json widgets(const Editor& editor) {
  Json all = Json::array();
  for (const Widget& w : editor.widgets())
    all.push_back({{"label", w.label},
                   {"x", w.x},
                   {"y", w.y},
                   {"width", w.width},
                   {"height", w.height},
                   {"enabled", w.enabled},
                   {"active", w.active}});
  return all;
}

Json state(const Editor& editor) {
  const EditorState s = editor.state();
  return {{"mode", s.mode},
          {"busy", s.busy},
          {"stage", s.stage},
          {"progress", s.progress},
          {"frame", s.frame},
          {"frames", s.frames},
          {"joints", s.joints},
          {"hasModel", s.has_model},
          {"canUndo", s.can_undo},
          {"message", s.message},
          {"unsaved", editor.unsaved()}};
}

Json answer_to(const std::string& question, const Editor& editor) {
  std::istringstream words(question);
  std::string verb;
  words >> verb;
  if (verb == "widgets") return widgets(editor);
  if (verb == "state") return state(editor);
  int frame = 0;
  double x = 0, y = 0;
  if (verb == "project" && words >> frame >> x >> y) {
    const std::optional<Vec2> place = editor.project(frame, x, y);
    return place ? Json{place->x(), place->y()} : Json(nullptr);
  }
  return {{"error", "no such question"}};
}

}  // namespace

Script::Script(Platform& platform) : questions_(std::make_shared<Questions>()) {
  std::thread([questions = questions_, &platform] {
    for (std::string line; std::getline(std::cin, line);) {
      const std::lock_guard lock(questions->mutex);
      questions->lines.push_back(std::move(line));
      platform.request_frame();
    }
  }).detach();
}

bool Script::answer(const Editor& editor) {
  std::vector<std::string> lines;
  {
    const std::lock_guard lock(questions_->mutex);
    lines.swap(questions_->lines);
  }
  for (const std::string& line : lines) {
    if (line == "quit") return true;
    std::printf("%s\n", answer_to(line, editor).dump().c_str());
    std::fflush(stdout);
  }
  return false;
}

}  // namespace artisketch
