// A tool: one file of modes/ with all that it is in the midst of, and one row in the table of them
// (modes/tools.h).
#pragma once

#include <memory>
#include <string>

#include "editor/session/on_screen.h"
#include "editor/session/view.h"

namespace artisketch {

struct App;

class Tool {
 public:
  virtual ~Tool() = default;

  // What the pointer does, frame by frame: a thin layer over document/edit. Paints nothing.
  virtual void pointer(App& app, const Pointer& pointer, const Stage& stage) = 0;
  // What shows of it over the stage, afterwards.
  virtual void paint(const App& app, const Pointer& pointer, const Stage& stage) const;
  // One line for who has it in hand.
  virtual std::string hint(const App& app) const = 0;

  // Whether something is begun that Esc gives up.
  virtual bool under_way() const { return false; }
  // Takes back the last piece of it; false where there is none, and undo goes to the document.
  virtual bool undo() { return false; }
  // Gives it up. Another tool is taken up, or the pointer's press was meant otherwise.
  virtual void cancel(App& app);

  // ---- What some ask for; the others go without.

  // The pointer's drag is its own: the view doesn't turn with it.
  virtual bool holds_pointer() const { return false; }
  // The wheel is its own: the view doesn't zoom.
  virtual bool takes_wheel(const App&, const Pointer&, const Stage&) const { return false; }
  // A press begins a line, over a joint as well; other tools' presses there are the joint's.
  virtual bool draws_lines() const { return false; }
  // A click on a joint gives it the chosen outline.
  virtual bool gives_outlines() const { return false; }
  // Result: it needs the parts as they are edited, the spheres that join them, the bones in sight.
  virtual bool shows_parts() const { return false; }
  virtual bool shows_spheres() const { return false; }
  virtual bool shows_bones() const { return false; }
};

// A row of the table: what the rail, the keys, the menus and scripts know of a tool.
struct ToolRow {
  const char* id;  // unique within its mode
  Mode mode;
  const char* name;
  const char* icon;
  ImGuiKey key;
  std::unique_ptr<Tool> (*make)();
  const char* about = nullptr;              // in place of the name, where that says too little
  bool usual = false;                       // in hand when the program starts: one of each mode
  bool (*available)(const App&) = nullptr;  // null: always
  std::string (*what_it_lacks)(const App&) = nullptr;  // where a person may wonder
};

template <class T>
std::unique_ptr<Tool> make_tool() {
  return std::make_unique<T>();
}

}  // namespace artisketch
