// SPDX-License-Identifier: GPL-3.0-or-later
/* What else finds markers and arenas: OpenCV's ArUco detector, and the
 * method of the platform's own software for the arena. */
#ifndef JUDGE_PEERS_HPP
#define JUDGE_PEERS_HPP

#include <opencv2/core.hpp>

#include <vector>

struct Finding {
  int id;
  cv::Point2d centre;
  double angle;  //  degrees, as vision.h says
};

//  OpenCV's detector of DICT_4X4_1000 with its default settings, corners
//  refined to sub-pixels
std::vector<Finding> opencv_markers(const cv::Mat &image);

//  What the platform's software does: a fixed threshold, edges, the first
//  large contour that four points describe, of which it keeps the box
bool platform_arena(const cv::Mat &image, cv::Rect &box);

//  The 6 x 6 modules of a marker, row by row, true: white
std::vector<bool> aruco_modules(int id);

#endif
