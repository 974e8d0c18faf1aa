// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of vision.h that the supervisor calls, as it is linked with
// them: each passes on to libdestijl_vision.so beside the program, which the
// first of them loads. OpenCV's libraries are some hundreds: a start need not
// wait for them, nor a robot without a camera have their memory
// (docs/measurements.md, "Why OpenCV is loaded late").

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include <dlfcn.h>
#include <limits.h>
#include <malloc.h>

#include "../vision.h"

namespace {

// Before main, as the environment may only be changed with a single thread.
struct Preparation {
  Preparation() {
    // Seconds; OpenCV reads it when loaded. A setting of the user remains.
    setenv("OPENCV_VIDEOIO_V4L_SELECT_TIMEOUT", "3", 0);
    // The memory is locked, so the C library can return only separately mapped
    // blocks (from this size on, not from one that grows with use) and the top
    // of its first heap: any other heap would keep its largest size.
    mallopt(M_ARENA_MAX, 1);
    mallopt(M_MMAP_THRESHOLD, 128 << 10);
  }
} const preparation;

thread_local char reason[256];  // why this thread found no function

// Loads the library by its full name, as a search is restricted for a program
// with capabilities. Null, with a reason, on failure; the next call tries
// again.
void *load() {
  static const char name[] = "libdestijl_vision.so";
  char path[PATH_MAX + sizeof name];
  if (realpath("/proc/self/exe", path) == nullptr) {
    std::snprintf(reason, sizeof reason, "no path to the program: %m");
    return nullptr;
  }
  std::strcpy(std::strrchr(path, '/') + 1, name);
  void *const library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr)
    std::snprintf(reason, sizeof reason, "%s", dlerror());
  return library;
}

// A function of the library; null, with a reason, if it cannot be had.
void *find(const char *name) {
  static std::atomic<void *> library{nullptr};
  if (library == nullptr)
    library = load();
  void *const function = library == nullptr ? nullptr : dlsym(library, name);
  if (function == nullptr && library != nullptr)
    std::snprintf(reason, sizeof reason, "%s", dlerror());
  return function;
}

}  // namespace

// Defines a function that calls that of the library, and its result without
// one. It is found once: dlsym waits for libraries that others are loading.
#define PASS_ON(RESULT, NAME, PARAMETERS, ARGUMENTS, OTHERWISE)               \
  RESULT NAME PARAMETERS {                                                    \
    static std::atomic<decltype(&NAME)> function{nullptr};                    \
    if (function == nullptr)                                                  \
      function = reinterpret_cast<decltype(&NAME)>(find(#NAME));              \
    return function != nullptr ? function.load() ARGUMENTS : OTHERWISE;       \
  }

extern "C" {

PASS_ON(vision_status, vision_open,
        (const char *source, int width, int height, int fps),
        (source, width, height, fps), VISION_NO_CAMERA)
PASS_ON(vision_status, vision_grab, (int slot), (slot), VISION_NO_CAMERA)
PASS_ON(const char *, vision_format, (), (), "")
PASS_ON(vision_status, vision_close, (), (), VISION_OK)
PASS_ON(vision_status, vision_find_arena, (int slot, vision_arena *arena),
        (slot, arena), VISION_FAILED)
PASS_ON(vision_status, vision_find_robots,
        (int slot, vision_marker marker, const vision_arena *arena,
         vision_robot *robots, int capacity, int *count,
         const vision_area *areas, int area_count),
        (slot, marker, arena, robots, capacity, count, areas, area_count),
        VISION_FAILED)
PASS_ON(vision_status, vision_draw_arena,
        (int slot, const vision_arena *arena), (slot, arena), VISION_FAILED)
PASS_ON(vision_status, vision_draw_robot,
        (int slot, const vision_robot *robot), (slot, robot), VISION_FAILED)
PASS_ON(vision_status, vision_encode,
        (int slot, int quality, unsigned char *buffer, int capacity,
         int *length),
        (slot, quality, buffer, capacity, length), VISION_FAILED)
PASS_ON(vision_status, vision_print_markers,
        (int descriptor, int first, int side), (descriptor, first, side),
        VISION_FAILED)
PASS_ON(const char *, vision_reason, (), (), reason)

}  // extern "C"
