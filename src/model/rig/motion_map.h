// Which joint of a recorded motion moves which of the document's.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "document/document.h"
#include "document/motion.h"
#include "model/rig/body_plan.h"

namespace artisketch {

enum class Match { given, named, guessed };  // by the document, by names, by the tree's shape
const char* match_word(Match match);

struct JointMatch {
  int joint = 0;  // of the document
  int mover = 0;  // of the motion
  Match how = Match::named;
};

struct JointMap {
  BodyPlan ours, theirs;
  std::vector<int> mover;           // per joint of the document; −1 where none moves it
  std::vector<JointMatch> matches;  // in the document's order
  std::vector<int> still;           // joints that carry others, and that nothing moves unasked
  std::vector<int> unused;          // the motion's named joints that move nothing
  std::vector<std::string> warnings;
};

// The document's own pairs first (joints that nobody shall move among them), then what names say of
// limbs and trunk, equal names, and what the trees' shapes show.
//   at  where the motion's joints stand in one of its poses, y up
JointMap mapped(const Document& document, const Motion& motion, const std::vector<Vec3>& at);

}  // namespace artisketch
