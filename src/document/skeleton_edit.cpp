#include "document/skeleton_edit.h"

#include <algorithm>
#include <cmath>

#include "base/ensure.h"
#include "document/edit.h"

namespace artisketch {
namespace {

constexpr int kNone = -1;

std::string side_of(const std::string& name) {
  const std::size_t n = name.size();
  const bool sided = n > 2 && name[n - 2] == '.' && (name[n - 1] == 'L' || name[n - 1] == 'R');
  return sided ? name.substr(n - 2) : "";
}

std::string without_side(const std::string& name) {
  return name.substr(0, name.size() - side_of(name).size());
}

std::string other_side(const std::string& side) {
  return side == ".L" ? ".R" : side == ".R" ? ".L" : side;
}

// How many bytes the character at `at` takes in UTF-8 (RFC 3629, section 4); 0 where it is none.
std::size_t character_size(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? unsigned(static_cast<unsigned char>(text[i])) : 0u;
  };
  const unsigned first = byte(at);
  const std::size_t size = first < 0x80                     ? 1
                           : first >= 0xC2 && first <= 0xDF ? 2
                           : first >= 0xE0 && first <= 0xEF ? 3
                           : first >= 0xF0 && first <= 0xF4 ? 4
                                                            : 0;
  // Neither longer than needed, nor half of a pair of UTF-16, nor beyond the last character.
  const unsigned low = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const unsigned high = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  for (std::size_t i = 1; i < size; ++i)
    if (byte(at + i) < (i == 1 ? low : 0x80) || byte(at + i) > (i == 1 ? high : 0xBF)) return 0;
  return size;
}

// Names that a file can hold: two that differ in what is no text would be alike there.
std::string as_text(const std::string& bytes) {
  std::string text;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t size = character_size(bytes, at);
    text += size ? bytes.substr(at, size) : "\xEF\xBF\xBD";
    at += std::max<std::size_t>(size, 1);
  }
  return text;
}

// Every pose of the document: the frames' and the clips'.
template <class F>
void each_pose(Document& document, const F& f) {
  for (Frame& frame : document.frames) f(frame.pose);
  for (Animation& animation : document.animations)
    for (Key& key : animation.keys) f(key.pose);
}

template <class T>
std::map<int, T> renumbered(const std::map<int, T>& old, const std::vector<int>& now) {
  std::map<int, T> result;
  for (const auto& [joint, value] : old)
    if (now[joint] != kNone) result.emplace(now[joint], value);
  return result;
}

std::vector<int> renumbered(const std::vector<int>& old, const std::vector<int>& now) {
  std::vector<int> result;
  for (const int joint : old)
    if (now[joint] != kNone) result.push_back(now[joint]);
  std::sort(result.begin(), result.end());
  return result;
}

// What counts joints, by the new numbers: now[old], −1 where there is none any more. Contours go to
// heir[old].
Document with_numbers(Document document, Skeleton skeleton, const std::vector<int>& now,
                      const std::vector<int>& heir) {
  for (Frame& frame : document.frames) {
    for (Contour& contour : frame.contours)
      contour.joint = contour.joint == kNone ? kNone : heir[contour.joint];
    frame.hidden = renumbered(frame.hidden, now);
    frame.set_joints = renumbered(frame.set_joints, now);
  }
  each_pose(document, [&](Pose& pose) {
    std::vector<Quat> rotations(std::size_t(skeleton.size()), Quat::Identity());
    for (std::size_t j = 0; j < pose.rotations.size(); ++j)
      if (now[j] != kNone) rotations[now[j]] = pose.rotations[j];
    pose.rotations = std::move(rotations);
  });
  document.spheres = renumbered(document.spheres, now);
  document.parts = renumbered(document.parts, now);
  document.calibration.locked = renumbered(document.calibration.locked, now);
  auto& moved = document.motion.joints;
  for (auto& [name, joint] : moved) joint = joint == kNone ? kNone : now[joint];
  moved.erase(std::remove_if(moved.begin(), moved.end(),
                             [](const auto& pair) { return pair.second == kNone; }),
              moved.end());
  document.skeleton = std::move(skeleton);
  return document;
}

