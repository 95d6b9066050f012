// What a joint's name says.
#include <algorithm>
#include <array>
#include <string_view>

#include "model/rig/body_plan.h"

namespace artisketch {
namespace {

bool is_upper(char c) {
  return c >= 'A' && c <= 'Z';
}
bool is_lower(char c) {
  return (c >= 'a' && c <= 'z') || (c & 0x80);
}

// "Bip01 L UpperArm", "upper_arm.L", "lShldr", "J_Bip_L_UpperArm" → words in lower case, without
// numbers: a new one begins at whatever is no letter, and where small letters turn to capitals.
std::vector<std::string> words_of(std::string_view name) {
  std::vector<std::string> words;
  std::string word;
  const auto end_word = [&] {
    if (!word.empty()) words.push_back(word);
    word.clear();
  };
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char c = name[i];
    if (!is_upper(c) && !is_lower(c)) {
      end_word();
      continue;
    }
    const bool before_small = i + 1 < name.size() && is_lower(name[i + 1]);
    const bool after_small = i > 0 && is_lower(name[i - 1]);
    const bool after_capital = i > 0 && is_upper(name[i - 1]);
    if (is_upper(c) && (after_small || (after_capital && before_small))) end_word();
    word += is_upper(c) ? char(c - 'A' + 'a') : c;
  }
  end_word();
  return words;
}

bool one_of(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_side(std::string_view word, Side& side) {
  if (one_of(word, {"l", "left", "lft", "lt"})) return side = Side::left, true;
  if (one_of(word, {"r", "right", "rgt", "rt"})) return side = Side::right, true;
  return false;
}

// Words that begin with a side's letter and no capital after it: "lfemur", "rwrist".
constexpr std::string_view kAfterLetter[] = {
    "femur", "tibia",   "foot",     "toes",  "clavicle", "humerus",  "radius", "wrist",
    "hand",  "fingers", "thumb",    "thigh", "shin",     "forearm",  "shldr",  "collar",
    "hip",   "knee",    "ankle",    "elbow", "shoulder", "upperarm", "arm",    "leg",
    "upleg", "calf",    "lowerarm", "toe",   "lowerleg", "upperleg"};

// What programs put before every name.
bool is_prefix(std::string_view word) {
  return one_of(word,
                {"mixamorig", "mixamo",     "bip", "biped",    "def",    "org",  "mch",   "jnt",
                 "joint",     "bone",       "j",   "c",        "b",      "bn",   "sk",    "skel",
                 "character", "valvebiped", "rig", "armature", "cc",     "base", "smplx", "smpl",
                 "avg",       "f",          "m",   "center",   "centre", "mid"});
}

}  // namespace

JointName joint_name(const std::string& full) {
  JointName found;
  std::string_view name = full;
  if (const auto colon = name.find_last_of(":|/"); colon != name.npos && colon + 1 < name.size())
    name.remove_prefix(colon + 1);
  std::vector<std::string> words = words_of(name);
  std::vector<std::string> kept;
  for (std::string& word : words) {
    if (is_side(word, found.side)) continue;
    // "LHipJoint" and "Lfoot" come as one word where all else is small.
    if (word.size() > 2 && found.side == Side::none && (word[0] == 'l' || word[0] == 'r') &&
        std::find(std::begin(kAfterLetter), std::end(kAfterLetter),
                  std::string_view(word).substr(1)) != std::end(kAfterLetter)) {
      found.side = word[0] == 'l' ? Side::left : Side::right;
      word.erase(0, 1);
    }
    for (const std::string_view side : {"left", "right"})
      if (found.side == Side::none && word.size() > side.size() + 2 && word.starts_with(side)) {
        found.side = side == "left" ? Side::left : Side::right;
        word.erase(0, side.size());
      }
    if (one_of(word,
               {"twist", "roll",   "ik",    "fk",       "pole",   "ctrl",  "control", "helper",
                "nub",   "end",    "site",  "effector", "target", "dummy", "tip",     "top",
                "aux",   "marker", "tweak", "mch",      "share",  "null"}))
      found.helper = true;
    else
      kept.push_back(std::move(word));
  }
  // A prefix alone is a name.
  while (kept.size() > 1 && is_prefix(kept.front())) kept.erase(kept.begin());
  for (std::size_t i = 0; i < kept.size(); ++i) {
    // "ForeArm" is the lower half of an arm, whichever leg that is.
    const bool forearm = kept[i] == "fore" && i + 1 < kept.size() && kept[i + 1] == "arm";
    const bool front = one_of(kept[i], {"fore", "front"}) && !forearm;
    const bool back = one_of(kept[i], {"hind", "rear", "back"});
    if (kept.size() > 1 && found.side != Side::none && (front || back))
      (front ? found.fore : found.hind) = true;
    else
      found.word += kept[i];
  }
  if (kept.size() == 1 && found.word.starts_with("foreleg")) found.fore = true, found.word = "leg";
  if (kept.size() == 1 && found.word.starts_with("hindleg")) found.hind = true, found.word = "leg";
  return found;
}

}  // namespace artisketch
