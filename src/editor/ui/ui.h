// The editor's controls. Each draws itself in the theme, shows a tooltip with its key, and is
// recorded, so that tests, scripts and screen readers find it by its label.
#pragma once

#include <string>
#include <vector>

#include "editor/ui/fonts.h"
#include "editor/ui/icons.h"
#include "editor/ui/rect.h"
#include "editor/ui/theme.h"
#include "editor/ui/widget.h"
#include "editor/ui/words.h"

namespace artisketch {

// Begins a frame: controls are recorded in `widgets`, ImGui's own windows take the theme's colours.
void begin_controls(std::vector<Widget>& widgets);
// The words of the frame so far for which there was too little room.
const std::vector<std::string>& words_cut_short();

// A window of ImGui's without any decoration, for as long as the object lives.
class Panel {
 public:
  enum class Layer { base, floating };
  Panel(const char* name, const Rect& place, ImU32 ground, Layer layer = Layer::base,
        float radius = 0);
  ~Panel();
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;
};

// A panel that lies over others, framed, in its shadow, for as long as the object lives.
class FloatingCard {
 public:
  FloatingCard(const char* name, const Rect& place);

 private:
  Panel panel_;
};

// ---------------------------------------------------------------- drawing

ImDrawList& draw();  // of the panel under way

// What is written comes in English and is shown in the person's language (words.h), and is measured
// so.
enum class Align { left, centre, right };
void write(const Rect& place, Font font, ImU32 colour, const std::string& text,
           Align align = Align::left);  // one line, cut short with … where it doesn't fit
// Broken into lines of the width; gives the height that they take.
float write_lines(const Rect& place, Font font, ImU32 colour, const std::string& text,
                  float line_height, Align align = Align::left);
float lines_height(Font font, const std::string& text, float width, float line_height);
float text_width(Font font, const std::string& text);
// What a person called something is shown as it is.
void write_name(const Rect& place, Font font, ImU32 colour, const std::string& name,
                Align align = Align::left);
float name_width(Font font, const std::string& name);
void write_icon(ImVec2 centre, IconSize size, ImU32 colour, const char* icon);
void shadow(const Rect& place, float radius);
void hairline(ImVec2 from, ImVec2 to);
void dashed_frame(const Rect& place, float radius, ImU32 colour);
std::string in_thousands(int number);  // "15 000", for numbers below a million
void key_cap(const Rect& place, const std::string& key);

// ---------------------------------------------------------------- controls

struct Look {
  const char* icon = nullptr;
  std::string hint;  // tooltip; the label where empty
  std::string key;   // shown in the tooltip
  bool primary = false;
  bool quiet = false;  // no ground until the pointer is on it
  bool on = false;     // pressed in, chosen
  bool enabled = true;
  std::string id;      // what it is recorded as, where the label alone would not be unique
  bool names = false;  // the label is somebody's name for something: it is shown as it is
};

// What the pointer does to a rectangle; the ground of every control here.
struct Press {
  bool hovered = false, held = false, clicked = false, double_clicked = false;
};
Press press_area(const std::string& label, const Rect& place, bool enabled = true,
                 bool active = false);

bool button(const std::string& label, const Rect& place, const Look& look = {});
bool icon_button(const std::string& label, const Rect& place, const Look& look);
// A sheet's title, and at its right the cross that Esc presses, too: whether it was pressed. id:
// where several sheets may be open.
bool sheet_head(Rect head, const std::string& title, const std::string& id = "");
bool tool_button(const std::string& label, const Rect& place, const Look& look, bool with_label);
bool checkbox(const std::string& label, const Rect& place, bool& on, bool show_label = true);
// `text` is the value in words, drawn by the caller; true while it changes.
bool slider(const std::string& label, const Rect& place, float& value, float low, float high);
// A row of choices that share one frame; gives the one that was clicked, or −1.
int segments(const std::vector<std::pair<std::string, Look>>& choices, const Rect& place,
             Font font = Font::body);
// takes_keys: what is typed goes there from now on. True once Enter was pressed.
bool text_field(const std::string& label, const Rect& place, std::string& text,
                bool takes_keys = false);

void tooltip(const std::string& words, const std::string& key);
// Registers what another function draws and handles.
void record(const std::string& label, const Rect& place, bool enabled = true, bool active = false);

}  // namespace artisketch
