// The part's inside is walked from its joint and from its bone's end at once: where the way from
// the joint is a given share of both ways together, one is that far along, however it bends. The
// middles of such stretches are its middle line, and across them it is cut.
#include "document/split.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "document/edit.h"
#include "document/posing.h"
#include "document/skeleton_edit.h"

namespace artisketch {
namespace {

constexpr int kAcross = 96;            // cells along a part's larger side
constexpr int kStretches = 24;         // of the middle line
constexpr int kFirst = 2, kLast = 21;  // of them: the ends belong to the neighbours as well
constexpr int kLow = 6, kHigh = 17;    // where a bend is looked for
constexpr double kNever = std::numeric_limits<double>::infinity();

// The inside of a part's closed outlines, in cells.
class Inside {
 public:
  explicit Inside(const std::vector<Polyline>& lines) {
    std::vector<Polyline> closed;
    for (const Polyline& line : lines)
      if (line.closed) closed.push_back(line);
    if (closed.empty()) return;
    const Box2 box = bounds(closed);
    step_ = box.sizes().maxCoeff() / kAcross;
    if (!(step_ > 0)) return;
    corner_ = box.min();
    width_ = int(box.sizes().x() / step_) + 1;
    height_ = int(box.sizes().y() / step_) + 1;
    for (int i = 0; i < width_ * height_; ++i) taken_.push_back(contains(closed, middle_of(i)));
  }
  bool empty() const {
    return std::none_of(taken_.begin(), taken_.end(), [](bool t) { return t; });
  }
  int size() const { return int(taken_.size()); }
  bool has(int cell) const { return taken_[std::size_t(cell)]; }
  double step() const { return step_; }
  Vec2 middle_of(int cell) const {
    return corner_ + step_ * Vec2(cell % width_ + 0.5, cell / width_ + 0.5);
  }
  int nearest(const Vec2& place) const {
    int best = -1;
    double least = kNever;
    for (int i = 0; i < size(); ++i)
      if (const double d = (middle_of(i) - place).squaredNorm(); has(i) && d < least)
        least = d, best = i;
    return best;
  }
  // How far each cell is from one, by ways inside; pixels.
  std::vector<double> ways_from(int cell) const {
    std::vector<double> ways(taken_.size(), kNever);
    using Reached = std::pair<double, int>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> next;
    next.push({0, cell});
    while (!next.empty()) {
      const auto [way, at] = next.top();
      next.pop();
      if (way >= ways[std::size_t(at)]) continue;
      ways[std::size_t(at)] = way;
      const int x = at % width_, y = at / width_;
      for (int v = std::max(0, y - 1); v <= std::min(height_ - 1, y + 1); ++v)
        for (int u = std::max(0, x - 1); u <= std::min(width_ - 1, x + 1); ++u)
          if (const int i = v * width_ + u; has(i))
            next.push({way + step_ * std::hypot(u - x, v - y), i});
    }
    return ways;
  }

