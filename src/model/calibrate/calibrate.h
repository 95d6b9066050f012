// What the calibration methods share: how far poses may move, and how well they agree.
#pragma once

#include <span>
#include <vector>

#include "model/stages.h"

namespace artisketch {

// The document's limits, with our defaults where it sets none.
struct PoseLimits {
  double max_rotation = 0;     // radians from the user's local rotation
  double max_translation = 0;  // units from the user's root position
  std::vector<char> free;      // per joint: its rotation may change
};
PoseLimits pose_limits(const Document& document);

// [frame][joint]: the joint has a closed contour in that frame and in another one as well, so that
// the two can be compared.
std::vector<std::vector<char>> shared_contours(const Document& document);

// How many times as large small drawings are taken: errors are measured in pixels of a figure some
// 500 large, of which a sprite's pixel is many. 1 from half of kShapeSize on.
double calibration_scale(const Document& document);

// The children that a joint's bones lead to: things that it holds are none.
std::vector<int> ends_of_bones(const Document& document, int joint);
// Middle of a joint's bones, in the joint's axes; the joint itself where it has none.
Vec3 middle_of_bones(const Document& document, int joint);

// How well each drawn part agrees with its other drawings at given poses.
struct Coverage {
  int joint = 0, frame = 0;
  // Share of the contours' pixels whose ray meets the part's visual hull: comes within kTouch of
  // every other silhouette at one depth. 1 where no other frame shows the part.
  double share = 1;
  double miss = 0;  // pixels, root mean square by which rays miss the hull
};
inline constexpr double kTouch = 1;  // pixels: half a line's width for each of two drawings

class RayResiduals;

// At the given poses and scales (one per frame): an entry per part and frame with a closed contour,
// by joint, then frame. rays: of the document.
std::vector<Coverage> coverage(const Document& document, const RayResiduals& rays,
                               std::span<const Pose> poses, std::span<const double> scales);
double mean_share(std::span<const Coverage> all);  // 1 where there are none

}  // namespace artisketch
