// Another skeleton's motion on the document's.
#pragma once

#include <string>
#include <vector>

#include "document/motion.h"
#include "model/rig/motion_map.h"
#include "model/stages.h"

namespace artisketch {

struct RetargetOptions {
  bool plant_feet = true;  // feet that stand don't slide or float; off: as the motion has it
  bool in_place = false;   // the figure's way over the ground is left out
};

struct Retargeted {
  Clip clip;
  JointMap map;
  bool z_up = false;                  // the motion's, before it was turned
  double scale = 1;                   // the document's units per unit of the motion
  bool loops = false;                 // the last pose is nearly the first
  std::vector<std::string> warnings;  // in words, the map's and the file's too
};

// The motion as a clip for the document's skeleton (docs/MOTION.md).
//   - limbs and the trunk point in the world as the motion's do, whatever its rest pose: that is
//     not needed, where a pose of the motion is nearer to the document's;
//   - the head and the feet keep how they are turned against what the figure does on average, and
//     while it stands;
//   - joints that nothing moves stay as at rest against their parents;
//   - y or z may be up: the way in which the figure stands;
//   - the root's way is scaled by the legs' lengths (else the height of the hips, or the whole
//     skeleton); it begins where the document's root is at rest, its feet as high above the ground
//     at y = 0 as there.
// Fails where no joint is found.
Result<Retargeted> retargeted(const Document& document, const Motion& motion,
                              const RetargetOptions& options);

// A motion and what became of it.
struct MovedBy {
  Motion motion;
  Retargeted result;
};

// Two lines for the terminal: what moves what, and what was guessed and left.
std::string mapping_words(const Document& document, const Motion& motion, const Retargeted& result);

}  // namespace artisketch
