// In which order, from where and which way round outlines were drawn says nothing of the character,
// nor does the order of a skeleton's joints, and neither must show in the model. Yet sums differ in
// their last bits by the order of what is summed, resampled lines by where they start, and what
// stands on a knife's edge falls by such bits: the stages get outlines, views and joints in one
// order of their own.
#pragma once

#include <vector>

#include "model/stages.h"

namespace artisketch {

// A closed line clockwise on screen, from the point farthest from its middle; an open one from the
// end that lies farther left, or up.
Polyline in_one_order(Polyline line);

// Lines of one part in one drawing, each so, and sorted.
std::vector<Polyline> in_one_order(std::vector<Polyline> lines);

// All outlines of a document so, by joint. Drawings and joints stay where they are.
Document in_one_order(Document document);

// A part's views, by their outlines, then by where the part stands in them.
Part with_views_in_one_order(Part part);

// The drawings' indices in an order of what they show: the first one stays.
std::vector<int> frames_in_one_order(const Document& document);

// The joints' indices, each after its parent, by where they stand.
std::vector<int> joints_in_one_order(const Skeleton& skeleton);

// Where in an order each index stands: what leads back to the order as given.
std::vector<int> inverse(const std::vector<int>& order);

// The same with joint order[i] as joint i.
Document with_joints_in(Document document, const std::vector<int>& order);
Calibration with_joints_in(Calibration calibration, const std::vector<int>& order);
Reconstruction with_joints_in(Reconstruction reconstruction, const std::vector<int>& order);

}  // namespace artisketch
