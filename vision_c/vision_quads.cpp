// SPDX-License-Identifier: GPL-3.0-or-later
// Candidates for markers: outlines of what is darker than what is around it,
// with four corners.

#include "vision_search.hpp"

#include <opencv2/imgproc.hpp>

namespace vision {

namespace {

constexpr int darker = 4;           // grey levels that are dark
constexpr double rough = 0.05;      // of the perimeter, what an outline may
                                    // differ from its polygon
constexpr int shortest_side = 7;    // pixels
constexpr std::size_t most = 4096;  // candidates: nobody has so many robots

bool is_large_enough(const cv::Rect &box) {
  return std::min(box.width, box.height) >= shortest_side;
}

}  // namespace

void find_quads(const cv::Mat &image, int window, int scale,
                std::vector<Quad> &quads) {
  static thread_local std::vector<std::vector<cv::Point>> contours;
  std::vector<cv::Point> polygon;
  cv::blur(image, scratch.darker, cv::Size(window, window),
           cv::Point(-1, -1), cv::BORDER_REPLICATE);
  cv::subtract(scratch.darker, image, scratch.darker);
  cv::threshold(scratch.darker, scratch.mask, darker - 1, 255,
                cv::THRESH_BINARY);
  cv::findContours(scratch.mask, contours, cv::RETR_LIST,
                   cv::CHAIN_APPROX_SIMPLE);
  for (const std::vector<cv::Point> &contour : contours) {
    if (quads.size() == most)
      break;
    if (contour.size() < 4 || !is_large_enough(cv::boundingRect(contour)))
      continue;
    cv::approxPolyDP(contour, polygon,
                     rough * cv::arcLength(contour, true), true);
    if (polygon.size() != 4 || !cv::isContourConvex(polygon))
      continue;
    // Not the inner outline, which turns the other way
    if (cv::contourArea(polygon, true) > 0.0)
      continue;
    Quad quad;
    for (int k = 0; k < 4; ++k)
      quad[k] = (Point(polygon[k]) + Point(0.5, 0.5)) * scale -
                Point(0.5, 0.5);
    std::reverse(quad.begin(), quad.end());
    quads.push_back(quad);
  }
}

}  // namespace vision
