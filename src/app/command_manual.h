// What is made of the command line's words (command_table.h): no verb or option is missing in it,
// nor stays when it goes.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace artisketch {

// artisketch(1), as man reads it.
std::string manual_page(const CLI::App& app);

// A script for `shell`: bash, zsh or fish.
std::string completions(const CLI::App& app, const std::string& shell);

}  // namespace artisketch
