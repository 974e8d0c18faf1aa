// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by the parts of vision_c: frame slots, errors, limits, opening.

#ifndef VISION_INTERNAL_HPP
#define VISION_INTERNAL_HPP

#include <cstddef>
#include <exception>
#include <string>

#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>

#include "vision.h"

namespace vision {

// Properties of a JPEG, known without decoding.
struct Jpeg_Facts {
  int width = 0, height = 0;
  std::size_t whole = 0;  // bytes up to its end, if it can be passed on as it
                          // is; else 0
};

// Examines the header of a JPEG, and the rest for data that is not part of an
// image. False, with a reason, if it cannot be decoded.
bool examine(const cv::Mat &bytes, Jpeg_Facts &facts);

// Decodes the undamaged part; scaled to a half, quarter or eighth if that is
// at least SIZE. False, with a reason, if it cannot be decoded.
bool decode(const cv::Mat &bytes, const cv::Size &size, cv::Mat &image);

// Encodes into BUFFER; its contents are undefined unless VISION_OK.
vision_status encode(const cv::Mat &image, int quality, unsigned char *buffer,
                     int capacity, int &length);

// The largest size that fits into LIMIT with the aspect ratio of FROM.
cv::Size fitting(const cv::Size &from, const cv::Size &limit);

// Makes TO of SIZE from FROM; if the sizes are equal, swaps the buffers
// instead of copying.
void scale(cv::Mat &from, cv::Mat &to, const cv::Size &size);

// A buffer for an image, or data of its size, that is reused for the next
// image. Large buffers are mapped separately, and returned to the system when
// no longer needed (vision_memory.cpp).
struct Kept : cv::Mat {
  Kept();
};

// Images will have this size, or are scaled to it.
void expect_images(int width, int height);

// An image. Its memory is reused for the next image in the same slot, and the
// work buffers by the same thread, so that nothing is allocated once sizes are
// stable.
struct Frame {
  // Contents of a slot. A camera's JPEG is decoded when its pixels are first
  // needed, and passed on unchanged until something is drawn.
  enum class Content { nothing, pixels, jpeg, jpeg_and_pixels };

  Content content = Content::nothing;
  Kept image;                  // 8-bit BGR
  Kept jpeg;                   // one row of bytes
  Jpeg_Facts facts;            // about it
  cv::Size limit;              // what it is to be scaled to fit

  bool holds_jpeg() const {
    return content == Content::jpeg || content == Content::jpeg_and_pixels;
  }

  // Size of the image, decoded or not.
  cv::Size size() const {
    return content == Content::jpeg
               ? fitting({facts.width, facts.height}, limit)
               : image.size();
  }
};

// The frame of a slot, null if there is no such slot.
Frame *frame(int slot);

// Decodes the frame if necessary. False, with a reason, on failure.
bool make_pixels(Frame &here);

// Records the error of the calling thread's operation, and returns the status.
vision_status fail(vision_status status, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

// Runs an operation; catches its exceptions. Not "...": the run time of Ada
// raises one for a fault here, of which the caller's task must end.
template <typename Operation> vision_status guarded(Operation operation) {
  try {
    return operation();
  } catch (const cv::Exception &error) {
    return fail(VISION_FAILED, "%s: %s", error.func.c_str(),
                error.err.c_str());
  } catch (const std::exception &error) {
    return fail(VISION_FAILED, "%s", error.what());
  }
}

// The same for an operation on a slot, which must hold an image.
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

// Whether a point can be drawn and searched around: finite, and not too far
// from the image.
inline bool sound(const vision_point &point) {
  const double limit = 1e6;  // false for a NaN too
  return point.x >= -limit && point.x <= limit && point.y >= -limit &&
         point.y <= limit;
}

bool sound(const vision_arena &arena);

// ------------------------------- FFmpeg and GStreamer (vision_libraries.cpp)

// Longer than the 2.5 s after which the supervisor closes a silent camera, so
// that it says why; the first image comes after the opening.
constexpr int read_limit = 3000;  // milliseconds, of a URL

// Why the source that this thread opens does not open; empty if unknown.
extern thread_local std::string cause;

// What may be secret in a URL as dots: up to the last @, so also in a password
// that should have been encoded, and from the question mark on.
std::string without_secrets(const std::string &name);

// Opens a file or a URL.
bool open_ffmpeg(cv::VideoCapture &capture, const std::string &name);

bool open_gstreamer(cv::VideoCapture &capture, const std::string &pipeline);

}  // namespace vision

#endif
