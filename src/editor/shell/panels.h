// The parts of the window. Each draws itself into its place and asks for commands; what the
// pointer does to the view or the document happens right there.
#pragma once

#include "editor/canvas/sketch_paint.h"
#include "editor/session/work.h"
#include "editor/shell/layout.h"
#include "editor/ui/ui.h"

namespace artisketch {

void top_bar(Work& work, const Layout& layout);
// What a mode offers: tools first, then what acts at once.
struct RailEntry {
  Command command;
  std::optional<Tool> tool;  // armed by it; else done at once
};
std::vector<RailEntry> tools_of(Mode mode);
Rect rail_place(const Work& work, const Layout& layout);  // as high as its tools, on tablets
void tool_rail(Work& work, const Layout& layout);
void canvas(Work& work, const Layout& layout, float pixel_ratio);
void model_view(Work& work, const Layout& layout, float pixel_ratio);
void inspector(Work& work, const Layout& layout);
void parts_panel(Work& work, Rect place);  // Outline: which part is outlined where
// How far a joint's own bone leans out of the paper: "50° away".
std::string lean_words(const Work& work, int joint);
// A joint's name as people read it, its side smaller.
void part_name(Rect row, const std::string& name, bool chosen);
void outline_panel(Work& work, Rect place);
// The button of "Hidden here": on where the chosen part is.
Look hidden_look(const Work& work);
// "Missing in Side", "24 px off in Back"
std::string fit_in_words(const Work& work, int joint, int frame);
void skeleton_panel(Work& work, Rect place);
void template_cards(Work& work, Rect place, int columns);
void pose_panel(Work& work, Rect place);  // Pose: the calibration's proposal
// What waits for an answer, on tablets in place of the parts.
void proposal_sheet(Work& work, Rect place);
void new_outline_sheet(Work& work, Rect place);
void skeleton_sheet(Work& work, Rect place);
void export_sheet(Work& work, const Rect& place);
void drawing_strip(Work& work, const Layout& layout);
void timeline(Work& work, const Layout& layout);
void status_line(const Work& work, const Layout& layout);
// What a drawing lacks (tablets); and where that is said, if it is.
void missing_card(Work& work, const Layout& layout);
std::optional<Rect> missing_card_place(const Work& work, const Layout& layout);
void toasts(Work& work, const Layout& layout);
void welcome(Work& work, const Layout& layout, float pixel_ratio);
void shortcut_sheet(Work& work, float width, float height);
void question_sheet(Work& work, float width, float height);
void main_menu(Work& work, const Rect& button);

// What the chosen tool does on the canvas with the pointer.
//   clear  where no other tools float over it
void use_tool(Work& work, const Rect& place, const Rect& clear, const OnScreen& on);

// What lies under a right click or a resting finger is chosen, and what can be done to it offered.
void canvas_menu(Work& work, const Rect& place, const OnScreen& on);

// Over the drawing in Pose: where the model's edge and the outlines part ways.
void paint_fit_marks(Work& work, const OnScreen& on);
void paint_fit_tag(Work& work, const Rect& place, const OnScreen& on);  // the worst of them

// Beside the body in Pose: the ball that turns it, its side view, the drawings to copy from.
std::vector<Rect> pose_inset_places(const Layout& layout);
void pose_insets(Work& work, const Layout& layout, float pixel_ratio);
// Whether the wheel over the canvas twists a bone rather than zooms.
bool wheel_twists(const Work& work, const OnScreen& on);

// A button for a command: its icon, key and hint; asks for it when clicked.
void command_button(Work& work, Command command, const Rect& place, Look look = {});
void command_icon(Work& work, Command command, const Rect& place, Look look = {});
bool available(const Work& work, Command command);
// What a command waits for, where a person may wonder; else empty.
std::string what_it_lacks(const Work& work, Command command);

// A small picture of a drawing with its outlines.
void thumbnail(const Work& work, const Frame& frame, const Rect& place, bool outlines = true);

// The model as seen by an eye, in a panel.
void show_model(const Built& built, const Eye& eye, const PaintOptions& options,
                RenderTarget& picture, float opacity, float pixel_ratio, float radius = 0);

// Orbit round the whole model.
void look_at(Work& work, const Model& model);

// What was dragged, and what it is: a file's size in words.
std::string bytes_in_words(std::size_t bytes);

}  // namespace artisketch
