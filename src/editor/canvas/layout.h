// Where everything stands, for a window of any size.
#pragma once

#include "editor/session/app.h"

namespace artisketch {

struct Layout {
  bool tablet = false;   // held upright: everything for fingers
  bool inset = false;    // model and drawing share a place, one lies over the other
  bool swapped = false;  // of those: the drawing is the inset
  bool compact = false;  // a small screen: icons without words, one line each
  Rect top, modes;       // modes: the tablet's second row
  Rect rail;             // tools; floats on tablets
  Rect canvas, canvas_head, canvas_foot;  // head and foot are bands beside the drawing's place
  Rect view, view_head, view_foot;        // the model
  Rect inspector;                         // the parts sheet on tablets
  Rect strip, status;
};

Layout lay_out(float width, float height, const View& view);

}  // namespace artisketch
