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
  constexpr int large = 1 << 20;  // bytes
  // The reason of a failure is returned, not printed.
  if (std::getenv("OPENCV_FFMPEG_LOGLEVEL") == nullptr)
    setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 0);
  if (std::getenv("OPENCV_VIDEOIO_V4L_SELECT_TIMEOUT") == nullptr)
    setenv("OPENCV_VIDEOIO_V4L_SELECT_TIMEOUT", "2", 0);  // seconds
  // An image of 4K is given back to the system when it is no longer needed.
  // The C library would else keep all large memory from then on.
  mallopt(M_MMAP_THRESHOLD, large);
}

}  // namespace vision

#endif
