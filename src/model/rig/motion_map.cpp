#include "model/rig/motion_map.h"

#include <algorithm>
#include <cmath>

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

class Mapper {
 public:
  Mapper(const Document& document, const Motion& motion, const std::vector<Vec3>& at)
      : document_(document), ours_(document.skeleton), theirs_(motion.skeleton) {
    map_.ours = body_plan_of(ours_, rest_positions(ours_), false);
    map_.theirs = body_plan_of(theirs_, at, true);
    map_.mover.assign(std::size_t(ours_.size()), -1);
    taken_.assign(std::size_t(theirs_.size()), false);
    nobodys_.assign(std::size_t(ours_.size()), false);
    at_ = at;
  }

  JointMap map() {
    given();
    limbs(false);
    trunk();
    equal_names();
    limbs(true);
    fingers();
    in_order(map_.ours.tail, map_.theirs.tail, Match::named);
    say_what_is_left();
    return std::move(map_);
  }

 private:
  void take(int joint, int mover, Match how) {
    if (joint < 0 || mover < 0 || map_.mover[joint] >= 0 || taken_[mover] || nobodys_[joint])
      return;
    map_.mover[joint] = mover;
    taken_[mover] = true;
    map_.matches.push_back({joint, mover, how});
  }

  void given() {
    for (const auto& [name, joint] : document_.motion.joints) {
      if (name.empty()) {
        nobodys_[joint] = true;
        continue;
      }
      const int mover = theirs_.find(name);
      if (mover >= 0) {
        take(joint, mover, Match::given);
        continue;
      }
      std::string near;
      for (const Joint& other : theirs_.joints)
        if (!other.name.empty() && plain_name(other.name).starts_with(plain_name(name)) &&
            near.empty())
          near = other.name;
      map_.warnings.push_back("/motion/joints names '" + name +
                              "', and the motion has no joint of that name" +
                              (near.empty() ? "" : "; did you mean '" + near + "'?"));
    }
  }

  Match how(int joint, int mover) const {
    return map_.ours.guessed[joint] || map_.theirs.guessed[mover] ? Match::guessed : Match::named;
  }

  void limbs(bool guesses) {
    const auto pair = [&](int joint, int mover) {
      if (joint < 0 || mover < 0) return;
      const Match match = how(joint, mover);
      if (guesses || match == Match::named) take(joint, mover, match);
    };
    for (std::size_t s = 0; s < 2; ++s)
      for (const auto& [our, their] : {std::pair(&map_.ours.legs[s], &map_.theirs.legs[s]),
                                       std::pair(&map_.ours.arms[s], &map_.theirs.arms[s])}) {
        pair(our->upper, their->upper);
        pair(our->lower, their->lower);
        pair(our->end, their->end);
        pair(our->collar, their->collar);
        if (their->tip >= 0 && !theirs_.joints[their->tip].name.empty()) pair(our->tip, their->tip);
      }
  }

  // The spine's joints by how far along it they stand.
  void trunk() {
    const BodyPlan &our = map_.ours, &their = map_.theirs;
    const auto match = [&](int joint, int mover) {
      const bool alike =
          joint >= 0 && mover >= 0 &&
          joint_name(ours_.joints[joint].name).word == joint_name(theirs_.joints[mover].name).word;
      if (joint >= 0 && mover >= 0) take(joint, mover, alike ? Match::named : Match::guessed);
    };
    match(our.hips, their.hips);
    if (their.chest != their.hips) match(our.chest, their.chest);
    match(our.head, their.head);
    const std::vector<Vec3> rest = rest_positions(ours_);
    between(our.hips, our.chest >= 0 ? our.chest : our.head, their.hips,
            their.chest >= 0 ? their.chest : their.head, rest);
    if (our.chest >= 0) between(our.chest, our.head, their.chest, their.head, rest);
  }