bool is_pair(const Skeleton& skeleton, int joint) {
  const int mirror = skeleton.joints[joint].mirror;
  return mirror >= 0 && mirror != joint;
}

Vec3 reflected(const Vec3& v) {
  return {-v.x(), v.y(), v.z()};
}

double height_of(const Skeleton& skeleton) {
  Box3 box;
  for (const Vec3& p : rest_positions(skeleton)) box.extend(p);
  return std::max(1e-3, box.sizes().maxCoeff());
}

}  // namespace

Document with_skeleton(Document document, Skeleton skeleton) {
  std::vector<int> now;
  for (const Joint& joint : document.skeleton.joints) now.push_back(skeleton.find(joint.name));
  return with_numbers(std::move(document), std::move(skeleton), now, now);
}

Document with_contours_at_bones(Document document) {
  for (std::size_t f = 0; f < document.frames.size(); ++f)
    for (std::size_t c = 0; c < document.frames[f].contours.size(); ++c) {
      if (document.frames[f].contours[c].joint != kNone) continue;
      // Those still without a joint must not be taken for one.
      Document settled = document;
      for (Frame& frame : settled.frames)
        frame.contours.erase(
            std::remove_if(frame.contours.begin(), frame.contours.end(),
                           [](const Contour& contour) { return contour.joint == kNone; }),
            frame.contours.end());
      Contour& contour = document.frames[f].contours[c];
      const std::vector<Candidate> likely = joint_candidates(settled, int(f), contour.line);
      contour.joint = likely.empty() ? 0 : likely[0].joint;
    }
  return document;
}

std::string unique_joint_name(const Skeleton& skeleton, const std::string& wanted, int except) {
  const std::string side = side_of(wanted), base = without_side(wanted);
  std::string name = wanted;
  for (int number = 2;; ++number) {
    const int found = skeleton.find(name);
    if (found < 0 || found == except) return name;
    name = base + " " + std::to_string(number) + side;
  }
}

Document with_joint_added(Document document, int parent, Vec3 offset, bool mirrored) {
  Skeleton& skeleton = document.skeleton;
  ensure(parent >= 0 && parent < skeleton.size(), "a joint of the skeleton");
  const int across = skeleton.joints[parent].mirror;
  const std::vector<Vec3> rest = rest_positions(skeleton);
  constexpr double kMiddle = 0.02;  // of the figure: nearer to its middle plane is on it
  const double off = rest[parent].x() + offset.x() - rest[0].x();
  const bool pair = mirrored && across >= 0 &&
                    (across != parent || std::abs(off) > kMiddle * height_of(skeleton));
  const bool middle = mirrored && across == parent && !pair;
  if (middle) offset.x() -= off;
  // Twice the same number for both sides.
  std::string base = "joint";
  for (int number = 2; skeleton.find(base) >= 0 || skeleton.find(base + ".L") >= 0 ||
                       skeleton.find(base + ".R") >= 0;
       ++number)
    base = "joint " + std::to_string(number);
  const int at = skeleton.size();
  const std::string own = side_of(skeleton.joints[parent].name);
  const std::string side = !pair ? "" : !own.empty() ? own : off > 0 ? ".L" : ".R";
  const auto add = [&](const std::string& name, int to, const Vec3& by, int mirror) {
    skeleton.joints.push_back({name, to, by, mirror, ""});
    each_pose(document, [](Pose& pose) { pose.rotations.push_back(Quat::Identity()); });
  };
  add(base + side, parent, offset, pair ? at + 1 : middle ? at : kNone);
  if (pair) add(base + other_side(side), across, reflected(offset), at);
  return document;
}

