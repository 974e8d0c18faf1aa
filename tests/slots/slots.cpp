// SPDX-License-Identifier: GPL-3.0-or-later
// The frame slots of vision_c, for the tests.

#include "slots.h"
#include "vision_internal.hpp"

using vision::Frame;

extern "C" {

void slot_load(int slot, const unsigned char *bgr, int width, int height) {
  Frame &frame = *vision::frame(slot);
  cv::Mat(height, width, CV_8UC3, const_cast<unsigned char *>(bgr))
      .copyTo(frame.image);
  frame.content = Frame::Content::pixels;
}

vision_status slot_load_jpeg(int slot, const unsigned char *jpeg, int length,
                             int width, int height) {
  const cv::Mat bytes(1, length, CV_8UC1, const_cast<unsigned char *>(jpeg));
  vision::Jpeg_Facts facts;
  if (!vision::examine(bytes, facts))
    return VISION_NO_IMAGE;
  Frame &frame = *vision::frame(slot);
  bytes.copyTo(frame.jpeg);
  frame.facts = facts;
  frame.limit = {width, height};
  frame.content = Frame::Content::jpeg;
  return VISION_OK;
}

void slot_size(int slot, int *width, int *height) {
  const cv::Size size = vision::frame(slot)->size();
  *width = size.width;
  *height = size.height;
}

}  // extern "C"
