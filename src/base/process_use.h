// What this process has used of its machine.
#pragma once

namespace artisketch {

struct ProcessUse {
  double cpu_seconds = 0;  // of all its threads, since it began
  double peak_bytes = 0;   // the most memory that it held at once so far; 0 where nobody tells
};
ProcessUse process_use();

}  // namespace artisketch
