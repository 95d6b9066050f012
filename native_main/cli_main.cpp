#include <cstdlib>

#include "app/cli.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

int main(int argc, char** argv) {
#ifdef __GLIBC__
  // What is freed is soon asked for again, for the next part or drawing: handing it back in between
  // is a fifth of the time of large drawings.
  constexpr int kKept = 1 << 30;  // bytes
  mallopt(M_MMAP_THRESHOLD, kKept);
  mallopt(M_TRIM_THRESHOLD, kKept);
#endif
  return artisketch::run_cli({argv + 1, argv + argc});
}
