#include "model/rig/body_plan.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string_view>

namespace artisketch {
namespace {

using WordList = std::span<const std::string_view>;

// What the parts of a limb are called; the first words of a list are preferred to later ones, which
// mean another part in some vocabularies (docs/MOTION.md).
constexpr std::string_view kUpperArm[] = {"upperarm",  "uparm",    "humerus",   "shldr",
                                          "shldrbend", "armupper", "upperwing", "wingupper",
                                          "arm",       "shoulder"};
constexpr std::string_view kForearm[] = {"forearm",     "lowerarm", "loarm",     "foarm",
                                         "forearmbend", "armlower", "lowerwing", "winglower",
                                         "elbow",       "radius"};
constexpr std::string_view kHand[] = {"wrist", "hand", "wing"};
constexpr std::string_view kCollar[] = {"collar", "clavicle", "scapula", "shoulder"};
constexpr std::string_view kThigh[] = {"thigh",      "upleg",     "upperleg", "femur", "legupper",
                                       "upperthigh", "thighbend", "hip",      "leg"};
constexpr std::string_view kShin[] = {"shin",  "calf",     "lowerleg", "loleg",
                                      "tibia", "leglower", "knee",     "leg"};
constexpr std::string_view kFoot[] = {"ankle", "foot", "paw", "hoof"};
constexpr std::string_view kToe[] = {"toe", "toes", "toebase", "ball", "foot", "paw"};
constexpr std::string_view kHips[] = {"hips", "pelvis", "hip", "body", "root"};
constexpr std::string_view kHead[] = {"head", "skull"};
constexpr std::string_view kFinger[] = {"middle",     "handmiddle", "fingermiddle", "fingers",
                                        "finger",     "handindex",  "index",        "fingerindex",
                                        "fingerbase", "hand"};

bool above(const Skeleton& skeleton, int ancestor, int joint) {
  for (joint = skeleton.joints[joint].parent; joint >= 0; joint = skeleton.joints[joint].parent)
    if (joint == ancestor) return true;
  return false;
}

// The nearest joint that both hang from, themselves included.
int common(const Skeleton& skeleton, int a, int b) {
  while (a != b) (a > b ? a : b) = skeleton.joints[a > b ? a : b].parent;
  return a;
}

class Finder {
 public:
  Finder(const Skeleton& skeleton, const std::vector<Vec3>& at) : skeleton_(skeleton), at_(at) {
    for (const Joint& joint : skeleton.joints) names_.push_back(joint_name(joint.name));
    found_.guessed.assign(std::size_t(skeleton.size()), false);
    measure();
  }

  BodyPlan find(bool shapes) {
    for (int s = 0; s < 2; ++s) {
      named_leg(s);
      named_arm(s);
    }
    tops_from_below();
    find_trunk(shapes);
    for (int s = 0; s < 2; ++s) {
      complete(found_.legs[std::size_t(s)]);
      complete(found_.arms[std::size_t(s)]);
    }
    find_collars();
    find_tail();
    return std::move(found_);
  }

 private:
  // Length of the longest chain below each joint.
  void measure() {
    reach_.assign(std::size_t(skeleton_.size()), 0);
    for (int j = skeleton_.size() - 1; j > 0; --j) {
      const int parent = skeleton_.joints[j].parent;
      reach_[parent] = std::max(reach_[parent], reach_[j] + (at_[j] - at_[parent]).norm());
    }
  }

  // The first joint of a side under the most preferred of the words, that `fits`.
  template <class Fits>
  int named(int side, WordList words, const Fits& fits) const {
    for (const std::string_view word : words)
      for (int j = 0; j < skeleton_.size(); ++j) {
        const JointName& name = names_[j];
        if (name.word == word && !name.helper && int(name.side) == side && fits(j)) return j;
      }
    return -1;
  }

  void named_leg(int s) {
    LimbJoints& leg = found_.legs[std::size_t(s)];
    const auto hind = [&](int j) { return !names_[j].fore; };
    const int side = s + 1;
    leg.upper = named(side, kThigh, hind);
    const auto below = [&](int top) {
      return [this, top, hind](int j) { return hind(j) && (top < 0 || above(skeleton_, top, j)); };
    };
    leg.lower = named(side, kShin, below(leg.upper));
    leg.end = named(side, kFoot, below(leg.lower >= 0 ? leg.lower : leg.upper));
    if (leg.end >= 0) leg.tip = named(side, kToe, below(leg.end));
  }

