// What the editor tells scripts of itself, as JSON: artisketch.widgets() and artisketch.state() in
// the page, the window's --script.
#pragma once

#include "editor/editor.h"
#include "files/json.h"

namespace artisketch {

// [{label, x, y, width, height, enabled, active}], in points, to a hundredth.
Json widgets_json(const Editor& editor);

// {mode, busy, stage, progress, frame, frames, joints, hasModel, liveParts, revision,
// liveRevision, canUndo, undo, message, unsaved}.
Json state_json(const Editor& editor);

}  // namespace artisketch
