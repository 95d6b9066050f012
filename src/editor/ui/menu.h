// Menus of what can be done to one thing: lines of words and keys over all else, recorded as other
// controls are.
#pragma once

#include <string>

#include "editor/ui/rect.h"

namespace artisketch {

// A finger or pen came to rest half a second ago. The mouse has a button for it.
bool long_press();

// For as long as the object lives; closed by a choice, Escape, or a press elsewhere.
class Menu {
 public:
  // Of the control before: by a right click, or a long press.
  Menu();
  // Opened by `open`.
  Menu(const char* name, bool open);
  ~Menu();
  Menu(const Menu&) = delete;
  Menu& operator=(const Menu&) = delete;

  explicit operator bool() const { return open_; }
  // A line; whether it was chosen. Of an open menu only.
  bool line(const std::string& label, const std::string& key = "", bool enabled = true);

 private:
  void begin(bool open);
  bool open_ = false;
};

}  // namespace artisketch
