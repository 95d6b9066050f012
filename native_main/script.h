// Answers on standard output, a JSON value a line, to questions on standard input, so that a test
// finds its way through the real window and moves the real pointer there:
//
//   widgets          [{label, x, y, width, height, enabled, active}], in points of the window
//   state            editor/introspection.h
//   project F X Y    [x, y]: where pixel (X, Y) of drawing F stands in the window; null where it
//                    isn't shown
//   quit             leaves without a question
#pragma once

#include <deque>
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
  // A frame has been drawn. Questions wait for three: what came before them acts in the first,
  // shows in the next, and hovers in the last.
  void drawn() { ++frame_; }
  bool waits() const { return !waiting_.empty(); }  // for frames
  // Answers what was asked long enough ago; true once the asker wants to quit.
  bool answer(const Editor& editor);

 private:
  struct Questions {
    std::mutex mutex;
    std::vector<std::string> lines;
  };
  struct Waiting {
    std::string question;
    int due = 0;  // frame
  };
  std::shared_ptr<Questions> questions_;  // shared with the reading thread, which may outlive this
  std::deque<Waiting> waiting_;
  int frame_ = 0;
};

}  // namespace artisketch
