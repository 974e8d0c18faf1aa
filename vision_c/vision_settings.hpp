// SPDX-License-Identifier: GPL-3.0-or-later
// What is to be set in the process before any image work.

#ifndef VISION_SETTINGS_HPP
#define VISION_SETTINGS_HPP

#include <cstdlib>

#include <malloc.h>

namespace vision {

// Before main, as the environment may only be changed while there is one
// thread; without effect where it has been called before. What the user has
// set stays.
inline void prepare_process() {
  constexpr int large = 128 << 10;  // bytes, the C library's own beginning
  // The reason of a failure is returned, not printed.
  if (std::getenv("OPENCV_FFMPEG_LOGLEVEL") == nullptr)
    setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
  if (std::getenv("OPENCV_VIDEOIO_V4L_SELECT_TIMEOUT") == nullptr)
    setenv("OPENCV_VIDEOIO_V4L_SELECT_TIMEOUT", "2", 0);  // seconds
  // What was needed for an image is given back to the system. The memory is
  // locked, so the C library can give back only what it has mapped apart, and
  // the end of the heap it began with: it would else keep for ever the most
  // that each thread has ever had, and large blocks, too, after the first.
  mallopt(M_MMAP_THRESHOLD, large);
  mallopt(M_ARENA_MAX, 1);
}

}  // namespace vision

#endif
