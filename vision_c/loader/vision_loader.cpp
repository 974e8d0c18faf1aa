// SPDX-License-Identifier: GPL-3.0-or-later
// The functions of vision.h that the supervisor calls, as it is linked with
// them: each passes on to libdestijl_vision.so beside the program, which is
// loaded when the camera is opened first. OpenCV's libraries are some
// hundreds: a start need not wait for them, nor a robot without a camera have
// their memory.

#include <atomic>
#include <cstdio>
#include <cstring>
#include <type_traits>

#include <dlfcn.h>
#include <errno.h>
#include <limits.h>
#include <pthread.h>
#include <unistd.h>

#include "../vision.h"
#include "../vision_settings.hpp"

namespace {

#define FOR_EACH_FUNCTION(DO)                                                 \
  DO(open) DO(grab) DO(format) DO(close) DO(find_arena) DO(find_robots)       \
  DO(draw_arena) DO(draw_robot) DO(encode) DO(print_markers) DO(reason)

struct Functions {
#define DECLARE(NAME) decltype(&vision_##NAME) NAME;
  FOR_EACH_FUNCTION(DECLARE)
};

// Null until the library is there.
std::atomic<const Functions *> functions{nullptr};

// Of the calling thread, as long as there is no library. Nothing was ever
// stored in a slot then.
thread_local char reason[256] = "no camera was ever opened";

struct Preparation {
  Preparation() { vision::prepare_process(); }
} const preparation;

template <typename Function>
bool find(void *library, const char *name, Function &function) {
  void *const address = dlsym(library, name);
  std::memcpy(&function, &address, sizeof function);
  return address != nullptr;
}

bool find_all(void *library, Functions &all) {
#define FIND(NAME) find(library, "vision_" #NAME, all.NAME) &&
  return FOR_EACH_FUNCTION(FIND) true;
}

// The path of the library into PATH; false where it cannot be told. By its
// full name, as a search is restricted for a program with capabilities.
bool locate(char *path, std::size_t capacity) {
  static const char name[] = "libdestijl_vision.so";
  const ssize_t length = readlink("/proc/self/exe", path, capacity);
  if (length <= 0 || std::size_t(length) >= capacity)
    return false;
  path[length] = '\0';
  char *const file = std::strrchr(path, '/') + 1;
  if (std::size_t(file - path) + sizeof name > capacity)
    return false;
  std::memcpy(file, name, sizeof name);
  return true;
}

// Loads the library unless that has been done. What fails is tried again with
// the next call. Null, with a reason, where it cannot be had.
const Functions *load() {
  static pthread_mutex_t alone = PTHREAD_MUTEX_INITIALIZER;
  static Functions all;
  pthread_mutex_lock(&alone);
  if (functions.load() == nullptr) {
    char path[PATH_MAX];
    if (!locate(path, sizeof path)) {
      std::snprintf(reason, sizeof reason, "no path to the program: %s",
                    std::strerror(errno));
    } else if (void *const library = dlopen(path, RTLD_NOW | RTLD_LOCAL)) {
      if (find_all(library, all))
        functions.store(&all);
      else {
        std::snprintf(reason, sizeof reason, "%s", dlerror());
        dlclose(library);
      }
    } else
      std::snprintf(reason, sizeof reason, "%s", dlerror());
  }
  pthread_mutex_unlock(&alone);
  return functions.load();
}

// The result of a FUNCTION of the library, or OTHERWISE without it.
template <typename Result, typename... Parameters>
Result pass(const Functions *all,
            Result (*Functions::*function)(Parameters...),
            std::common_type_t<Result> otherwise, Parameters... parameters) {
  return all != nullptr ? (all->*function)(parameters...) : otherwise;
}

}  // namespace

extern "C" {

vision_status vision_open(const char *source, int width, int height,
                          int fps) {
  return pass(load(), &Functions::open, VISION_NO_CAMERA, source, width,
              height, fps);
}

vision_status vision_grab(int slot) {
  return pass(functions, &Functions::grab, VISION_NO_CAMERA, slot);
}

const char *vision_format(void) {
  return pass(functions, &Functions::format, "");
}

vision_status vision_close(void) {
  return pass(functions, &Functions::close, VISION_OK);
}

vision_status vision_find_arena(int slot, vision_arena *arena) {
  return pass(functions, &Functions::find_arena, VISION_BAD_ARGUMENT, slot,
              arena);
}

vision_status vision_find_robots(int slot, vision_marker marker,
                                 const vision_arena *arena,
                                 vision_robot *robots, int capacity,
                                 int *count, const vision_area *areas,
                                 int area_count) {
  *count = 0;
  return pass(functions, &Functions::find_robots, VISION_BAD_ARGUMENT, slot,
              marker, arena, robots, capacity, count, areas, area_count);
}

vision_status vision_draw_arena(int slot, const vision_arena *arena) {
  return pass(functions, &Functions::draw_arena, VISION_BAD_ARGUMENT, slot,
              arena);
}

vision_status vision_draw_robot(int slot, const vision_robot *robot) {
  return pass(functions, &Functions::draw_robot, VISION_BAD_ARGUMENT, slot,
              robot);
}

vision_status vision_encode(int slot, int quality, unsigned char *buffer,
                            int capacity, int *length) {
  *length = 0;
  return pass(functions, &Functions::encode, VISION_BAD_ARGUMENT, slot,
              quality, buffer, capacity, length);
}

vision_status vision_print_markers(int descriptor, int first, int side) {
  return pass(load(), &Functions::print_markers, VISION_FAILED, descriptor,
              first, side);
}

const char *vision_reason(void) {
  return pass(functions, &Functions::reason, reason);
}

}  // extern "C"
