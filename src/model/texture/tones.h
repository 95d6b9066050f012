// Shade told from colour: drawings in flat colours shade by a second tone, which belongs to the
// light and not to the surface.
#pragma once

#include "model/texture/drawn_surface.h"

namespace artisketch {

// Gives shaded pixels of the sketches the lit tone of their colour, part by part. A tone counts as
// another one's shade where it is that much darker, in nearly the same hue, borders on it, and
// parts of other colours have a shade just like it, or one drawing has it where another has the lit
// one. Drawings without flat colours stay as they are.
//   views  of the sketches, none mirrored
void take_lit_tones(const Model& model, std::span<const SurfaceView> views,
                    std::vector<Sketch>& sketches);

}  // namespace artisketch
