// SPDX-License-Identifier: GPL-3.0-or-later
// The frame slots: storing, drawing, encoding; and error messages.

#include "vision_internal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include <opencv2/core/ocl.hpp>
#include <opencv2/core/utility.hpp>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>

namespace vision {

namespace {

thread_local char reason[160] = "";

struct Frames {
  Frame slot[VISION_SLOTS];

  Frames() {
    cv::setNumThreads(1);  // work stays in the caller, at its priority
    cv::ocl::setUseOpenCL(false);
    // The reason of a failure is returned, not printed.
    if (std::getenv("OPENCV_LOG_LEVEL") == nullptr)
      cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  }
};

// Points are given to OpenCV in sixteenths of a pixel.
constexpr int shift = 4;

cv::Point fine(const vision_point &point) {
  return {cvRound(point.x * (1 << shift)), cvRound(point.y * (1 << shift))};
}

// Lines remain visible in large images.
int thickness(const cv::Mat &image) {
  return std::max(1, std::min(image.cols, image.rows) / 240);
}

// Writes TEXT on an opaque plate next to a marker that extends by REACH from
// CENTRE: at the first corner where the plate is inside the image and does not
// hide TIP.
void draw_label(cv::Mat &image, const std::string &text,
                const cv::Point2d &centre, const cv::Point2d &tip,
                double reach) {
  const cv::Scalar black(0, 0, 0), white(255, 255, 255);
  constexpr int font = cv::FONT_HERSHEY_SIMPLEX;
  constexpr double digit_height = 21;  // of the font, at scale 1
  const int height = std::max(12, std::min(image.cols, image.rows) / 24);
  const int thick = std::max(1, height / 9);
  const int margin = height / 4 + thick;
  const double scale = height / digit_height;
  const cv::Size letters =
      cv::getTextSize(text, font, scale, thick, nullptr);
  const cv::Size plate(letters.width + 2 * margin,
                       letters.height + 2 * margin);
  const double distance = reach + 3 * thickness(image);

  const cv::Rect whole(0, 0, image.cols, image.rows);
  cv::Rect place({}, plate);
  for (int n = 0; n < 4; ++n) {
    place.x = cvRound(n % 2 == 0 ? centre.x + distance
                                 : centre.x - distance - plate.width);
    place.y = cvRound(n < 2 ? centre.y + distance
                            : centre.y - distance - plate.height);
    if ((place & whole) == place && !place.contains(tip))
      break;
  }
  place.x = std::clamp(place.x, 0, std::max(0, image.cols - plate.width));
  place.y = std::clamp(place.y, 0, std::max(0, image.rows - plate.height));

  cv::rectangle(image, place, black, cv::FILLED);
  cv::putText(image, text,
              {place.x + margin, place.y + margin + letters.height}, font,
              scale, white, thick, cv::LINE_AA);
}

}  // namespace

Frame *frame(int slot) {
  // Never destroyed: at exit another thread may still use a frame.
  static Frames *const frames = new Frames;
  return slot >= 0 && slot < VISION_SLOTS ? &frames->slot[slot] : nullptr;
}

vision_status fail(vision_status status, const char *format, ...) {
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(reason, sizeof reason, format, arguments);
  va_end(arguments);
  for (char *next = reason; *next != '\0'; ++next)
    if (static_cast<unsigned char>(*next) < ' ')
      *next = ' ';  // one line of a log
  return status;
}

cv::Size fitting(const cv::Size &from, const cv::Size &limit) {
  const double share = std::min(double(limit.width) / from.width,
                                double(limit.height) / from.height);
  return {std::max(1, cvRound(from.width * share)),
          std::max(1, cvRound(from.height * share))};
}

void scale(cv::Mat &from, cv::Mat &to, const cv::Size &size) {
  if (size == from.size())
    std::swap(from, to);
  else
    cv::resize(from, to, size, 0, 0,
               size.area() < from.size().area() ? cv::INTER_AREA
                                                : cv::INTER_LINEAR);
}

bool make_pixels(Frame &here) {
  if (here.content != Frame::Content::jpeg)
    return true;
  static thread_local Kept unscaled;  // as decoded
  const cv::Size size = here.size();
  if (!decode(here.jpeg, size, unscaled))
    return false;
  const bool is_large = unscaled.size() != size;
  scale(unscaled, here.image, size);
  if (is_large)
    unscaled.release();  // an image of 4K is not kept
  here.content = Frame::Content::jpeg_and_pixels;
  return true;
}

bool sound(const vision_arena &arena) {
  return std::all_of(std::begin(arena.corner), std::end(arena.corner),
                     [](const vision_point &corner) { return sound(corner); });
}

}  // namespace vision

using namespace vision;

extern "C" {

vision_status vision_draw_arena(int slot, const vision_arena *arena) {
  return on_image(slot, [&](Frame &here) {
    if (arena == nullptr || !sound(*arena))
      return fail(VISION_BAD_ARGUMENT, "no arena to draw");
    const cv::Scalar green(0, 220, 0);
    for (int k = 0; k < 4; ++k)
      cv::line(here.image, fine(arena->corner[k]),
               fine(arena->corner[(k + 1) % 4]), green,
               thickness(here.image), cv::LINE_AA, shift);
    here.content = Frame::Content::pixels;
    return VISION_OK;
  });
}

vision_status vision_draw_robot(int slot, const vision_robot *robot) {
  return on_image(slot, [&](Frame &here) {
    if (robot == nullptr || !sound(robot->centre) || !sound(robot->direction))
      return fail(VISION_BAD_ARGUMENT, "no robot to draw");
    const cv::Scalar red(40, 40, 255);
    const int thick = thickness(here.image);
    const cv::Point2d centre(robot->centre.x, robot->centre.y);
    const cv::Point2d ahead(robot->direction.x - centre.x,
                            robot->direction.y - centre.y);

    // The arrow extends well beyond the direction point, to be visible outside
    // the marker.
    const vision_point tip{centre.x + 2.5 * ahead.x, centre.y + 2.5 * ahead.y};
    if (!sound(tip))
      return fail(VISION_BAD_ARGUMENT, "no robot to draw");
    cv::arrowedLine(here.image, fine(robot->centre), fine(tip),
                    red, thick, cv::LINE_AA, shift, 0.25);
    cv::circle(here.image, fine(robot->centre),
               (2 * thick) << shift, red, cv::FILLED, cv::LINE_AA,
               shift);

    draw_label(here.image, std::to_string(robot->id), centre,
                       {tip.x, tip.y}, std::hypot(ahead.x, ahead.y));
    here.content = Frame::Content::pixels;
    return VISION_OK;
  });
}

vision_status vision_encode(int slot, int quality, unsigned char *buffer,
                            int capacity, int *length) {
  if (length != nullptr)
    *length = 0;
  return on_frame(slot, [&](Frame &here) {
    if (length == nullptr || buffer == nullptr || capacity < 0 ||
        quality < 1 || quality > 100)
      return fail(VISION_BAD_ARGUMENT,
                  "cannot encode at quality %d into %d bytes", quality,
                  capacity);
    const cv::Size delivered(here.facts.width, here.facts.height);
    if (here.holds_jpeg() && here.size() == delivered &&
        here.facts.whole > 0 && here.facts.whole <= std::size_t(capacity)) {
      std::memcpy(buffer, here.jpeg.data, here.facts.whole);
      *length = int(here.facts.whole);
      return VISION_OK;
    }
    if (!make_pixels(here))
      return VISION_FAILED;
    return encode(here.image, quality, buffer, capacity, *length);
  });
}

const char *vision_reason(void) {
  return reason;
}

}  // extern "C"
