#include "editor/tools.h"

namespace artisketch {

void use_tool(Work& work, const Rect& place, const OnScreen& on) {
  const Pointer p = pointer_on(place, on);
  switch (work.view.mode) {
    case Mode::outline:
      if (work.view.tool() == Tool::draw)
        draw_tool(work, p, on);
      else if (work.view.tool() == Tool::points)
        points_tool(work, p, on);
      else if (work.view.tool() == Tool::cut)
        cut_tool(work, p, on);
      else
        edit_tool(work, p, on);
      if (work.outline) pending_outline(work, place, on);
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
