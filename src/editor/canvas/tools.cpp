#include "editor/canvas/tools.h"

#include "editor/modes/outline/new_outline.h"

namespace artisketch {

void use_tool(Work& work, const Rect& place, const Rect& clear, const OnScreen& on) {
  Pointer p = pointer_on(place, on);
  switch (work.view.mode) {
    case Mode::outline:
      if (picks_joint(work, p, on)) p.pressed = p.held = p.dragging = false;
      if (work.view.tool() == Tool::draw)
        draw_tool(work, p, on);
      else if (work.view.tool() == Tool::points)
        points_tool(work, p, on);
      else if (work.view.tool() == Tool::trace)
        trace_tool(work, p, on);
      else if (work.view.tool() == Tool::cut)
        cut_tool(work, p, on);
      else
        edit_tool(work, p, on);
      if (work.outline) pending_outline(work, clear, on);
      break;
    case Mode::skeleton:
      skeleton_tool(work, p, on);
      break;
    case Mode::pose:
      record_joints(work, on);
      if (work.view.tool() == Tool::twist)
        twist_tool(work, p, on);
      else if (work.view.tool() == Tool::turn)
        turn_tool(work, p, place);
      else
        pose_tool(work, p, on);
      break;
    case Mode::result:
      break;
  }
}

}  // namespace artisketch
