#include "model/rig/actor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/rotation.h"

namespace artisketch {
namespace {

Quat about(double degrees_, const Vec3& axis) {
  return Quat(Eigen::AngleAxisd(radians(degrees_), axis));
}

struct Entry {
  const char *name, *parent;
  Vec3 offset;
};

// As templates do: the left side's joints again on the right, mirrored.
Skeleton both_sides(std::vector<Entry> entries) {
  Skeleton skeleton;
  const auto right = [](std::string name) {
    if (name.ends_with(".L")) name.back() = 'R';
    return name;
  };
  std::vector<Entry> left;
  for (const Entry& e : entries) {
    skeleton.joints.push_back({e.name, skeleton.find(e.parent), e.offset, -1, ""});
    if (std::string(e.name).ends_with(".L")) left.push_back(e);
  }
  for (const Entry& e : left)
    skeleton.joints.push_back({right(e.name), skeleton.find(right(e.parent)),
                               e.offset.cwiseProduct(Vec3(-1, 1, 1)), -1, ""});
  return skeleton;
}

const std::vector<Entry> kPerson = {{"hips", "", {0, 0.95, 0}},
                                    {"spine", "hips", {0, 0.12, -0.01}},
                                    {"chest", "spine", {0, 0.22, 0}},
                                    {"neck", "chest", {0, 0.22, -0.01}},
                                    {"head", "neck", {0, 0.1, 0.02}},
                                    {"head_end", "head", {0, 0.18, 0}},
                                    {"collar.L", "chest", {0.03, 0.15, 0}},
                                    {"upper_arm.L", "collar.L", {0.14, 0.02, 0}},
                                    {"forearm.L", "upper_arm.L", {0.27, 0, 0}},
                                    {"hand.L", "forearm.L", {0.25, 0, 0}},
                                    {"hand_end.L", "hand.L", {0.1, 0, 0}},
                                    {"thigh.L", "hips", {0.09, -0.04, 0}},
                                    {"shin.L", "thigh.L", {0, -0.42, 0}},
                                    {"foot.L", "shin.L", {0, -0.41, 0}},
                                    {"toe.L", "foot.L", {0, -0.06, 0.13}},
                                    {"toe_end.L", "toe.L", {0, 0, 0.06}}};

const std::vector<Entry> kDog = {{"hips", "", {0, 0.55, -0.4}},
                                 {"spine", "hips", {0, 0.02, 0.25}},
                                 {"chest", "spine", {0, 0.02, 0.25}},
                                 {"neck", "chest", {0, 0.08, 0.12}},
                                 {"head", "neck", {0, 0.12, 0.1}},
                                 {"head_end", "head", {0, -0.02, 0.2}},
                                 {"tail", "hips", {0, 0.03, -0.1}},
                                 {"tail_2", "tail", {0, -0.02, -0.15}},
                                 {"tail_end", "tail_2", {0, -0.03, -0.15}},
                                 {"upper_arm.L", "chest", {0.08, -0.08, 0.05}},
                                 {"forearm.L", "upper_arm.L", {0, -0.2, -0.03}},
                                 {"hand.L", "forearm.L", {0, -0.24, 0.02}},
                                 {"hand_end.L", "hand.L", {0, -0.04, 0.08}},
                                 {"thigh.L", "hips", {0.08, -0.04, 0}},
                                 {"shin.L", "thigh.L", {0, -0.22, 0.06}},
                                 {"foot.L", "shin.L", {0, -0.22, -0.09}},
                                 {"toe_end.L", "foot.L", {0, -0.04, 0.08}}};

// A leg from its top to a wanted ankle, in the plane of its way: both bones' turns. Whether it
// reaches.
bool bend_leg(const Skeleton& skeleton, int upper, int lower, int end, const Vec3& top,
              const Vec3& ankle, double knee_ahead, std::vector<Quat>& turns) {
  const Vec3 a = skeleton.joints[lower].offset, b = skeleton.joints[end].offset;
  Vec3 way = ankle - top;
  const double reach = std::min(way.norm(), 0.999 * (a.norm() + b.norm()));
  way.normalize();
  Vec3 bend = knee_ahead * Vec3::UnitZ();
  bend = (bend - bend.dot(way) * way).normalized();
  const double ahead = (a.squaredNorm() - b.squaredNorm() + reach * reach) / (2 * reach);
  const Vec3 knee = ahead * way + std::sqrt(std::max(0.0, a.squaredNorm() - ahead * ahead)) * bend;
  turns[upper] = least_turn(a, knee);
  turns[lower] = least_turn(b, reach * way - knee);
  return (top + reach * way - ankle).norm() < 1e-3;
}

// One foot's way through a stride that begins with its heel's strike: along the ground at the
// body's pace while it stands, over it in an arc, its pitch from heel to toe.
struct FootAt {
  double ahead, up, pitch;  // of the ankle against the middle of its stance, degrees toes down
  bool on_ground = false;
  bool stands() const { return on_ground && pitch == 0; }
};
FootAt foot_at(double phase, double stride, double stance, double lift, bool rolls) {
  phase -= std::floor(phase);
  const double half = stride * stance / 2;
  if (phase < stance) {
    const double t = phase / stance;
    FootAt at{half - 2 * half * t, 0, 0, true};
    if (rolls && t > 0.7) at.pitch = 30 * std::pow((t - 0.7) / 0.3, 2);
    return at;
  }
  const double t = (phase - stance) / (1 - stance), s = t * t * (3 - 2 * t);
  FootAt at{-half + 2 * half * s, lift * std::sin(kPi * t), 0};
  if (rolls) at.pitch = 30 * (1 - s);
  return at;
}

}  // namespace

const char* rest_word(Rest rest) {
  constexpr const char* kWords[] = {"T", "A", "bones along x", "all one way", "first frame", "any"};
  return kWords[int(rest)];
}

std::vector<Vec3> Actor::at(int pose) const {
  std::vector<Vec3> places;
  for (int j = 0; j < skeleton.size(); ++j) {
    const int parent = skeleton.joints[j].parent;
    places.push_back(parent < 0 ? roots[std::size_t(pose)]
                                : Vec3(places[std::size_t(parent)] +
                                       turns[std::size_t(pose)][std::size_t(parent)] *
                                           skeleton.joints[j].offset));
  }
  return places;
}

Actor walking_person() {
  Actor actor;
  actor.skeleton = both_sides(kPerson);
  const Skeleton& skeleton = actor.skeleton;
  const int poses = 60;
  const double stride = 1.2, stance = 0.6;
  for (int k = 0; k < poses; ++k) {
    const double phase = 2.0 * k / (poses - 1);
    std::vector<Quat> turns(skeleton.joints.size(), Quat::Identity());
    const Vec3 root(0.02 * std::sin(2 * kPi * phase), 0.9 + 0.01 * std::cos(4 * kPi * phase),
                    stride * phase);
    const Quat hips = about(6 * std::sin(2 * kPi * phase), Vec3::UnitY()) * about(4, Vec3::UnitX());
    const Quat chest =
        about(-6 * std::sin(2 * kPi * phase), Vec3::UnitY()) * about(10, Vec3::UnitX());
    for (int j = 0; j < skeleton.size(); ++j) {
      const std::string& name = skeleton.joints[j].name;
      const bool left = name.ends_with(".L");
      const double side = left ? 1 : -1,
                   swing = left ? std::sin(2 * kPi * phase) : -std::sin(2 * kPi * phase);
      const Quat parent =
          skeleton.joints[j].parent < 0 ? Quat(Quat::Identity()) : turns[skeleton.joints[j].parent];
      if (name == "hips")
        turns[j] = hips;
      else if (name == "spine")
        turns[j] = hips.slerp(0.5, chest);
      else if (name == "chest" || name == "neck")
        turns[j] = chest;
      else if (name.starts_with("head"))
        turns[j] = about(3 * std::sin(2 * kPi * phase), Vec3::UnitY());
      else if (name.starts_with("upper_arm"))
        turns[j] = chest * about(-30 * swing, Vec3::UnitX()) * about(-side * 70, Vec3::UnitZ());
      else if (name.starts_with("forearm"))
        turns[j] = parent * about(-side * (25 + 15 * swing), Vec3::UnitY());
      else
        turns[j] = parent;
    }
    std::vector<Vec3> at{root};
    for (int j = 1; j < skeleton.size(); ++j)
      at.push_back(at[skeleton.joints[j].parent] +
                   turns[skeleton.joints[j].parent] * skeleton.joints[j].offset);
    for (const char* side : {".L", ".R"}) {
      const int upper = skeleton.find(std::string("thigh") + side),
                lower = skeleton.find(std::string("shin") + side),
                end = skeleton.find(std::string("foot") + side),
                toe = skeleton.find(std::string("toe") + side),
                tip = skeleton.find(std::string("toe_end") + side);
      const FootAt foot = foot_at(phase + (side[1] == 'L' ? 0 : 0.5), stride, stance, 0.08, true);
      // The toes are what stands: the ankle rises over them.
      // Where it stands it stands: the hips sway over it.
      const Vec3 toes(skeleton.joints[upper].offset.x(), 0.03 + foot.up,
                      stride * phase + foot.ahead + 0.13);
      turns[end] = about(foot.pitch, Vec3::UnitX());
      const Vec3 ankle = toes - turns[end] * skeleton.joints[toe].offset;
      const bool reaches = bend_leg(skeleton, upper, lower, end, at[upper], ankle, 1, turns);
      actor.stands[std::string("foot") + side].push_back(foot.stands() && reaches);
      turns[toe] = turns[tip] = Quat::Identity();
    }
    actor.turns.push_back(std::move(turns));
    actor.roots.push_back(root);
  }
  return actor;
}

Actor walking_dog() {
  Actor actor;
  actor.skeleton = both_sides(kDog);
  const Skeleton& skeleton = actor.skeleton;
  const int poses = 60;
  const double stride = 0.5, stance = 0.65;
  for (int k = 0; k < poses; ++k) {
    const double phase = 2.0 * k / (poses - 1);
    std::vector<Quat> turns(skeleton.joints.size(), Quat::Identity());
    const Vec3 root(0, 0.52 + 0.005 * std::cos(4 * kPi * phase), stride * phase - 0.4);
    for (int j = 0; j < skeleton.size(); ++j) {
      const std::string& name = skeleton.joints[j].name;
      if (name.starts_with("tail")) turns[j] = about(20 * std::sin(2 * kPi * phase), Vec3::UnitY());
      if (name.starts_with("head")) turns[j] = about(5, Vec3::UnitX());
    }
    std::vector<Vec3> at{root};
    for (int j = 1; j < skeleton.size(); ++j)
      at.push_back(at[skeleton.joints[j].parent] +
                   turns[skeleton.joints[j].parent] * skeleton.joints[j].offset);
    const struct {
      const char *upper, *lower, *end, *side;
      double phase, knee;
    } legs[] = {{"upper_arm", "forearm", "hand", ".L", 0.25, -1},
                {"upper_arm", "forearm", "hand", ".R", 0.75, -1},
                {"thigh", "shin", "foot", ".L", 0, 1},
                {"thigh", "shin", "foot", ".R", 0.5, 1}};
    for (const auto& leg : legs) {
      const int upper = skeleton.find(std::string(leg.upper) + leg.side),
                lower = skeleton.find(std::string(leg.lower) + leg.side),
                end = skeleton.find(std::string(leg.end) + leg.side);
      const FootAt foot = foot_at(phase + leg.phase, stride, stance, 0.05, false);
      const Vec3 ankle(at[upper].x(), 0.05 + foot.up, at[upper].z() + foot.ahead);
      const bool reaches = bend_leg(skeleton, upper, lower, end, at[upper], ankle, leg.knee, turns);
      actor.stands[std::string(leg.end) + leg.side].push_back(foot.stands() && reaches);
    }
    actor.turns.push_back(std::move(turns));
    actor.roots.push_back(root);
  }
  return actor;
}

// ---------------------------------------------------------------- files

const std::vector<Vocabulary>& vocabularies() {
  const std::vector<std::string> mixamo = {"Hips",      "Spine", "Spine2",   "Neck",  "Head",
                                           "&Shoulder", "&Arm",  "&ForeArm", "&Hand", "&UpLeg",
                                           "&Leg",      "&Foot", "&ToeBase"};
  const auto prefixed = [](std::vector<std::string> names, const std::string& prefix) {
    for (std::string& name : names) name = prefix + name;
    return names;
  };
  const std::vector<std::string> words = {"Left", "Right"}, capitals = {"L", "R"},
                                 small = {"l", "r"};
  const std::vector<std::string> rigify = {
      "spine",    "spine.001", "spine.003", "spine.004", "spine.006", "shoulder&", "upper_arm&",
      "forearm&", "hand&",     "thigh&",    "shin&",     "foot&",     "toe&"};
  static const std::vector<Vocabulary> all = {
      {"Mixamo", prefixed(mixamo, "mixamorig:"), words},
      {"Mixamo without prefix", mixamo, words},
      {"CMU",
       {"Hips", "LowerBack", "Spine1", "Neck1", "Head", "&Shoulder", "&Arm", "&ForeArm", "&Hand",
        "&UpLeg", "&Leg", "&Foot", "&ToeBase"},
       words},
      {"CMU's own",
       {"root", "lowerback", "thorax", "upperneck", "head", "&clavicle", "&humerus", "&radius",
        "&hand", "&femur", "&tibia", "&foot", "&toes"},
       small},
      {"Biped",
       {"Bip01 Pelvis", "Bip01 Spine", "Bip01 Spine1", "Bip01 Neck", "Bip01 Head",
        "Bip01 & Clavicle", "Bip01 & UpperArm", "Bip01 & Forearm", "Bip01 & Hand", "Bip01 & Thigh",
        "Bip01 & Calf", "Bip01 & Foot", "Bip01 & Toe0"},
       capitals},
      {"Rokoko",
       {"Hips", "Spine1", "Spine3", "Neck", "Head", "&Shoulder", "&Arm", "&ForeArm", "&Hand",
        "&Thigh", "&Shin", "&Foot", "&Toe"},
       words},
      {"LaFAN",
       {"Hips", "Spine", "Spine2", "Neck", "Head", "&Shoulder", "&Arm", "&ForeArm", "&Hand",
        "&UpLeg", "&Leg", "&Foot", "&Toe"},
       words},
      {"Bandai-Namco",
       {"Hips", "Spine", "Chest", "Neck", "Head", "Shoulder_&", "UpperArm_&", "LowerArm_&",
        "Hand_&", "UpperLeg_&", "LowerLeg_&", "Foot_&", "Toes_&"},
       capitals},
      {"HumanIK", prefixed(mixamo, "Character1_"), words},
      {"Unreal",
       {"pelvis", "spine_01", "spine_03", "neck_01", "head", "clavicle_&", "upperarm_&",
        "lowerarm_&", "hand_&", "thigh_&", "calf_&", "foot_&", "ball_&"},
       small},
      {"VRM, Unity",
       {"hips", "spine", "chest", "neck", "head", "&Shoulder", "&UpperArm", "&LowerArm", "&Hand",
        "&UpperLeg", "&LowerLeg", "&Foot", "&Toes"},
       {"left", "right"}},
      {"VRoid",
       {"J_Bip_C_Hips", "J_Bip_C_Spine", "J_Bip_C_Chest", "J_Bip_C_Neck", "J_Bip_C_Head",
        "J_Bip_&_Shoulder", "J_Bip_&_UpperArm", "J_Bip_&_LowerArm", "J_Bip_&_Hand",
        "J_Bip_&_UpperLeg", "J_Bip_&_LowerLeg", "J_Bip_&_Foot", "J_Bip_&_ToeBase"},
       capitals},
      {"Rigify .L", rigify, {".L", ".R"}},
      {"Rigify _l", rigify, {"_l", "_r"}},
      {"Rigify Left", rigify, {"Left", "Right"}},
      {"SMPL",
       {"Pelvis", "Spine1", "Spine3", "Neck", "Head", "&_Collar", "&_Shoulder", "&_Elbow",
        "&_Wrist", "&_Hip", "&_Knee", "&_Ankle", "&_Foot"},
       capitals},
      {"Biovision",
       {"Hips", "Chest", "Chest2", "Neck", "Head", "&Collar", "&Shoulder", "&Elbow", "&Wrist",
        "&Hip", "&Knee", "&Ankle", "&Toe"},
       words},
      {"Poser, Daz",
       {"hip", "abdomenLower", "chestLower", "neckLower", "head", "&Collar", "&ShldrBend",
        "&ForearmBend", "&Hand", "&ThighBend", "&Shin", "&Foot", "&Toe"},
       small},
      {"no words",
       {"b0", "b1", "b2", "b3", "b4", "b5&", "b6&", "b7&", "b8&", "b9&", "b10&", "b11&", "b12&"},
       {"a", "z"}},
  };
  return all;
}

const std::vector<Vocabulary>& four_legged_vocabularies() {
  static const std::vector<Vocabulary> all = {
      {"as a person's",
       {"Hips", "Spine", "Spine1", "Neck", "Head", "Tail", "Tail1", "&Arm", "&ForeArm", "&Hand",
        "&UpLeg", "&Leg", "&Foot"},
       {"Left", "Right"}},
      {"Rigify's",
       {"spine", "spine.001", "spine.003", "spine.004", "spine.006", "tail", "tail.001",
        "front_thigh.&", "front_shin.&", "front_foot.&", "thigh.&", "shin.&", "foot.&"},
       {"L", "R"}},
      {"fore and hind",
       {"body", "belly", "chest", "neck", "head", "tail", "tail_2", "fore_thigh_&", "fore_shin_&",
        "fore_paw_&", "hind_thigh_&", "hind_shin_&", "hind_paw_&"},
       {"L", "R"}},
      {"front and back",
       {"Root", "Spine1", "Spine2", "Neck", "Head", "Tail1", "Tail2", "&FrontUpperLeg",
        "&FrontLowerLeg", "&FrontFoot", "&BackUpperLeg", "&BackLowerLeg", "&BackFoot"},
       {"Left", "Right"}},
  };
  return all;
}

namespace {

// The turn of each joint in the file's rest pose against the T-pose.
std::vector<Quat> rest_turns(const Actor& actor, Rest rest) {
  const Skeleton& skeleton = actor.skeleton;
  std::vector<Quat> turns(skeleton.joints.size(), Quat::Identity());
  const auto first_bone = [&](int j) {
    const std::vector<int> children = skeleton.children(j);
    return children.empty() ? Vec3(Vec3::UnitY()) : skeleton.joints[children[0]].offset;
  };
  for (int j = 0; j < skeleton.size(); ++j) {
    const std::string& name = skeleton.joints[j].name;
    const int parent = skeleton.joints[j].parent;
    const bool arm = name.find("arm") != name.npos || name.find("hand") != name.npos;
    switch (rest) {
      case Rest::t_pose:
        break;
      case Rest::a_pose:
        if (arm) turns[j] = about(name.ends_with(".L") ? -45 : 45, Vec3::UnitZ());
        break;
      case Rest::along_x:  // the whole figure lies, its spine along x
        turns[j] = about(-90, Vec3::UnitZ());
        break;
      case Rest::all_one_way:  // every bone lies along x, joints with several by their first
        turns[j] =
            parent < 0
                ? least_turn(first_bone(j), Vec3::UnitX())
                : Quat(least_turn(turns[parent] * first_bone(j), Vec3::UnitX()) * turns[parent]);
        break;
      case Rest::first_frame:
        turns[j] = actor.turns[0][j];
        break;
      case Rest::any: {
        Quat q(std::sin(1.0 + j), std::cos(3.0 * j), std::sin(5.0 * j + 2), std::cos(7.0 * j + 1));
        turns[j] = q.normalized();
        break;
      }
    }
  }
  return turns;
}

}  // namespace

Motion recorded(const Actor& actor, const Vocabulary& names, Rest rest, bool z_up) {
  Motion motion;
  motion.name = names.name;
  motion.step = actor.step;
  motion.skeleton = actor.skeleton;
  const std::vector<Quat> to_rest = rest_turns(actor, rest);
  const Quat up = z_up ? about(90, Vec3::UnitX()) : Quat(Quat::Identity());
  std::vector<Joint>& joints = motion.skeleton.joints;
  std::size_t next = 0;
  for (const std::string side : {"", ".L", ".R"}) {
    for (Joint& joint : joints) {
      const bool of_side = side.empty() ? !joint.name.ends_with(".L") && !joint.name.ends_with(".R")
                                        : joint.name.ends_with(side);
      if (!of_side || joint.name.find("_end") != joint.name.npos) continue;
      std::string name = names.joints.at(next++);
      if (const auto at = name.find('&'); at != name.npos)
        name.replace(at, 1, names.sides[side == ".L" ? 0 : 1]);
      joint.unknown = name;
    }
    if (side == ".L")
      next -= std::size_t(std::count_if(joints.begin(), joints.end(), [](auto& j) {
        return j.name.ends_with(".L") && j.name.find("_end") == j.name.npos;
      }));
  }
  for (Joint& joint : joints) joint.name = std::exchange(joint.unknown, "");
  joints[0].offset.setZero();
  for (std::size_t j = 1; j < joints.size(); ++j)
    joints[j].offset = up * (to_rest[joints[j].parent] * joints[j].offset);
  for (std::size_t k = 0; k < actor.turns.size(); ++k) {
    Pose pose = rest_pose(motion.skeleton);
    pose.root_position = 100 * (up * actor.roots[k]);
    std::vector<Quat> world;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      world.push_back(up * actor.turns[k][j] * to_rest[j].conjugate() * up.conjugate());
      pose.rotations[j] =
          joints[j].parent < 0 ? world[j] : Quat(world[joints[j].parent].conjugate() * world[j]);
      pose.rotations[j].normalize();
    }
    motion.poses.push_back(std::move(pose));
  }
  for (Joint& joint : joints) joint.offset *= 100;  // centimetres
  return motion;
}

