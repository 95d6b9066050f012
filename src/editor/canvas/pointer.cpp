#include "editor/canvas/pointer.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "document/edit.h"
#include "editor/ui/ui.h"

namespace artisketch {

namespace {

// What is the same over the sketch and over the model.
Pointer pointer_anywhere() {
  const ImGuiIO& io = ImGui::GetIO();
  Pointer p;
  p.screen = io.MousePos;
  p.delta = io.MouseDelta;
  p.from = io.MouseClickedPos[ImGuiMouseButton_Left];
  p.wheel = io.MouseWheel;
  p.moved = pointer_moved();
  p.alt = io.KeyAlt;
  p.shift = io.KeyShift;
  if (io.WantTextInput) return p;
  p.enter = ImGui::IsKeyPressed(ImGuiKey_Enter, false);
  p.tab = ImGui::IsKeyPressed(ImGuiKey_Tab);
  p.backspace = ImGui::IsKeyPressed(ImGuiKey_Backspace);
  return p;
}

}  // namespace

Pointer pointer_on_sketch(const Rect& place, const OnScreen& on) {
  const Press press = press_area("Sketch", place);
  Pointer p = pointer_anywhere();
  p.at = on.back(p.screen);
  p.hovered = press.hovered;
  p.held = press.held;
  p.pressed = ImGui::IsItemActivated();
  p.released = ImGui::IsItemDeactivated();
  p.dragging = item_dragged();
  p.double_clicked = press.double_clicked;
  return p;
}

Pointer pointer_on_model() {
  Pointer p = pointer_anywhere();
  p.hovered = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
  p.pressed = ImGui::IsMouseClicked(ImGuiMouseButton_Left) && ImGui::IsWindowHovered();
  p.held = pointer_holds();
  p.released = ImGui::IsMouseReleased(ImGuiMouseButton_Left);
  p.dragging = pointer_dragged();
  return p;
}

bool pan_key_held() {
  return ImGui::IsKeyDown(ImGuiKey_Space) && !ImGui::GetIO().WantTextInput;
}

float apart(ImVec2 a, ImVec2 b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

bool pointer_dragged() {
  if (!pointer_holds()) return false;
  const ImGuiIO& io = ImGui::GetIO();
  const float way = apart(io.MousePos, io.MouseClickedPos[ImGuiMouseButton_Left]);
  return std::max(way * way, io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left]) >=
         io.MouseDragThreshold * io.MouseDragThreshold;
}

bool pointer_holds() {
  return ImGui::IsMouseDown(ImGuiMouseButton_Left) || ImGui::IsMouseReleased(ImGuiMouseButton_Left);
}

bool pointer_moved() {
  const ImVec2 delta = ImGui::GetIO().MouseDelta;
  return delta.x != 0 || delta.y != 0;
}

bool item_dragged() {
  return (ImGui::IsItemActive() || ImGui::IsItemDeactivated()) && pointer_dragged();
}

std::string part_words(const App& app, int joint) {
  return joint_words(app.document().skeleton.joints[std::size_t(joint)].name).whole();
}

std::string parts_listed(const App& app, const std::vector<int>& joints) {
  std::string words;
  for (std::size_t i = 0; i < joints.size(); ++i)
    words += (i == 0 ? "" : i + 1 == joints.size() ? " and " : ", ") + part_words(app, joints[i]);
  return words;
}

OnLine nearest_on(const Polyline& line, const OnScreen& on, ImVec2 p) {
  OnLine best;
  for (std::size_t s = 0; s < line.segments(); ++s) {
    const ImVec2 a = on.of(line.points[s]), b = on.of(line.end_of(s));
    const float dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    const float t =
        square > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0f, 1.0f) : 0;
    const float distance = apart(p, {a.x + t * dx, a.y + t * dy});
    if (distance < best.distance) best = {distance, s};
  }
  return best;
}

int contour_at(const App& app, const OnScreen& on, ImVec2 p) {
  int best = -1;
  float nearest = kReach;
  const std::vector<Contour>& contours = app.frame().contours;
  for (int i = 0; i < int(contours.size()); ++i) {
    const float distance = nearest_on(contours[std::size_t(i)].line, on, p).distance;
    if (distance <= nearest) nearest = distance, best = i;
  }
  if (best >= 0) return best;
  // Within several, the smallest.
  const Vec2 at = on.back(p);
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < int(contours.size()); ++i) {
    const Polyline& line = contours[std::size_t(i)].line;
    const double area = line.closed ? std::abs(signed_area(line)) : least;
    if (area < least && contains(line, at)) least = area, best = i;
  }
  return best;
}

int joint_at(const std::vector<Transform>& posed, const FrameCamera& camera, const OnScreen& on,
             ImVec2 p, float reach) {
  int best = -1;
  float nearest = reach;
  for (int j = 0; j < int(posed.size()); ++j) {
    const float distance = apart(on.of(camera.project(posed[std::size_t(j)].translation())), p);
    if (distance < nearest) nearest = distance, best = j;
  }
  return best;
}

Vec3 under_pointer(const ViewProjection& projection, ImVec2 p, const Vec3& X) {
  Eigen::Vector4d clip = projection.clip * X.homogeneous();
  clip.x() = clip.w() * (2 * (p.x - projection.place.x) / projection.place.w - 1);
  clip.y() = clip.w() * (1 - 2 * (p.y - projection.place.y) / projection.place.h);
  return (projection.clip.inverse() * clip).hnormalized();
}

}  // namespace artisketch
