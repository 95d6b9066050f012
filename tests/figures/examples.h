// The documents under assets/examples, made from figures whose truth is known.
#pragma once

#include "figures.h"
#include "figures/ink.h"

namespace artisketch::figures {

struct Example {
  std::string name;
  Figure figure;
  Sketches sketches;  // `given` is what the file holds
  InkStyle ink;
};

std::vector<std::string> example_names();
Example example(std::string_view name);  // one of example_names()

}  // namespace artisketch::figures