  void named_arm(int s) {
    LimbJoints& arm = found_.arms[std::size_t(s)];
    const int side = s + 1;
    const auto fore = [&](int j) { return names_[j].fore; };
    if (named(side, kThigh, fore) >= 0) {  // a front leg, under a leg's names
      arm.upper = named(side, kThigh, fore);
      arm.lower = named(side, kShin, fore);
      arm.end = named(side, kFoot, fore);
      arm.tip = named(side, kToe, [&](int j) { return fore(j) && j != arm.end; });
      return;
    }
    const auto any = [](int) { return true; };
    arm.upper = named(side, kUpperArm, any);
    const auto below = [&](int top) {
      return [this, top](int j) { return top < 0 || above(skeleton_, top, j); };
    };
    arm.lower = named(side, kForearm, below(arm.upper));
    arm.end = named(side, kHand, below(arm.lower >= 0 ? arm.lower : arm.upper));
    if (arm.end >= 0) arm.tip = named(side, kFinger, below(arm.end));
  }

  // Where a shin or forearm is known and what it hangs from isn't, that is the limb's top.
  void tops_from_below() {
    for (auto* pair : {&found_.arms, &found_.legs})
      for (LimbJoints& limb : *pair)
        if (limb.upper < 0 && limb.lower >= 0) {
          limb.upper = skeleton_.joints[limb.lower].parent;
          if (limb.upper >= 0) found_.guessed[limb.upper] = true;
        }
  }

  // Joints from an upper one to a lower one, both included.
  std::vector<int> path(int from, int to) const {
    std::vector<int> joints;
    for (int j = to; j >= 0; j = skeleton_.joints[j].parent) {
      joints.push_back(j);
      if (j == from) break;
    }
    std::reverse(joints.begin(), joints.end());
    return joints;
  }

  int longest_child(int joint) const {
    int best = -1;
    double length = 0;
    for (const int child : skeleton_.children(joint)) {
      const double reach = reach_[child] + (at_[child] - at_[joint]).norm();
      if (!names_[child].helper && reach > length) {
        best = child;
        length = reach;
      }
    }
    return best;
  }

  // What the names leave open of a limb whose top is known.
  void complete(LimbJoints& limb) {
    if (limb.upper < 0) return;
    const auto guess = [&](int joint) {
      if (joint >= 0) found_.guessed[joint] = true;
      return joint;
    };
    if (limb.lower < 0 && limb.end >= 0) {
      // The one in the middle bends.
      const std::vector<int> joints = path(limb.upper, limb.end);
      double best = 1e300;
      for (std::size_t i = 1; i + 1 < joints.size(); ++i) {
        if (names_[joints[i]].helper) continue;
        const double off = std::abs((at_[joints[i]] - at_[limb.upper]).norm() -
                                    (at_[joints[i]] - at_[limb.end]).norm());
        if (off < best) limb.lower = joints[i], best = off;
      }
      guess(limb.lower);
    }
    const auto named_child = [&](int joint) {
      const int child = longest_child(joint);
      return child >= 0 && !skeleton_.joints[child].name.empty() ? child : -1;
    };
    if (limb.lower < 0 && limb.end < 0) limb.lower = guess(named_child(limb.upper));
    if (limb.end < 0 && limb.lower >= 0) limb.end = guess(named_child(limb.lower));
    if (limb.tip < 0 && limb.end >= 0) {
      const std::vector<int> children = skeleton_.children(limb.end);
      for (const int child : children)
        if (names_[child].word.find("thumb") == std::string::npos &&
            (at_[child] - at_[limb.end]).norm() > 1e-6 * reach_[0])
          if (limb.tip < 0 || reach_[child] > 1.5 * reach_[limb.tip]) limb.tip = child;
    }
  }

  void find_collars() {
    for (int s = 0; s < 2; ++s) {
      LimbJoints& arm = found_.arms[std::size_t(s)];
      if (arm.upper < 0) continue;
      arm.collar = named(s + 1, kCollar,
                         [&](int j) { return j != arm.upper && above(skeleton_, j, arm.upper); });
      // What stands between the trunk and one arm alone.
      const int parent = skeleton_.joints[arm.upper].parent;
      if (arm.collar < 0 && parent >= 0 && found_.chest >= 0 &&
          above(skeleton_, found_.chest, parent)) {
        arm.collar = parent;
        found_.guessed[parent] = true;
      }
    }
  }

