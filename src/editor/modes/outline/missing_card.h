// What a drawing lacks, said once on tablets, whose sheet has no room for rings in all drawings.
#pragma once

#include <optional>

#include "editor/canvas/layout.h"
#include "editor/session/app.h"

namespace artisketch {

void missing_card(App& app, const Layout& layout);
// Where that is said, if it is.
std::optional<Rect> missing_card_place(const App& app, const Layout& layout);

}  // namespace artisketch
