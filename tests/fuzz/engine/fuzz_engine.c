// SPDX-License-Identifier: GPL-3.0-or-later
// Between AFL++ and a fuzz target: inputs come in, coverage goes out.

#include "fuzz_engine.h"

#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>

// Of AFL++: the coverage map of its run time, afl-compiler-rt.o, and its
// driver, libAFLDriver.a, which gives all inputs of afl-fuzz, or files.
extern uint8_t *__afl_area_ptr;
int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);
int LLVMFuzzerRunDriver(int *count, char ***arguments,
                        int (*target)(const uint8_t *bytes, size_t size));

enum { map_bits = 16 };  // of the coverage map: 65536 counters, as AFL's

// Where the program was loaded: the linker's symbol.
extern const char __executable_start;

static uintptr_t before;

static fuzz_target run;
static int chosen;

void __sanitizer_cov_trace_pc(void);

// GCC's -fsanitize-coverage=trace-pc calls it in each basic block. As in AFL
// a pair of blocks, one after the other, has a counter.
void __sanitizer_cov_trace_pc(void) {
  const uintptr_t block = (uintptr_t)__builtin_return_address(0) -
                          (uintptr_t)&__executable_start;
  const uint32_t here = (uint32_t)block * 2654435769u >> (32 - map_bits);
  uint8_t *const counter = &__afl_area_ptr[here ^ before];
  // Never back to 0, which would say that the pair was not seen.
  *counter = (uint8_t)(*counter + 1 + (*counter == UINT8_MAX));
  before = here >> 1;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size) {
  // A copy of the process waits stopped between two inputs, and afl-fuzz was
  // seen to end without it.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  unsigned char *const data = malloc(size);
  if (data == NULL && size > 0)
    fuzz_crash();
  if (size > 0)
    memcpy(data, bytes, size);
  before = 0;
  run(chosen, data, size);
  free(data);
  return 0;
}

void fuzz_crash(void) {
  signal(SIGABRT, SIG_DFL);
  abort();
}

int fuzz_main(int count, char **arguments, const char *const *names,
              fuzz_target target) {
  run = target;
  if (count < 2) {
    for (; *names != NULL; ++names)
      puts(*names);
    return EXIT_SUCCESS;
  }
  while (names[chosen] != NULL && strcmp(names[chosen], arguments[1]) != 0)
    ++chosen;
  if (names[chosen] == NULL) {
    fprintf(stderr, "no target %s\n", arguments[1]);
    return EXIT_FAILURE;
  }
  // the driver knows nothing of targets
  arguments[1] = arguments[0];
  ++arguments;
  --count;
  return LLVMFuzzerRunDriver(&count, &arguments, LLVMFuzzerTestOneInput);
}
