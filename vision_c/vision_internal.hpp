// SPDX-License-Identifier: GPL-3.0-or-later
// What the three parts of vision_c share: frame slots, errors, limits.

#ifndef VISION_INTERNAL_HPP
#define VISION_INTERNAL_HPP

#include <exception>
#include <new>
#include <vector>

#include <opencv2/core.hpp>

#include "vision.h"

namespace vision {

// An image and what the work on it needs. Everything is reused from one
// image to the next, so that nothing is allocated once sizes have settled.
struct Frame {
  cv::Mat image;               // 8-bit BGR, empty until something is stored
  cv::Mat grey, smooth;        // the searches' own
  cv::Mat small, gradient, transposed, mask;
  std::vector<unsigned char> encoded;
  std::vector<int> encoding;   // parameters of the JPEG encoder
};

// The frame of a slot, null when there is no such slot.
Frame *frame(int slot);

// Notes why the calling thread's operation fails, and returns the status.
vision_status fail(vision_status status, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

// Runs an operation; its exceptions end here.
template <typename Operation> vision_status guarded(Operation operation) {
  try {
    return operation();
  } catch (const cv::Exception &error) {
    return fail(VISION_FAILED, "%s: %s", error.func.c_str(),
                error.err.c_str());
  } catch (const std::bad_alloc &) {
    return fail(VISION_FAILED, "out of memory");
  } catch (const std::exception &error) {
    return fail(VISION_FAILED, "%s", error.what());
  } catch (...) {
    return fail(VISION_FAILED, "unknown failure");
  }
}

// The same for an operation on the image of a slot, which has to be there.
template <typename Operation>
vision_status on_image(int slot, Operation operation) {
  return guarded([&] {
    Frame *const here = frame(slot);
    if (here == nullptr)
      return fail(VISION_BAD_ARGUMENT, "no slot %d", slot);
    if (here->image.empty())
      return fail(VISION_BAD_ARGUMENT, "no image in slot %d", slot);
    return operation(*here);
  });
}

// Whether a point can be drawn and searched around: a finite number of
// pixels not absurdly far from the image.
inline bool sound(const vision_point &point) {
  const double limit = 1e6;  // false for a NaN too
  return point.x >= -limit && point.x <= limit && point.y >= -limit &&
         point.y <= limit;
}

bool sound(const vision_arena &arena);

}  // namespace vision

#endif
