// Strokes and outlines: what drawing, redrawing and cutting make of the pointer's path.
#include <algorithm>
#include <cmath>

#include "document/edit.h"

namespace artisketch {
namespace {

double cross(const Vec2& a, const Vec2& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Points of the line that matter: Ramer, Douglas and Peucker, between two kept ends.
void keep_between(std::span<const Vec2> points, std::size_t first, std::size_t last, double error,
                  std::vector<bool>& kept) {
  std::vector<std::pair<std::size_t, std::size_t>> spans = {{first, last}};
  while (!spans.empty()) {
    const auto [a, b] = spans.back();
    spans.pop_back();
    const Vec2 d = points[b] - points[a];
    double farthest = error;
    std::size_t at = a;
    for (std::size_t i = a + 1; i < b; ++i) {
      const double t =
          std::clamp((points[i] - points[a]).dot(d) / std::max(d.squaredNorm(), 1e-12), 0.0, 1.0);
      const double distance = (points[i] - points[a] - t * d).norm();
      if (distance > farthest) {
        farthest = distance;
        at = i;
      }
    }
    if (at == a) continue;
    kept[at] = true;
    spans.push_back({a, at});
    spans.push_back({at, b});
  }
}

std::vector<Vec2> simplified(std::span<const Vec2> points, bool closed, double error) {
  if (points.size() < 4) return {points.begin(), points.end()};
  std::vector<bool> kept(points.size(), false);
  kept.front() = kept.back() = true;
  if (closed) {
    // Two far points split the loop into lines.
    std::size_t far = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
      if ((points[i] - points[0]).norm() > (points[far] - points[0]).norm()) far = i;
    kept[far] = true;
    keep_between(points, 0, far, error, kept);
    keep_between(points, far, points.size() - 1, error, kept);
  } else {
    keep_between(points, 0, points.size() - 1, error, kept);
  }
  std::vector<Vec2> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (kept[i]) result.push_back(points[i]);
  if (closed && result.size() > 3 && (result.front() - result.back()).norm() < error)
    result.pop_back();
  return result;
}

// A Gaussian over equally spaced points, as wide as `radius` pixels.
std::vector<Vec2> smoothed(std::span<const Vec2> points, bool closed, double radius, double step) {
  const int n = int(points.size()), reach = int(std::ceil(2 * radius / step));
  if (radius <= 0 || n < 3) return {points.begin(), points.end()};
  std::vector<Vec2> result(points.begin(), points.end());
  for (int i = 0; i < n; ++i) {
    // An open line keeps its ends.
    const int here = closed ? std::min(reach, n / 4) : std::min({reach, i, n - 1 - i});
    Vec2 sum = Vec2::Zero();
    double weights = 0;
    for (int k = -here; k <= here; ++k) {
      const double weight = std::exp(-0.5 * std::pow(k * step / radius, 2));
      sum += weight * points[(i + k + n) % n];
      weights += weight;
    }
    result[i] = sum / weights;
  }
  return result;
}

}  // namespace

std::optional<Polyline> outline_of_stroke(std::span<const Vec2> stroke,
                                          const StrokeOptions& options) {
  Polyline raw{{}, false};
  for (const Vec2& p : stroke)
    if (raw.points.empty() || (p - raw.points.back()).norm() > 1e-6) raw.points.push_back(p);
  if (raw.points.size() < 3) return std::nullopt;
  const double gap = (raw.points.front() - raw.points.back()).norm(), size = length(raw);
  raw.closed = !options.open && gap <= options.reach && size > 3 * options.reach;
  if (!raw.closed && size < 4) return std::nullopt;
  constexpr double kStep = 1;  // pixels
  const Polyline even = resampled(raw, kStep);
  Polyline result{simplified(smoothed(even.points, raw.closed, options.smooth, kStep), raw.closed,
                             options.error),
                  raw.closed};
  if (result.closed && (result.points.size() < 3 || std::abs(signed_area(result)) < 1))
    return std::nullopt;
  return result;
}

std::optional<std::pair<Polyline, Polyline>> cut_outline(const Polyline& outline, const Vec2& a,
                                                         const Vec2& b, double overlap) {
  if (!outline.closed || (b - a).norm() < 1e-9) return std::nullopt;
  struct Crossing {
    std::size_t segment;
    Vec2 point;
  };
  std::vector<Crossing> crossings;
  const Vec2 d = b - a;
  for (std::size_t s = 0; s < outline.segments(); ++s) {
    const Vec2 p = outline.points[s], e = outline.end_of(s) - p;
    const double denominator = cross(e, d);
    if (std::abs(denominator) < 1e-12) continue;
    const double t = cross(a - p, d) / denominator, u = cross(a - p, e) / denominator;
    if (t >= 0 && t < 1 && u >= 0 && u <= 1) crossings.push_back({s, p + t * e});
  }
  if (crossings.size() != 2) return std::nullopt;
  const Vec2 normal = Vec2(-d.y(), d.x()).normalized();
  const auto half = [&](const Crossing& from, const Crossing& to) {
    Polyline piece;
    piece.points.push_back(from.point);
    for (std::size_t s = from.segment; s != to.segment; s = (s + 1) % outline.segments())
      piece.points.push_back(outline.end_of(s));
    piece.points.push_back(to.point);
    // Rounded beyond the line, as a rigid part ends within its neighbour.
    const Vec2 middle = centroid(std::span(&piece, 1));
    const Vec2 out = normal * ((middle - from.point).dot(normal) > 0 ? -overlap : overlap);
    const Vec2 chord = from.point - to.point;
    constexpr int kArc = 6;
    for (int i = 1; i < kArc; ++i) {
      const double t = double(i) / kArc;
      piece.points.push_back(to.point + t * chord + std::sin(kPi * t) * out);
    }
    return piece;
  };
  return std::pair{half(crossings[0], crossings[1]), half(crossings[1], crossings[0])};
}

Polyline with_stretch_redrawn(const Polyline& outline, std::span<const Vec2> stroke) {
  const int n = int(outline.points.size());
  const auto nearest = [&](const Vec2& p) {
    int best = 0;
    for (int i = 1; i < n; ++i)
      if ((outline.points[i] - p).norm() < (outline.points[best] - p).norm()) best = i;
    return best;
  };
  if (stroke.size() < 2 || n < 3) return outline;
  const int a = nearest(stroke.front()), b = nearest(stroke.back());
  const auto along = [&](int from, int to) {
    double sum = 0;
    for (int i = from; i != to; i = (i + 1) % n)
      sum += (outline.points[(i + 1) % n] - outline.points[i]).norm();
    return sum;
  };
  Polyline result{{}, outline.closed};
  if (!outline.closed) {
    const bool forward = a <= b;
    const int low = std::min(a, b), high = std::max(a, b);
    result.points.assign(outline.points.begin(), outline.points.begin() + low);
    if (forward)
      result.points.insert(result.points.end(), stroke.begin(), stroke.end());
    else
      result.points.insert(result.points.end(), stroke.rbegin(), stroke.rend());
    result.points.insert(result.points.end(), outline.points.begin() + high + 1,
                         outline.points.end());
    return result;
  }
  // The shorter way round is the one that was redrawn; the longer one stays.
  const bool forward = along(a, b) <= along(b, a);
  const int from = forward ? b : a, to = forward ? a : b;
  for (int i = from;; i = (i + 1) % n) {
    result.points.push_back(outline.points[i]);
    if (i == to) break;
  }
  if (forward)
    result.points.insert(result.points.end(), stroke.begin(), stroke.end());
  else
    result.points.insert(result.points.end(), stroke.rbegin(), stroke.rend());
  return result;
}

// ---------------------------------------------------------------- correspondence

namespace {

// Size and slenderness of an outline, alike for the same part in another drawing.
struct Likeness {
  double area, slenderness;
};
Likeness likeness(const Polyline& line) {
  const double area = std::abs(signed_area(line)), around = length(line);
  return {area, area > 0 ? around * around / area : 1e9};
}

}  // namespace

std::vector<Candidate> joint_candidates(const Document& document, int frame, const Polyline& line) {
  const Skeleton& skeleton = document.skeleton;
  const std::vector<Transform> posed = posed_joints(skeleton, document.frames.at(frame).pose);
  const FrameCamera camera = frame_camera(document, frame);
  const Vec2 middle = centroid(std::span(&line, 1));
  struct Scored {
    int joint;
    double distance;
  };
  std::vector<Scored> scored;
  for (int j = 0; j < skeleton.size(); ++j) {
    double best = -1;
    const Vec2 a = camera.project(posed[j].translation());
    for (int child : skeleton.children(j)) {
      const Vec2 d = camera.project(posed[child].translation()) - a;
      // The middle of the bone counts: the ends belong to the neighbours as well.
      const double t =
          std::clamp((middle - a).dot(d) / std::max(d.squaredNorm(), 1e-9), 0.25, 0.75);
      const double distance = (middle - a - t * d).norm();
      if (best < 0 || distance < best) best = distance;
    }
    if (best >= 0 && std::isfinite(best)) scored.push_back({j, best});
  }
  const auto taken = [&](int joint) { return !contours_of(document.frames[frame], joint).empty(); };
  // One that has its outline here already is less likely.
  const auto worth = [&](const Scored& s) { return s.distance * (taken(s.joint) ? 3 : 1); };
  std::stable_sort(scored.begin(), scored.end(),
                   [&](const Scored& a, const Scored& b) { return worth(a) < worth(b); });
  std::vector<Candidate> result;
  const auto propose = [&](int joint, const std::string& reason) {
    if (joint < 0) return;
    for (Candidate& candidate : result)
      if (candidate.joint == joint) {
        if (candidate.reason.find(reason) == std::string::npos) candidate.reason += " · " + reason;
        return;
      }
    result.push_back({joint, reason});
  };
  if (scored.empty()) return result;
  const int nearest = scored[0].joint;
  propose(nearest, "nearest bone");
  const Likeness own = likeness(line);
  double closest = 0.5;  // of a natural logarithm: shapes farther off aren't alike
  int alike = -1;
  std::string where;
  for (int f = 0; f < int(document.frames.size()); ++f) {
    if (f == frame) continue;
    for (const Contour& contour : document.frames[f].contours) {
      if (!contour.line.closed || taken(contour.joint)) continue;
      const Likeness other = likeness(contour.line);
      const double apart = std::abs(std::log(other.area / std::max(own.area, 1e-9))) +
                           std::abs(std::log(other.slenderness / own.slenderness));
      if (apart < closest) {
        closest = apart;
        alike = contour.joint;
        where = document.frames[f].name;
      }
    }
  }
  if (alike >= 0) propose(alike, where.empty() ? "same shape elsewhere" : "same shape in " + where);
  if (scored.size() > 1) propose(scored[1].joint, "next bone");
  propose(skeleton.joints[nearest].mirror, "its mirror image");
  return result;
}

}  // namespace artisketch
