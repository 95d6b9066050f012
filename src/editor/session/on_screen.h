// The pointer and the places it works on, as plain values: a test hands them to a tool as the
// window does.
#pragma once

#include <vector>

#include <imgui.h>

#include "document/document.h"
#include "editor/pictures/view_projection.h"
#include "editor/ui/rect.h"

namespace artisketch {

// From the sketch's pixels to the window: origin + zoom · p.
struct OnScreen {
  ImVec2 origin;
  float zoom = 1;
  ImVec2 of(const Vec2& p) const {
    return {origin.x + zoom * float(p.x()), origin.y + zoom * float(p.y())};
  }
  Vec2 back(ImVec2 p) const { return {(p.x - origin.x) / zoom, (p.y - origin.y) / zoom}; }
};

// The pointer in one frame.
struct Pointer {
  ImVec2 screen;           // points
  ImVec2 delta;            // since the frame before
  ImVec2 from;             // where the button went down last
  Vec2 at = Vec2::Zero();  // the sketch's pixels
  float wheel = 0;         // notches
  bool hovered = false;    // nothing else lies over the place
  bool pressed = false, held = false, released = false;
  bool dragging = false;  // held, and moved farther than a hand trembles
  bool moved = false;     // since the frame before
  bool double_clicked = false;
  bool alt = false, shift = false;                     // held
  bool enter = false, tab = false, backspace = false;  // as they go down
};

// The model as it stands in its panel.
struct ModelStage {
  ViewProjection projection;
  Pose pose;
  Vec3 shift = Vec3::Zero();  // that sets its feet on the ground
  std::vector<Vec3> joints;   // posed, in the world
};

// What a tool works on: the sketch, or in Result the model.
struct Stage {
  Rect place;
  OnScreen on;
  const ModelStage* model = nullptr;  // in Result alone
};

}  // namespace artisketch
