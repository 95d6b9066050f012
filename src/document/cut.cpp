// One outline cut into two that overlap, and whose part each of them is.
#include <algorithm>
#include <cmath>

#include "document/edit.h"

namespace artisketch {
namespace {

struct Crossing {
  std::size_t segment;  // of the outline
  Vec2 point;
  double along;  // of the cut, 0 … 1
};

std::vector<Crossing> crossings_of(const Polyline& outline, const Vec2& a, const Vec2& b) {
  std::vector<Crossing> crossings;
  const Vec2 d = b - a;
  for (std::size_t s = 0; s < outline.segments(); ++s) {
    const Vec2 p = outline.points[s], e = outline.end_of(s) - p;
    const double denominator = cross(e, d);
    if (std::abs(denominator) < 1e-12) continue;
    const double t = cross(a - p, d) / denominator, u = cross(a - p, e) / denominator;
    if (t >= 0 && t < 1 && u >= 0 && u <= 1) crossings.push_back({s, p + t * e, u});
  }
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& x, const Crossing& y) { return x.along < y.along; });
  return crossings;
}

// The outline from one crossing to the other, closed by an arc beyond the cut: a rigid part ends
// within its neighbour, rounded, and never outside the outline that was cut.
Polyline half(const Polyline& outline, const Crossing& from, const Crossing& to, double overlap) {
  Polyline piece;
  piece.points.push_back(from.point);
  for (std::size_t s = from.segment; s != to.segment; s = (s + 1) % outline.segments())
    piece.points.push_back(outline.end_of(s));
  piece.points.push_back(to.point);
  const Vec2 chord = from.point - to.point;
  Vec2 out(-chord.y(), chord.x());  // away from the piece
  if (signed_area(piece) > 0) out = -out;
  constexpr int kArc = 8;
  for (double reach = overlap; reach > 0.01; reach *= 0.8) {
    std::vector<Vec2> arc;
    for (int i = 1; i < kArc; ++i) {
      const double t = double(i) / kArc;
      arc.push_back(to.point + t * chord + reach * std::sin(kPi * t) * out);
    }
    if (!std::all_of(arc.begin(), arc.end(), [&](const Vec2& p) { return contains(outline, p); }))
      continue;
    piece.points.insert(piece.points.end(), arc.begin(), arc.end());
    break;
  }
  return piece;
}

}  // namespace

std::optional<std::pair<Polyline, Polyline>> cut_outline(const Polyline& outline, const Vec2& a,
                                                         const Vec2& b, double overlap) {
  if (!outline.closed || (b - a).norm() < 1e-9) return std::nullopt;
  const std::vector<Crossing> crossings = crossings_of(outline, a, b);
  // The stretch of the cut inside the outline that is nearest to the cut's middle.
  double nearest = 1e9;
  std::size_t at = crossings.size();
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
    const Crossing &from = crossings[i], &to = crossings[i + 1];
    const double middle = (from.along + to.along) / 2, off = std::abs(middle - 0.5);
    if (off >= nearest || !contains(outline, (from.point + to.point) / 2)) continue;
    nearest = off, at = i;
  }
  if (at == crossings.size()) return std::nullopt;
  const Crossing &from = crossings[at], &to = crossings[at + 1];
  return std::pair{half(outline, from, to, overlap), half(outline, to, from, overlap)};
}

namespace {

// How much of a part's bones, as drawn, lies inside a line: 0 … 1.
double share_inside(const std::vector<DrawnBone>& bones, const Polyline& line) {
  constexpr int kSamples = 24;
  double all = 0, inside = 0;
  for (const DrawnBone& bone : bones) {
    // A bone seen from its end still has a place.
    const double weight = std::max(1e-3, (bone.to - bone.from).norm());
    for (int i = 0; i < kSamples; ++i) {
      all += weight;
      if (contains(line, bone.from + (i + 0.5) / kSamples * (bone.to - bone.from)))
        inside += weight;
    }
  }
  return all > 0 ? inside / all : 0;
}

int depth_of(const Skeleton& skeleton, int joint) {
  int depth = 0;
  for (; joint > 0; joint = skeleton.joints[joint].parent) ++depth;
  return depth;
}

}  // namespace

std::optional<Document> with_contour_cut(const Document& document, int frame, int contour,
                                         const Vec2& a, const Vec2& b) {
  const std::vector<Contour>& contours = document.frames.at(frame).contours;
  const Contour whole = contours.at(contour);
  constexpr double kOverlap = 0.3;  // of the cut's length inside: about a round end
  auto halves = cut_outline(whole.line, a, b, kOverlap);
  if (!halves) return std::nullopt;
  auto& [first, second] = *halves;
  const std::vector<std::vector<DrawnBone>> bones = drawn_bones(document, frame);
  // The half with more of the part's own bone keeps the part; at a tie, the larger one.
  const double own_first = share_inside(bones[whole.joint], first),
               own_second = share_inside(bones[whole.joint], second);
  const bool larger = std::abs(signed_area(second)) > std::abs(signed_area(first));
  if (own_second > own_first + 1e-9 || (own_second >= own_first - 1e-9 && larger))
    std::swap(first, second);
  // The other is the part whose bone lies most in it; of several that lie in it as a whole, the
  // one that the others hang on: the next cut parts them.
  int other = -1;
  double best = 0;
  for (int j = 0; j < document.skeleton.size(); ++j) {
    if (j == whole.joint || bones[j].empty()) continue;
    double share = share_inside(bones[j], second);
    if (!contours_of(document.frames[frame], j).empty()) share *= 0.5;  // has its outline here
    constexpr double kWhole = 0.85;                                     // joints are set by hand
    share = std::min(share, kWhole) - 1e-3 * depth_of(document.skeleton, j);
    if (share > best) best = share, other = j;
  }
  if (other < 0) {
    for (const Candidate& candidate : joint_candidates(document, frame, second))
      if (candidate.joint != whole.joint) {
        other = candidate.joint;
        break;
      }
  }
  if (other < 0) other = whole.joint;
  Document next = with_contour_points(document, frame, contour, first.points);
  // What lies within the other half, a hole, goes with it.
  for (Contour& inner : next.frames[frame].contours)
    if (&inner != &next.frames[frame].contours[contour] && inner.joint == whole.joint &&
        contains(second, centroid(std::span(&inner.line, 1))) &&
        contains(whole.line, inner.line.points[0]) &&
        !contains(first, centroid(std::span(&inner.line, 1))))
      inner.joint = other;
  return with_contour(std::move(next), frame, {other, std::move(second), whole.unknown});
}

}  // namespace artisketch
