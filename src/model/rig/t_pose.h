// The rest pose that avatars are asked for.
#pragma once

#include <string_view>

#include "base/result.h"
#include "model/stages.h"

namespace artisketch {

// The model with another rest pose: arms level to the sides, legs straight down with the feet flat
// and as high as they were; the trunk as it was. Joints stand in every clip where they stood, and
// so does what hangs on one joint alone; between joints the skin is as it bends on the way to the
// new rest pose. A limb that isn't whole stays as it was. Rest poses have no turns: offsets alone.
Model t_posed(const Model& model);

// with_rig's model (rig_profile.h), in the T-pose where an engine compares skeletons in it: of all
// profiles but Rigify's, whose rig is made for the rest pose at hand. Fails as with_rig does.
Result<Model> for_engine(const Model& model, std::string_view profile);

}  // namespace artisketch
