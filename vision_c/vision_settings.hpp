// SPDX-License-Identifier: GPL-3.0-or-later
// Process settings, to be made before any image processing.

#ifndef VISION_SETTINGS_HPP
#define VISION_SETTINGS_HPP

#include <algorithm>
#include <cstdlib>

#include <malloc.h>

namespace vision {

constexpr int least_mapped = 128 << 10;  // bytes: the C library's beginning

// Buffers that images of this size need repeatedly, a byte for each pixel,
// stay with the process; larger blocks are returned to the system when no
// longer needed. Otherwise the C library would keep the memory of a 4K image
// permanently.
inline void keep_memory_for(int width, int height) {
  mallopt(M_MMAP_THRESHOLD, std::max(least_mapped, width * height / 4 * 5));
}

// Call before main, as the environment may only be changed with a single
// thread; no effect if called before. Settings of the user are kept.
inline void prepare_process() {
  // The reason of a failure is returned, not printed.
  if (std::getenv("OPENCV_FFMPEG_LOGLEVEL") == nullptr)
    setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
  if (std::getenv("OPENCV_VIDEOIO_V4L_SELECT_TIMEOUT") == nullptr)
    setenv("OPENCV_VIDEOIO_V4L_SELECT_TIMEOUT", "3", 0);  // seconds
  // The memory is locked, so the C library can return only separately mapped
  // blocks (see keep_memory_for) and the top of its first heap: any other heap
  // would keep its largest size.
  mallopt(M_ARENA_MAX, 1);
  keep_memory_for(640, 480);
}

}  // namespace vision

#endif
