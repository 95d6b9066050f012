// The pointer over the canvas, what it is near to, and gestures as steps of undo.
#pragma once

#include <string>

#include "editor/shell/panels.h"

namespace artisketch {

inline constexpr float kReach = 9, kCloseReach = 12;  // points

struct Pointer {
  ImVec2 screen;
  Vec2 at;  // the sketch's pixels
  bool hovered = false, pressed = false, held = false, released = false, dragging = false;
  bool moved = false;  // as pointer_moved()
  bool double_clicked = false, alt = false;
};

Pointer pointer_on(const Rect& place, const OnScreen& on);

// Whether the pointer drags the control shown last, up to its release.
bool item_dragged();
// The same of the pointer itself. The last move may come in one frame with the release: that frame
// still holds.
bool pointer_dragged();
bool pointer_holds();
// Since the last frame: a hand that rests changes nothing.
bool pointer_moved();

float apart(ImVec2 a, ImVec2 b);

// The nearest place on a line, in points on screen.
struct OnLine {
  float distance = 1e9f;
  std::size_t segment = 0;
};
OnLine nearest_on(const Polyline& line, const OnScreen& on, ImVec2 p);

// The outline of the drawing in view whose line is near a place on screen, else the smallest around
// it; −1: none.
int contour_at(const Work& work, const OnScreen& on, ImVec2 p);

// The joint within `reach` points of a place on screen; −1: none.
int joint_at(const std::vector<Transform>& posed, const FrameCamera& camera, const OnScreen& on,
             ImVec2 p, float reach = 14);

// A press takes the joint under it, or none.
void take_joint(Work& work, const Pointer& p, const std::vector<Transform>& posed,
                const FrameCamera& camera, const OnScreen& on);

// What people call a joint's part.
std::string part_words(const Work& work, int joint);

}  // namespace artisketch
