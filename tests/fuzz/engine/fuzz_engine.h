// SPDX-License-Identifier: GPL-3.0-or-later
/* Between AFL++ and a fuzz target: inputs come in, coverage goes out. For
 * targets in any language that GCC compiles. */
#ifndef FUZZ_ENGINE_H
#define FUZZ_ENGINE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Takes one input for the target of that number. What is wrong ends the
 * process with a signal. DATA is exactly SIZE bytes of the heap, so that the
 * address sanitizer sees a step beyond them; it is freed afterwards. */
typedef void (*fuzz_target)(int target, const unsigned char *data,
                            size_t size);

/* PROGRAM TARGET [FILE ...]: gives the target of that name in NAMES, of which
 * the last is null, each file (-: standard input), or without one all inputs
 * of afl-fuzz. Alone it prints the names. The result is the program's status. */
int fuzz_main(int count, char **arguments, const char *const *names,
              fuzz_target target);

/* Ends the process as a crash that afl-fuzz sees. Not plain abort: Ada's run
 * time makes an exception of its signal. */
void fuzz_crash(void) __attribute__((noreturn));

#ifdef __cplusplus
}
#endif

#endif
