// SPDX-License-Identifier: GPL-3.0-or-later
/* The peers, with either interface of OpenCV's ArUco. */
#include "peers.hpp"

#include <opencv2/core/version.hpp>
#include <opencv2/imgproc.hpp>

#if CV_VERSION_MAJOR > 4 || (CV_VERSION_MAJOR == 4 && CV_VERSION_MINOR >= 7)
#define ARUCO_IN_OBJDETECT
#include <opencv2/objdetect/aruco_detector.hpp>
#else
#include <opencv2/aruco.hpp>
#endif

#include <cmath>

std::vector<Finding> opencv_markers(const cv::Mat &image) {
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
#ifdef ARUCO_IN_OBJDETECT
  cv::aruco::DetectorParameters settings;
  settings.cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
  const cv::aruco::ArucoDetector detector(
      cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_1000), settings);
  detector.detectMarkers(image, corners, ids);
#else
  const cv::Ptr<cv::aruco::DetectorParameters> settings =
      cv::aruco::DetectorParameters::create();
  settings->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
  cv::aruco::detectMarkers(
      image, cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_1000),
      corners, ids, settings);
#endif
  std::vector<Finding> findings;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const std::vector<cv::Point2f> &c = corners[i];
    const cv::Point2d centre = (c[0] + c[2]) / 2, ahead = (c[0] + c[1]) / 2;
    findings.push_back({ids[i], centre,
                        std::atan2(centre.y - ahead.y, centre.x - ahead.x) *
                            180 / M_PI});
  }
  return findings;
}

bool platform_arena(const cv::Mat &image, cv::Rect &box) {
  cv::Mat grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  cv::threshold(grey, grey, 128, 255, cv::THRESH_BINARY);
  cv::Canny(grey, grey, 100, 200);
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(grey, contours, cv::RETR_TREE, cv::CHAIN_APPROX_SIMPLE);
  //  Its 100,000 pixels are meant for the images it works on, 1024 x 768
  const double least = 100000.0 / (1024 * 768) * double(image.total());
  for (const std::vector<cv::Point> &contour : contours) {
    std::vector<cv::Point> outline;
    cv::approxPolyDP(contour, outline, 0.1 * cv::arcLength(contour, true),
                     true);
    if (outline.size() == 4 && std::abs(cv::contourArea(contour)) > least) {
      box = cv::boundingRect(contour);
      return true;
    }
  }
  return false;
}

std::vector<bool> aruco_modules(int id) {
  cv::Mat bits;
#ifdef ARUCO_IN_OBJDETECT
  cv::aruco::generateImageMarker(
      cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_1000), id, 6,
      bits, 1);
#else
  cv::aruco::drawMarker(
      cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_1000), id, 6,
      bits, 1);
#endif
  std::vector<bool> white;
  for (int i = 0; i < 36; ++i)
    white.push_back(bits.at<uchar>(i / 6, i % 6) > 127);
  return white;
}
