#include "model/rig/rig_profile.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <vector>

#include "model/rig/body_plan.h"

namespace artisketch {
namespace {

// What a profile calls a person's joints; & stands for the side. No name: it asks for none.
struct Names {
  RigProfile profile;
  const char* root;  // above the hips
  const char* hips;
  std::array<const char*, 4> spine;  // from the hips up, the chest last; fewer: null
  const char *neck, *head;
  const char *collar, *upper_arm, *forearm, *hand;
  const char *thigh, *shin, *foot, *toe;
  const char *left, *right;
};
constexpr Names kProfiles[] = {
    {{"mixamo", "Mixamo"},
     nullptr,
     "mixamorig:Hips",
     {"mixamorig:Spine", "mixamorig:Spine1", "mixamorig:Spine2", nullptr},
     "mixamorig:Neck",
     "mixamorig:Head",
     "mixamorig:&Shoulder",
     "mixamorig:&Arm",
     "mixamorig:&ForeArm",
     "mixamorig:&Hand",
     "mixamorig:&UpLeg",
     "mixamorig:&Leg",
     "mixamorig:&Foot",
     "mixamorig:&ToeBase",
     "Left",
     "Right"},
    {{"unreal", "Unreal's mannequin"},
     "root",
     "pelvis",
     {"spine_01", "spine_02", "spine_03", nullptr},
     "neck_01",
     "head",
     "clavicle_&",
     "upperarm_&",
     "lowerarm_&",
     "hand_&",
     "thigh_&",
     "calf_&",
     "foot_&",
     "ball_&",
     "l",
     "r"},
    {{"unity", "Unity's and VRM's humanoid"},
     nullptr,
     "hips",
     {"spine", "chest", nullptr, nullptr},
     "neck",
     "head",
     "&Shoulder",
     "&UpperArm",
     "&LowerArm",
     "&Hand",
     "&UpperLeg",
     "&LowerLeg",
     "&Foot",
     "&Toes",
     "left",
     "right"},
    {{"godot", "Godot's SkeletonProfileHumanoid"},
     "Root",
     "Hips",
     {"Spine", "Chest", "UpperChest", nullptr},
     "Neck",
     "Head",
     "&Shoulder",
     "&UpperArm",
     "&LowerArm",
     "&Hand",
     "&UpperLeg",
     "&LowerLeg",
     "&Foot",
     "&Toes",
     "Left",
     "Right"},
    {{"rigify", "Blender's Rigify"},
     nullptr,
     "spine",
     {"spine.001", "spine.002", "spine.003", nullptr},
     "spine.004",
     "spine.006",
     "shoulder.&",
     "upper_arm.&",
     "forearm.&",
     "hand.&",
     "thigh.&",
     "shin.&",
     "foot.&",
     "toe.&",
     "L",
     "R"},
};

std::string sided(const char* name, const Names& names, int side) {
  std::string text = name;
  if (const auto at = text.find('&'); at != text.npos)
    text.replace(at, 1, side == 0 ? names.left : names.right);
  return text;
}

// A skeleton that grows joints between others; order is put right at the end.
class Rig {
 public:
  Rig(const Model& model, const Names& names)
      : model_(model),
        names_(names),
        plan_(body_plan_of(model.skeleton, rest_positions(model.skeleton), false)) {
    joints_ = model.skeleton.joints;
    named_.assign(joints_.size(), false);
  }

  bool is_person() const {
    bool whole = plan_.hips == 0 && plan_.chest > 0 && plan_.head > 0;
    for (const auto* pair : {&plan_.arms, &plan_.legs})
      for (const LimbJoints& limb : *pair)
        whole &= limb.upper >= 0 && limb.lower >= 0 && limb.end >= 0;
    if (!whole) return false;
    // Whose trunk lies goes on four legs.
    const std::vector<Vec3> rest = rest_positions(model_.skeleton);
    const Vec3 trunk = rest[plan_.chest] - rest[plan_.hips];
    return trunk.y() > trunk.norm() / 2;
  }

  Model made() {
    name_trunk();
    for (int side = 0; side < 2; ++side) name_limbs(side);
    if (names_.root) add_root();
    tidy_names();
    return in_order();
  }

 private:
  void call(int joint, const std::string& name) {
    joints_[std::size_t(joint)].name = name;
    named_[std::size_t(joint)] = true;
  }

  // A joint on the bone from `child`'s parent to it.
  int put_in(int child, double share, const std::string& name) {
    Joint joint;
    joint.parent = joints_[child].parent;
    joint.offset = share * joints_[child].offset;
    joints_[child].offset -= joint.offset;
    joints_[child].parent = int(joints_.size());
    joints_.push_back(joint);
    named_.push_back(false);
    call(int(joints_.size()) - 1, name);
    return int(joints_.size()) - 1;
  }

  // The joints between two of the trunk: the model's own, then as many more as names are left over.
  void name_between(int from, int to, const std::vector<std::string>& names) {
    std::vector<int> own;
    for (const int joint : plan_.trunk)
      if (joint > from && joint < to) own.push_back(joint);
    std::size_t next = 0;
    for (; next < std::min(own.size(), names.size()); ++next) call(own[next], names[next]);
    for (std::size_t left = names.size() - next; left > 0; --left, ++next)
      put_in(to, 1.0 / double(left + 1), names[next]);
  }

