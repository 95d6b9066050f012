#include "editor/editor.h"

#include <imgui.h>

#include "editor/fonts.h"
#include "editor/theme.h"

namespace artisketch {

struct Editor::Parts {
  Platform& platform;
  Jobs& jobs;
  std::vector<Widget> widgets;
  EditorState state;
};

Editor::Editor(Platform& platform, Jobs& jobs)
    : parts_(new Parts{.platform = platform, .jobs = jobs, .widgets = {}, .state = {}}) {}
Editor::~Editor() = default;

void Editor::open(Result<std::vector<NamedBytes>> files) {
  parts_->state.message = files ? files->front().name : files.error().text();
}
bool Editor::close() {
  return true;
}
bool Editor::closed() const {
  return false;
}

void Editor::frame(float width, float height, float) {
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  draw.AddRectFilled({0, 0}, {width, height}, theme().panel);
  draw.AddText(font(Font::headline), 24 * 1.21f, {24, 24}, theme().text, "ArtiSketch");
}
bool Editor::wants_frame() const {
  return false;
}

const std::vector<Widget>& Editor::widgets() const {
  return parts_->widgets;
}
EditorState Editor::state() const {
  return parts_->state;
}
std::optional<Vec2> Editor::project(int, double, double) const {
  return std::nullopt;
}
bool Editor::unsaved() const {
  return false;
}

}  // namespace artisketch
