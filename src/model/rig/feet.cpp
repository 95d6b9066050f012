#include "model/rig/feet.h"

#include <algorithm>
#include <cmath>

#include "base/rotation.h"

namespace artisketch {
namespace {

// ---------------------------------------------------------------- contacts

// All of a leg's length, and seconds.
constexpr double kLow = 0.06;    // higher than this above where it stands, a foot is off the ground
constexpr double kStill = 0.5;   // a leg a second: a foot that swings goes at three or more
constexpr double kBlink = 0.08;  // shorter contacts, and shorter gaps in one, are noise

// The height at which most of the values lie, to within a band; where two do as well, the one that
// a ground at zero would give.
double usual_height(std::vector<double> heights, double leg) {
  std::sort(heights.begin(), heights.end());
  constexpr double kBand = 0.03;
  double best = heights.front();
  double most = -1;
  for (std::size_t first = 0, last = 0; first < heights.size(); ++first) {
    while (last < heights.size() && heights[last] <= heights[first] + kBand * leg) ++last;
    const double middle = heights[first + (last - first) / 2];
    const bool on_zero = middle > -0.02 * leg && middle < 0.3 * leg;
    const double votes = double(last - first) * (on_zero ? 1.5 : 1);
    if (votes > most) {
      most = votes;
      best = middle;
    }
  }
  return best;
}

std::vector<double> speeds_of(const std::vector<Vec3>& at, double step) {
  const std::size_t count = at.size();
  std::vector<double> speeds(count, 0);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t a = k > 0 ? k - 1 : 0, b = std::min(k + 1, count - 1);
    if (b > a) speeds[k] = (at[b] - at[a]).norm() / (double(b - a) * step);
  }
  return speeds;
}

// Runs of `value` that are shorter than `least` become the other.
void drop_short(std::vector<bool>& flags, bool value, std::size_t least) {
  for (std::size_t k = 0; k < flags.size();) {
    std::size_t end = k;
    while (end < flags.size() && flags[end] == flags[k]) ++end;
    const bool at_an_end = k == 0 || end == flags.size();
    if (flags[k] == value && end - k < least && !at_an_end)
      for (std::size_t i = k; i < end; ++i) flags[i] = !value;
    k = end;
  }
}

std::vector<bool> contacts(const std::vector<Vec3>& at, double stance, double leg, double step) {
  const std::vector<double> speeds = speeds_of(at, step);
  std::vector<bool> flags;
  for (std::size_t k = 0; k < at.size(); ++k)
    flags.push_back(std::abs(at[k].y() - stance) < kLow * leg && speeds[k] < kStill * leg);
  const auto least = std::size_t(std::lround(kBlink / step));
  drop_short(flags, false, least);
  drop_short(flags, true, least);
  return flags;
}

// ---------------------------------------------------------------- legs

constexpr double kRamp = 0.12;        // seconds over which a foot goes to its place and leaves it
constexpr double kStraight = 0.9995;  // of a leg's length: as far as it reaches

// 1 where the flag is set, falling to 0 within kRamp beside it.
std::vector<double> ramped(const std::vector<bool>& flags, const std::vector<double>& times) {
  std::vector<double> weights(flags.size(), 0);
  const auto pass = [&](auto begin, auto end, int step) {
    double since = 1e9;
    for (auto k = begin; k != end; k += step) {
      if (flags[std::size_t(k)])
        since = 0;
      else if (k - step >= 0 && k - step < std::ptrdiff_t(flags.size()) && since < 1e9)
        since += std::abs(times[std::size_t(k)] - times[std::size_t(k - step)]);
      const double t = std::clamp(1 - since / kRamp, 0.0, 1.0);
      weights[std::size_t(k)] = std::max(weights[std::size_t(k)], t * t * (3 - 2 * t));
    }
  };
  const auto count = std::ptrdiff_t(flags.size());
  pass(std::ptrdiff_t(0), count, 1);
  pass(count - 1, std::ptrdiff_t(-1), -1);
  return weights;
}

Quat turn_of(const Transform& joint) {
  return Quat(joint.linear()).normalized();
}

// Where a foot stands, from one pose to another.
struct Stand {
  std::size_t begin = 0, end = 0;
  Vec3 pivot = Vec3::Zero();  // of the toes, or the ankle where there are none
  Quat flat = Quat::Identity();
};

double yaw_of(const Quat& turn, const Vec3& ahead) {
  const Vec3 way = turn * ahead;
  return std::atan2(way.x(), way.z()) - std::atan2(ahead.x(), ahead.z());
}

class Planter {
 public:
  Planter(const Skeleton& skeleton, const FootTrack& foot, const Clip& clip)
      : skeleton_(skeleton), foot_(foot), clip_(clip), rest_(rest_positions(skeleton)) {
    const LimbJoints& limb = foot.limb;
    if (limb.tip >= 0) to_toe_ = rest_[limb.tip] - rest_[limb.end];
    ahead_ = Vec3(to_toe_.x(), 0, to_toe_.z());
    if (ahead_.norm() < 1e-9) ahead_ = Vec3::UnitZ();
    toes_ = limb.tip >= 0;
    for (std::size_t k = 0; k < clip.poses.size(); ++k) {
      const std::vector<Transform> posed = posed_joints(skeleton, clip.poses[k]);
      ankle_.push_back(posed[limb.end].translation());
      turn_.push_back(turn_of(posed[limb.end]));
      top_.push_back(posed[limb.upper].translation());
    }
    find_stands();
    find_targets();
  }

