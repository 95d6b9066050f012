// Small details that several drawings show: an eye, a buckle, a letter.
#pragma once

#include "base/face_neighbours.h"
#include "model/texture/drawn_surface.h"

namespace artisketch {

// Has each detail painted from one drawing alone. Where the model's depth is a little off, drawings
// from different sides lay the same eye on different places: it would be painted twice, or have two
// outlines. Of details alike in colour and size and near each other, which the drawings can't both
// be right about, the one that is seen whole and squarely is kept, the earlier drawing's before a
// later one's. The others' sketches have what lies round them in their place, and their views no
// quality where the kept one lies.
void keep_details_once(const Mesh& mesh, const FaceNeighbours& neighbours, DrawnSurface& surface);

}  // namespace artisketch