namespace {

// Where the joint's bone goes, and the child in which it ends; −1: none.
struct OnlyBone {
  int child = kNone;
  Vec3 offset = Vec3::Zero();
};
OnlyBone only_bone(const Skeleton& skeleton, int joint, double length) {
  const std::vector<int> children = skeleton.children(joint);
  ensure(children.size() <= 1, "a joint of one bone");
  if (!children.empty()) return {children[0], skeleton.joints[children[0]].offset};
  const Vec3 before = skeleton.joints[joint].offset;
  return {kNone, length * (before.norm() > 1e-9 ? before.normalized() : Vec3(0, -1, 0))};
}

// The new joint's number is given back.
Document with_one_in_bone(const Document& document, int joint, double along, double length,
                          int& added) {
  const OnlyBone bone = only_bone(document.skeleton, joint, length);
  Skeleton skeleton = document.skeleton;
  added = bone.child == kNone ? skeleton.size() : bone.child;
  std::vector<int> now;
  for (int j = 0; j < skeleton.size(); ++j) now.push_back(j < added ? j : j + 1);
  const auto number = [&](int j) { return j < 0 ? kNone : now[j]; };
  for (Joint& each : skeleton.joints) {
    each.parent = number(each.parent);
    each.mirror = number(each.mirror);
  }
  const std::string name = unique_joint_name(skeleton, skeleton.joints[joint].name);
  skeleton.joints.insert(skeleton.joints.begin() + added,
                         Joint{name, now[joint], along * bone.offset, kNone, ""});
  if (bone.child != kNone) {
    skeleton.joints[added + 1].parent = added;
    skeleton.joints[added + 1].offset = (1 - along) * bone.offset;
  }
  Document next = with_numbers(document, std::move(skeleton), now, now);
  if (const auto settings = next.parts.find(now[joint]); settings != next.parts.end()) {
    const PartSettings same = settings->second;
    next.parts[added] = same;
  }
  for (Frame& frame : next.frames)
    if (std::binary_search(frame.hidden.begin(), frame.hidden.end(), now[joint]))
      frame.hidden.insert(std::lower_bound(frame.hidden.begin(), frame.hidden.end(), added), added);
  return next;
}

std::optional<Document> without_one(const Document& document, int joint) {
  Skeleton skeleton = document.skeleton;
  const std::vector<int> children = skeleton.children(joint);
  const int parent = skeleton.joints[joint].parent;
  const bool root = parent < 0;
  if (root && children.size() != 1) return std::nullopt;
  const Vec3 offset = skeleton.joints[joint].offset;
  for (int child : children) {
    skeleton.joints[child].parent = parent;
    skeleton.joints[child].offset += offset;
  }
  Document next = document;
  each_pose(next, [&](Pose& pose) {
    if (root) pose.root_position = posed_joints(document.skeleton, pose)[children[0]].translation();
    // The children keep how they stand in the world.
    for (int child : children)
      pose.rotations[child] = (pose.rotations[joint] * pose.rotations[child]).normalized();
  });
  std::vector<int> now, heir;
  for (int j = 0; j < skeleton.size(); ++j)
    now.push_back(j < joint ? j : j == joint ? kNone : j - 1);
  const auto number = [&](int j) { return j < 0 ? kNone : now[j]; };
  heir = now;
  heir[joint] = number(root ? children[0] : parent);
  skeleton.joints.erase(skeleton.joints.begin() + joint);
  for (Joint& each : skeleton.joints) {
    each.parent = number(each.parent);
    each.mirror = number(each.mirror);
  }
  return with_numbers(std::move(next), std::move(skeleton), now, heir);
}

}  // namespace