  const std::vector<Vec3>& targets() const { return targets_; }
  const std::vector<Quat>& turns() const { return turns_; }
  double length() const {
    return (rest_[foot_.limb.lower] - rest_[foot_.limb.upper]).norm() +
           (rest_[foot_.limb.end] - rest_[foot_.limb.lower]).norm();
  }
  // How far the root must sink for the leg to reach its foot.
  double lack(std::size_t k, double weight_at_least) const {
    if (weights_[k] < weight_at_least) return 0;
    const Vec3 way = top_[k] - targets_[k];
    const double reach = kStraight * length(), across = std::hypot(way.x(), way.z());
    if (way.norm() <= reach) return 0;
    if (across >= reach) return 0;  // no sinking helps
    return way.y() - std::sqrt(reach * reach - across * across);
  }

  void apply(std::size_t k, Pose& pose) const {
    put_limb(skeleton_, foot_.limb, targets_[k], turns_[k], pose);
  }

 private:
  Vec3 pivot_at(std::size_t k) const { return ankle_[k] + turn_[k] * to_toe_; }

  void find_stands() {
    const std::size_t count = ankle_.size();
    const auto stands = [&](std::size_t k) {
      return foot_.stands[k] || (toes_ && foot_.toes_stand[k]);
    };
    for (std::size_t k = 0; k < count;) {
      if (!stands(k)) {
        ++k;
        continue;
      }
      Stand stand;
      stand.begin = k;
      while (k < count && stands(k)) ++k;
      stand.end = k;
      settle(stand);
      stands_.push_back(stand);
    }
  }

  // The mean of where the foot is while it is flat, else while its toes stand.
  void settle(Stand& stand) const {
    bool any_flat = false;
    for (std::size_t k = stand.begin; k < stand.end; ++k) any_flat |= bool(foot_.stands[k]);
    Vec3 sum = Vec3::Zero();
    double x = 0, z = 0;
    int used = 0;
    for (std::size_t k = stand.begin; k < stand.end; ++k) {
      if (any_flat && !foot_.stands[k]) continue;
      const double yaw = yaw_of(turn_[k], ahead_);
      x += std::sin(yaw);
      z += std::cos(yaw);
      sum += pivot_at(k);
      ++used;
    }
    stand.flat = Quat(Eigen::AngleAxisd(std::atan2(x, z), Vec3::UnitY()));
    stand.pivot = sum / used;
    stand.pivot.y() = toes_ ? foot_.toe_height : foot_.height;
  }

  void find_targets() {
    const std::size_t count = ankle_.size();
    std::vector<bool> any(count);
    for (std::size_t k = 0; k < count; ++k)
      any[k] = foot_.stands[k] || (toes_ && foot_.toes_stand[k]);
    weights_ = ramped(any, clip_.times);
    const std::vector<double> flat = ramped(foot_.stands, clip_.times);
    for (std::size_t k = 0; k < count; ++k) {
      Quat turn = turn_[k];
      Vec3 target = ankle_[k];
      if (const Stand* stand = nearest(k); stand && weights_[k] > 0) {
        turn = turn.slerp(flat[k], stand->flat);
        const Vec3 locked = stand->pivot - turn * to_toe_;
        target += weights_[k] * (locked - target);
      }
      // Above the ground, heel and toes.
      const double heel = foot_.height - target.y();
      const double toe = toes_ ? foot_.toe_height - (target + turn * to_toe_).y() : 0;
      target.y() += std::max({0.0, heel * (toes_ ? level_share(turn) : 1), toe});
      targets_.push_back(target);
      turns_.push_back(turn);
    }
  }

