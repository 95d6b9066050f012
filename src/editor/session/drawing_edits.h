// What a person does to a drawing as a whole: each is a step of undo.
#pragma once

#include "editor/session/app.h"

namespace artisketch {

void turn_drawing(App& app, int frame, int quarters);  // clockwise
void flip_drawing(App& app, int frame);
// To the figure and its outlines, with a little room.
void crop_drawing(App& app, int frame);
// To a box that is drawn on it.
void crop_by_hand(App& app, int frame);
// Asks for another picture of the same drawing, in any size of the same proportions: outlines and
// pose stay.
void replace_picture(App& app, int frame);

}  // namespace artisketch
