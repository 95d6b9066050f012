// Outlines of one part, brought to the proportions that they have in common.
#pragma once

#include "model/stages.h"

namespace artisketch {

// A hand draws a part longer here, wider there, and a little beside its bone elsewhere. A hull is
// what all outlines share, so it would be smaller than any of them. Each outline is stretched and
// shifted in its picture, as little as makes all of them reach equally far along the axes that
// their views share, and only as far as they contradict each other: outlines that agree stay.
// Mirrored outlines have a say where they contradict the part's own no more than those do each
// other.
struct InProportion {
  Part part;  // with its views, and its mirrored ones, so redrawn
  // By how much its own outlines reached differently far: root mean square, in the part's size.
  double contradiction = 0;
};
InProportion in_proportion(const Part& part);

}  // namespace artisketch