  // An ankle may come lower than at rest while the foot points down or up; flat it may not.
  double level_share(const Quat& turn) const {
    const Vec3 way = turn * to_toe_;
    const double tilt = std::abs(std::asin(std::clamp(way.y() / way.norm(), -1.0, 1.0)) -
                                 std::asin(std::clamp(to_toe_.y() / to_toe_.norm(), -1.0, 1.0)));
    return std::clamp(1 - tilt / radians(60), 0.0, 1.0);
  }

  const Stand* nearest(std::size_t k) const {
    const Stand* best = nullptr;
    std::size_t off = ~std::size_t(0);
    for (const Stand& stand : stands_) {
      const std::size_t d = k < stand.begin  ? stand.begin - k
                            : k >= stand.end ? k - stand.end + 1
                                             : 0;
      if (d < off) off = d, best = &stand;
    }
    return best;
  }

  const Skeleton& skeleton_;
  const FootTrack& foot_;
  const Clip& clip_;
  std::vector<Vec3> rest_, ankle_, top_, targets_;
  std::vector<Quat> turn_, turns_;
  std::vector<double> weights_;
  std::vector<Stand> stands_;
  Vec3 to_toe_ = Vec3::Zero(), ahead_ = Vec3::UnitZ();
  bool toes_ = false;
};

// Never less than the values, and without their corners.
std::vector<double> smooth_above(const std::vector<double>& values,
                                 const std::vector<double>& times) {
  const auto within = [&](std::size_t a, std::size_t b) {
    return std::abs(times[a] - times[b]) <= kRamp / 2 + 1e-9;
  };
  const auto filtered = [&](const std::vector<double>& from, bool largest) {
    std::vector<double> to(from.size(), 0);
    for (std::size_t k = 0, first = 0; k < from.size(); ++k) {
      while (!within(first, k)) ++first;
      double sum = 0, most = 0;
      std::size_t i = first;
      for (; i < from.size() && within(i, k); ++i) {
        sum += from[i];
        most = std::max(most, from[i]);
      }
      to[k] = largest ? most : sum / double(i - first);
    }
    return to;
  };
  return filtered(filtered(values, true), false);
}

}  // namespace

void put_limb(const Skeleton& skeleton, const LimbJoints& limb, const Vec3& target,
              const Quat& end_turn, Pose& pose) {
  const std::vector<Transform> posed = posed_joints(skeleton, pose);
  const Vec3 top = posed[limb.upper].translation(), knee = posed[limb.lower].translation();
  const Vec3 end = posed[limb.end].translation();
  const double upper = (knee - top).norm(), lower = (end - knee).norm();
  Vec3 way = target - top;
  if (way.norm() < 1e-9 || upper < 1e-9 || lower < 1e-9) return;
  const double reach =
      std::clamp(way.norm(), std::abs(upper - lower) + 1e-6, kStraight * (upper + lower));
  way.normalize();
  const auto across = [](const Vec3& v, const Vec3& axis) -> Vec3 {
    return v - v.dot(axis) * axis;
  };
  Vec3 bend = across(knee - top, (end - top).normalized());
  if (bend.norm() < 0.01 * upper) {
    const std::vector<Vec3> rest = rest_positions(skeleton);
    const Vec3 at_rest = across(rest[limb.lower] - rest[limb.upper],
                                (rest[limb.end] - rest[limb.upper]).normalized());
    bend = turn_of(posed[limb.upper]) *
           (at_rest.norm() > 0.01 * upper ? at_rest : Vec3(0.1 * upper * Vec3::UnitZ()));
  }
  bend = across(least_turn(end - top, way) * bend, way);
  if (bend.norm() < 1e-9) bend = way.unitOrthogonal();
  const double ahead = (upper * upper - lower * lower + reach * reach) / (2 * reach);
  const double aside = std::sqrt(std::max(0.0, upper * upper - ahead * ahead));
  const Vec3 new_knee = top + ahead * way + aside * bend.normalized();
  const Vec3 new_end = top + reach * way;

  const Quat swing = least_turn(knee - top, new_knee - top);
  const Quat thigh = swing * turn_of(posed[limb.upper]);
  const Quat shin =
      least_turn(swing * (end - knee), new_end - new_knee) * swing * turn_of(posed[limb.lower]);
  // Joints between (twists) keep their own turns: each is turned against its parent as it is then.
  const auto turn_to = [&](int joint, const Quat& wanted) {
    const int parent = skeleton.joints[joint].parent;
    const Quat above =
        parent < 0 ? Quat(Quat::Identity()) : turn_of(posed_joints(skeleton, pose)[parent]);
    pose.rotations[joint] = (above.conjugate() * wanted).normalized();
  };
  turn_to(limb.upper, thigh);
  turn_to(limb.lower, shin);
  turn_to(limb.end, end_turn);
}

