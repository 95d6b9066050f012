// Where a part's model and its outline in a drawing part ways, to be drawn there.
#pragma once

#include "model/stages.h"

namespace artisketch {

// A point of the model's edge and the nearest one of the part's outlines; pixels of the sketch.
struct EdgePoint {
  Vec2 at = Vec2::Zero(), outline = Vec2::Zero();
  double off() const { return (at - outline).norm(); }
};

struct FitMarks {
  std::vector<std::vector<EdgePoint>> edge;  // closed loops, a point every two pixels or so
  double off = 0;                            // pixels, mean over the edge
  // The longest stretch of the edge that is over the limit: its length and middle, and which way
  // is out of the model there. No length: none is.
  double stretch = 0;
  EdgePoint middle;
  Vec2 outward = Vec2(0, -1);
};

// The edge that a part shows, as `mesh` (rest space) stands with `to_world` before the camera,
// against its closed contours in the frame. Empty where one of the two is.
//   limit  pixels; what a stretch is longer than
FitMarks fit_marks(const Mesh& mesh, const Transform& to_world, const FrameCamera& camera,
                   const Frame& frame, int joint, double limit);

}  // namespace artisketch