  int common_of(const std::array<LimbJoints, 2>& pair) const {
    if (pair[0].upper >= 0 && pair[1].upper >= 0)
      return common(skeleton_, pair[0].upper, pair[1].upper);
    for (const LimbJoints& limb : pair)
      if (limb.upper >= 0) return skeleton_.joints[limb.upper].parent;
    return -1;
  }

  void find_trunk(bool shapes) {
    const auto any = [](int) { return true; };
    if (shapes && found_.legs[0].upper < 0 && found_.legs[1].upper < 0) guess_legs();
    found_.hips = common_of(found_.legs);
    if (found_.hips < 0) found_.hips = named(0, kHips, any);
    if (found_.hips < 0) return;
    if (shapes && found_.arms[0].upper < 0 && found_.arms[1].upper < 0) guess_arms();
    found_.chest = common_of(found_.arms);
    if (found_.chest >= 0 && !above(skeleton_, found_.hips, found_.chest)) found_.chest = -1;
    const int base = found_.chest >= 0 ? found_.chest : found_.hips;
    found_.head = named(0, kHead, [&](int j) { return above(skeleton_, base, j); });
    if (found_.head < 0) found_.head = guessed_head(base);
    if (found_.head >= 0)
      found_.trunk = path(found_.hips, found_.head);
    else
      found_.trunk = path(found_.hips, base);
    std::erase_if(found_.trunk, [&](int j) { return names_[j].helper; });
  }

  bool of_limb(int joint) const {
    for (const auto* pair : {&found_.arms, &found_.legs})
      for (const LimbJoints& limb : *pair)
        if (limb.upper >= 0 && (joint == limb.upper || above(skeleton_, joint, limb.upper)))
          return true;
    return false;
  }

  // The end of what rises from the chest beside the arms: as long as one joint follows another, or,
  // where the face hangs from it, as long as they are called alike.
  int guessed_head(int base) {
    int next = -1;
    double best = 0;
    const Vec3 along = trunk_direction(base);
    for (const int child : skeleton_.children(base)) {
      if (of_limb(child) || skeleton_.joints[child].name.empty() || names_[child].helper ||
          names_[child].word.starts_with("tail") || names_[child].side != Side::none)
        continue;
      const double rise = (at_[child] - at_[base]).dot(along) + 0.1 * reach_[child];
      if (next < 0 || rise > best) next = child, best = rise;
    }
    if (next < 0 || base == 0) return -1;
    for (;;) {
      std::vector<int> children;
      for (const int child : skeleton_.children(next))
        if (!skeleton_.joints[child].name.empty() && !names_[child].helper)
          children.push_back(child);
      const auto alike = std::find_if(children.begin(), children.end(), [&](int child) {
        return names_[child].word == names_[next].word;
      });
      if (alike != children.end())
        next = *alike;
      else if (children.size() == 1 && names_[children[0]].side == Side::none &&
               names_[next].word.starts_with("neck"))
        next = children[0];
      else
        break;
    }
    found_.guessed[next] = true;
    return next;
  }

  // From the hips to the chest, or upwards.
  Vec3 trunk_direction(int base) const {
    const Vec3 way = at_[base] - at_[found_.hips];
    return way.norm() > 1e-9 ? Vec3(way.normalized()) : Vec3(Vec3::UnitY());
  }

  // Child chains of a joint that are as long as each other, to within a fifth, and stand apart.
  std::optional<std::pair<int, int>> pair_below(int joint, bool lowest) const {
    std::optional<std::pair<int, int>> best;
    double best_height = 0;
    const std::vector<int> children = skeleton_.children(joint);
    for (std::size_t i = 0; i < children.size(); ++i)
      for (std::size_t k = i + 1; k < children.size(); ++k) {
        const int a = children[i], b = children[k];
        if (reach_[a] < 0.1 * reach_[0] || std::abs(reach_[a] - reach_[b]) > 0.2 * reach_[a])
          continue;
        if (bends_below(a) < 1 || bends_below(b) < 1 || of_limb(a) || of_limb(b)) continue;
        const double height = end_below(a).y() + end_below(b).y();
        if (!best || (lowest ? height < best_height : reach_[a] > reach_[best->first])) {
          best = {a, b};
          best_height = height;
        }
      }
    return best;
  }

