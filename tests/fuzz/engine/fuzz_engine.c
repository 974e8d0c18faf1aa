// SPDX-License-Identifier: GPL-3.0-or-later
// Between AFL++ and a fuzz target: inputs come in, coverage goes out.

#include "fuzz_engine.h"

#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>

// Of AFL++'s run time, afl-compiler-rt.o. Its compilers would write these
// declarations, and the two marks below that afl-fuzz looks for in a
// program: many inputs to a process, and a process that says itself where
// its copies begin.
extern uint8_t *__afl_area_ptr;
extern unsigned char *__afl_fuzz_ptr;
extern uint32_t *__afl_fuzz_len;
int __afl_sharedmem_fuzzing = 1;
int __afl_persistent_loop(unsigned count);
void __afl_manual_init(void);

static const char *const volatile many_inputs = "##SIG_AFL_PERSISTENT##";
static const char *const volatile own_start = "##SIG_AFL_DEFER_FORKSRV##";

enum {
  map_bits = 16,         // of the coverage map: 65536 counters, as AFL's
  inputs_each = 2000,    // to one process, then a fresh one
  most_bytes = 1 << 20
};

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

static void give(const unsigned char *bytes, size_t size) {
  unsigned char *const data = malloc(size);
  if (data == NULL && size > 0)
    fuzz_crash();
  if (size > 0)
    memcpy(data, bytes, size);
  before = 0;
  run(chosen, data, size);
  free(data);
}

static int give_file(FILE *file) {
  unsigned char *const bytes = malloc(most_bytes);
  if (bytes == NULL)
    return -1;
  const size_t size = fread(bytes, 1, most_bytes, file);
  const int failed = ferror(file);
  if (!failed)
    give(bytes, size);
  free(bytes);
  return failed ? -1 : 0;
}

static int replay(const char *path) {
  FILE *const file = fopen(path, "rb");
  const int status = file == NULL ? -1 : give_file(file);
  if (file != NULL)
    fclose(file);
  if (status != 0)
    fprintf(stderr, "cannot read %s\n", path);
  return status;
}

static void give_all(void) {
  (void)many_inputs;
  (void)own_start;
  __afl_manual_init();
  // A copy waits stopped between two inputs, and afl-fuzz was seen to end
  // without it.
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (__afl_fuzz_ptr == NULL) {
    give_file(stdin);
    return;
  }
  while (__afl_persistent_loop(inputs_each))
    give(__afl_fuzz_ptr, *__afl_fuzz_len);
}

void fuzz_crash(void) {
  signal(SIGABRT, SIG_DFL);
  abort();
}

int fuzz_main(int count, char **arguments, const char *const *names,
              fuzz_target target) {
  int failed = 0;
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
  if (count == 2)
    give_all();
  for (int k = 2; k < count; ++k)
    failed |= replay(arguments[k]);
  return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
