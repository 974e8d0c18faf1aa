// SPDX-License-Identifier: GPL-3.0-or-later
// What is to be set in the process before any image work.

#ifndef VISION_SETTINGS_HPP
#define VISION_SETTINGS_HPP

#include <algorithm>
#include <cstdlib>

#include <malloc.h>

namespace vision {

constexpr int least_mapped = 128 << 10;  // bytes: the C library's beginning

// What images of this size need again and again, a byte for each pixel, stays
// with the process; larger blocks go back to the system when they are no
// longer needed. The C library would else keep for ever what an image of 4K
// needed.
inline void keep_memory_for(int width, int height) {
  mallopt(M_MMAP_THRESHOLD, std::max(least_mapped, width * height / 4 * 5));
}

// Before main, as the environment may only be changed while there is one
// thread; without effect where it has been called before. What the user has
// set stays.
inline void prepare_process() {
  // The reason of a failure is returned, not printed.
  if (std::getenv("OPENCV_FFMPEG_LOGLEVEL") == nullptr)
    setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
  if (std::getenv("OPENCV_VIDEOIO_V4L_SELECT_TIMEOUT") == nullptr)
    setenv("OPENCV_VIDEOIO_V4L_SELECT_TIMEOUT", "2", 0);  // seconds
  // The memory is locked, so the C library can give back only what it has
  // mapped apart (see keep_memory_for), and the end of the heap it began with:
  // of each other heap it would keep the most there ever was.
  mallopt(M_ARENA_MAX, 1);
  keep_memory_for(640, 480);
}

}  // namespace vision

#endif
