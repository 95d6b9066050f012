// How large each drawing shows the figure, against the first: people draw it larger or smaller from
// drawing to drawing, and a body that only turns must tip away to explain that.
#pragma once

#include <string>
#include <vector>

#include "document/document.h"
#include "model/calibrate/ray_residuals.h"

namespace artisketch {

struct DrawnSize {
  double factor = 1;  // times the first frame's size, beyond what the frames' scales say already
  double error = 0;   // the factor's standard error, as a share: how well the parts agree about it
  int parts = 0;      // that speak for it
  // Whether it's large, and certain, enough to be told.
  bool differs() const;
};

// One per frame, at a placement, from all parts: two views of a part show it alike along the axis
// across both. Drawings that are inconsistent part by part have an error to match.
std::vector<DrawnSize> drawn_sizes(const RayResiduals& rays, const Placement& placement);

// A line per frame whose size differs, with the `frames[].scale` that would make up for it.
std::vector<std::string> drawn_size_words(const Document& document,
                                          const std::vector<DrawnSize>& sizes,
                                          const std::vector<double>& scales);

// Per frame, the `frames[].scale` at which it would show the figure as large as the first does; the
// scale it has where nothing speaks for another.
std::vector<double> offered_scales(const Document& document);

}  // namespace artisketch
