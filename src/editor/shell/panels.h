// The parts of the window. Each draws itself into its place and asks for commands; what the
// pointer does to the view or the document happens right there.
#pragma once

#include "editor/canvas/layout.h"
#include "editor/session/app.h"

namespace artisketch {

void top_bar(App& app, const Layout& layout);
Rect rail_place(const App& app, const Layout& layout);  // as high as its tools, on tablets
void tool_rail(App& app, const Layout& layout);
void sketch_panel(App& app, const Layout& layout, float pixel_ratio);
void model_panel(App& app, const Layout& layout, float pixel_ratio);
void hints_card(App& app, const Layout& layout);
void notes_card(App& app, const Layout& layout);
void inspector(App& app, const Layout& layout);
void drawing_strip(App& app, const Layout& layout);
// The edges between panels, to drag; a double click sets them back.
void splitters(App& app, const Layout& layout);
void status_line(const App& app, const Layout& layout);
void toasts(App& app, const Layout& layout);
void welcome(App& app, const Layout& layout, float pixel_ratio);
void examples_row(App& app, const Rect& place);  // the first screen's, with the way to the gallery
void gallery(App& app, const Rect& place);       // every example, over the first screen
void shortcut_sheet(App& app, float width, float height);
void picking_sheet(App& app, float width, float height);
void question_sheet(App& app, float width, float height);
// Darkens the window; false once what stands at `place` over it is dismissed.
bool over_all(const Rect& place, float width, float height);
void main_menu(App& app, const Rect& button);

// What lies under a right click or a resting finger is chosen, and what can be done to it offered.
void canvas_menu(App& app, const Rect& place, const OnScreen& on);

}  // namespace artisketch
