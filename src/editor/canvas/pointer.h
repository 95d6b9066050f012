// The pointer as ImGui has it, and what of a sketch or a model it is near to.
#pragma once

#include <string>

#include "editor/session/app.h"

namespace artisketch {

inline constexpr float kReach = 9, kCloseReach = 12;  // points

// Over the sketch, and over the model's panel under way.
Pointer pointer_on_sketch(const Rect& place, const OnScreen& on);
Pointer pointer_on_model();

// Space is held: the pointer takes the view along, in every mode, and no tool has it.
bool pan_key_held();

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
int contour_at(const App& app, const OnScreen& on, ImVec2 p);

// The joint within `reach` points of a place on screen; −1: none.
int joint_at(const std::vector<Transform>& posed, const FrameCamera& camera, const OnScreen& on,
             ImVec2 p, float reach = 14);

// The world point that shows at a place on screen, as deep as X.
Vec3 under_pointer(const ViewProjection& projection, ImVec2 p, const Vec3& X);

// What people call a joint's part.
std::string part_words(const App& app, int joint);
// "Forearm L, Hand L and Foot L"
std::string parts_listed(const App& app, const std::vector<int>& joints);

}  // namespace artisketch
