#include "model/rig/retarget.h"

#include <algorithm>
#include <cmath>

#include "base/rotation.h"
#include "base/words.h"
#include "model/rig/feet.h"
#include "model/rig/retarget_aims.h"
#include "model/rig/upright_motion.h"

namespace artisketch {
namespace {

constexpr double kNothing = 1e-9;  // of a length: too short to point anywhere

// ---------------------------------------------------------------- where figures point

// Axes with the second along `primary` and the first as near to `side` as that allows.
Mat3 axes(const Vec3& primary, const Vec3& side) {
  const Vec3 y = primary.normalized();
  Vec3 x = side - y.dot(side) * y;
  x = x.norm() > kNothing ? Vec3(x.normalized()) : y.unitOrthogonal();
  Mat3 all;
  all << x, y, x.cross(y);
  return all;
}

// From the right to the left, where a pair is known.
std::optional<Vec3> across(const std::array<LimbJoints, 2>& pair, const std::vector<Vec3>& at) {
  if (pair[0].upper < 0 || pair[1].upper < 0) return std::nullopt;
  const Vec3 side = at[pair[0].upper] - at[pair[1].upper];
  return side.norm() > kNothing ? std::optional(side) : std::nullopt;
}

std::optional<Vec3> along(const std::vector<Vec3>& at, int from, int to) {
  if (from < 0 || to < 0) return std::nullopt;
  const Vec3 way = at[to] - at[from];
  return way.norm() > kNothing ? std::optional(way) : std::nullopt;
}

struct Frame3 {
  std::optional<Mat3> hips, chest;
};
Frame3 trunk_frames(const BodyPlan& figure, const std::vector<Vec3>& at) {
  Frame3 frames;
  if (figure.trunk.size() < 2) return frames;
  const auto primary = along(at, figure.trunk.front(), figure.trunk.back());
  auto side = across(figure.legs, at);
  if (!side) side = across(figure.arms, at);
  if (primary && side) frames.hips = axes(*primary, *side);
  auto upper = along(at, figure.chest, figure.head);
  if (!upper) upper = primary;
  if (const auto shoulders = across(figure.arms, at); shoulders && upper)
    frames.chest = axes(*upper, *shoulders);
  return frames;
}

class Retargeter {
 public:
  Retargeter(const Document& document, const Motion& motion, const RetargetOptions& options)
      : document_(document),
        ours_(document.skeleton),
        motion_(motion),
        source_(motion),
        options_(options),
        rest_(rest_positions(document.skeleton)) {}

  Result<Retargeted> run() {
    out_.z_up = source_.z_up();
    out_.map = mapped(document_, motion_, places_of(source_.posed(0)));
    if (out_.map.matches.empty())
      return bad_input("the motion '" + motion_.name + "' moves no joint of the document: its '" +
                       theirs().joints[0].name +
                       "' is none; name pairs in /motion/joints, like { \"" +
                       theirs().joints[0].name + "\": \"" + ours_.joints[0].name + "\" }");
    aims_.emplace(ours_, theirs(), out_.map);
    find_reference();
    find_feet();
    find_differences();
    find_scale();
    make_clip();
    finish();
    return std::move(out_);
  }

 private:
  const Skeleton& theirs() const { return motion_.skeleton; }
  const BodyPlan& our() const { return out_.map.ours; }
  const BodyPlan& their() const { return out_.map.theirs; }
  int mover(int joint) const { return joint < 0 ? -1 : out_.map.mover[joint]; }
  bool nobodys(int joint) const {
    const auto& pairs = document_.motion.joints;
    return std::count(pairs.begin(), pairs.end(), std::pair(std::string(), joint)) > 0;
  }

  // ---- the pose in which both figures are compared

