#include "model/rig/feet.h"

#include <algorithm>
#include <cmath>

#include "base/rotation.h"

namespace artisketch {
namespace {

constexpr double kRamp = 0.12;        // seconds over which a foot goes to its place and leaves it
constexpr double kStraight = 0.9995;  // of a leg's length: as far as it reaches
// Of a leg: nobody sees a foot so little off its place, and a leg that is nearly straight would
// bend by degrees to mend it.
constexpr double kUnseen = 0.003;
constexpr double kMostPitch = 1.5;  // of what the motion's foot points down: a shorter foot's

Quat turn_of(const Transform& joint) {
  return Quat(joint.linear()).normalized();
}

// What planting changes at one pose: added to where the ankle is, turned after what the foot's turn
// is.
struct Mend {
  Vec3 way = Vec3::Zero();
  Quat turn = Quat::Identity();
};

// Where a foot stands, from one pose to another.
struct Stand {
  std::size_t begin = 0, end = 0;
  Vec3 toes = Vec3::Zero(), ankle = Vec3::Zero();  // where they are while it is flat
  Vec3 shift = Vec3::Zero();      // from where the motion has the ankle then, on average
  Quat flat = Quat::Identity();   // its turn then, upright
  Quat level = Quat::Identity();  // and what makes that of the motion's, on average
};

double yaw_of(const Quat& turn, const Vec3& ahead) {
  const Vec3 way = turn * ahead;
  return std::atan2(way.x(), way.z()) - std::atan2(ahead.x(), ahead.z());
}

// Feet that already stand right stay as the motion has them: a foot is moved by what its place is
// off, which is nothing then, and beside a stand that fades.
class Planter {
 public:
  Planter(const Skeleton& skeleton, const FootTrack& foot, const Clip& clip)
      : skeleton_(skeleton), foot_(foot), clip_(clip), rest_(rest_positions(skeleton)) {
    const LimbJoints& limb = foot.limb;
    if (limb.tip >= 0) to_toe_ = rest_[limb.tip] - rest_[limb.end];
    toes_ = to_toe_.norm() > 1e-9;
    ahead_ = level(to_toe_);
    if (ahead_.norm() < 1e-9) ahead_ = Vec3::UnitZ();
    for (std::size_t k = 0; k < clip.poses.size(); ++k) {
      const std::vector<Transform> posed = posed_joints(skeleton, clip.poses[k]);
      ankle_.push_back(posed[limb.end].translation());
      turn_.push_back(turn_of(posed[limb.end]));
      top_.push_back(posed[limb.upper].translation());
    }
    find_stands();
    find_targets();
  }