  void between(int our_from, int our_to, int their_from, int their_to,
               const std::vector<Vec3>& rest) {
    const auto part = [](const std::vector<int>& trunk, int from, int to) {
      const auto a = std::find(trunk.begin(), trunk.end(), from);
      const auto b = std::find(trunk.begin(), trunk.end(), to);
      return a == trunk.end() || b == trunk.end() || b < a ? std::vector<int>()
                                                           : std::vector<int>(a, b + 1);
    };
    const std::vector<int> our = part(map_.ours.trunk, our_from, our_to);
    const std::vector<int> their = part(map_.theirs.trunk, their_from, their_to);
    if (our.size() < 3 || their.size() < 3) return;
    const std::vector<double> our_way = way_along(our, rest), their_way = way_along(their, at_);
    for (std::size_t i = 1; i + 1 < our.size(); ++i) {
      int best = -1;
      double off = 1e300;
      for (std::size_t k = 1; k + 1 < their.size(); ++k)
        if (!taken_[their[k]] && std::abs(their_way[k] - our_way[i]) < off) {
          best = their[k];
          off = std::abs(their_way[k] - our_way[i]);
        }
      take(our[i], best, Match::guessed);
    }
  }

  // 0 at the first joint, 1 at the last.
  static std::vector<double> way_along(const std::vector<int>& joints,
                                       const std::vector<Vec3>& at) {
    std::vector<double> way{0};
    for (std::size_t i = 1; i < joints.size(); ++i)
      way.push_back(way.back() + (at[joints[i]] - at[joints[i - 1]]).norm());
    for (double& w : way) w /= std::max(way.back(), 1e-12);
    return way;
  }

  void equal_names() {
    for (int j = 0; j < ours_.size(); ++j) {
      const std::string name = plain_name(ours_.joints[j].name);
      for (int m = 0; m < theirs_.size() && map_.mover[j] < 0 && !name.empty(); ++m)
        if (!taken_[m] && plain_name(theirs_.joints[m].name) == name) take(j, m, Match::named);
    }
  }

  void in_order(const std::vector<int>& our, const std::vector<int>& their, Match match) {
    for (std::size_t i = 0; i < std::min(our.size(), their.size()); ++i)
      take(our[i], their[i], match);
  }

  static std::vector<int> finger(const Skeleton& skeleton, Side side, std::string_view word) {
    std::vector<int> joints;
    for (int j = 0; j < skeleton.size(); ++j) {
      const JointName name = joint_name(skeleton.joints[j].name);
      const bool little = word == "little" && name.word.find("pinky") != std::string::npos;
      if (name.side == side && !name.helper &&
          (name.word.find(word) != std::string::npos || little))
        joints.push_back(j);
    }
    return joints;
  }

  void fingers() {
    for (const Side side : {Side::none, Side::left, Side::right})
      for (const char* word : {"thumb", "index", "middle", "ring", "little"})
        in_order(finger(ours_, side, word), finger(theirs_, side, word), Match::named);
  }

  void say_what_is_left() {
    std::sort(map_.matches.begin(), map_.matches.end(),
              [](const JointMatch& a, const JointMatch& b) { return a.joint < b.joint; });
    for (int j = 0; j < ours_.size(); ++j)
      if (map_.mover[j] < 0 && !nobodys_[j] && !ours_.children(j).empty()) map_.still.push_back(j);
    for (int m = 0; m < theirs_.size(); ++m)
      if (!taken_[m] && !theirs_.joints[m].name.empty()) map_.unused.push_back(m);
  }

  const Document& document_;
  const Skeleton &ours_, &theirs_;
  std::vector<Vec3> at_;
  std::vector<bool> taken_;
  std::vector<bool> nobodys_;  // joints that nothing shall move
  JointMap map_;
};

}  // namespace

const char* match_word(Match match) {
  switch (match) {
    case Match::given:
      return "given";
    case Match::named:
      return "named";
    case Match::guessed:
      break;
  }
  return "guessed";
}

JointMap mapped(const Document& document, const Motion& motion, const std::vector<Vec3>& at) {
  return Mapper(document, motion, at).map();
}

}  // namespace artisketch
