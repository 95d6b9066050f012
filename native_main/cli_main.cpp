#include "app/cli.h"

int main(int argc, char** argv) {
  return artisketch::run_cli({argv + 1, argv + argc});
}
