// Which joint of a skeleton is which: hips, trunk, arms, legs, whoever named them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "document/skeleton.h"

namespace artisketch {

enum class Side { none, left, right };

// A joint's name, taken apart: "mixamorig:LeftUpLeg" is the word "upleg" of the left side. Prefixes
// that a program puts before all its joints are dropped; numbers aren't part of the word.
struct JointName {
  Side side = Side::none;
  std::string word;     // letters alone, in lower case; other alphabets as they are
  bool fore = false;    // of a front leg, where the name says so
  bool hind = false;    // of a back leg
  bool helper = false;  // twists, controls, ends: no joint that one bends
};
JointName joint_name(const std::string& name);

// An arm, a wing or a leg from top to end; −1 where there is none.
struct LimbJoints {
  int collar = -1;  // of an arm: the shoulder blade or collar bone above it
  int upper = -1, lower = -1, end = -1, tip = -1;
};

struct BodyPlan {
  std::vector<int> trunk;  // from the hips along the spine to the head, as far as known
  int hips = -1, chest = -1, head = -1;  // of the trunk; the chest carries the arms
  std::array<LimbJoints, 2> arms, legs;  // left, right; forelegs are arms
  std::vector<int> tail;                 // from the trunk on
  std::vector<bool> guessed;  // per joint: what it is shows in the tree's shape, not in its name
};

// Where posed joints are.
std::vector<Vec3> places_of(const std::vector<Transform>& posed);

// By the joints' names; what these leave open, by the tree's shape and by `at`, where the joints
// stand in some pose, y up. Only with `shapes` whole limbs are looked for by shape alone.
BodyPlan body_plan_of(const Skeleton& skeleton, const std::vector<Vec3>& at, bool shapes);

// From the feet to the hips and on to the head; nothing where neither is known.
std::optional<Vec3> standing_direction(const BodyPlan& plan, const std::vector<Vec3>& at);

// Which way the figure looks, level; +z where nothing shows it.
Vec3 forward_of(const BodyPlan& plan, const std::vector<Vec3>& at);

}  // namespace artisketch
