// The model while it is edited: its parts, made anew on a coarse grid where something changed, each
// bound to its joint alone.
#pragma once

#include "editor/session/app.h"

namespace artisketch {

// Asks for the parts of the document as it stands, where nothing else is computed; the newest state
// is asked for once the last answer is there. Then the spheres of a model that came without them,
// while they are to be seen. Called each frame.
void keep_live(App& app);
void take_parts(App& app, const RunningJob& job, Result<JobResult> outcome);

// The fit marks of the drawing on the canvas, in its pose as shown; a model that is up to
// date in the pose that it was made at. None of parts inside others.
const std::vector<PartMarks>& marks_of_drawing(App& app);

}  // namespace artisketch
