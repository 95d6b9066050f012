// How outlines and bones are drawn over a sketch, large on the canvas and small in the strip.
#pragma once

#include <span>
#include <vector>

#include "document/document.h"
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

struct OutlineLook {
  float width = 2, casing = 1.25f;  // points; the casing on each side
  float opacity = 1, fill = 0;
  bool dashed = false;
};
void paint_outline(ImDrawList& list, const Polyline& line, const OnScreen& on, ImU32 colour,
                   const OutlineLook& look);

// Thin white bones and joints (Outline), or bones that taper with depth (Pose).
struct BonesLook {
  bool tapered = false;
  bool faint = false;  // dotted, the other pose
  int chosen = -1;     // joint
  float size = 1;      // of the joints; larger for fingers
};
void paint_bones(ImDrawList& list, const Skeleton& skeleton, const Pose& pose,
                 const FrameCamera& camera, const OnScreen& on, const BonesLook& look);

// The line on screen, without the points that nobody would miss.
std::vector<ImVec2> on_screen(const Polyline& line, const OnScreen& on);

// Triangles that fill a simple polygon, as indices into it; ear clipping. What crosses itself is
// filled about right.
std::vector<int> filling(std::span<const ImVec2> polygon);

void paint_dashes(ImDrawList& list, std::span<const ImVec2> points, bool closed, ImU32 colour,
                  float width, float dash, float gap);

}  // namespace artisketch