namespace {

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6f ", value);
  return text;
}

void write_joint(const Skeleton& skeleton, int j, const std::string& indent, std::string& out) {
  const Joint& joint = skeleton.joints[j];
  const bool end = joint.name.empty();
  out += indent +
         (joint.parent < 0 ? "ROOT " + joint.name
          : end            ? "End Site"
                           : "JOINT " + joint.name) +
         "\n" + indent + "{\n" + indent + "  OFFSET ";
  for (int c = 0; c < 3; ++c) out += number(joint.offset[c]);
  out += "\n";
  if (!end)
    out += indent +
           (joint.parent < 0 ? "  CHANNELS 6 Xposition Yposition Zposition " : "  CHANNELS 3 ") +
           "Zrotation Xrotation Yrotation\n";
  for (const int child : skeleton.children(j)) write_joint(skeleton, child, indent + "  ", out);
  out += indent + "}\n";
}

// Joints in the order in which the file has them.
void in_file_order(const Skeleton& skeleton, int j, std::vector<int>& order) {
  if (!skeleton.joints[j].name.empty()) order.push_back(j);
  for (const int child : skeleton.children(j)) in_file_order(skeleton, child, order);
}

}  // namespace

std::string bvh_text(const Motion& motion) {
  std::string out = "HIERARCHY\n";
  write_joint(motion.skeleton, 0, "", out);
  out += "MOTION\nFrames: " + std::to_string(motion.poses.size()) +
         "\nFrame Time: " + number(motion.step) + "\n";
  std::vector<int> order;
  in_file_order(motion.skeleton, 0, order);
  for (const Pose& pose : motion.poses) {
    for (int c = 0; c < 3; ++c) out += number(pose.root_position[c]);
    for (const int j : order) {
      const Vec3 angles = pose.rotations[j].toRotationMatrix().eulerAngles(2, 0, 1);
      for (int c = 0; c < 3; ++c) out += number(degrees(angles[c]));
    }
    out += "\n";
  }
  return out;
}

}  // namespace artisketch
