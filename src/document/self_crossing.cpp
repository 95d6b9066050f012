// Sweep over a line's segments (Shamos and Hoey 1976): a vertical line moves to the right over
// them, and only segments next to each other along it need to be compared. Plain doubles: a touch
// within rounding may pass for a crossing or not, which a person drawing in pixels cannot tell
// either.
#include <algorithm>
#include <cmath>
#include <set>

#include "document/contour.h"

namespace artisketch {
namespace {

// Side of c seen from the line a b: −1, 0, 1; 0 at its ends however the compiler rounds.
int side(const Vec2& a, const Vec2& b, const Vec2& c) {
  if (c == a || c == b) return 0;
  const double s = cross(b - a, c - a);
  return (s > 0) - (s < 0);
}

bool before(const Vec2& a, const Vec2& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

struct Segment {
  Vec2 a, b;  // a before b
};

// Order along the sweep line, of segments that it meets and that don't cross.
struct Below {
  using is_transparent = void;
  const std::vector<Segment>& all;
  bool operator()(int i, int j) const {
    const Segment &s = all[i], &t = all[j];
    if (before(t.a, s.a)) {
      const int at_start = side(t.a, t.b, s.a);
      return (at_start ? at_start : side(t.a, t.b, s.b)) < 0;
    }
    const int at_start = side(s.a, s.b, t.a);
    return (at_start ? at_start : side(s.a, s.b, t.b)) > 0;
  }
  bool operator()(int i, const Vec2& p) const { return side(all[i].a, all[i].b, p) > 0; }
  bool operator()(const Vec2& p, int i) const { return side(all[i].a, all[i].b, p) < 0; }
};

// One passage of the line through a point: where it comes from and where it goes, from there.
struct Passage {
  Vec2 from, to;
};

// Passages through one point cross where their ends alternate round it; they lie on each other
// where two ends point the same way.
bool cross_or_overlap(const std::vector<Passage>& passages) {
  struct End {
    double angle;
    int passage;
    Vec2 towards;
  };
  std::vector<End> ends;
  for (int i = 0; i < int(passages.size()); ++i)
    for (const Vec2& end : {passages[i].from, passages[i].to})
      ends.push_back({std::atan2(end.y(), end.x()), i, end});
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.angle < b.angle; });
  std::vector<int> open;  // passages of which one end was met, innermost last
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Vec2 &one = ends[i].towards, &next = ends[(i + 1) % ends.size()].towards;
    if (cross(one, next) == 0 && one.dot(next) > 0) return true;
    if (!open.empty() && open.back() == ends[i].passage)
      open.pop_back();
    else
      open.push_back(ends[i].passage);
  }
  return !open.empty();
}

class Sweep {
 public:
  explicit Sweep(const Polyline& line);
  std::optional<Vec2> first_crossing();

 private:
  // A multiset, since rounding may make segments look equal that are not.
  using Status = std::multiset<int, Below>;

  // The segments before and after a vertex, −1 at an open line's ends.
  int segment_before(int v) const {
    return v > 0 ? v - 1 : closed_ ? int(segments_.size()) - 1 : -1;
  }
  int segment_after(int v) const { return v < int(segments_.size()) ? v : -1; }
  bool cross_properly(int i, int j);
  bool crosses_next(Status::iterator at);
  bool leave(int segment);
  bool enter(int segment);
  bool passages_cross(std::span<const int> vertices);

  bool closed_;
  std::vector<Vec2> points_;  // without repeated ones
  std::vector<Segment> segments_;
  Status status_{Below{segments_}};
  std::vector<Status::iterator> at_;  // by segment, while it is in the status
  Vec2 found_ = Vec2::Zero();
};

Sweep::Sweep(const Polyline& line) : closed_(line.closed) {
  for (const Vec2& p : line.points)
    if (points_.empty() || p != points_.back()) points_.push_back(p);
  while (closed_ && points_.size() > 1 && points_.back() == points_.front()) points_.pop_back();
  const std::size_t n = points_.size();
  for (std::size_t i = 0; n > 1 && i < (closed_ ? n : n - 1); ++i) {
    const Vec2 &p = points_[i], &q = points_[(i + 1) % n];
    segments_.push_back(before(p, q) ? Segment{p, q} : Segment{q, p});
  }
  at_.resize(segments_.size());
}

bool Sweep::cross_properly(int i, int j) {
  const Segment &s = segments_[i], &t = segments_[j];
  if (side(s.a, s.b, t.a) * side(s.a, s.b, t.b) >= 0 ||
      side(t.a, t.b, s.a) * side(t.a, t.b, s.b) >= 0)
    return false;
  const Vec2 along = s.b - s.a, other = t.b - t.a;
  found_ = s.a + along * (cross(t.a - s.a, other) / cross(along, other));
  return true;
}

bool Sweep::crosses_next(Status::iterator at) {
  if (at == status_.end()) return false;
  const auto next = std::next(at);
  return next != status_.end() && cross_properly(*at, *next);
}

bool Sweep::leave(int segment) {
  const auto next = status_.erase(at_[segment]);
  return next != status_.begin() && crosses_next(std::prev(next));
}

bool Sweep::enter(int segment) {
  const auto at = at_[segment] = status_.insert(segment);
  return crosses_next(at) || (at != status_.begin() && crosses_next(std::prev(at)));
}

// What runs through one place: the vertices there, and the segments of the status with it inside.
bool Sweep::passages_cross(std::span<const int> vertices) {
  const Vec2& p = points_[vertices[0]];
  std::vector<Passage> passages;
  const int n = int(points_.size());
  for (const int v : vertices)
    if (segment_before(v) >= 0 && segment_after(v) >= 0)
      passages.push_back({points_[(v + n - 1) % n] - p, points_[(v + 1) % n] - p});
  const Below below{segments_};
  for (auto s = status_.lower_bound(p); s != status_.end() && !below(p, *s); ++s)
    passages.push_back({segments_[*s].a - p, segments_[*s].b - p});
  if (!cross_or_overlap(passages)) return false;
  found_ = p;
  return true;
}

std::optional<Vec2> Sweep::first_crossing() {
  std::vector<int> order(points_.size());
  for (int v = 0; v < int(order.size()); ++v) order[v] = v;
  std::sort(order.begin(), order.end(), [&](int v, int w) {
    return before(points_[v], points_[w]) || (points_[v] == points_[w] && v < w);
  });
  std::vector<int> ending, starting;
  for (std::size_t i = 0, end = 0; i < order.size(); i = end) {
    const Vec2& p = points_[order[i]];
    ending.clear();
    starting.clear();
    for (end = i; end < order.size() && points_[order[end]] == p; ++end)
      for (const int s : {segment_before(order[end]), segment_after(order[end])})
        if (s >= 0) (segments_[s].b == p ? ending : starting).push_back(s);
    for (const int s : ending)
      if (leave(s)) return found_;
    if (passages_cross({&order[i], end - i})) return found_;
    for (const int s : starting)
      if (enter(s)) return found_;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Vec2> self_crossing(const Polyline& line) {
  return Sweep(line).first_crossing();
}

}  // namespace artisketch
