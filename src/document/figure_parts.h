// A whole figure taken apart along its posed skeleton: an outline for each part at once.
#pragma once

#include "document/document.h"
#include "document/region_outline.h"

namespace artisketch {

struct FigureParts {
  Document document;             // with the outlines
  std::vector<int> outlined;     // joints whose parts have one now that had none; ascending
  std::vector<int> off_figure;   // whose bones the figure doesn't reach
  std::vector<int> behind;       // whose bones lie behind other parts: nothing of them shows
  std::vector<int> had_outline;  // whose outlines stay as they are
};

// The figure, all that isn't paper and hangs together about the bones, divided among the parts by
// the frame's pose: each pixel goes to the part whose bone a random walk from there is likeliest to
// meet first, where steps across an edge of colour are unlikely (Grady 2006, "Random walks for
// image segmentation"). So parts meet at joints where the figure is narrow, or along lines that are
// drawn. At a joint both parts run on into one another, rounded, as wide as the figure is there;
// what nearer parts cover of a limb is completed along its bone.
//   image  the frame's drawing
// Left alone: parts that have an outline in the frame, parts said to be hidden, things.
FigureParts with_figure_parts(const Document& document, int frame, const SegmentedImage& image);

}  // namespace artisketch