  double length() const {
    return (rest_[foot_.limb.lower] - rest_[foot_.limb.upper]).norm() +
           (rest_[foot_.limb.end] - rest_[foot_.limb.lower]).norm();
  }
  // How far the root must sink for a leg that stands to reach its foot.
  double lack(std::size_t k) const {
    if (!stands(k)) return 0;
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
  static Vec3 level(Vec3 way) {
    way.y() = 0;
    return way;
  }
  bool stands(std::size_t k) const { return foot_.stands[k] || (toes_ && foot_.toes_stand[k]); }
  // How far the toes point up, against how they do at rest.
  double pitch(const Quat& turn) const {
    return std::asin(std::clamp((turn * to_toe_).y() / to_toe_.norm(), -1.0, 1.0)) - rest_pitch();
  }
  double rest_pitch() const { return std::asin(to_toe_.y() / to_toe_.norm()); }
  // Pitched further, toes up.
  Quat pitched(const Quat& turn, double angle) const {
    const Vec3 side = level(turn * to_toe_).cross(Vec3::UnitY());
    if (side.norm() < 1e-9 * to_toe_.norm()) return turn;
    return Quat(Eigen::AngleAxisd(angle, side.normalized())) * turn;
  }

  void find_stands() {
    const std::size_t count = ankle_.size();
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

  // The poses of a stand in which the foot lies as it does for most of it: heels that rise over the
  // toes or strike before them are none of these. All, where it stands on its toes alone.
  std::vector<std::size_t> flat_poses(const Stand& stand) const {
    std::vector<std::size_t> flat;
    for (std::size_t k = stand.begin; k < stand.end; ++k)
      if (foot_.stands[k]) flat.push_back(k);
    if (flat.empty())
      for (std::size_t k = stand.begin; k < stand.end; ++k) flat.push_back(k);
    if (!toes_) return flat;
    std::vector<double> pitches;
    for (const std::size_t k : flat) pitches.push_back(pitch(turn_[k]));
    std::nth_element(pitches.begin(), pitches.begin() + std::ptrdiff_t(pitches.size() / 2),
                     pitches.end());
    const double usual = pitches[pitches.size() / 2];
    constexpr double kAlike = 2;  // degrees
    std::erase_if(
        flat, [&](std::size_t k) { return std::abs(pitch(turn_[k]) - usual) > radians(kAlike); });
    return flat;
  }

  void settle(Stand& stand) const {
    const std::vector<std::size_t> flat = flat_poses(stand);
    const bool on_sole = foot_.stands[flat.front()];
    Eigen::Vector4d turns = Eigen::Vector4d::Zero();
    Vec3 ankle = Vec3::Zero();
    double x = 0, z = 0;
    for (const std::size_t k : flat) {
      const double yaw = yaw_of(turn_[k], ahead_);
      x += std::sin(yaw);
      z += std::cos(yaw);
      const Eigen::Vector4d q = turn_[k].coeffs();
      turns += q.dot(turns) < 0 ? Eigen::Vector4d(-q) : q;
      ankle += ankle_[k] / double(flat.size());
    }
    Quat mean;
    mean.coeffs() = turns.normalized();
    stand.flat =
        on_sole ? Quat(Eigen::AngleAxisd(std::atan2(x, z), Vec3::UnitY())) : on_tiptoe(mean, ankle);
    stand.level = stand.flat * mean.conjugate();
    stand.toes = ankle + stand.flat * to_toe_;
    stand.toes.y() = toes_ ? foot_.toe_height : foot_.height;
    stand.ankle = stand.toes - stand.flat * to_toe_;
    stand.shift = stand.ankle - ankle;
  }

  // Pitched so that its toes are on the ground, the ankle where it is.
  Quat on_tiptoe(const Quat& turn, const Vec3& ankle) const {
    const double up = pitch(turn);
    if (!toes_ || up >= 0) return turn;
    const double drop = std::clamp((foot_.toe_height - ankle.y()) / to_toe_.norm(), -1.0, 1.0);
    return pitched(turn, std::clamp(std::asin(drop) - rest_pitch(), kMostPitch * up, 0.0) - up);
  }

  // The foot at a pose of a stand: on its toes or, while these are up, on its heel.
  Mend planted(const Stand& stand, std::size_t k) const {
    Quat turn = stand.level * turn_[k];
    Vec3 target = stand.ankle;
    if (toes_) {
      const double up = pitch(turn);
      if (up < 0) turn = pitched(turn, over_toes(stand, k, turn) - up);
      constexpr double kOnHeel = 4;  // degrees
      const double on_toes = std::clamp(1 - up / radians(kOnHeel), 0.0, 1.0);
      target += on_toes * (stand.toes - turn * to_toe_ - target);
    }
    Vec3 way = target - ankle_[k];
    way *= std::max(0.0, 1 - kUnseen * length() / std::max(way.norm(), 1e-12));
    return {way, turn * turn_[k].conjugate()};
  }

  // How far a foot whose heel is up points down, so that the ankle comes near to where the motion
  // has it: as far as the motion's, where the foot is as long as that one's.
  double over_toes(const Stand& stand, std::size_t k, const Quat& turn) const {
    const Vec3 way = ankle_[k] + stand.shift - stand.toes;
    const double behind = -way.dot(level(turn * to_toe_).normalized());
    return std::clamp(-std::atan2(way.y(), behind) - rest_pitch(), kMostPitch * pitch(turn), 0.0);
  }

  void find_targets() {
    const std::size_t count = ankle_.size();
    targets_ = ankle_;
    turns_ = turn_;
    for (const Stand& stand : stands_)
      for (std::size_t k = stand.begin; k < stand.end; ++k) apply(planted(stand, k), 1, k);
    for (std::size_t s = 0; s <= stands_.size(); ++s)
      fade(s > 0 ? &stands_[s - 1] : nullptr, s < stands_.size() ? &stands_[s] : nullptr);
    for (std::size_t k = 0; k < count; ++k) keep_above_ground(k);
  }

  void apply(const Mend& mend, double share, std::size_t k) {
    targets_[k] += share * mend.way;
    turns_[k] = Quat::Identity().slerp(share, mend.turn) * turns_[k];
  }

  // Between two stands what either changes fades.
  void fade(const Stand* before, const Stand* after) {
    const std::size_t begin = before ? before->end : 0, end = after ? after->begin : ankle_.size();
    const Mend left = before ? planted(*before, begin - 1) : Mend(),
               come = after ? planted(*after, end) : Mend();
    for (std::size_t k = begin; k < end; ++k) {
      double a = before ? faded(clip_.times[k] - clip_.times[begin - 1]) : 0;
      double b = after ? faded(clip_.times[end] - clip_.times[k]) : 0;
      if (const double sum = a + b; sum > 1) a /= sum, b /= sum;
      if (a > 0) apply(left, a, k);
      if (b > 0) apply(come, b, k);
    }
  }
  static double faded(double since) {
    const double t = std::clamp(1 - since / kRamp, 0.0, 1.0);
    return t * t * (3 - 2 * t);
  }

  // Heel and toes. Toes that hang too low are lifted by the foot before the leg is.
  void keep_above_ground(std::size_t k) {
    Vec3& target = targets_[k];
    Quat& turn = turns_[k];
    if (toes_) {
      const double room = std::clamp((foot_.toe_height - target.y()) / to_toe_.norm(), -1.0, 1.0);
      const double least = std::min(std::asin(room) - rest_pitch(), 0.0);
      if (const double up = pitch(turn); up < least) turn = pitched(turn, least - up);
    }
    const double heel = foot_.height - target.y();
    const double toe = toes_ ? foot_.toe_height - (target + turn * to_toe_).y() : 0;
    target.y() += std::max({0.0, heel * (toes_ ? level_share(turn) : 1), toe});
  }

  // An ankle may come lower than at rest while the foot points down or up; flat it may not.
  double level_share(const Quat& turn) const {
    return std::clamp(1 - std::abs(pitch(turn)) / radians(60), 0.0, 1.0);
  }

  const Skeleton& skeleton_;
  const FootTrack& foot_;
  const Clip& clip_;
  std::vector<Vec3> rest_, ankle_, top_, targets_;
  std::vector<Quat> turn_, turns_;
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

void plant_feet(const Skeleton& skeleton, const std::vector<FootTrack>& feet, Clip& clip) {
  std::vector<Planter> planters;
  for (const FootTrack& foot : feet)
    if (foot.limb.lower >= 0) planters.emplace_back(skeleton, foot, clip);
  if (planters.empty()) return;
  std::vector<double> lacks(clip.poses.size(), 0);
  for (std::size_t k = 0; k < lacks.size(); ++k)
    for (const Planter& planter : planters) lacks[k] = std::max(lacks[k], planter.lack(k));
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