 private:
  std::vector<bool> taken_;
  Vec2 corner_ = Vec2::Zero();
  double step_ = 0;
  int width_ = 0, height_ = 0;
};

// A part as one drawing shows it.
struct Limb {
  Inside inside;
  std::vector<double> along;  // per cell, 0 … 1; kNever: not reached
  std::vector<Vec2> middle;   // of each stretch
  double way = 0;             // pixels, from the joint to the bone's end
  double width = 0;           // on the mean
  double along_at(const Vec2& place) const { return along[std::size_t(inside.nearest(place))]; }
};

bool is_leaf(const Skeleton& skeleton, int joint) {
  return skeleton.children(joint).empty();
}

std::optional<Limb> limb_in(const Document& document, int frame, int joint) {
  Limb limb{Inside(contours_of(document.frames[frame], joint)), {}, {}, 0, 0};
  const std::vector<DrawnBone> bones = drawn_bones(document, frame)[joint];
  if (limb.inside.empty() || bones.size() != 1) return std::nullopt;
  const int start = limb.inside.nearest(bones[0].from);
  const std::vector<double> from = limb.inside.ways_from(start);
  int tip = limb.inside.nearest(bones[0].to);
  // A bone without an end of its own goes to the part's tip.
  if (is_leaf(document.skeleton, joint))
    for (int i = 0; i < limb.inside.size(); ++i)
      if (from[i] < kNever && (from[tip] == kNever || from[i] > from[tip])) tip = i;
  if (from[tip] == kNever || from[tip] < 4 * limb.inside.step()) return std::nullopt;
  limb.way = from[tip];
  const std::vector<double> to = limb.inside.ways_from(tip);
  std::vector<double> weights(kStretches, 0);
  limb.middle.assign(kStretches, Vec2::Zero());
  for (int i = 0; i < limb.inside.size(); ++i) {
    limb.along.push_back(from[i] < kNever ? from[i] / (from[i] + to[i]) : kNever);
    if (limb.along[i] == kNever) continue;
    const int stretch = std::min(kStretches - 1, int(kStretches * limb.along[i]));
    limb.middle[stretch] += limb.inside.middle_of(i);
    weights[stretch] += 1;
    limb.width += limb.inside.step() * limb.inside.step() / limb.way;
  }
  for (int k = 0; k < kStretches; ++k) {
    if (weights[k] == 0 && k >= kFirst && k <= kLast) return std::nullopt;  // too short for a line
    if (weights[k] > 0) limb.middle[k] /= weights[k];
  }
  return limb;
}

// How far the middle line lies from one that is broken at a stretch, mean square over its length.
double misses(const Limb& limb, int at) {
  const auto off = [&](int k, const Vec2& a, const Vec2& b) {
    const Vec2 d = b - a;
    const double t =
        std::clamp((limb.middle[k] - a).dot(d) / std::max(d.squaredNorm(), 1e-9), 0.0, 1.0);
    return (limb.middle[k] - a - t * d).squaredNorm();
  };
  double sum = 0;
  for (int k = kFirst; k <= kLast; ++k)
    sum += k < at ? off(k, limb.middle[kFirst], limb.middle[at])
                  : off(k, limb.middle[at], limb.middle[kLast]);
  return sum / (limb.way * limb.way);
}

// Toward the side to which y goes from x; radians. What is short for its width has no bend to speak
// of.
double angle_at(const Limb& limb, int at) {
  constexpr double kSlender = 2.5;  // length over width
  if (limb.way < kSlender * limb.width) return 0;
  const Vec2 before = limb.middle[at] - limb.middle[kFirst],
             after = limb.middle[kLast] - limb.middle[at];
  return std::atan2(cross(before, after), before.dot(after));
}

int bend_in(const std::vector<const Limb*>& limbs) {
  int best = kStretches / 2;
  double least = kNever;
  for (int at = kLow; at <= kHigh; ++at) {
    double sum = 0;
    for (const Limb* limb : limbs) sum += misses(*limb, at);
    if (sum < least) least = sum, best = at;
  }
  return best;
}

double along_of(int stretch) {
  return (stretch + 0.5) / kStretches;
}

std::vector<std::optional<Limb>> limbs_of(const Document& document, int joint) {
  std::vector<std::optional<Limb>> limbs;
  for (int f = 0; f < int(document.frames.size()); ++f)
    limbs.push_back(limb_in(document, f, joint));
  return limbs;
}

std::optional<Fold> fold_in(const std::vector<std::optional<Limb>>& limbs) {
  std::vector<const Limb*> all, bent;
  std::vector<double> angles{0};  // of a straight one
  for (const std::optional<Limb>& limb : limbs) {
    if (!limb) continue;
    all.push_back(&*limb);
    const double angle = angle_at(*limb, bend_in({&*limb}));
    if (std::abs(angle) >= kFold) bent.push_back(&*limb);
    angles.push_back(angle);
  }
  if (all.empty()) return std::nullopt;
  const auto [least, most] = std::minmax_element(angles.begin(), angles.end());
  // A straight one tells nothing about where others bend.
  return Fold{bent.empty() ? 0.5 : along_of(bend_in(bent)), *most - *least};
}

int mirror_of(const Skeleton& skeleton, int joint) {
  const int mirror = skeleton.joints[joint].mirror;
  return mirror >= 0 && mirror != joint ? mirror : -1;
}

// ---------------------------------------------------------------- cutting

// The outline of the part's cut through a place of its middle line; whether it was.
bool cut_one(std::vector<Contour>& contours, int joint, int beyond, const Limb& limb,
             const Vec2& place, const Vec2& along, double at) {
  const Vec2 across(-along.y(), along.x());
  const double far = kAcross * limb.inside.step();
  constexpr double kOverlap = 0.3;  // as the tool that cuts by hand
  for (std::size_t c = 0; c < contours.size(); ++c) {
    if (contours[c].joint != joint || !contours[c].line.closed) continue;
    auto halves =
        cut_outline(contours[c].line, place - far * across, place + far * across, kOverlap);
    if (!halves) continue;
    auto& [near, other] = *halves;
    const auto mean = [&](const Polyline& half) {
      double sum = 0, count = 0;
      for (int i = 0; i < limb.inside.size(); ++i)
        if (limb.along[i] < kNever && contains(half, limb.inside.middle_of(i)))
          sum += limb.along[i], ++count;
      return count > 0 ? sum / count : at;
    };
    if (mean(near) > mean(other)) std::swap(near, other);
    Contour second{beyond, std::move(other), contours[c].unknown};
    contours[c].line = std::move(near);
    contours.insert(contours.begin() + std::ptrdiff_t(c) + 1, std::move(second));
    // Holes and strokes go with the half that they lie in.
    for (std::size_t k = 0; k < contours.size(); ++k)
      if (contours[k].joint == joint && k != c &&
          limb.along_at(centroid(std::span(&contours[k].line, 1))) > at)
        contours[k].joint = beyond;
    return true;
  }
  return false;
}

// The bend lies in the picture: the bone before it swings there, and what hangs on the new joint
// stays as it is seen.
void pose_to_bend(Document& document, int frame, int beyond, const Vec2& place) {
  const Skeleton& skeleton = document.skeleton;
  const FrameCamera camera = frame_camera(document, frame);
  Pose& pose = document.frames[frame].pose;
  const std::vector<Transform> before = posed_joints(skeleton, pose);
  pose = with_bone_toward(skeleton, pose, camera, beyond, place);
  for (const int child : skeleton.children(beyond)) {
    pose = with_bone_toward(skeleton, pose, camera, child,
                            camera.project(before[child].translation()));
    const Quat now(posed_joints(skeleton, pose)[beyond].rotation());
    pose.rotations[child] = (now.conjugate() * Quat(before[child].rotation())).normalized();
  }
}

// Units that the part's bone without an end is long, as the drawing shows it.
double length_of(const Document& document, int frame, int joint, const Limb& limb) {
  const FrameCamera camera = frame_camera(document, frame);
  const Vec3 place =
      posed_joints(document.skeleton, document.frames[frame].pose)[joint].translation();
  const double unit = (camera.project(place + Vec3::UnitX()) - camera.project(place)).norm();
  return unit > 0 ? limb.way / unit : 0;
}

struct Whole {
  std::vector<std::optional<Limb>> limbs;  // by frame
  double length = 0;                       // of a bone without an end
};

bool cut_part(Document& document, int joint, int beyond, const Whole& whole, double along) {
  bool any = false;
  for (int f = 0; f < int(document.frames.size()); ++f) {
    if (!whole.limbs[f]) continue;
    const Limb& limb = *whole.limbs[f];
    const int own = bend_in({&limb});
    const bool bent = std::abs(angle_at(limb, own)) >= kFold;
    const int at = bent ? own : std::clamp(int(along * kStretches), kFirst, kLast);
    const Vec2 way = limb.middle[std::min(at + 2, kLast)] - limb.middle[std::max(at - 2, kFirst)];
    if (!(way.norm() > 0)) continue;
    if (!cut_one(document.frames[f].contours, joint, beyond, limb, limb.middle[at],
                 way.normalized(), along_of(at)))
      continue;
    any = true;
    if (bent || is_leaf(document.skeleton, beyond))
      pose_to_bend(document, f, beyond, limb.middle[at]);
  }
  return any;
}

}  // namespace

bool can_split(const Document& document, int joint) {
  if (joint < 0 || joint >= document.skeleton.size()) return false;
  return document.skeleton.children(joint).size() <= 1 &&
         std::any_of(document.frames.begin(), document.frames.end(),
                     [&](const Frame& frame) { return !closed_contours(frame, joint).empty(); });
}

std::optional<Fold> fold_of(const Document& document, int joint) {
  return can_split(document, joint) ? fold_in(limbs_of(document, joint)) : std::nullopt;
}

std::optional<double> along_part(const Document& document, int frame, int joint,
                                 const Vec2& place) {
  const std::optional<Limb> limb =
      can_split(document, joint) ? limb_in(document, frame, joint) : std::nullopt;
  if (!limb || limb->along_at(place) == kNever) return std::nullopt;
  return limb->along_at(place);
}

std::optional<Document> with_part_split(const Document& document, int joint,
                                        std::optional<double> along) {
  if (!can_split(document, joint)) return std::nullopt;
  const int mirror = mirror_of(document.skeleton, joint);
  std::vector<Whole> wholes;
  std::vector<std::optional<Limb>> all;
  for (const int part : {joint, mirror}) {
    if (part < 0) continue;
    Whole whole{limbs_of(document, part), 0};
    for (int f = 0; f < int(document.frames.size()); ++f)
      if (whole.limbs[f])
        whole.length = std::max(whole.length, length_of(document, f, part, *whole.limbs[f]));
    all.insert(all.end(), whole.limbs.begin(), whole.limbs.end());
    wholes.push_back(std::move(whole));
  }
  const std::optional<Fold> fold = fold_in(all);
  if (!fold) return std::nullopt;
  const double at = std::clamp(along.value_or(fold->along), 0.1, 0.9);
  double length = 0;
  for (const Whole& whole : wholes) length = std::max(length, whole.length);
  Document next = with_joint_in_bone(document, joint, at, length);
  const auto numbered = [&](int part) {
    return next.skeleton.find(document.skeleton.joints[part].name);
  };
  const auto joint_beyond = [&](int part) {
    return next.skeleton.children(numbered(part)).front();
  };
  bool any = cut_part(next, numbered(joint), joint_beyond(joint), wholes[0], at);
  if (mirror >= 0 && next.skeleton.children(numbered(mirror)).size() == 1 &&
      next.skeleton.joints[joint_beyond(mirror)].mirror == joint_beyond(joint))
    any |= cut_part(next, numbered(mirror), joint_beyond(mirror), wholes[1], at);
  if (!any) return std::nullopt;
  return next;
}

}  // namespace artisketch