void find_contacts(std::vector<FootTrack>& feet, double leg, double step) {
  if (feet.empty() || leg <= 0) return;
  const std::size_t count = feet[0].ankle.size();
  std::vector<double> lowest(count, 1e300);
  for (const FootTrack& foot : feet)
    for (std::size_t k = 0; k < count; ++k) lowest[k] = std::min(lowest[k], foot.ankle[k].y());
  const double ground = usual_height(lowest, leg);
  for (FootTrack& foot : feet) {
    foot.stance = ground;
    foot.stands = contacts(foot.ankle, ground, leg, step);
    // Toes are as high as they are while the foot is flat.
    std::vector<double> heights;
    for (std::size_t k = 0; k < count; ++k)
      if (foot.stands[k]) heights.push_back(foot.toe[k].y());
    if (heights.empty()) {
      foot.toes_stand.assign(count, false);
      continue;
    }
    std::nth_element(heights.begin(), heights.begin() + std::ptrdiff_t(heights.size() / 2),
                     heights.end());
    foot.toes_stand = contacts(foot.toe, heights[heights.size() / 2], leg, step);
  }
}

void plant_feet(const Skeleton& skeleton, const std::vector<FootTrack>& feet, Clip& clip) {
  std::vector<Planter> planters;
  for (const FootTrack& foot : feet)
    if (foot.limb.lower >= 0) planters.emplace_back(skeleton, foot, clip);
  if (planters.empty()) return;
  std::vector<double> lacks(clip.poses.size(), 0);
  constexpr double kPlanted = 0.99;  // of its weight
  for (std::size_t k = 0; k < lacks.size(); ++k)
    for (const Planter& planter : planters)
      lacks[k] = std::max(lacks[k], planter.lack(k, kPlanted));
  const std::vector<double> sinks = smooth_above(lacks, clip.times);
  for (std::size_t k = 0; k < clip.poses.size(); ++k) {
    clip.poses[k].root_position.y() -= sinks[k];
    for (const Planter& planter : planters) planter.apply(k, clip.poses[k]);
  }
}

void stay_in_place(Clip& clip) {
  if (clip.poses.size() < 2) return;
  Vec3 way = clip.poses.back().root_position - clip.poses.front().root_position;
  way.y() = 0;
  const double length = clip.times.back() - clip.times.front();
  for (std::size_t k = 0; k < clip.poses.size(); ++k)
    clip.poses[k].root_position -= (clip.times[k] - clip.times[0]) / length * way;
}

bool close_loop(const Skeleton& skeleton, Clip& clip) {
  const std::size_t count = clip.poses.size();
  constexpr std::size_t kFew = 8;
  constexpr double kShort = 0.4;  // seconds
  if (count < kFew || clip.times.back() - clip.times.front() < kShort) return false;
  const Pose first = clip.poses.front(), last = clip.poses.back();
  const double tall = std::max(1e-9, std::abs(first.root_position.y()));
  constexpr double kNear = 12;   // degrees between the first pose's joints and the last's
  constexpr double kMoves = 15;  // that some joint turns at all: what stands still is no loop
  double apart = 0, most = 0;
  for (int j = 0; j < skeleton.size(); ++j) {
    apart = std::max(apart, first.rotations[j].angularDistance(last.rotations[j]));
    for (const Pose& pose : clip.poses)
      most = std::max(most, first.rotations[j].angularDistance(pose.rotations[j]));
  }
  constexpr double kLevel = 0.03;  // of the root's height
  const double rise = last.root_position.y() - first.root_position.y();
  if (apart > radians(kNear) || most < radians(kMoves) || std::abs(rise) > kLevel * tall)
    return false;
  constexpr double kTail = 0.25;  // of the clip
  const double begin = clip.times.back() - kTail * (clip.times.back() - clip.times.front());
  for (std::size_t k = 0; k < count; ++k) {
    const double t = (clip.times[k] - begin) / (clip.times.back() - begin);
    if (t <= 0) continue;
    const double share = t * t * (3 - 2 * t);
    for (int j = 0; j < skeleton.size(); ++j) {
      const Quat whole = last.rotations[j].conjugate() * first.rotations[j];
      clip.poses[k].rotations[j] =
          (clip.poses[k].rotations[j] * Quat::Identity().slerp(share, whole)).normalized();
    }
    clip.poses[k].root_position.y() -= share * rise;
  }
  clip.poses.back().rotations = first.rotations;
  return true;
}

}  // namespace artisketch
