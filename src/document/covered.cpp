// Parts that a drawing doesn't show, as the artist says or as the other outlines do.
#include <algorithm>

#include "document/edit.h"

namespace artisketch {
namespace {

constexpr double kStep = 3;      // pixels along an outline
constexpr double kShows = 0.05;  // of its length: less is a crease between the parts in front

struct Cover {
  int joint = 0;
  const Polyline* line = nullptr;
  Box2 box;
};

// The closed contours of other parts in front of one; those of a joint side by side.
std::vector<Cover> covers_of(const Frame& frame, std::size_t contour) {
  std::vector<Cover> covers;
  for (std::size_t i = contour + 1; i < frame.contours.size(); ++i) {
    const Contour& other = frame.contours[i];
    if (other.joint != frame.contours[contour].joint && other.line.closed)
      covers.push_back({other.joint, &other.line, bounds(std::span(&other.line, 1))});
  }
  std::stable_sort(covers.begin(), covers.end(),
                   [](const Cover& a, const Cover& b) { return a.joint < b.joint; });
  return covers;
}

// Whether a point is inside one of the parts, each by the even-odd rule.
bool covered(const std::vector<Cover>& covers, const Vec2& p) {
  bool inside = false;
  for (std::size_t i = 0; i < covers.size(); ++i) {
    if (i > 0 && covers[i].joint != covers[i - 1].joint) {
      if (inside) return true;
      inside = false;
    }
    if (covers[i].box.contains(p) && contains(*covers[i].line, p)) inside = !inside;
  }
  return inside;
}

}  // namespace

Document with_hidden(Document document, int frame, int joint, bool hidden) {
  std::vector<int>& joints = document.frames.at(frame).hidden;
  std::erase(joints, joint);
  if (hidden) joints.insert(std::upper_bound(joints.begin(), joints.end(), joint), joint);
  return document;
}

bool inside_other_parts(const Frame& frame, int joint) {
  std::vector<std::pair<std::size_t, std::vector<Vec2>>> edges;  // by contour
  std::size_t all = 0, shown = 0;
  for (std::size_t i = 0; i < frame.contours.size(); ++i) {
    const Contour& contour = frame.contours[i];
    if (contour.joint != joint || !contour.line.closed) continue;
    edges.emplace_back(i, resampled(contour.line, kStep).points);
    all += edges.back().second.size();
  }
  const double most = kShows * double(all);
  for (const auto& [contour, points] : edges) {
    const std::vector<Cover> covers = covers_of(frame, contour);
    for (const Vec2& p : points)
      if (!covered(covers, p) && double(++shown) > most) return false;
  }
  return all > 0;
}

}  // namespace artisketch
