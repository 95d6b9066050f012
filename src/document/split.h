// A part taken apart at a new joint: an arm drawn as one part that bends from drawing to drawing.
#pragma once

#include <optional>

#include "document/document.h"

namespace artisketch {

// Where a part bends, along its middle line from its joint (0) to the end of its bone (1), and by
// how much: the most that a drawing shows it bent against another, or against a straight line.
struct Fold {
  double along = 0.5;
  double angle = 0;  // radians
};
// Nothing where no drawing shows a part of one bone with a middle line.
std::optional<Fold> fold_of(const Document& document, int joint);
// From there on it is a bend and no wobble of a hand.
inline constexpr double kFold = radians(25);

// How far along the part a place of a drawing lies; nothing where that shows no such part.
std::optional<double> along_part(const Document& document, int frame, int joint, const Vec2& place);

// Whether a part can be split: it has outlines, and no more than one bone.
bool can_split(const Document& document, int joint);

// A new joint in the part's bone; every drawing's outlines of the part are cut across there into
// two that overlap, or, where that drawing shows it bent by kFold, at its bend. There the new joint
// is turned to the bend, and what hangs on it stays where it is seen. The mirror image's part and
// bone likewise. The joint comes right after the part's own; its name is the part's with a number.
//   along  0.1 … 0.9; absent: where it bends, or in the middle
// Nothing where no outline could be cut.
std::optional<Document> with_part_split(const Document& document, int joint,
                                        std::optional<double> along = std::nullopt);

}  // namespace artisketch
