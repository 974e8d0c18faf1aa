// SPDX-License-Identifier: GPL-3.0-or-later
// What is read and written of the synthetic arena by the tests alone.

#include "scene.h"

#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>

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

int scene_page(const char *path, int scale, unsigned char *bgr, int room,
               int *width, int *height) {
  try {
    std::ifstream file(path);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    cv::Mat page;
    double x, y, w, h, left = 0, top = 0, size = scale;
    int level = 0;
    for (const char *at = text.c_str(); *at != '\0'; ++at)
      if (*at == 'v' &&
          std::sscanf(at, "viewBox=\"%*f %*f %lf %lf", &w, &h) == 2) {
        *width = cvRound(scale * w);
        *height = cvRound(scale * h);
        if (*width * *height * 3 > room)
          return -1;
        page = cv::Mat(*height, *width, CV_8UC3, bgr);
      } else if (*at == 't' && std::sscanf(at, "translate(%lf %lf) scale(%lf",
                                           &x, &y, &size) == 3) {
        left = scale * x;
        top = scale * y;
        size *= scale;
      } else if (std::strncmp(at, "fill=\"none", 10) == 0) {
        at = std::strstr(at, "/>");
      } else if (std::strncmp(at, "fill=\"", 6) == 0) {
        level = std::strncmp(at, "fill=\"#fff", 10) == 0 ? 255 : 0;
      } else if (*at == 'M' && std::sscanf(at, "M%lf %lfh%lfv%lf", &x, &y, &w,
                                           &h) == 4) {
        page(cv::Rect(cv::Point2d(left + x * size, top + y * size),
                      cv::Point2d(left + (x + w) * size,
                                  top + (y + h) * size))) =
            cv::Scalar::all(level);
      }
    return page.empty() ? -1 : 0;
  } catch (...) {
    return -1;
  }
}

}  // extern "C"
