// What each tool does on the canvas with the pointer: a thin layer over document/edit.
#pragma once

#include "editor/pointer.h"

namespace artisketch {

// ---------------------------------------------------------------- outline

void edit_tool(Work& work, const Pointer& p, const OnScreen& on);
void draw_tool(Work& work, const Pointer& p, const OnScreen& on);
void points_tool(Work& work, const Pointer& p, const OnScreen& on);
void trace_tool(Work& work, const Pointer& p, const OnScreen& on);
void trace_with(Work& work, double tolerance);  // the pending outline, which was traced
void cut_tool(Work& work, const Pointer& p, const OnScreen& on);

// ---------------------------------------------------------------- skeleton

void skeleton_tool(Work& work, const Pointer& p, const OnScreen& on);

// ---------------------------------------------------------------- pose

// Each joint as a control that scripts and screen readers find: "Joint Hand L".
void record_joints(const Work& work, const OnScreen& on);
void pose_tool(Work& work, const Pointer& p, const OnScreen& on);
void twist_tool(Work& work, const Pointer& p, const OnScreen& on);
void turn_body(Work& work, const Quat& turn);
void turn_tool(Work& work, const Pointer& p, const Rect& place);

}  // namespace artisketch
