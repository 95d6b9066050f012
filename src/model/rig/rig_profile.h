// Skeletons as engines know them: their names, and the joints that they ask for.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "model/stages.h"

namespace artisketch {

struct RigProfile {
  const char* name;   // as the command line has it: "mixamo"
  const char* about;  // "Mixamo"
};
std::span<const RigProfile> rig_profiles();

// The model with a person's joints renamed, and those that the profile asks for put in where there
// are none, without weights: spine and neck along their bones, shoulders a third of the way to the
// arms, toes two thirds of the way to the tips. Nothing that is seen moves, in any clip. Names
// that the profile doesn't have lose dots and what else engines refuse; none comes twice.
// Fails where there is no profile of that name, or no person: hips, a head, two arms, two legs.
Result<Model> with_rig(const Model& model, std::string_view profile);

}  // namespace artisketch
