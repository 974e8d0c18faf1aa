// SPDX-License-Identifier: GPL-3.0-or-later
// bin/destijl_fuzz_vision TARGET [FILE ...]: gives the target each file, or
// without one all inputs of afl-fuzz. Alone it names its targets.

#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "fuzz_engine.h"
#include "vision_targets.hpp"

namespace {

struct Target {
  const char *name;
  fuzz_target run;
};

constexpr Target targets[] = {
    {"calls", calls}, {"scenes", scenes}, {"files", files}};

}  // namespace

int main(int count, char **argument) {
  if (count < 2) {
    for (const Target &target : targets)
      std::puts(target.name);
    return EXIT_SUCCESS;
  }

  // No image of gigabytes: its memory would be the finding.
  setenv("OPENCV_IO_MAX_IMAGE_PIXELS", "1048576", 1);
  for (const Target &target : targets) {
    if (std::strcmp(target.name, argument[1]) != 0)
      continue;
    int status = EXIT_SUCCESS;
    for (int k = 2; k < count; ++k)
      if (fuzz_replay(argument[k], target.run) != 0) {
        std::fprintf(stderr, "cannot read %s\n", argument[k]);
        status = EXIT_FAILURE;
      }
    if (count == 2)
      fuzz_all(target.run);
    return status;
  }
  std::fprintf(stderr, "no target %s\n", argument[1]);
  return EXIT_FAILURE;
}
