// How outlines and bones are drawn over a sketch, large on the canvas and small in the strip.
#pragma once

#include <span>
#include <vector>

#include "document/document.h"
#include "editor/session/on_screen.h"

namespace artisketch {

struct OutlineLook {
  float width = 2, casing = 1.25f;  // points; the casing on each side
  float opacity = 1, fill = 0;
  bool dashed = false;
};
void paint_outline(ImDrawList& list, const Polyline& line, const OnScreen& on, ImU32 colour,
                   const OutlineLook& look);

// The points of a line as handles; those near the pointer are larger.
void paint_points(const Polyline& line, const OnScreen& on, ImU32 colour, ImVec2 pointer);

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
