// SPDX-License-Identifier: GPL-3.0-or-later
// What is read and written of the synthetic arena by the tests alone.

#include "scene.h"

#include <cstring>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

extern "C" {

int scene_decode_grey(const unsigned char *jpeg, int length, int width,
                      int height, unsigned char *grey) {
  try {
    if (jpeg == nullptr || grey == nullptr || length < 1)
      return -1;
    const cv::Mat bytes(1, length, CV_8UC1, const_cast<unsigned char *>(jpeg));
    const cv::Mat image = cv::imdecode(bytes, cv::IMREAD_GRAYSCALE);
    if (image.size() != cv::Size(width, height))
      return -1;
    std::memcpy(grey, image.data, image.total());
    return 0;
  } catch (...) {
    return -1;
  }
}

int scene_video(const scene_description *scene, int frames, int fps,
                const char *path) {
  try {
    if (scene == nullptr || frames < 1 || fps < 1 || path == nullptr)
      return -1;
    cv::VideoWriter writer(path, cv::CAP_OPENCV_MJPEG,
                           cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), fps,
                           cv::Size(scene->width, scene->height));
    if (!writer.isOpened())
      return -1;
    scene_description moving = *scene;
    cv::Mat image(scene->height, scene->width, CV_8UC3);
    for (int k = 0; k < frames; ++k) {
      if (scene_draw(&moving, image.data) != 0)
        return -1;
      writer.write(image);
      ++moving.seed;
    }
    return 0;
  } catch (...) {
    return -1;
  }
}

}  // extern "C"
