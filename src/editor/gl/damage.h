// What of the window changed since the frame before. Most frames change little, and a machine
// without graphics pays for every pixel.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "editor/ui/rect.h"

namespace artisketch {

class Damage {
 public:
  // Narrows what is to be drawn to the places that look otherwise than in the frame before, and
  // gives these: disjoint, in points; none: nothing changed. What is drawn lies within them and is
  // complete there, over whatever was there before.
  //   painted  textures whose pictures changed since
  //   afresh   whatever was drawn before is gone
  std::vector<Rect> narrow(ImDrawData& data, std::span<const unsigned> painted, bool afresh);

 private:
  struct List {
    std::string owner;
    std::vector<ImDrawCmd> commands;
    std::vector<ImDrawVert> vertices;
    std::vector<ImDrawIdx> indices;
  };
  static void compare(const List& old, const List& now, std::span<const unsigned> painted,
                      std::vector<Rect>& changed);
  static Rect around(const List& list, const ImDrawCmd& command, std::size_t from, std::size_t to);
  static void whole(const List& list, std::vector<Rect>& changed);
  std::vector<List> before_;
};

}  // namespace artisketch
