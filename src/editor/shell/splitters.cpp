#include "editor/canvas/pointer.h"
#include "editor/shell/panels.h"
#include "editor/ui/ui.h"

namespace artisketch {

void splitters(App& app, const Layout& layout) {
  if (layout.inset) return;
  struct Edge {
    const char* name;
    float& size;
    Rect place;
    bool upright;
  };
  constexpr float kGrip = 6;
  Splits& by = app.view.splits;
  const Rect &inspector = layout.inspector, &model = layout.view, &strip = layout.strip;
  const float grip = kGrip / 2;
  for (const Edge& edge :
       {Edge{"Inspector edge",
             by.inspector,
             {inspector.x - grip, inspector.y, kGrip, inspector.h},
             true},
        Edge{"Model edge", by.model, {model.x - grip, model.y, kGrip, model.h}, true},
        Edge{"Strip edge", by.strip, {strip.x, strip.y - grip, strip.w, kGrip}, false}}) {
    const Panel panel(edge.name, edge.place, 0, Panel::Layer::floating);
    const Press press = press_area(edge.name, edge.place);
    if (press.hovered || press.held) {
      ImGui::SetMouseCursor(edge.upright ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
      const ImVec2 middle = edge.place.centre();
      if (edge.upright)
        draw().AddRectFilled({middle.x - 1, edge.place.y}, {middle.x + 1, edge.place.bottom()},
                             theme().accent);
      else
        draw().AddRectFilled({edge.place.x, middle.y - 1}, {edge.place.right(), middle.y + 1},
                             theme().accent);
    }
    if (ImGui::IsItemActivated()) by.grabbed = edge.size;
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 from = io.MouseClickedPos[ImGuiMouseButton_Left];
    if (item_dragged())
      edge.size = by.grabbed + (edge.upright ? from.x - io.MousePos.x : from.y - io.MousePos.y);
    if (press.double_clicked) edge.size = 0;
  }
}

}  // namespace artisketch
