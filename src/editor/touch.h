// Fingers on the screen. One is the pointer; two pan and zoom; a tap of two undoes, of three
// redoes.
#pragma once

#include <map>

#include <imgui.h>

namespace artisketch {

// What two or more fingers did since it was asked last.
struct Fingers {
  int count = 0;       // on the screen; 0: at most one
  ImVec2 at, moved;    // their middle and its way; points
  float spread = 1;    // factor of their distance from the middle
  bool began = false;  // a second finger came down: what the first began is to be dropped
  int tapped = 0;      // fingers of a tap that just ended
};

class Touch {
 public:
  // A finger came down, moved or left; points, seconds.
  void down(long long finger, ImVec2 at, double time);
  void move(long long finger, ImVec2 at);
  void up(long long finger, double time);

  // From the second finger on, until the last one left: the pointer rests.
  bool several() const { return several_; }
  Fingers take();

 private:
  void measure(ImVec2& middle, float& spread) const;
  void begin_anew();  // whenever the fingers are others

  std::map<long long, ImVec2> fingers_;
  Fingers since_;
  ImVec2 middle_;  // when it was asked last
  float spread_ = 0;
  bool several_ = false;
  int most_ = 0;  // fingers at once in this touch
  double began_ = 0;
  float way_ = 0;  // that they moved, points
};

}  // namespace artisketch
