#include "script.h"

#include <cstdio>
#include <iostream>
#include <sstream>
#include <thread>

#include "editor/introspection.h"

namespace artisketch {
namespace {

Json answer_to(const std::string& question, const Editor& editor) {
  std::istringstream words(question);
  std::string verb;
  words >> verb;
  if (verb == "widgets") return widgets_json(editor);
  if (verb == "state") return state_json(editor);
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
  constexpr int kFrames = 3;  // as the window draws them after an event
  {
    const std::lock_guard lock(questions_->mutex);
    for (std::string& line : questions_->lines)
      waiting_.push_back({std::move(line), frame_ + kFrames});
    questions_->lines.clear();
  }
  for (; !waiting_.empty() && waiting_.front().due <= frame_; waiting_.pop_front()) {
    const std::string& question = waiting_.front().question;
    if (question == "quit") return true;
    std::printf("%s\n", answer_to(question, editor).dump().c_str());
    std::fflush(stdout);
  }
  return false;
}

}  // namespace artisketch
