// Orbit: looks round the model, and changes nothing.
#include "editor/session/tool.h"
#include "editor/ui/icons.h"

namespace artisketch {
namespace {

class OrbitTool : public Tool {
 public:
  void pointer(App&, const Pointer&, const Stage&) override {}
  std::string hint(const App&) const override { return "Drag to look around the model.  P plays."; }
};

}  // namespace

ToolRow orbit_tool() {
  return {.id = "orbit",
          .mode = Mode::result,
          .name = "Orbit",
          .icon = icon::kRotate3d,
          .key = ImGuiKey_O,
          .make = make_tool<OrbitTool>,
          .about = "Look around"};
}

}  // namespace artisketch
