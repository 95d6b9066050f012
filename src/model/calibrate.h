// What both methods of calibration share: how far poses may move, and how well they agree.
#pragma once

#include <span>
#include <vector>

#include "model/stages.h"

namespace artisketch {

// Where the document gives no limits. Users' poses are 8 to 15° off, bad ones 30°.
inline constexpr double kDefaultMaxRotation = radians(45);
inline constexpr double kDefaultMaxTranslation = 0.25;  // of the figure's size

// How far calibration may take the poses from the user's. A joint's rotation may turn by at most
// `rotation`, a frame's root may move by at most `translation`.
struct PoseBounds {
  std::vector<double> rotation;  // radians, per joint; 0 where locked
  double translation = 0;        // units
  std::vector<bool> moves;       // per frame: it is free at all (frame 1 is not, nor are frames that
                                 // share too few parts with the others)
};
PoseBounds pose_bounds(const Document& document);

// Diagonal of the box of the rest pose's joints, in units; positive.
double figure_size(const Document& document);

// Closed contours of each joint in each frame: which of them other frames can be compared with.
// shared[f][j]: joint j has a closed contour in frame f and in another one.
std::vector<std::vector<bool>> shared_parts(const Document& document);

// A contour's pixel counts as met where the hull comes this near to its ray in every other view:
// half a pixel's width for each of the two lines.
inline constexpr double kTouch = 1;

// Share of each contour's pixels whose ray meets the part's visual hull, at the given poses and
// scales (one per frame): one entry per part and frame with a closed contour, joints ascending, then
// frames. 1 where no other frame shows the part.
struct Coverage {
  int joint = 0, frame = 0;
  double share = 1;
  double rms = 0;  // pixels, how far rays miss the hull
};
std::vector<Coverage> coverage(const Document& document, std::span<const Pose> poses,
                               std::span<const double> scales);

}  // namespace artisketch