Document with_joint_in_bone(Document document, int joint, double along, double length) {
  ensure(joint >= 0 && joint < document.skeleton.size(), "a joint of the skeleton");
  const Skeleton before = document.skeleton;
  int added = kNone;
  Document next = with_one_in_bone(document, joint, along, length, added);
  const auto now = [&](int j) { return next.skeleton.find(before.joints[j].name); };
  const int mirror = before.joints[joint].mirror;
  if (mirror == joint) next.skeleton.joints[added].mirror = added;
  if (!is_pair(before, joint) || before.children(mirror).size() != before.children(joint).size())
    return next;
  int across = kNone;
  const std::string name = next.skeleton.joints[added].name;
  next = with_one_in_bone(next, now(mirror), along, length, across);
  added = next.skeleton.find(name);
  next.skeleton.joints[added].mirror = across;
  next.skeleton.joints[across].mirror = added;
  return next;
}

Document with_thing_added(Document document, int parent) {
  document = with_joint_added(std::move(document), parent, Vec3::Zero(), false);
  const int joint = document.skeleton.size() - 1;
  Joint& thing = document.skeleton.joints[joint];
  thing.name = unique_joint_name(document.skeleton, "thing", joint);
  thing.mirror = -1;
  return with_role(std::move(document), joint, Role::held);
}

std::optional<Document> without_joint(const Document& document, int joint, bool mirrored) {
  ensure(joint >= 0 && joint < document.skeleton.size(), "a joint of the skeleton");
  const int mirror = document.skeleton.joints[joint].mirror;
  const bool both = mirrored && is_pair(document.skeleton, joint);
  std::optional<Document> next = without_one(document, both ? std::max(joint, mirror) : joint);
  return both && next ? without_one(*next, std::min(joint, mirror)) : next;
}

Document with_joint_renamed(Document document, int joint, const std::string& words) {
  Skeleton& skeleton = document.skeleton;
  const std::size_t first = words.find_first_not_of(' ');
  if (first == words.npos) return document;
  std::string name = as_text(words.substr(first, words.find_last_not_of(' ') + 1 - first));
  const std::string old = skeleton.joints[joint].name, side = side_of(old);
  const int mirror = skeleton.joints[joint].mirror;
  name = unique_joint_name(skeleton, without_side(name) + side, joint);
  const bool alike = is_pair(skeleton, joint) && !side.empty() &&
                     skeleton.joints[mirror].name == without_side(old) + other_side(side);
  skeleton.joints[joint].name = name;
  if (alike)
    skeleton.joints[mirror].name =
        unique_joint_name(skeleton, without_side(name) + other_side(side), mirror);
  return document;
}

Document with_joint_moved(Document document, int joint, const Vec3& offset, bool mirrored) {
  Skeleton& skeleton = document.skeleton;
  skeleton.joints.at(joint).offset = offset;
  if (mirrored && is_pair(skeleton, joint))
    skeleton.joints[skeleton.joints[joint].mirror].offset = reflected(offset);
  return document;
}

Document with_pair_lengths_equal(Document document, int joint) {
  std::vector<Joint>& joints = document.skeleton.joints;
  for (int j = 0; j < document.skeleton.size(); ++j) {
    const int mirror = joints[j].mirror;
    if (mirror <= j || (joint >= 0 && joint != j && joint != mirror)) continue;
    const double a = joints[j].offset.norm(), b = joints[mirror].offset.norm();
    if (a < 1e-9 || b < 1e-9) continue;
    joints[j].offset *= (a + b) / 2 / a;
    joints[mirror].offset *= (a + b) / 2 / b;
  }
  return document;
}

Document with_figure_scaled(Document document, double factor) {
  ensure(factor > 0, "a factor above 0");
  std::vector<Joint>& joints = document.skeleton.joints;
  for (std::size_t j = 1; j < joints.size(); ++j) joints[j].offset *= factor;
  for (auto& [joint, sphere] : document.spheres) {
    if (sphere.radius) *sphere.radius *= factor;
    sphere.offset *= factor;
  }
  return document;
}

}  // namespace artisketch