  // Of the motion's rest and its poses the one that is most like the document's rest: from there
  // the shortest turns are the right ones. A rest pose made for that (T, A) is preferred.
  void find_reference() {
    const Mat3 mine = trunk_frames(our(), rest_).hips.value_or(Mat3::Identity());
    const auto unlike = [&](int k) {
      const std::vector<Vec3> at = places_of(source_.posed(k));
      const auto frame = trunk_frames(their(), at).hips;
      const Mat3 yours = frame.value_or(Mat3::Identity());
      double sum = 0;
      for (int j = 0; j < ours_.size(); ++j) {
        if (aims_->of_trunk(j) || ends_limb(our(), j)) continue;
        const auto way = aims_->aimed(j, at);
        if (!way || aims_->bone(j).norm() < kNothing) continue;
        const Vec3 a = mine.transpose() * aims_->bone(j).normalized();
        const Vec3 b = yours.transpose() * way->normalized();
        sum += std::pow(std::acos(std::clamp(a.dot(b), -1.0, 1.0)), 2);
      }
      return sum;
    };
    constexpr double kForRest = 0.5;  // radians², for being made to be compared with
    reference_ = -1;
    double best = unlike(-1) - kForRest;
    for (const int k : source_.sampled(100))
      if (const double cost = unlike(k); cost < best) {
        best = cost;
        reference_ = k;
      }
  }

  // ---- differences

  Quat turned(const Transform& joint) const { return Quat(joint.linear()).normalized(); }

  // What takes a joint's turn in the motion to that of the document's: ours = theirs · difference.
  void find_differences() {
    difference_.assign(std::size_t(ours_.size()), Quat::Identity());
    const std::vector<Transform> posed = source_.posed(reference_);
    const std::vector<Vec3> at = places_of(posed);
    const Frame3 mine = trunk_frames(our(), rest_), yours = trunk_frames(their(), at);
    std::vector<Quat> ours(std::size_t(ours_.size()), Quat::Identity());
    for (int j = 0; j < ours_.size(); ++j) {
      const int parent = ours_.joints[j].parent;
      Quat turn = parent >= 0 ? ours[parent] : Quat(Quat::Identity());
      const auto frames = [](const std::optional<Mat3>& to, const std::optional<Mat3>& from) {
        return Quat(Mat3(*to * from->transpose()));
      };
      if (j == our().hips && mine.hips && yours.hips)
        turn = frames(yours.hips, mine.hips);
      else if (j == our().chest && mine.chest && yours.chest && mover(j) >= 0)
        turn = frames(yours.chest, mine.chest);
      if (const auto way = aims_->aimed(j, at);
          way && mover(j) >= 0 && aims_->bone(j).norm() > kNothing && !stands_on(j))
        turn = (least_turn(turn * aims_->bone(j), *way) * turn).normalized();
      ours[j] = turn;
      if (mover(j) >= 0) difference_[j] = (turned(posed[mover(j)]).conjugate() * turn).normalized();
    }
    level_head(posed, ours);
    level_feet();
  }

  // Where the rest pose isn't what is compared with, the head looks ahead on average.
  void level_head(const std::vector<Transform>& reference, const std::vector<Quat>& ours) {
    const int head = our().head;
    if (head < 0 || mover(head) < 0 || reference_ < 0) return;
    int base = ours_.joints[head].parent;
    while (base >= 0 && mover(base) < 0) base = ours_.joints[base].parent;
    if (base < 0) return;
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (const int k : source_.sampled(200)) {
      const std::vector<Transform> posed = source_.posed(k);
      const Quat q = turned(posed[mover(base)]).conjugate() * turned(posed[mover(head)]);
      sum += q.coeffs().dot(sum) < 0 ? Eigen::Vector4d(-q.coeffs()) : q.coeffs();
    }
    if (sum.norm() < kNothing) return;
    Quat mean;
    mean.coeffs() = sum.normalized();
    difference_[head] =
        (mean.conjugate() * turned(reference[mover(base)]).conjugate() * ours[base]).normalized();
  }

  // ---- feet

  bool stands_on(int joint) const {
    return std::any_of(feet_.begin(), feet_.end(),
                       [&](const FootTrack& foot) { return foot.limb.end == joint; });
  }

