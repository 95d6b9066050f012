// Answers on standard output, a JSON value a line, to questions on standard input, so that a test
// finds its way through the real window and moves the real pointer there:
//
//   widgets          [{label, x, y, width, height, enabled, active}], in points of the window
//   state            editor/introspection.h
//   project F X Y    [x, y]: where pixel (X, Y) of drawing F stands in the window; null where it
//                    isn't shown
//   quit             leaves without a question
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace artisketch {

class Editor;
class Platform;

class Script {
 public:
  explicit Script(Platform& platform);  // woken when a question came in
  // Answers what was asked since; true once the asker wants to quit.
  bool answer(const Editor& editor);

 private:
  struct Questions {
    std::mutex mutex;
    std::vector<std::string> lines;
  };
  std::shared_ptr<Questions> questions_;  // shared with the reading thread, which may outlive this
};

}  // namespace artisketch