  int bends_below(int joint) const {
    int bends = 0;
    for (int child = longest_child(joint); child >= 0; child = longest_child(child)) ++bends;
    return bends;
  }

  Vec3 end_below(int joint) const {
    for (int child = longest_child(joint); child >= 0; child = longest_child(child)) joint = child;
    return at_[joint];
  }

  void take_pair(std::array<LimbJoints, 2>& limbs, std::pair<int, int> pair) {
    // By name where a side shows there, else by where they stand: the figure looks along +z.
    const auto side_of = [&](int joint) {
      for (int j = joint; j >= 0; j = longest_child(j))
        if (names_[j].side != Side::none) return names_[j].side;
      return Side::none;
    };
    bool first_left = at_[pair.first].x() > at_[pair.second].x();
    if (const Side side = side_of(pair.first); side != Side::none)
      first_left = side == Side::left;
    else if (const Side other = side_of(pair.second); other != Side::none)
      first_left = other == Side::right;
    limbs[0].upper = first_left ? pair.first : pair.second;
    limbs[1].upper = first_left ? pair.second : pair.first;
    for (LimbJoints& limb : limbs) {
      // A short joint before the limb proper carries it: a collar, a hip's joint.
      const int next = longest_child(limb.upper);
      if (next >= 0 && (at_[next] - at_[limb.upper]).norm() < 0.25 * reach_[limb.upper] &&
          bends_below(next) >= 2)
        limb.upper = next;
      found_.guessed[limb.upper] = true;
    }
  }

  void guess_legs() {
    for (int j = 0; j < skeleton_.size(); ++j)
      if (skeleton_.children(j).size() >= 3)
        if (const auto pair = pair_below(j, true)) return take_pair(found_.legs, *pair);
  }

  void guess_arms() {
    for (int j = found_.hips + 1; j < skeleton_.size(); ++j)
      if (above(skeleton_, found_.hips, j) && skeleton_.children(j).size() >= 2)
        if (const auto pair = pair_below(j, false)) return take_pair(found_.arms, *pair);
  }

  void find_tail() {
    for (int j = 0; j < skeleton_.size(); ++j)
      if (names_[j].word.starts_with("tail") && names_[j].side == Side::none && !names_[j].helper)
        found_.tail.push_back(j);
  }

  const Skeleton& skeleton_;
  const std::vector<Vec3>& at_;
  std::vector<JointName> names_;
  std::vector<double> reach_;
  BodyPlan found_;
};

}  // namespace

BodyPlan body_plan_of(const Skeleton& skeleton, const std::vector<Vec3>& at, bool shapes) {
  return Finder(skeleton, at).find(shapes);
}

std::optional<Vec3> standing_direction(const BodyPlan& plan, const std::vector<Vec3>& at) {
  Vec3 up = Vec3::Zero();
  for (const LimbJoints& leg : plan.legs)
    if (leg.upper >= 0 && std::max(leg.end, leg.lower) >= 0)
      up += at[leg.upper] - at[leg.end >= 0 ? leg.end : leg.lower];
  if (plan.trunk.size() > 1) up += at[plan.trunk.back()] - at[plan.trunk.front()];
  constexpr double kNothing = 1e-9;
  return up.norm() > kNothing ? std::optional(Vec3(up.normalized())) : std::nullopt;
}

std::vector<Vec3> places_of(const std::vector<Transform>& posed) {
  std::vector<Vec3> at;
  at.reserve(posed.size());
  for (const Transform& joint : posed) at.push_back(joint.translation());
  return at;
}

Vec3 forward_of(const BodyPlan& plan, const std::vector<Vec3>& at) {
  Vec3 side = Vec3::Zero();
  for (const auto* pair : {&plan.legs, &plan.arms})
    if ((*pair)[0].upper >= 0 && (*pair)[1].upper >= 0)
      side += (at[(*pair)[0].upper] - at[(*pair)[1].upper]).normalized();
  Vec3 forward = side.cross(Vec3::UnitY());
  forward.y() = 0;
  return forward.norm() > 1e-6 ? Vec3(forward.normalized()) : Vec3(Vec3::UnitZ());
}

}  // namespace artisketch