  void name_trunk() {
    call(plan_.hips, names_.hips);
    std::vector<std::string> spine;
    for (const char* name : names_.spine)
      if (name) spine.push_back(name);
    const std::string chest = spine.back();
    spine.pop_back();
    name_between(plan_.hips, plan_.chest, spine);
    call(plan_.chest, chest);
    // Necks are short: an own joint has its place, another stands near the head.
    std::vector<int> own;
    for (const int joint : plan_.trunk)
      if (joint > plan_.chest && joint < plan_.head) own.push_back(joint);
    if (own.empty())
      put_in(plan_.head, 0.7, names_.neck);
    else
      call(own.back(), names_.neck);
    call(plan_.head, names_.head);
  }

  void name_limbs(int side) {
    const LimbJoints &arm = plan_.arms[std::size_t(side)], &leg = plan_.legs[std::size_t(side)];
    if (arm.collar >= 0 && arm.collar != arm.upper)
      call(arm.collar, sided(names_.collar, names_, side));
    else
      put_in(arm.upper, 1.0 / 3, sided(names_.collar, names_, side));
    call(arm.upper, sided(names_.upper_arm, names_, side));
    call(arm.lower, sided(names_.forearm, names_, side));
    call(arm.end, sided(names_.hand, names_, side));
    call(leg.upper, sided(names_.thigh, names_, side));
    call(leg.lower, sided(names_.shin, names_, side));
    call(leg.end, sided(names_.foot, names_, side));
    if (leg.tip < 0) return;
    if (model_.skeleton.children(leg.tip).empty())
      put_in(leg.tip, 2.0 / 3, sided(names_.toe, names_, side));
    else
      call(leg.tip, sided(names_.toe, names_, side));
  }

  // On the ground under the hips; the whole figure's way is its.
  void add_root() {
    Joint root;
    root.name = names_.root;
    joints_.push_back(root);
    named_.push_back(true);
    joints_[plan_.hips].parent = int(joints_.size()) - 1;
  }

  void tidy_names() {
    std::set<std::string> taken;
    for (std::size_t j = 0; j < joints_.size(); ++j)
      if (named_[j]) taken.insert(joints_[j].name);
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      if (named_[j]) continue;
      std::string& name = joints_[j].name;
      // Unreal cuts names at dots and takes none of the others; Godot takes no : and no /.
      for (char& c : name)
        if (std::string_view("./:\\,|&!~@#(){}[]=;^%$`\"' ").find(c) != std::string_view::npos)
          c = '_';
      while (!taken.insert(name).second) name += "_";
    }
  }

  Model in_order() const {
    // Parents first, each joint followed by what hangs from it.
    std::vector<int> order, place(joints_.size(), -1);
    for (std::size_t j = 0; j < joints_.size(); ++j)
      if (joints_[j].parent < 0) add_with_children(int(j), order);
    for (std::size_t i = 0; i < order.size(); ++i) place[std::size_t(order[i])] = int(i);
    Model model = model_;
    model.skeleton.joints.clear();
    for (const int j : order) {
      Joint joint = joints_[std::size_t(j)];
      joint.parent = joint.parent < 0 ? -1 : place[std::size_t(joint.parent)];
      joint.mirror = joint.mirror < 0 ? -1 : place[std::size_t(joint.mirror)];
      model.skeleton.joints.push_back(joint);
    }
    for (Eigen::Index i = 0; i < model.weights.joints.size(); ++i) {
      int& joint = model.weights.joints.data()[i];
      if (model.weights.weights.data()[i] != 0) joint = place[std::size_t(joint)];
    }
    const int root = order[0];
    const bool other_root = root >= model_.skeleton.size();
    for (Clip& clip : model.clips)
      for (Pose& pose : clip.poses) {
        std::vector<Quat> rotations(order.size(), Quat::Identity());
        for (std::size_t j = 0; j < pose.rotations.size(); ++j)
          rotations[std::size_t(place[j])] = pose.rotations[j];
        pose.rotations = std::move(rotations);
        if (other_root) pose.root_position -= model_.skeleton.joints[0].offset;
      }
    return model;
  }

  void add_with_children(int joint, std::vector<int>& order) const {
    order.push_back(joint);
    for (std::size_t j = 0; j < joints_.size(); ++j)
      if (joints_[j].parent == joint) add_with_children(int(j), order);
  }

  const Model& model_;
  const Names& names_;
  const BodyPlan plan_;
  std::vector<Joint> joints_;
  std::vector<bool> named_;
};

}  // namespace

std::span<const RigProfile> rig_profiles() {
  static const std::vector<RigProfile> all = [] {
    std::vector<RigProfile> profiles;
    for (const Names& names : kProfiles) profiles.push_back(names.profile);
    return profiles;
  }();
  return all;
}

Result<Model> with_rig(const Model& model, std::string_view profile) {
  std::string known;
  for (const Names& names : kProfiles) {
    known += (known.empty() ? "" : ", ") + std::string(names.profile.name);
    if (profile != names.profile.name) continue;
    Rig rig(model, names);
    if (!rig.is_person())
      return bad_input(std::string("the skeleton is no person's, as ") + names.profile.about +
                       " is: it wants hips at the root, a chest, a head, two arms and two legs");
    return rig.made();
  }
  return bad_input("there is no rig '" + std::string(profile) + "': there are " + known);
}

}  // namespace artisketch