  // Where the motion's feet are at each time, and how high they are while they stand.
  void find_feet() {
    const auto add = [&](const LimbJoints& mine, const LimbJoints& yours) {
      if (mine.end < 0 || yours.end < 0 || mover(mine.end) != yours.end || mine.upper < 0 ||
          mover(mine.upper) != yours.upper || yours.upper < 0 || nobodys(mine.lower))
        return;
      feet_.push_back({});
      feet_.back().limb = mine;
      their_feet_.push_back(yours);
    };
    for (std::size_t s = 0; s < 2; ++s) add(our().legs[s], their().legs[s]);
    if (four_legged(our(), rest_))
      for (std::size_t s = 0; s < 2; ++s) add(our().arms[s], their().arms[s]);
    if (feet_.empty()) return;
    for (int k = 0; k < source_.size(); ++k) {
      const std::vector<Vec3> at = places_of(source_.posed(k));
      for (std::size_t f = 0; f < feet_.size(); ++f) {
        feet_[f].ankle.push_back(at[their_feet_[f].end]);
        const int tip = their_feet_[f].tip;
        feet_[f].toe.push_back(tip >= 0 ? at[tip] : at[their_feet_[f].end]);
      }
    }
    const std::vector<Vec3> at = places_of(source_.posed(0));
    leg_ = 0;
    for (const LimbJoints& leg : their_feet_) leg_ += length_of(leg, at) / double(feet_.size());
    find_contacts(feet_, leg_, motion_.step);
  }

  static double length_of(const LimbJoints& leg, const std::vector<Vec3>& at) {
    return leg.lower < 0
               ? (at[leg.end] - at[leg.upper]).norm()
               : (at[leg.lower] - at[leg.upper]).norm() + (at[leg.end] - at[leg.lower]).norm();
  }

  // A foot that stands is as flat as at rest in the document, turned as the motion's toes are.
  void level_feet() {
    for (std::size_t f = 0; f < feet_.size(); ++f) {
      const int end = feet_[f].limb.end, tip = feet_[f].limb.tip;
      if (mover(end) < 0) continue;
      const Vec3 mine = tip >= 0 ? level(rest_[tip] - rest_[end]) : Vec3(Vec3::Zero());
      Eigen::Vector4d sum = Eigen::Vector4d::Zero();
      int used = 0;
      const std::size_t count = feet_[f].stands.size(),
                        step = std::max<std::size_t>(1, count / 400);
      for (std::size_t k = 0; k < count; k += step) {
        if (!feet_[f].stands[k]) continue;
        const std::vector<Transform> posed = source_.posed(int(k));
        const std::vector<Vec3> at = places_of(posed);
        Vec3 yours = level(feet_[f].toe[k] - feet_[f].ankle[k]);
        const bool toes = yours.norm() > 0.03 * leg_ && mine.norm() > kNothing;
        const Vec3 from = toes ? mine : forward_of(our(), rest_);
        if (!toes) yours = forward_of(their(), at);
        const double angle = std::atan2(yours.x(), yours.z()) - std::atan2(from.x(), from.z());
        const Quat q =
            turned(posed[mover(end)]).conjugate() * Quat(Eigen::AngleAxisd(angle, Vec3::UnitY()));
        sum += q.coeffs().dot(sum) < 0 ? Eigen::Vector4d(-q.coeffs()) : q.coeffs();
        ++used;
      }
      if (used == 0 || sum.norm() < kNothing) continue;
      difference_[end].coeffs() = sum.normalized();
    }
  }
  static Vec3 level(Vec3 way) {
    way.y() = 0;
    return way;
  }

  // ---- size and place

  struct Stature {
    double hips = 0, whole = 0;  // height of the root above the lowest joint; the longest side
  };
  static Stature stature(const std::vector<Vec3>& at, int hips) {
    Box3 box;
    for (const Vec3& p : at) box.extend(p);
    return {at[hips].y() - box.min().y(), box.sizes().maxCoeff()};
  }

  void find_scale() {
    root_mover_ = std::max(mover(std::max(our().hips, 0)), 0);
    if (!feet_.empty()) {
      double mine = 0;
      for (const FootTrack& foot : feet_)
        mine += length_of(foot.limb, rest_) / double(feet_.size());
      if (leg_ > kNothing) {
        out_.scale = mine / leg_;
        return;
      }
    }
    const std::vector<Vec3> at = places_of(source_.posed(reference_));
    const Stature mine = stature(rest_, 0), yours = stature(at, root_mover_);
    constexpr double kLeast = 0.05;  // of the whole; hips lower than this are no hips
    stands_ = mine.hips > kLeast * mine.whole && yours.hips > kLeast * yours.whole;
    their_hips_ = yours.hips;
    out_.scale = stands_ ? mine.hips / yours.hips : yours.whole > 0 ? mine.whole / yours.whole : 1;
  }

