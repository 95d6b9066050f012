// Fingers on the screen. One is the pointer; two pan and zoom; a tap of two undoes, of three
// redoes. While a pen is near, the pen draws: a finger alone pans too, and its tap is a click.
#pragma once

#include <map>

#include <imgui.h>

namespace artisketch {

// What fingers that aren't the pointer did since it was asked last.
struct Fingers {
  int count = 0;       // on the screen; 0: none, or one that is the pointer
  ImVec2 at, moved;    // their middle and its way; points
  float spread = 1;    // factor of their distance from the middle
  bool began = false;  // the pointer's finger became one of these: what it began is to be dropped
  int tapped = 0;      // fingers of a tap that just ended
};

class Touch {
 public:
  // A finger came down, moved or left; points, seconds. down(): whether the finger that was the
  // pointer no longer is.
  bool down(long long finger, ImVec2 at, double time);
  void move(long long finger, ImVec2 at);
  void up(long long finger, double time);

  // From the next touch on.
  void pen_near(bool near) { pen_near_ = near; }

  // Whether a finger may be the pointer now.
  bool points() const { return fingers_.empty() ? !pen_near_ : !several_; }
  Fingers take();

 private:
  void measure(ImVec2& middle, float& spread) const;
  void begin_anew();  // whenever the fingers are others

  std::map<long long, ImVec2> fingers_;
  Fingers since_;
  ImVec2 middle_;  // when it was asked last
  float spread_ = 0;
  bool pen_near_ = false;
  bool several_ = false;  // from the second finger on, beside a pen the first, until the last left
  int most_ = 0;          // fingers at once in this touch
  double began_ = 0;
  float way_ = 0;  // that they moved, points
};

}  // namespace artisketch
