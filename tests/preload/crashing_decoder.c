// SPDX-License-Identifier: GPL-3.0-or-later
// libjpeg with an error that a picture makes use of: preloaded, it decodes as
// ever until the file $CRASH_FILE is there, then does what $CRASH says:
//
//   abort    gives up, as the C library does with a damaged heap
//   free     frees twice, which the C library finds
//   fault    writes where it may not, in the caller's thread
//   stack    calls itself until the caller's stack is used up
//   thread   writes where it may not, in a thread of its own, as FFmpeg has them
//   exit     ends the process, as libjpeg does by default

#include <stddef.h>
#include <stdio.h>  // before jpeglib.h

#include <dlfcn.h>
#include <jpeglib.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void *volatile nowhere = NULL;
static volatile int depth_limit = -1;

static void *fault(void *unused) {
  *(int *)nowhere = 1;
  return unused;
}

static int recurse(int depth) {
  volatile char used[1000];
  used[depth % 1000] = 1;
  return depth == depth_limit ? 0 : recurse(depth + 1) + used[depth % 999];
}

static void crash(const char *how) {
  pthread_t thread;
  if (strcmp(how, "abort") == 0)
    abort();
  if (strcmp(how, "free") == 0) {
    void *volatile memory = malloc(100);
    free(memory);
    free(memory);
  }
  if (strcmp(how, "fault") == 0)
    fault(NULL);
  if (strcmp(how, "stack") == 0)
    exit(recurse(0));
  if (strcmp(how, "thread") == 0) {
    pthread_create(&thread, NULL, fault, NULL);
    pthread_join(thread, NULL);
  }
  if (strcmp(how, "exit") == 0)
    exit(1);
}

boolean jpeg_start_decompress(j_decompress_ptr object) {
  static boolean (*next)(j_decompress_ptr) = NULL;
  if (access(getenv("CRASH_FILE"), F_OK) == 0)
    crash(getenv("CRASH"));
  if (next == NULL) {
    // the library is not among those that RTLD_NEXT searches
    void *const library = dlopen("libjpeg.so.62", RTLD_LAZY);
    *(void **)&next = dlsym(library, "jpeg_start_decompress");
  }
  return next(object);
}
