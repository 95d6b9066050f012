#include "model/rig/retarget.h"

#include <algorithm>
#include <cmath>

#include "base/rotation.h"

namespace artisketch {
namespace {

// Letters and digits alone, in lower case; other alphabets as they are.
std::string plain_name(const std::string& name) {
  std::string plain;
  for (const char c : name) {
    if (c >= 'A' && c <= 'Z')
      plain += char(c - 'A' + 'a');
    else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (c & 0x80))
      plain += c;
  }
  return plain;
}

// Per joint of the document the motion's joint that moves it, −1 where none does.
std::vector<int> movers(const Document& document, const Motion& motion) {
  std::vector<int> mover(document.skeleton.size(), -1);
  std::vector<bool> taken(motion.skeleton.size(), false);
  for (const auto& [name, joint] : document.motion.joints)
    if (const int m = motion.skeleton.find(name); m >= 0) {
      mover[joint] = m;
      taken[m] = true;
    }
  for (int j = 0; j < document.skeleton.size(); ++j) {
    const std::string name = plain_name(document.skeleton.joints[j].name);
    for (int m = 0; m < motion.skeleton.size() && mover[j] < 0 && !name.empty(); ++m)
      if (!taken[m] && plain_name(motion.skeleton.joints[m].name) == name) {
        mover[j] = m;
        taken[m] = true;
      }
  }
  return mover;
}

// Where the bone of `joint` leads: to the one mapped joint that comes next below it, or to its only
// child where none does. Nothing where several do: a pelvis has no direction.
std::optional<int> next_joint(const Skeleton& skeleton, int joint,
                              const std::vector<bool>& mapped) {
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
  if (next.size() != 1) return std::nullopt;
  return next[0];
}

// Turns the bone of joint j of the document at rest into that of joint m of the motion at rest.
Quat rest_difference(const Skeleton& ours, int j, const std::vector<bool>& our_mapped,
                     const Skeleton& theirs, int m, const std::vector<bool>& their_mapped) {
  const auto our_next = next_joint(ours, j, our_mapped);
  const auto their_next = next_joint(theirs, m, their_mapped);
  if (!our_next || !their_next) return Quat::Identity();
  const std::vector<Vec3> our_rest = rest_positions(ours), their_rest = rest_positions(theirs);
  const Vec3 a = our_rest[*our_next] - our_rest[j], b = their_rest[*their_next] - their_rest[m];
  if (a.norm() < 1e-9 || b.norm() < 1e-9) return Quat::Identity();
  return least_turn(a, b);
}

struct Stature {
  double hips = 0;  // of the root above the lowest joint
  double whole = 0;
};
Stature stature(const Skeleton& skeleton) {
  double lowest = 0, highest = 0;
  Box3 box;
  const std::vector<Vec3> rest = rest_positions(skeleton);
  for (const Vec3& p : rest) {
    lowest = std::min(lowest, p.y() - rest[0].y());
    highest = std::max(highest, p.y() - rest[0].y());
    box.extend(p);
  }
  return {-lowest, box.sizes().maxCoeff()};
}

}  // namespace

Result<Clip> retargeted(const Document& document, const Motion& motion) {
  const Skeleton &ours = document.skeleton, &theirs = motion.skeleton;
  const std::vector<int> mover = movers(document, motion);
  std::vector<bool> our_mapped(ours.size(), false), their_mapped(theirs.size(), false);
  for (int j = 0; j < ours.size(); ++j)
    if (mover[j] >= 0) our_mapped[j] = their_mapped[mover[j]] = true;
  if (std::find(our_mapped.begin(), our_mapped.end(), true) == our_mapped.end())
    return bad_input("the motion '" + motion.name + "' moves no joint of the document: its '" +
                     theirs.joints[0].name + "' is none; name pairs in /motion/joints, like { \"" +
                     theirs.joints[0].name + "\": \"" + ours.joints[0].name + "\" }");

  std::vector<Quat> difference(ours.size(), Quat::Identity());
  for (int j = 0; j < ours.size(); ++j)
    if (mover[j] >= 0)
      difference[j] = rest_difference(ours, j, our_mapped, theirs, mover[j], their_mapped);

  const Stature our_size = stature(ours), their_size = stature(theirs);
  constexpr double kLeast = 0.05;  // of the whole; hips lower than this are no hips
  const bool stands =
      our_size.hips > kLeast * our_size.whole && their_size.hips > kLeast * their_size.whole;
  const double scale = stands                 ? our_size.hips / their_size.hips
                       : their_size.whole > 0 ? our_size.whole / their_size.whole
                                              : 1;
  const int way = std::max(mover[0], 0);  // whose way the root follows
  const auto place = [&](const Pose& pose) {
    return Vec3(posed_joints(theirs, pose)[way].translation());
  };
  Vec3 start = place(motion.poses[0]);
  // Where the motion's ground is at 0, a figure that begins crouching stays on it.
  if (stands && way == 0 && std::abs(start.y() - their_size.hips) < their_size.hips / 2)
    start.y() = their_size.hips;

  Clip clip{motion.name, {}, {}};
  for (std::size_t k = 0; k < motion.poses.size(); ++k) {
    const std::vector<Transform> posed = posed_joints(theirs, motion.poses[k]);
    Pose pose = rest_pose(ours);
    pose.root_position = ours.joints[0].offset + scale * (place(motion.poses[k]) - start);
    std::vector<Quat> turned(ours.size());
    for (int j = 0; j < ours.size(); ++j) {
      const int parent = ours.joints[j].parent;
      const Quat above = parent < 0 ? Quat(Quat::Identity()) : turned[parent];
      turned[j] = mover[j] < 0 ? above : Quat(posed[mover[j]].linear()) * difference[j];
      turned[j].normalize();
      pose.rotations[j] = (above.conjugate() * turned[j]).normalized();
    }
    clip.times.push_back(double(k) * motion.step);
    clip.poses.push_back(std::move(pose));
  }
  return clip;
}

}  // namespace artisketch
