// Small details that several drawings show: an eye, a buckle, a letter.
#pragma once

#include "base/face_neighbours.h"
#include "model/texture/drawn_surface.h"

namespace artisketch {

// Has each detail painted from one drawing alone. Where the model's depth is a little off, drawings
// from different sides lay the same eye on different places: it would be painted twice, or have two
// outlines. Two drawings' details are one where they are alike in colour and size, and either lie
// near each other, where the drawings can't both be right, or their rays meet at a place that isn't
// far from either, as in a hollow that no outline shows. Of several alike in a row, as spots and
// buttons, which is which can't be told: they stay. The one that is seen whole and squarely is
// kept, the earlier drawing's before a later one's. The others' sketches have what lies round them
// in their place, and their views no quality where the kept one lies.
void keep_details_once(const Mesh& mesh, const FaceNeighbours& neighbours, DrawnSurface& surface);

}  // namespace artisketch
