// What each tool does on the canvas with the pointer: a thin layer over document/edit.
#pragma once

#include "editor/canvas/pointer.h"

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
// A pose from the outlines, and which way its bones lean to choose from.
void suggest_pose(Work& work);
void bend_chooser(Work& work, ImVec2 corner);  // its lower left one
void turn_body(Work& work, const Quat& turn);
void turn_tool(Work& work, const Pointer& p, const Rect& place);

// ---------------------------------------------------------------- result

void set_key(Work& work);   // of the pose shown, at the playhead; in a clip of one's own
void new_clip(Work& work);  // from the pose shown on
void remove_key(Work& work);

// What the chosen tool does with the pointer on the model as it stands; gives whether it has the
// pointer, which else turns the view.
bool use_result_tool(Work& work, const Eye& eye, const Pose& pose, const Vec3& shift);

}  // namespace artisketch
