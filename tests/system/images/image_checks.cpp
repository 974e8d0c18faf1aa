// SPDX-License-Identifier: GPL-3.0-or-later
/* What a received image shows, and images for cameras that are files. C
 * interface for Images; no exception leaves it. */
#include <opencv2/core/version.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#if CV_VERSION_MAJOR > 4 || (CV_VERSION_MAJOR == 4 && CV_VERSION_MINOR >= 7)
#include <opencv2/objdetect/aruco_detector.hpp>
#else
#include <opencv2/aruco.hpp>
#endif

#include <algorithm>
#include <fstream>
#include <iterator>
#include <vector>

namespace {

int digit(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+') return 62;
  if (c == '/') return 63;
  return -1;
}

std::vector<unsigned char> bytes_of(const char *text, int length) {
  std::vector<unsigned char> bytes;
  unsigned bits = 0;
  int held = 0;
  for (int i = 0; i < length && text[i] != '='; ++i) {
    const int value = digit(text[i]);
    if (value < 0) return {};
    bits = (bits << 6) | static_cast<unsigned>(value);
    held += 6;
    if (held >= 8) {
      held -= 8;
      bytes.push_back(static_cast<unsigned char>(bits >> held));
    }
  }
  return bytes;
}

cv::Mat decoded(const char *text, int length) {
  const std::vector<unsigned char> bytes = bytes_of(text, length);
  if (bytes.empty()) return {};
  return cv::imdecode(bytes, cv::IMREAD_COLOR);
}

}  // namespace

extern "C" {

/* Whether base64 TEXT stands for exactly what the file at PATH has: 0 if. */
int image_is_file(const char *text, int length, const char *path) {
  try {
    std::ifstream file(path, std::ios::binary);
    const std::vector<unsigned char> held(
        (std::istreambuf_iterator<char>(file)),
        std::istreambuf_iterator<char>());
    return !held.empty() && held == bytes_of(text, length) ? 0 : 1;
  } catch (...) {
    return 1;
  }
}

/* Size of the image in base64 TEXT, and how many of its pixels are clearly
 * coloured: the arena and its robot are grey, what is drawn over them is
 * not. 0 if it is an image. */
int image_facts(const char *text, int length, int *width, int *height,
                int *coloured) {
  try {
    const cv::Mat image = decoded(text, length);
    if (image.empty()) return 1;
    *width = image.cols;
    *height = image.rows;
    *coloured = 0;
    for (int y = 0; y < image.rows; ++y)
      for (int x = 0; x < image.cols; ++x) {
        const cv::Vec3b p = image.at<cv::Vec3b>(y, x);
        const int most = std::max({p[0], p[1], p[2]});
        const int least = std::min({p[0], p[1], p[2]});
        if (most - least > 60) ++*coloured;
      }
    return 0;
  } catch (...) {
    return 2;
  }
}

/* The centre of the ArUco marker in the image. 0 if there is one. */
int image_marker(const char *text, int length, double *x, double *y) {
  try {
    const cv::Mat image = decoded(text, length);
    if (image.empty()) return 1;
    std::vector<std::vector<cv::Point2f>> corners;
    std::vector<int> ids;
    const auto dictionary =
        cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_1000);
#if CV_VERSION_MAJOR > 4 || (CV_VERSION_MAJOR == 4 && CV_VERSION_MINOR >= 7)
    cv::aruco::ArucoDetector(dictionary).detectMarkers(image, corners, ids);
#else
    cv::aruco::detectMarkers(image, dictionary, corners, ids);
#endif
    if (corners.empty()) return 1;
    *x = (corners[0][0].x + corners[0][2].x) / 2.0;
    *y = (corners[0][0].y + corners[0][2].y) / 2.0;
    return 0;
  } catch (...) {
    return 2;
  }
}

/* Writes an image to PATH that shows neither arena nor robot. 0 if done. */
int image_write_empty(const char *path) {
  try {
    cv::Mat image(480, 640, CV_8UC3, cv::Scalar::all(70));
    cv::randn(image, 70, 3);
    return cv::imwrite(path, image) ? 0 : 1;
  } catch (...) {
    return 2;
  }
}

/* Writes the image of the file FROM to TO as a camera's YUYV, without colour:
 * a byte of brightness for each pixel, and one that says grey. 0 if done. */
int image_write_yuyv(const char *from, const char *to) {
  try {
    const cv::Mat image = cv::imread(from, cv::IMREAD_GRAYSCALE);
    std::ofstream file(to, std::ios::binary);
    for (const unsigned char *p = image.datastart; p < image.dataend; ++p)
      file.put(static_cast<char>(*p)).put(static_cast<char>(128));
    return !image.empty() && file.flush() ? 0 : 1;
  } catch (...) {
    return 2;
  }
}

}
