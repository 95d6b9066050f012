// The command line's words, from which it is read, and from which its help, manual and completions
// are made.
#pragma once

#include <memory>

#include <CLI/CLI.hpp>

#include "app/verbs.h"

namespace artisketch {

// Reads into `a`, which must outlive it.
std::unique_ptr<CLI::App> command_table(Arguments& a);

}  // namespace artisketch
