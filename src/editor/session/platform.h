// What the editor asks of the place it runs in: the desktop (native_main/desktop.cpp) or a browser
// (web/). Answers may come later: a `then` is called on the drawing thread, between two frames, or
// at once; not at all where the person chose nothing.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "base/result.h"

namespace artisketch {

struct NamedBytes {
  std::string name;  // without folders
  std::string bytes;
  std::string place;  // where save_file() can put it back; empty where it cannot
};

// A document that came with the program: its drawings inside, and the model made from it, where
// that came along too.
struct Example {
  std::string document;
  std::string glb;  // may be empty
};

// How the first screen knows an example.
struct ExampleCard {
  std::string name;
  int drawings = 0;
  enum class Shelf { first_screen, gallery, elsewhere };  // elsewhere: this copy came without it
  Shelf shelf = Shelf::first_screen;
};

class Platform {
 public:
  virtual ~Platform() = default;

  // Whether open_files() and save_file() can ask. Where not, the editor asks for a path itself, and
  // calls open_recent() and save_file() with it.
  virtual bool has_dialogs() = 0;

  enum class Kind { document, drawings };  // one document, or several images
  using Opened = std::function<void(Result<std::vector<NamedBytes>>)>;
  virtual void open_files(Kind kind, Opened then) = 0;

  // place: where it was opened from or saved to before; empty: asks the person, proposing `name`,
  // or downloads it. Gives the place for the next time.
  struct Saved {
    std::string name, place;
  };
  virtual void save_file(const std::string& name, const std::string& place, std::string bytes,
                         std::function<void(Result<Saved>)> then) = 0;

  // Documents opened and saved lately, newest first.
  struct Recent {
    std::string name, place;
  };
  virtual std::vector<Recent> recents() = 0;
  virtual void open_recent(const std::string& place, Opened then) = 0;

  // Small things kept between sessions, by key: "autosave", "left", "settings". Nothing removes.
  virtual void store(const std::string& key, std::string bytes) = 0;
  virtual void load(const std::string& key, std::function<void(std::string)> then) = 0;

  // The examples, the one that greets first, the gallery's after all others; one of them; and a
  // small picture of its model, a PNG, empty where there is none.
  virtual std::vector<ExampleCard> examples() = 0;
  virtual void load_example(const std::string& name, std::function<void(Result<Example>)> then) = 0;
  virtual void load_example_picture(const std::string& name,
                                    std::function<void(std::string)> then) = 0;

  // The language that the person set for the browser or the system, as that names it: "de-AT",
  // "de_DE.UTF-8"; and assets/languages/CODE.txt, empty where it can't be had.
  virtual std::string language() = 0;
  virtual void load_words(const std::string& code, std::function<void(std::string)> then) = 0;

  // The guide, as a page in the system's browser or another tab, where this place has it.
  virtual bool has_guide() = 0;
  virtual void show_guide() = 0;

  // The window's or the tab's title; unsaved work makes its closing ask.
  virtual void set_title(const std::string& title, bool unsaved) = 0;
  virtual bool prefers_dark() = 0;
  virtual int default_grid() = 0;    // cells: what this place computes in bearable time
  virtual void request_frame() = 0;  // from any thread: wakes a window that rests
  virtual bool mac_keys() = 0;       // Cmd where others have Ctrl
  // A clock that never goes back; seconds.
  virtual double now() {
    const auto since = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(since).count();
  }
};

}  // namespace artisketch
