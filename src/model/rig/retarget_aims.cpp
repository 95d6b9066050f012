#include "model/rig/retarget_aims.h"

#include <algorithm>

namespace artisketch {
namespace {

constexpr double kNowhere = 1e-9;  // of a length: too short to point anywhere

// The one mapped joint that comes next below, or the only child; −1 where several do.
int next_joint(const Skeleton& skeleton, int joint, const std::vector<bool>& mapped) {
  std::vector<int> next, open = skeleton.children(joint);
  while (!open.empty()) {
    const int j = open.back();
    open.pop_back();
    if (mapped[j]) {
      next.push_back(j);
      continue;
    }
    const std::vector<int> children = skeleton.children(j);
    open.insert(open.end(), children.begin(), children.end());
  }
  if (next.empty()) next = skeleton.children(joint);
  return next.size() == 1 ? next[0] : -1;
}

}  // namespace

bool ends_limb(const BodyPlan& figure, int joint) {
  for (const auto* pair : {&figure.arms, &figure.legs})
    for (const LimbJoints& limb : *pair)
      if (limb.end == joint) return true;
  return false;
}

bool four_legged(const BodyPlan& figure, const std::vector<Vec3>& at) {
  if (figure.trunk.size() < 2) return false;
  const int chest = figure.chest >= 0 ? figure.chest : figure.trunk.back();
  const Vec3 way = at[chest] - at[figure.trunk.front()];
  return std::abs(way.y()) < way.norm() / 2;
}

RetargetAims::RetargetAims(const Skeleton& ours, const Skeleton& theirs, const JointMap& map)
    : ours_(ours),
      theirs_(theirs),
      map_(map),
      rest_(rest_positions(ours)),
      aims_(ours.joints.size()) {
  find_limbs();
  find_trunk();
  find_others();
}

void RetargetAims::find_limbs() {
  const auto limb = [&](const LimbJoints& mine, const LimbJoints& yours) {
    const int our_joints[] = {mine.collar, mine.upper, mine.lower, mine.end, mine.tip};
    const int their_joints[] = {yours.collar, yours.upper, yours.lower, yours.end, yours.tip};
    for (int i = 0; i < 4; ++i) {
      // Where both lack it, neither points anywhere.
      if (our_joints[i] < 0 || their_joints[i] < 0 || mover(our_joints[i]) != their_joints[i])
        continue;
      for (int k = i + 1; k < 5; ++k)
        if (our_joints[k] >= 0 && their_joints[k] >= 0 &&
            (k == 4 || mover(our_joints[k]) == their_joints[k])) {
          aims_[our_joints[i]] = {our_joints[k], their_joints[i], their_joints[k], -1};
          break;
        }
    }
  };
  for (std::size_t s = 0; s < 2; ++s) {
    limb(map_.ours.arms[s], map_.theirs.arms[s]);
    limb(map_.ours.legs[s], map_.theirs.legs[s]);
  }
}

// Trunks are alike as wholes: a joint a third of the way up ours follows the point a third of the
// way up theirs. Where arms are forelegs, the chest is where they are.
void RetargetAims::find_trunk() {
  const std::vector<int>&mine = map_.ours.trunk, &yours = map_.theirs.trunk;
  if (mine.size() < 2 || yours.size() < 2) return;
  const auto at = [](const std::vector<int>& trunk, int joint) {
    return int(std::find(trunk.begin(), trunk.end(), joint) - trunk.begin());
  };
  std::vector<std::pair<int, int>> anchors{{0, 0}};
  const bool heads = map_.ours.head >= 0 && map_.theirs.head >= 0;
  if (map_.ours.chest > map_.ours.hips && map_.theirs.chest > map_.theirs.hips &&
      (four_legged(map_.ours, rest_) || !heads))
    anchors.emplace_back(at(mine, map_.ours.chest), at(yours, map_.theirs.chest));
  else if (!heads && map_.ours.chest < 0)
    anchors.emplace_back(int(mine.size()) - 1, int(yours.size()) - 1);
  if (heads) anchors.emplace_back(int(mine.size()) - 1, int(yours.size()) - 1);
  trunk_at_.clear();
  for (std::size_t a = 0; a + 1 < anchors.size(); ++a) {
    double whole = 0, way = 0;
    for (int i = anchors[a].first; i < anchors[a + 1].first; ++i)
      whole += (rest_[mine[i + 1]] - rest_[mine[i]]).norm();
    for (int i = anchors[a].first; i < anchors[a + 1].first; ++i) {
      trunk_at_.push_back({anchors[a].second, anchors[a + 1].second, way / whole});
      way += (rest_[mine[i + 1]] - rest_[mine[i]]).norm();
    }
  }
  if (anchors.size() < 2 || anchors.back().second == 0) return trunk_at_.clear();
  trunk_at_.push_back({anchors.back().second, anchors.back().second, 0});
  for (int i = 0; i + 1 < int(trunk_at_.size()); ++i)
    if (mover(mine[i]) >= 0) aims_[mine[i]] = {mine[i + 1], -1, -1, i};
}

// Whatever else: from a mapped joint to the one that comes next.
void RetargetAims::find_others() {
  std::vector<bool> mine(ours_.size(), false), yours(theirs_.size(), false);
  for (const JointMatch& match : map_.matches) mine[match.joint] = yours[match.mover] = true;
  for (const JointMatch& match : map_.matches) {
    Aim& aim = aims_[match.joint];
    if (aim.to >= 0 || aim.trunk >= 0 || ends_limb(map_.ours, match.joint) ||
        match.joint == map_.ours.head || match.joint == map_.ours.hips ||
        match.joint == map_.ours.chest)
      continue;
    const int to = next_joint(ours_, match.joint, mine);
    const int their_to = next_joint(theirs_, match.mover, yours);
    if (to >= 0 && their_to >= 0) aim = {to, match.mover, their_to, -1};
  }
}

Vec3 RetargetAims::on_trunk(int i, const std::vector<Vec3>& at) const {
  const OnTrunk& place = trunk_at_[std::size_t(i)];
  const std::vector<int>& trunk = map_.theirs.trunk;
  double whole = 0;
  for (int k = place.from; k < place.to; ++k) whole += (at[trunk[k + 1]] - at[trunk[k]]).norm();
  double left = place.share * whole;
  for (int k = place.from; k < place.to; ++k) {
    const double length = (at[trunk[k + 1]] - at[trunk[k]]).norm();
    if (left <= length && length > 0)
      return at[trunk[k]] + left / length * (at[trunk[k + 1]] - at[trunk[k]]);
    left -= length;
  }
  return at[trunk[place.to]];
}

std::optional<Vec3> RetargetAims::aimed(int joint, const std::vector<Vec3>& at) const {
  const Aim& aim = aims_[joint];
  if (aim.to < 0) return std::nullopt;
  const Vec3 way = aim.trunk >= 0 ? Vec3(on_trunk(aim.trunk + 1, at) - on_trunk(aim.trunk, at))
                                  : Vec3(at[aim.their_to] - at[aim.their_from]);
  return way.norm() > kNowhere ? std::optional(way) : std::nullopt;
}

}  // namespace artisketch
