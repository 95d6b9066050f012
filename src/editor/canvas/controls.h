// What several panels show of the document and its commands.
#pragma once

#include <string>
#include <string_view>

#include "document/edit.h"
#include "editor/session/app.h"
#include "editor/ui/ui.h"

namespace artisketch {

// A button for a command: its icon, key and hint, pressed in where it is on; asks for it when
// clicked.
void command_button(App& app, std::string_view command, const Rect& place, Look look = {});
void command_icon(App& app, std::string_view command, const Rect& place, Look look = {});
// How such a button looks, for one of another shape.
Look command_look(const App& app, const Command& command, Look look = {});

// What lies behind a drawing: paper, or what pale figures stand out from.
ImU32 ground_of(const Drawing* drawing);  // null: none
// A small picture of a drawing with its outlines.
void thumbnail(const App& app, const Frame& frame, const Rect& place, bool outlines = true);

// A joint's side as the person's language has it: "L", "I".
std::string shown_side(const JointWords& words);
// A joint's name as people read it, its side smaller.
void part_name(Rect row, const std::string& name, bool chosen);

// Each joint as a control that scripts and screen readers find: "Joint Hand L".
void record_joints(const App& app, const OnScreen& on);

// A model as its panel sees it.
void show_model(const BuiltModel& built, const ViewProjection& projection,
                const PaintOptions& options, RenderTarget& picture, float opacity,
                float pixel_ratio, float radius = 0);

// Of `count` rows `tall` each, those that fit `place`: the wheel over it goes through them, by
// `first`, and a bar at its right tells where one is.
struct Rows {
  int first = 0, end = 0;
};
Rows scrolled_rows(int& first, int count, float tall, const Rect& place);

}  // namespace artisketch
