// The documents under assets/examples and assets/gallery, made from figures whose truth is known.
#pragma once

#include "figures.h"
#include "figures/ink.h"

namespace artisketch::figures {

struct Example {
  std::string folder;  // "examples", or "gallery": the paper's figures, and what else can be drawn
  std::string name;
  Figure figure;
  Sketches sketches;  // `given` is what the file holds
  InkStyle ink;
};

std::vector<std::string> example_names();
Example example(std::string_view name);  // one of example_names()

// What every example ends with: the drawings' names, poses that read well in a file.
Example finished(Figure figure, Sketches sketches, const InkStyle& ink = {},
                 const std::string& folder = "gallery");

Example prince_walking();
Example horse_trotting();  // its torso one part
Example horse_turning();   // three
Example ballerina_dancing();
Example alien_landed();
Example climber_climbing();
Example legs_dancing();
Example parrot_flying();
Example monster_once();      // a single drawing
Example gnome_walking();     // a sheet of four sprites
Example knight_in_pixels();  // 64 of them
Example bear_in_pencil();

}  // namespace artisketch::figures
