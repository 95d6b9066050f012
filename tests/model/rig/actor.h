// Somebody who walks: the truth that motions of any vocabulary, rest pose and axis are made from.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "document/motion.h"

namespace artisketch {

enum class Rest { t_pose, a_pose, along_x, all_one_way, first_frame, any };
inline constexpr Rest kRests[] = {Rest::t_pose,      Rest::a_pose,      Rest::along_x,
                                  Rest::all_one_way, Rest::first_frame, Rest::any};
const char* rest_word(Rest rest);

struct Vocabulary {
  const char* name;
  std::vector<std::string> joints;  // names in the order of Actor's; & stands for a side
  std::vector<std::string> sides;   // what it stands for: left, right
};
const std::vector<Vocabulary>& vocabularies();
const std::vector<Vocabulary>& four_legged_vocabularies();

// A figure whose joints' turns are known against its T-pose.
struct Actor {
  Skeleton skeleton;                     // at rest as the T-pose; faces +z, y up
  std::vector<std::vector<Quat>> turns;  // per pose and joint, in the world
  std::vector<Vec3> roots;
  std::map<std::string, std::vector<bool>>
      stands;  // per foot and pose: flat on the ground, at rest
  double step = 1 / 30.0;
  int find(const std::string& name) const { return skeleton.find(name); }
  std::vector<Vec3> at(int pose) const;
};
Actor walking_person();  // 1.7 tall, 60 poses, two strides; heels and toes as in life
Actor walking_dog();

// The actor's motion as a file would have it: other names, another rest pose, another axis up.
Motion recorded(const Actor& actor, const Vocabulary& names, Rest rest, bool z_up);
std::string bvh_text(const Motion& motion);

}  // namespace artisketch
