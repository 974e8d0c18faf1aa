// SPDX-License-Identifier: GPL-3.0-or-later
// What the parts of vision_c share: frame slots, errors, limits.

#ifndef VISION_INTERNAL_HPP
#define VISION_INTERNAL_HPP

#include <cstddef>
#include <exception>
#include <new>

#include <opencv2/core.hpp>

#include "vision.h"

namespace vision {

// What is known of a JPEG without decoding it.
struct Jpeg_Facts {
  int width = 0, height = 0;
  std::size_t whole = 0;  // bytes up to its end, if it can be passed on as it
                          // is; else 0
};

// Looks at the head of a JPEG, and at the rest for what is no part of an
// image. False, with a reason, where it cannot be decoded.
bool examine(const cv::Mat &bytes, Jpeg_Facts &facts);

// Decodes as far as the bytes are good; to a half, quarter or eighth of its
// size where that is SIZE still or more. False, with a reason, where it
// cannot be done.
bool decode(const cv::Mat &bytes, const cv::Size &size, cv::Mat &image);

// Encodes into BUFFER; what is in it is undefined unless VISION_OK.
vision_status encode(const cv::Mat &image, int quality, unsigned char *buffer,
                     int capacity, int &length);

// The largest size of the proportions of FROM that fits into LIMIT.
cv::Size fitting(const cv::Size &from, const cv::Size &limit);

// Makes TO of SIZE from FROM; of the same size they swap, so that the buffers
// go round and nothing is copied.
void scale(cv::Mat &from, cv::Mat &to, const cv::Size &size);

// An image, or something of its size, that is kept for the next one. Where it
// is large its memory is mapped apart, and goes back to the system when it is
// no longer needed (vision_memory.cpp).
struct Kept : cv::Mat {
  Kept();
};

// Images will be of this size, or are scaled to it.
void expect_images(int width, int height);

// An image. Its memory is used for the next one in the same slot, as is what
// the work on it needs by the next work of the same thread, so that nothing is
// allocated once sizes have settled.
struct Frame {
  // What a slot holds. A camera's own JPEG is decoded when its pixels are
  // needed first, and passed on as it is until something is drawn in it.
  enum class Content { nothing, pixels, jpeg, jpeg_and_pixels };

  Content content = Content::nothing;
  Kept image;                  // 8-bit BGR
  Kept jpeg;                   // one row of bytes
  Jpeg_Facts facts;            // about it
  cv::Size limit;              // what it is to be scaled to fit

  bool holds_jpeg() const {
    return content == Content::jpeg || content == Content::jpeg_and_pixels;
  }

  // Of the image, decoded or not.
  cv::Size size() const {
    return content == Content::jpeg
               ? fitting({facts.width, facts.height}, limit)
               : image.size();
  }
};

// The frame of a slot, null when there is no such slot.
Frame *frame(int slot);

// Decodes what a frame holds if need be. False, with a reason, where that
// cannot be done.
bool make_pixels(Frame &here);

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

// The same for an operation on a slot, which has to hold an image.
template <typename Operation>
vision_status on_frame(int slot, Operation operation) {
  return guarded([&] {
    Frame *const here = frame(slot);
    if (here == nullptr)
      return fail(VISION_BAD_ARGUMENT, "no slot %d", slot);
    if (here->content == Frame::Content::nothing)
      return fail(VISION_BAD_ARGUMENT, "no image in slot %d", slot);
    return operation(*here);
  });
}

// The same for an operation on the pixels of the image.
template <typename Operation>
vision_status on_image(int slot, Operation operation) {
  return on_frame(slot, [&](Frame &here) {
    return make_pixels(here) ? operation(here) : VISION_FAILED;
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
