// The language that the interface speaks (ui/words.h): the one chosen in the menu, else the
// browser's or the system's.
#pragma once

#include <string>

#include "editor/session/app.h"

namespace artisketch {

// What was chosen in a former session comes in.
void recall_language(App& app);
// Speaks it from now on, and in later sessions. One of kLanguages' codes.
void choose_language(App& app, const std::string& code);

}  // namespace artisketch
