// Outlines as things: several of a drawing at once moved, scaled, turned, simplified, taken out,
// and laid over the same bones of another drawing. As document/edit.h: from a document to the next
// one; indices must be valid (ensured).
#pragma once

#include <set>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "document/document.h"

namespace artisketch {

// Which of a frame's contours.
using ContourSet = std::set<int>;

// From pixels to pixels of one drawing.
using PictureMap = Eigen::Transform<double, 2, Eigen::Affine>;

Document with_contours_mapped(Document document, int frame, const ContourSet& contours,
                              const PictureMap& map);
Document without_contours(Document document, int frame, const ContourSet& contours);

// Of a frame's closed contours of one joint, those that a new one of it is drawn in the place of:
// half of the smaller of the two, or more, is the other's as well. What lies within a contour,
// clear of its line, makes a hole in it instead. Holes go with their contour.
ContourSet contours_redrawn(const Frame& frame, int joint, const Polyline& line);
// The contour in the place of those; in front of all others where there are none.
Document with_contour_over(Document document, int frame, Contour contour);

// What two closed lines have in common, as a share of what both enclose together; 0 … 1.
double common_share(const Polyline& a, const Polyline& b);

// To the fewest points that stay within `error` pixels of the line. What would cross itself then,
// or enclose a tenth less, stays as it is.
Document with_contours_simplified(Document document, int frame, const ContourSet& contours,
                                  double error);

// An outline apart from its drawing, and the bone that it was drawn over.
struct LooseOutline {
  std::string joint;  // by name: another document's skeleton may have it, too
  Polyline line;
  Vec2 start = Vec2::Zero(), along = Vec2(0, 1);  // of the bone there: pixels, unit length
  double size = 1;                                // the drawing's smaller side, in pixels
};
std::vector<LooseOutline> loose_outlines(const Document& document, int frame,
                                         const ContourSet& contours);

// In front of the frame's own, in their order: moved, turned and scaled (as the drawings' sizes are
// to each other) from bone to bone. Those of joints that the skeleton lacks are left out.
Document with_outlines_laid(Document document, int frame,
                            const std::vector<LooseOutline>& outlines);

}  // namespace artisketch
