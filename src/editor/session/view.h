// How one looks at a document. All of it stays when another document is opened, but for what
// begin() says.
#pragma once

#include <array>
#include <cstddef>

#include "document/region_outline.h"
#include "editor/pictures/model_picture.h"
#include "editor/pictures/view_projection.h"
#include "editor/session/on_screen.h"
#include "files/sprites.h"
#include "model/stages.h"

namespace artisketch {

enum class Mode { outline, skeleton, pose, result };
inline constexpr int kModes = 4;

struct Layers {
  bool drawing = true, outlines = true, bones = true, model = false;
  float drawing_opacity = 0.85f, model_opacity = 1;
};

// Where the sketch stands in the window.
struct SketchPlace {
  bool fit = true;  // the drawing fills the canvas
  // On tablets it keeps its place while its figure changes.
  int fitted_frame = -1;
  Mode fitted_mode = Mode::outline;
  ImVec2 fitted_size;
  float zoom = 1;  // points per pixel of the sketch
  ImVec2 origin;   // where the sketch's corner stands in the window
  OnScreen on() const { return {origin, zoom}; }
};

// What the export sheet offers for every document alike.
struct ExportChoice {
  std::size_t format = 0;
  bool texture = true;
  int halvings = 0;     // of the texture's sides
  bool sides = false;   // sprites all round in place of one picture
  std::size_t rig = 0;  // 0: joints as drawn; else one more than the profile's row
  bool compress = false;
  SpriteOptions sprites;  // but for the clip: that is the one chosen in the timeline
};

// How far panels were dragged from their usual sizes, in points.
struct Splits {
  float inspector = 0, model = 0, strip = 0;
  float grabbed = 0;  // how far the one under the pointer was when it was grabbed
};

// What one does in a mode, in three lines (session/hints.h).
struct Hints {
  bool open = false;
  Mode mode = Mode::outline;  // whose they are
  double since = 0;           // seconds: when they came
  std::array<bool, kModes> seen{};
  bool recalled = false;  // what was seen in former sessions is known
};

struct View {
  bool welcome = true;
  bool gallery = false;  // over the first screen
  Mode mode = Mode::outline;
  std::array<std::size_t, kModes> armed{};  // each mode's tool, by its row in App::tools
  std::array<Layers, kModes> layers;
  SketchPlace sketch;
  Orbit orbit;
  Surface surface = Surface::textured;
  bool model_bones = false;
  std::array<bool, kModes> swapped{};  // tablets: the model is large, the drawing its inset
  Splits splits;
  double scrolled_at = -1;  // seconds: when a trackpad scrolled last
  bool panning = false;     // the press under way began with Space held

  double tolerance = kUsualTolerance;  // of Trace, as it was used last
  bool both_sides = true;              // Skeleton: what is done to one side is done to the other
  bool looping = true;                 // clips play again and again
  ExportChoice export_choice;

  bool choosing_pose = false;  // to copy: the drawings are listed
  bool choosing_copy = false;  // where to copy outlines
  bool exporting = false, mapping = false, all_drawings = false, help = false;  // sheets
  Hints hints;
  float strip_scroll = 0;  // points
  bool dark = true;
  const char* language = "en";  // one of kLanguages' codes

  // Another document was opened.
  void begin() {
    welcome = exporting = mapping = choosing_pose = false;
    mode = Mode::outline;
    fit_again();
  }
  void fit_again() { sketch.fit = true, sketch.fitted_frame = -1; }
  void swap() { swapped[std::size_t(mode)] ^= true, fit_again(); }
  Layers& layer() { return layers[std::size_t(mode)]; }
  const Layers& layer() const { return layers[std::size_t(mode)]; }
};

// The orbit that takes in the whole model.
Orbit orbit_round(const Model& model);

}  // namespace artisketch
