// Another skeleton's motion on the document's.
#pragma once

#include "document/motion.h"
#include "model/stages.h"

namespace artisketch {

// The motion as a clip for the document's skeleton. The document's `motion.joints` say which joint
// moves which; where it says nothing, equal names do, whatever their case and punctuation.
//   - a bone points in the world as the motion's does, though the rest poses differ;
//   - joints that nothing moves stay as at rest;
//   - the root's way is scaled by the height of the hips (else of the whole skeleton), from where
//     the figure stands in its rest pose.
// Fails where no joint is found.
Result<Clip> retargeted(const Document& document, const Motion& motion);

}  // namespace artisketch
