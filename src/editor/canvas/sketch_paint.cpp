#include "editor/canvas/sketch_paint.h"

#include <algorithm>
#include <cmath>

#include "document/line_fit.h"
#include "editor/canvas/pointer.h"
#include "editor/ui/ui.h"

namespace artisketch {
namespace {

float cross(ImVec2 a, ImVec2 b, ImVec2 c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

float distance(ImVec2 a, ImVec2 b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace

std::vector<ImVec2> on_screen(const Polyline& line, const OnScreen& on) {
  constexpr float kApart = 0.75f;
  constexpr double kUnseen = 0.15;  // points of the screen
  std::vector<Vec2> points;
  for (const Vec2& p : line.points) {
    const ImVec2 at = on.of(p);
    const Vec2 here(at.x, at.y);
    if (points.empty() || (points.back() - here).norm() > kApart) points.push_back(here);
  }
  while (line.closed && points.size() > 3 && (points.front() - points.back()).norm() < kApart)
    points.pop_back();
  std::vector<ImVec2> seen;
  for (const Vec2& p : simplified(points, line.closed, kUnseen))
    seen.emplace_back(float(p.x()), float(p.y()));
  return seen;
}

std::vector<int> filling(std::span<const ImVec2> polygon) {
  const int n = int(polygon.size());
  std::vector<int> triangles;
  if (n < 3) return triangles;
  float area = 0;
  for (int i = 0; i < n; ++i) area += cross({0, 0}, polygon[i], polygon[(i + 1) % n]);
  const float turn = area >= 0 ? 1.0f : -1.0f;
  std::vector<int> left(static_cast<std::size_t>(n));
  for (int i = 0; i < n; ++i) left[std::size_t(i)] = i;
  std::size_t at = 0, tried = 0;
  while (left.size() > 3) {
    const std::size_t m = left.size();
    const int a = left[(at + m - 1) % m], b = left[at % m], c = left[(at + 1) % m];
    bool ear = turn * cross(polygon[a], polygon[b], polygon[c]) > 0;
    for (std::size_t k = 2; ear && k + 1 < m; ++k) {
      const ImVec2 p = polygon[left[(at + k) % m]];
      ear = turn * cross(polygon[a], polygon[b], p) < 0 ||
            turn * cross(polygon[b], polygon[c], p) < 0 ||
            turn * cross(polygon[c], polygon[a], p) < 0;
    }
    // A polygon that crosses itself may have no ear left: then any corner goes.
    if (ear || tried > m) {
      if (ear) triangles.insert(triangles.end(), {a, b, c});
      left.erase(left.begin() + std::ptrdiff_t(at % m));
      at = at % m == 0 ? left.size() - 1 : at % m - 1;
      tried = 0;
    } else {
      at = (at + 1) % m;
      ++tried;
    }
  }
  triangles.insert(triangles.end(), {left[0], left[1], left[2]});
  return triangles;
}

void paint_dashes(ImDrawList& list, std::span<const ImVec2> points, bool closed, ImU32 colour,
                  float width, float dash, float gap) {
  float phase = 0;
  const std::size_t n = points.size(), segments = closed ? n : n - 1;
  for (std::size_t i = 0; n > 1 && i < segments; ++i) {
    const ImVec2 a = points[i], b = points[(i + 1) % n];
    const float size = distance(a, b);
    for (float at = 0; at < size;) {
      const bool on = phase < dash;
      const float step = std::max(0.01f, std::min(size - at, (on ? dash : dash + gap) - phase));
      const auto point = [&](float s) {
        return ImVec2{a.x + (b.x - a.x) * s / size, a.y + (b.y - a.y) * s / size};
      };
      if (on) list.AddLine(point(at), point(std::min(size, at + step)), colour, width);
      at += step;
      phase += step;
      if (phase >= dash + gap - 1e-3f) phase = 0;
    }
  }
}

void paint_outline(ImDrawList& list, const Polyline& line, const OnScreen& on, ImU32 colour,
                   const OutlineLook& look) {
  const std::vector<ImVec2> points = on_screen(line, on);
  if (points.size() < 2) return;
  const int n = int(points.size());
  if (look.fill > 0 && line.closed && n > 2) {
    const ImU32 ink = faded(colour, look.fill);
    const std::vector<int> triangles = filling(points);
    const ImVec2 uv = ImGui::GetFontTexUvWhitePixel();
    list.PrimReserve(int(triangles.size()), n);
    const unsigned first = list._VtxCurrentIdx;
    for (const ImVec2& p : points) list.PrimWriteVtx(p, uv, ink);
    for (int t : triangles) list.PrimWriteIdx(ImDrawIdx(first + unsigned(t)));
  }
  const ImDrawFlags flags = line.closed ? ImDrawFlags_Closed : ImDrawFlags_None;
  if (look.casing > 0)
    list.AddPolyline(points.data(), n, rgb(0xFFFFFF, 0.7f * look.opacity), flags,
                     look.width + 2 * look.casing);
  if (look.dashed)
    paint_dashes(list, points, line.closed, faded(colour, look.opacity), look.width, 6, 4);
  else
    list.AddPolyline(points.data(), n, faded(colour, look.opacity), flags, look.width);
}

namespace {

constexpr float kAlongPaper = 0.2588f;  // sine of 15°: no arrow below

// A bone as a slim quadrangle in the joint's colour, wider where it is nearer.
void paint_bone(ImDrawList& list, ImVec2 a, ImVec2 b, float wide_a, float wide_b, ImU32 colour,
                float toward) {
  const float size = distance(a, b);
  if (size < 1) return;
  const ImVec2 along = {(b.x - a.x) / size, (b.y - a.y) / size}, across = {-along.y, along.x};
  const auto corner = [&](ImVec2 p, float w) {
    return ImVec2{p.x + across.x * w / 2, p.y + across.y * w / 2};
  };
  const ImVec2 quad[] = {corner(a, wide_a), corner(b, wide_b), corner(b, -wide_b),
                         corner(a, -wide_a)};
  const bool away = toward < -kAlongPaper;
  list.AddPolyline(quad, 4, rgb(0xFFFFFF, 0.85f), ImDrawFlags_Closed, 3);
  if (away) list.AddConvexPolyFilled(quad, 4, rgb(0xFFFFFF, 0.5f));
  list.AddConvexPolyFilled(quad, 4, faded(colour, away ? 0.38f : 1.0f));
  list.AddPolyline(quad, 4, rgb(0x1C2025, 0.75f), ImDrawFlags_Closed, 1);
  if (std::abs(toward) < kAlongPaper || size < 18) return;
  const ImVec2 m = {(a.x + b.x) / 2, (a.y + b.y) / 2};
  constexpr float kArrow = 5;
  const auto at = [&](float s, float t) {
    return ImVec2{m.x + along.x * s + across.x * t, m.y + along.y * s + across.y * t};
  };
  const ImVec2 tip = at(kArrow, 0), left = at(-kArrow * 0.8f, kArrow),
               right = at(-kArrow * 0.8f, -kArrow);
  list.AddTriangleFilled(tip, left, right, away ? rgb(0x1C2025) : rgb(0xFFFFFF));
  list.AddTriangle(tip, left, right, away ? rgb(0xFFFFFF) : rgb(0x1C2025), 1.25f);
}

}  // namespace

void paint_bones(ImDrawList& list, const Skeleton& skeleton, const Pose& pose,
                 const FrameCamera& camera, const OnScreen& on, const BonesLook& look) {
  const std::vector<Transform> posed = posed_joints(skeleton, pose);
  std::vector<ImVec2> at;
  Box3 box;
  for (const Transform& joint : posed) {
    if (!camera.in_front(joint.translation())) return;
    at.push_back(on.of(camera.project(joint.translation())));
    box.extend(joint.translation());
  }
  const double height = std::max(1e-6, box.sizes().maxCoeff());
  const double middle = box.center().z();
  for (int j = 1; j < skeleton.size(); ++j) {
    const int parent = skeleton.joints[j].parent;
    const ImVec2 a = at[parent], b = at[j];
    if (look.faint) {
      const ImVec2 ends[] = {a, b};
      paint_dashes(list, ends, false, rgb(0x1C2025, 0.55f), 3, 2, 4);
      paint_dashes(list, ends, false, rgb(0xFFFFFF, 0.9f), 1.5f, 2, 4);
      continue;
    }
    if (!look.tapered) {
      list.AddLine(a, b, rgb(0x1C2025, 0.45f), 3.25f);
      list.AddLine(a, b, rgb(0xFFFFFF), 1.25f);
      continue;
    }
    const auto width = [&](int joint) {
      return std::clamp(float(6 + 16 * (posed[joint].translation().z() - middle) / height), 2.5f,
                        12.0f);
    };
    const Vec3 bone = posed[j].translation() - posed[parent].translation();
    const float toward = bone.norm() > 1e-9 ? float(bone.normalized().z()) : 0;
    paint_bone(list, a, b, width(parent), width(j), joint_tint(parent), toward);
  }
  if (look.faint) return;
  for (int j = 0; j < skeleton.size(); ++j) {
    const bool leaf = skeleton.children(j).empty();
    if (!look.tapered) {
      list.AddCircleFilled(at[j], 3.2f * look.size, rgb(0x1C2025, 0.6f));
      list.AddCircleFilled(at[j], 2.3f * look.size, rgb(0xFFFFFF));
      if (j == look.chosen) list.AddCircle(at[j], 7 * look.size, theme().accent, 0, 2);
      continue;
    }
    const double depth = (posed[j].translation().z() - middle) / height;
    const float radius = leaf ? 4.0f : std::clamp(float(7 + 5 * depth), 5.5f, 9.0f) * look.size;
    if (j == look.chosen) list.AddCircle(at[j], radius + 6, theme().accent, 0, 2);
    list.AddCircleFilled(at[j], radius + 1, rgb(0x1C2025, 0.8f));
    list.AddCircleFilled(at[j], radius, rgb(0xFFFFFF));
    list.AddCircleFilled(at[j], radius - 2, leaf ? rgb(0xFFFFFF) : joint_tint(j));
  }
}

void paint_points(const Polyline& line, const OnScreen& on, ImU32 colour, ImVec2 pointer) {
  for (const Vec2& point : line.points) {
    const ImVec2 p = on.of(point);
    const bool near = apart(p, pointer) < kReach;
    draw().AddCircleFilled(p, near ? 4.7f : 3.7f, colour);
    draw().AddCircleFilled(p, near ? 3.7f : 2.7f, rgb(0xFFFFFF));
  }
}

}  // namespace artisketch