  // The legs' tops, in the middle: what carries the figure.
  static Vec3 tops(const std::vector<LimbJoints>& legs, const std::vector<Vec3>& at) {
    Vec3 sum = Vec3::Zero();
    for (const LimbJoints& leg : legs) sum += at[leg.upper] / double(legs.size());
    return sum;
  }

  void make_clip() {
    out_.clip.name = motion_.name;
    find_stance();
    if (options_.plant_feet) find_tilt();
    Vec3 first = Vec3::Zero();
    for (int k = 0; k < source_.size(); ++k) {
      const std::vector<Transform> posed = source_.posed(k);
      const std::vector<Vec3> at = places_of(posed);
      Pose pose = pose_like(posed, at);
      if (feet_.empty()) {
        Vec3 start = k == 0 ? at[root_mover_] : first;
        if (k == 0) {
          // Where the motion's ground is at 0, a figure that begins crouching stays on it.
          if (stands_ && std::abs(start.y() - their_hips_) < their_hips_ / 2)
            start.y() = their_hips_;
          first = start;
        }
        pose.root_position = ours_.joints[0].offset + out_.scale * (at[root_mover_] - start);
      } else {
        carry(pose, at);
        if (k == 0) first = level(pose.root_position - ours_.joints[0].offset);
        pose.root_position -= first;
      }
      out_.clip.times.push_back(double(k) * motion_.step);
      out_.clip.poses.push_back(std::move(pose));
    }
  }

  void find_stance() {
    const double ground = our_ground();
    for (const FootTrack& foot : feet_) {
      our_legs_.push_back(foot.limb);
      our_stance_ += (rest_[foot.limb.end].y() - ground) / double(feet_.size());
      their_stance_ += foot.stance / double(feet_.size());
    }
  }

  // The root, where the legs' tops go the motion's way.
  void carry(Pose& pose, const std::vector<Vec3>& at) const {
    const std::vector<Vec3> mine = places_of(artisketch::posed_joints(ours_, pose));
    const Vec3 theirs_top = tops(their_feet_, at);
    Vec3 top = out_.scale * theirs_top;
    top.y() = our_stance_ + out_.scale * (theirs_top.y() - their_stance_);
    pose.root_position += top - tops(our_legs_, mine);
  }

  // Forelegs that are longer or shorter against hind legs than the motion's would be bent or
  // stretched by planting them; the trunk leans instead, by as much as brings both to the ground.
  void find_tilt() {
    constexpr double kMost = 3;  // degrees; further than that the legs give way
    const auto fore = [&](std::size_t f) {
      return our_legs_[f].end == our().arms[0].end || our_legs_[f].end == our().arms[1].end;
    };
    std::array<double, 2> high{},
        ahead{};  // of hind and fore feet that stand, and their legs' tops
    std::array<int, 2> count{};
    for (const int k : source_.sampled(200)) {
      const std::vector<Transform> posed = source_.posed(k);
      const std::vector<Vec3> at = places_of(posed);
      Pose pose = pose_like(posed, at);
      carry(pose, at);
      const std::vector<Vec3> mine = places_of(artisketch::posed_joints(ours_, pose));
      const Vec3 forward = forward_of(our(), mine);
      for (std::size_t f = 0; f < feet_.size(); ++f) {
        if (!feet_[f].stands[std::size_t(k)]) continue;
        const LimbJoints& leg = our_legs_[f];
        high[fore(f)] += mine[leg.end].y() - rest_[leg.end].y();
        ahead[fore(f)] += (mine[leg.upper] - pose.root_position).dot(forward);
        ++count[fore(f)];
      }
    }
    if (count[0] == 0 || count[1] == 0) return;
    const double length = ahead[1] / count[1] - ahead[0] / count[0];
    if (length < kNothing) return;
    const double up = high[0] / count[0] - high[1] / count[1];
    tilt_ = std::clamp(std::atan2(up, length), radians(-kMost), radians(kMost));
  }

  // 0, where the document's figure stands on it or a little above, else its lowest joint.
  double our_ground() const {
    double lowest = 1e300, leg = 0;
    for (const FootTrack& foot : feet_) {
      leg = std::max(leg, length_of(foot.limb, rest_));
      for (const int joint : {foot.limb.end, foot.limb.tip})
        if (joint >= 0) lowest = std::min(lowest, rest_[joint].y());
    }
    constexpr double kLow = 0.35;  // of a leg: an ankle over the sole
    return lowest >= -0.01 * leg && lowest < kLow * leg ? 0 : lowest;
  }

