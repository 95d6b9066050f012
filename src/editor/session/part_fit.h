// How the parts of each drawing fit its outlines, as far as that is known.
#pragma once

#include <string>
#include <vector>

#include "editor/session/app.h"

namespace artisketch {

// Missing and hidden without an outline, the others with one. Of a part inside others nothing can
// be told.
enum class Fit { outlined, missing, hidden, off, inside };
Fit fit_of(const App& app, int joint, int frame);
// "Missing in Side", "24 px off in Back"
std::string fit_in_words(const App& app, int joint, int frame);

// How well the model's part will hold from sides that no drawing shows, which the fit doesn't say:
// "From sides not drawn: doubtful"; of the whole for −1. Nothing where there is no model of what is
// drawn.
std::string trust_in_words(const App& app, int joint);

struct PartCount {
  int outlined = 0, off = 0, all = 0;  // all: that are to be outlined
};
PartCount count_parts(const App& app, int frame);

double distance_in(const std::vector<FrameFit>& fits, int joint, int frame);  // as distance_of
double distance_of(const App& app, int joint, int frame);  // pixels; −1 where unknown
inline constexpr double kOff = 3.5, kFarOff = 9;           // pixels: amber, red

}  // namespace artisketch
