// Outline: what the pointer does to contours.
#include <cmath>
#include <limits>

#include "document/edit.h"
#include "document/mend.h"
#include "editor/canvas/tools.h"
#include "editor/modes/outline/new_outline.h"
#include "editor/modes/outline/outline_commands.h"

namespace artisketch {
namespace {

void paint_points(const Polyline& line, const OnScreen& on, ImU32 colour, ImVec2 pointer) {
  for (const Vec2& point : line.points) {
    const ImVec2 p = on.of(point);
    const bool near = apart(p, pointer) < kReach;
    draw().AddCircleFilled(p, near ? 4.7f : 3.7f, colour);
    draw().AddCircleFilled(p, near ? 3.7f : 2.7f, rgb(0xFFFFFF));
  }
}

// Only points some way apart on screen are handles: a traced outline has hundreds.
std::vector<int> handles(const Polyline& line, const OnScreen& on) {
  constexpr float kApart = 14;
  std::vector<int> result;
  for (int i = 0; i < int(line.points.size()); ++i)
    if (result.empty() || apart(on.of(line.points[std::size_t(result.back())]),
                                on.of(line.points[std::size_t(i)])) >= kApart)
      result.push_back(i);
  return result;
}

// The points within a handle's reach follow it, less the farther along the line they are.
std::vector<Vec2> dragged(const Polyline& line, const std::vector<Vec2>& from, int point,
                          const Vec2& by, double reach) {
  std::vector<Vec2> points = from;
  const int n = int(points.size());
  points[std::size_t(point)] += by;
  for (int way : {1, -1}) {
    double along = 0;
    for (int k = 1; k < n; ++k) {
      const int i = point + way * k;
      if (!line.closed && (i < 0 || i >= n)) break;
      const std::size_t here = std::size_t((i % n + n) % n),
                        before = std::size_t(((i - way) % n + n) % n);
      along += (from[here] - from[before]).norm();
      if (along >= reach) break;
      const double t = along / reach, weight = (1 - t * t) * (1 - t * t);
      points[here] += weight * by;
    }
  }
  return points;
}

}  // namespace

void edit_tool(Work& work, const Pointer& p, const OnScreen& on) {
  View& view = work.view;
  const bool chosen = view.contour >= 0;
  view.point = -1;
  if (chosen) {
    const Contour& contour = work.frame().contours[std::size_t(view.contour)];
    const std::vector<int> ends = handles(contour.line, on);
    Polyline shown{{}, contour.line.closed};
    for (int i : ends) shown.points.push_back(contour.line.points[std::size_t(i)]);
    paint_points(shown, on, joint_tint(contour.joint), p.screen);
    float best = kReach;
    for (int i : ends) {
      const float distance = apart(on.of(contour.line.points[std::size_t(i)]), p.screen);
      if (p.hovered && distance < best) best = distance, view.point = i;
    }
    if (p.pressed) {
      work.gesture = {};
      work.gesture.point = view.point;
      work.gesture.contour = view.contour;
      work.gesture.from = p.at;
      work.gesture.points = contour.line.points;
      const OnLine edge = nearest_on(contour.line, on, p.screen);
      if (view.point < 0 && edge.distance < kReach && !p.double_clicked) {
        // An edge bends where it is held.
        work.gesture.point = int(edge.segment) + 1;
        work.gesture.points.insert(work.gesture.points.begin() + work.gesture.point, p.at);
      }
    }
    if (p.double_clicked && view.point < 0) {
      const OnLine place = nearest_on(contour.line, on, p.screen);
      if (place.distance < kReach) {
        std::vector<Vec2> points = contour.line.points;
        points.insert(points.begin() + std::ptrdiff_t(place.segment) + 1, p.at);
        work.commit("Add point", with_contour_points(work.document(), view.frame, view.contour,
                                                     std::move(points)));
        return;
      }
    }
  } else if (p.pressed) {
    work.gesture = {};
  }
  if (p.dragging && p.moved && work.gesture.point >= 0 && work.gesture.contour == view.contour) {
    const Polyline& line = work.frame().contours[std::size_t(view.contour)].line;
    // As far as the next handles.
    const double reach = 14 / on.zoom;
    work.change("Move point",
                with_contour_points(work.document(), view.frame, view.contour,
                                    dragged(line, work.gesture.points, work.gesture.point,
                                            p.at - work.gesture.from, reach)));
  } else if (p.pressed && work.gesture.point < 0) {
    const int under = contour_at(work, on, p.screen);
    if (view.joining && chosen && under >= 0) return join_with(work, under);
    view.contour = under;
    view.joint = view.contour >= 0 ? work.frame().contours[std::size_t(view.contour)].joint : -1;
  }
}

void draw_tool(Work& work, const Pointer& p, const OnScreen& on) {
  if (p.pressed) work.stroke = {p.at};
  if (p.held && !work.stroke.empty() && apart(on.of(work.stroke.back()), p.screen) > 1.5f)
    work.stroke.push_back(p.at);
  if (p.held && work.stroke.size() > 1) {
    OutlineLook look;
    paint_outline(draw(), {work.stroke, false}, on, theme().accent, look);
    if (apart(on.of(work.stroke.front()), p.screen) < kCloseReach && work.stroke.size() > 8)
      draw().AddCircle(on.of(work.stroke.front()), kCloseReach, theme().accent, 0, 1.5f);
  }
  if (!p.released || work.stroke.empty()) return;
  const std::vector<Vec2> stroke = std::move(work.stroke);
  work.stroke.clear();
  StrokeOptions options;
  options.smooth = 2 / on.zoom;
  options.error = 0.4 / on.zoom;
  options.reach = kCloseReach / on.zoom;
  options.open = p.alt;
  View& view = work.view;
  std::optional<Polyline> line = outline_of_stroke(stroke, options);
  if (view.redrawing && view.contour >= 0) {
    view.redrawing = false;
    if (!line) return;
    Document next = work.document();
    Contour& chosen = next.frames[std::size_t(view.frame)].contours[std::size_t(view.contour)];
    chosen.line = *line;
    work.commit("Redraw " + part_words(work, chosen.joint), std::move(next));
    return;
  }
  // What closes is an outline of its own, though it may begin where another one runs.
  if (view.contour >= 0 && stroke.size() > 2 && !(line && line->closed)) {
    const Contour& chosen = work.frame().contours[std::size_t(view.contour)];
    const bool from = nearest_on(chosen.line, on, on.of(stroke.front())).distance < kCloseReach,
               to = nearest_on(chosen.line, on, on.of(stroke.back())).distance < kCloseReach;
    if (from && to) {
      options.open = true;
      const std::optional<Polyline> smooth = outline_of_stroke(stroke, options);
      if (!smooth) return;
      work.commit("Redraw " + part_words(work, chosen.joint),
                  with_contour_points(work.document(), view.frame, view.contour,
                                      with_stretch_redrawn(chosen.line, smooth->points).points));
      return;
    }
  }
  if (line) {
    NewOutline fresh;
    fresh.line = std::move(*line);
    fresh.stroke = stroke;
    fresh.options = options;
    propose(work, std::move(fresh));
  }
}

// A click sets a corner; dragging from it pulls the curve's tangent.
void points_tool(Work& work, const Pointer& p, const OnScreen& on) {
  std::vector<Vec2>&points = work.stroke, &handles = work.handles;
  handles.resize(points.size(), Vec2::Zero());
  const bool closes = points.size() > 2 && apart(on.of(points.front()), p.screen) < kCloseReach;
  if (p.pressed && !closes) {
    if (points.empty() && work.outline) keep_outline(work);
    points.push_back(p.at);
    handles.push_back(Vec2::Zero());
    work.gesture = {};
    work.gesture.point = int(points.size()) - 1;
  }
  const int pulled = work.gesture.point;
  if (p.dragging && pulled >= 0 && pulled < int(points.size()))
    handles[std::size_t(pulled)] = p.at - points[std::size_t(pulled)];
  if (ImGui::IsKeyPressed(ImGuiKey_Backspace) && !points.empty()) {
    points.pop_back();
    handles.pop_back();
  }
  std::vector<Vec2> shown = points, bent = handles;
  if (p.hovered && !p.held && !points.empty()) {
    shown.push_back(closes ? points.front() : p.at);
    bent.push_back(closes ? handles.front() : Vec2::Zero());
  }
  if (shown.size() > 1)
    paint_outline(draw(), curve_through(shown, bent, false), on, theme().accent, {});
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (handles[i].isZero()) continue;
    const ImVec2 a = on.of(points[i] - handles[i]), b = on.of(points[i] + handles[i]);
    draw().AddLine(a, b, theme().accent, 1);
    draw().AddCircleFilled(a, 3, theme().accent);
    draw().AddCircleFilled(b, 3, theme().accent);
  }
  paint_points({points, false}, on, theme().accent, p.screen);
  if (closes) draw().AddCircle(on.of(points.front()), kCloseReach, theme().accent, 0, 1.5f);
  const bool enter = ImGui::IsKeyPressed(ImGuiKey_Enter, false) && points.size() > 2;
  if ((p.pressed && closes) || enter) {
    NewOutline fresh;
    fresh.line = curve_through(points, handles, true);
    points.clear();
    propose(work, std::move(fresh));
  }
}

