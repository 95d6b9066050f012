// What tests ask of a document, and where things of it stand in the window.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "editor/harness.h"
#include "files/document_file.h"

namespace artisketch {

// All of the document; equal where nothing changed.
inline std::string text(const Harness& h) {
  return document_text(h.document());
}

inline int joint(const Harness& h, const std::string& name) {
  return h.document().skeleton.find(name);
}

inline const std::vector<Contour>& contours(const Harness& h, int frame = 0) {
  return h.document().frames.at(std::size_t(frame)).contours;
}

// The outlines of a joint's part in a drawing, back to front.
inline std::vector<Polyline> outlines(const Harness& h, const std::string& name, int frame = 0) {
  return contours_of(h.document().frames.at(std::size_t(frame)), joint(h, name));
}
inline Polyline outline(const Harness& h, const std::string& name, int frame = 0) {
  const std::vector<Polyline> all = outlines(h, name, frame);
  return all.empty() ? Polyline() : all[0];
}
// Where it stands among the frame's contours, 0 being the backmost; −1: nowhere.
inline int place_of(const Harness& h, const std::string& name, int frame = 0) {
  const std::vector<Contour>& all = contours(h, frame);
  for (int i = 0; i < int(all.size()); ++i)
    if (all[std::size_t(i)].joint == joint(h, name)) return i;
  return -1;
}

inline Vec2 lowest(const Polyline& line) {
  return *std::max_element(line.points.begin(), line.points.end(),
                           [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); });
}
inline Vec2 leftmost(const Polyline& line) {
  return *std::min_element(line.points.begin(), line.points.end(),
                           [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
}
inline Vec2 rightmost(const Polyline& line) {
  return *std::max_element(line.points.begin(), line.points.end(),
                           [](const Vec2& a, const Vec2& b) { return a.x() < b.x(); });
}
inline Vec2 centre(const Polyline& line) {
  return bounds(std::span(&line, 1)).center();
}

inline Vec2 on_screen(const Harness& h, const Vec2& pixel) {
  return h.on_screen(pixel.x(), pixel.y());
}
// Points on screen that a pixel of the drawing takes.
inline double zoom(const Harness& h) {
  return (h.on_screen(1, 0) - h.on_screen(0, 0)).norm();
}

// Places round a middle, on screen; from angle 0 once round, or as far as `turns`.
inline std::vector<Vec2> circle(const Vec2& middle, double radius, double turns = 1) {
  std::vector<Vec2> places;
  constexpr int kSteps = 48;
  for (int i = 0; i <= kSteps; ++i) {
    const double a = 2 * M_PI * turns * i / kSteps;
    places.push_back(middle + radius * Vec2(std::cos(a), std::sin(a)));
  }
  return places;
}

inline double turned(const Harness& h, const Document& before, const std::string& name,
                     int frame = 0) {
  const std::size_t j = std::size_t(joint(h, name)), f = std::size_t(frame);
  return h.document().frames[f].pose.rotations[j].angularDistance(
      before.frames[f].pose.rotations[j]);
}

// A motion (BVH): an arm is lifted.
inline std::string waving() {
  const std::string joint = "CHANNELS 3 Zrotation Xrotation Yrotation\n";
  return "HIERARCHY\nROOT Hips\n{\nOFFSET 0 0 0\nCHANNELS 6 Xposition Yposition Zposition "
         "Zrotation "
         "Xrotation Yrotation\nJOINT LeftArm\n{\nOFFSET 20 50 0\n" +
         joint + "JOINT LeftForeArm\n{\nOFFSET 30 0 0\n" + joint +
         "End Site\n{\nOFFSET 25 0 0\n}\n}\n}\n}\nMOTION\nFrames: 3\nFrame Time: 0.5\n"
         "0 90 0 0 0 0 0 0 0 0 0 0\n0 90 0 0 0 0 45 0 0 0 0 0\n0 90 0 0 0 0 80 0 0 0 0 0\n";
}

}  // namespace artisketch
