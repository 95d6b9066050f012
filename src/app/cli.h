// The command line (FORMAT.md). Exit status: 0 done, 1 bad input, 2 bad command line, 3 the result
// could not be written, 130 stopped by Ctrl-C.
#pragma once

#include <string>
#include <vector>

namespace artisketch {

int run_cli(const std::vector<std::string>& arguments);

}  // namespace artisketch
