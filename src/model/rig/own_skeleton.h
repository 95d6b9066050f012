// Somebody's own skeleton, to draw a character on.
#pragma once

#include "document/document.h"
#include "document/motion.h"

namespace artisketch {

// A document without drawings whose skeleton is the motion's: names and bones as they are there, so
// that what is made of it goes back into the rig that it came from.
//   - At rest it is as the motion's rest pose, where that stands; else as its first pose.
//   - Where z is up it is turned to y; a root at the origin is raised until the figure stands on 0.
//   - Ends without names take their parent's, with "_end"; of equal names the later are numbered.
//   - Joints that mirror each other across x = x(root) say so.
//   - The camera shows it 500 pixels high.
Document document_with_skeleton(const Motion& motion);

}  // namespace artisketch
