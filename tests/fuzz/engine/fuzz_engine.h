// SPDX-License-Identifier: GPL-3.0-or-later
/* Between AFL++ and a fuzz target: inputs come in, coverage goes out. For
 * targets in any language that GCC compiles. */
#ifndef FUZZ_ENGINE_H
#define FUZZ_ENGINE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Takes one input. What is wrong ends the process with a signal. DATA
 * is exactly SIZE bytes of the heap, so that the address sanitizer sees a step
 * beyond them; it is freed afterwards. */
typedef void (*fuzz_target)(const unsigned char *data, size_t size);

/* Gives TARGET the contents of the file PATH. 0, or -1 where it cannot be
 * read. */
int fuzz_replay(const char *path, fuzz_target target);

/* Gives TARGET the inputs of afl-fuzz, many to a process; outside afl-fuzz
 * one input, that on standard input. */
void fuzz_all(fuzz_target target);

/* Ends the process as a crash that afl-fuzz sees. Not plain abort: Ada's run
 * time makes an exception of its signal. */
void fuzz_crash(void) __attribute__((noreturn));

#ifdef __cplusplus
}
#endif

#endif