  Pose pose_like(const std::vector<Transform>& posed, const std::vector<Vec3>& at) const {
    Pose pose = rest_pose(ours_);
    std::vector<Quat> turns(std::size_t(ours_.size()));
    const Quat lean(
        Eigen::AngleAxisd(tilt_, forward_of(their(), at).cross(Vec3::UnitY()).normalized()));
    for (int j = 0; j < ours_.size(); ++j) {
      const int parent = ours_.joints[j].parent;
      const Quat above = parent < 0 ? Quat(Quat::Identity()) : turns[parent];
      turns[j] = above;
      if (mover(j) >= 0) {
        turns[j] = turned(posed[mover(j)]) * difference_[j];
        const auto way = stands_on(j) ? std::nullopt : aims_->aimed(j, at);
        if (way && aims_->bone(j).norm() > kNothing)
          turns[j] = least_turn(turns[j] * aims_->bone(j), *way) * turns[j];
        if (tilt_ != 0 && before_chest(j)) turns[j] = lean * turns[j];
      }
      turns[j].normalize();
      pose.rotations[j] = (above.conjugate() * turns[j]).normalized();
    }
    return pose;
  }

  bool before_chest(int joint) const {
    for (const int one : our().trunk) {
      if (one == our().chest) return false;
      if (one == joint) return true;
    }
    return false;
  }

  void finish() {
    out_.warnings = motion_.warnings;
    out_.warnings.insert(out_.warnings.end(), out_.map.warnings.begin(), out_.map.warnings.end());
    if (!out_.map.still.empty()) {
      std::string names;
      for (const int joint : out_.map.still)
        names += (names.empty() ? "" : ", ") + ours_.joints[joint].name;
      out_.warnings.push_back("moves nothing of " + names +
                              "; pairs in /motion/joints say what should");
    }
    out_.loops = close_loop(ours_, out_.clip);
    if (options_.plant_feet && !feet_.empty()) {
      // What the motion's feet do, in the document's units and place.
      const double ground = our_ground();
      for (FootTrack& foot : feet_) {
        foot.height = rest_[foot.limb.end].y() - ground;
        foot.toe_height = foot.limb.tip >= 0 ? rest_[foot.limb.tip].y() - ground : foot.height;
      }
      plant_feet(ours_, feet_, out_.clip);
    }
    if (options_.in_place) stay_in_place(out_.clip);
  }

  const Document& document_;
  const Skeleton& ours_;
  const Motion& motion_;
  UprightMotion source_;
  const RetargetOptions& options_;
  const std::vector<Vec3> rest_;
  std::optional<RetargetAims> aims_;  // once joints are mapped
  int reference_ = -1;
  std::vector<Quat> difference_;
  std::vector<FootTrack> feet_;
  std::vector<LimbJoints> their_feet_;
  double leg_ = 0;  // of the motion's
  int root_mover_ = 0;
  bool stands_ = false;
  double their_hips_ = 0;
  std::vector<LimbJoints> our_legs_;
  double our_stance_ = 0, their_stance_ = 0;  // the ankles' height while the figure stands
  double tilt_ = 0;                           // of the trunk, radians, the chest up
  Retargeted out_;
};

}  // namespace

Result<Retargeted> retargeted(const Document& document, const Motion& motion,
                              const RetargetOptions& options) {
  return Retargeter(document, motion, options).run();
}

std::string mapping_words(const Document& document, const Motion& motion,
                          const Retargeted& result) {
  int guessed = 0;
  std::string guesses;
  for (const JointMatch& match : result.map.matches)
    if (match.how == Match::guessed) {
      ++guessed;
      guesses += (guesses.empty() ? "" : ", ") + document.skeleton.joints[match.joint].name +
                 " by " + motion.skeleton.joints[match.mover].name;
    }
  std::string words = "motion " + motion.name + ": " +
                      counted((long long)result.map.matches.size(), "joint") + " moved, " +
                      (result.z_up ? "z" : "y") + " up, " +
                      counted((long long)motion.poses.size(), "pose");
  if (result.loops) words += ", loops";
  if (guessed > 0) words += "; by the tree's shape: " + guesses;
  return words;
}

}  // namespace artisketch
