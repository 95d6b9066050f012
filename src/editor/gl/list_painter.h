// Dear ImGui's draw lists in an OpenGL context that is ours alone. Dear ImGui's own back end asks
// OpenGL for its state in every frame to restore it; in a browser each answer waits until the
// graphics process has drawn all that was asked of it before.
#pragma once

#include <imgui.h>

namespace artisketch {

class ListPainter {
 public:
  ListPainter() = default;
  ListPainter(ListPainter&& other) noexcept;
  ListPainter& operator=(ListPainter&&) = delete;
  ~ListPainter();

  // Hands the fonts to the card where it has none of them; before ImGui::NewFrame().
  void load_fonts();
  // The fonts were made anew.
  void drop_fonts();
  // Into the frame that is bound, of that size. Leaves nothing bound, and tests nothing.
  void paint(const ImDrawData& data, int pixels_wide, int pixels_high);
  // While the context is there.
  void release();

 private:
  void make();
  void begin(const ImDrawData& data, int pixels_wide, int pixels_high) const;
  unsigned program_ = 0, array_ = 0, vertices_ = 0, indices_ = 0, fonts_ = 0;
  int projection_ = 0, squares_ = 0;  // uniforms
};

}  // namespace artisketch
