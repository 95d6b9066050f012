// What to say to a command line that isn't understood.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace artisketch {

inline constexpr std::string_view kVerbs[] = {"reconstruct", "calibrate", "check",  "render",
                                              "sprites",     "skeleton",  "manual", "completions"};

// What is wrong with the first word, which should be a verb or an option: empty where it is one.
std::string verb_fault(const std::vector<std::string>& arguments);

// The one of `known` that somebody meant by `word`: begun with it, or a slip or two away; empty
// where none is near.
std::string meant(std::string_view word, std::span<const std::string> known);

}  // namespace artisketch