void cut_tool(Work& work, const Pointer& p, const OnScreen& on) {
  if (p.pressed) {
    if (work.outline) keep_outline(work);
    work.stroke = {p.at, p.at};
  }
  if (work.stroke.size() < 2) return;
  if (p.held || p.released) work.stroke[1] = p.at;
  const Vec2 a = work.stroke[0], b = work.stroke[1];
  draw().AddLine(on.of(a), on.of(b), rgb(0xFFFFFF, 0.7f), 4.5f);
  draw().AddLine(on.of(a), on.of(b), theme().error, 2);
  if (!p.released) return;
  work.stroke.clear();
  // The chosen outline, else the frontmost that the line cuts right across.
  const int contours = int(work.frame().contours.size());
  std::vector<int> order;
  if (work.view.contour >= 0) order.push_back(work.view.contour);
  for (int i = contours - 1; i >= 0; --i) order.push_back(i);
  for (int i : order) {
    std::optional<Document> next = with_contour_cut(work.document(), work.view.frame, i, a, b);
    if (!next) continue;
    const int joint = work.frame().contours[std::size_t(i)].joint;
    work.commit("Cut " + part_words(work, joint), std::move(*next));
    work.view.contour = int(work.frame().contours.size()) - 1;
    work.view.joint = work.frame().contours.back().joint;
    return;
  }
  Toast toast;
  toast.words = "Draw the line right across one outline.";
  work.say(std::move(toast));
}

}  // namespace artisketch
