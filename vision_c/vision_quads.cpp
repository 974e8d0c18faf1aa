// SPDX-License-Identifier: GPL-3.0-or-later
// Candidates for markers: quadrilateral outlines of regions darker than their
// surroundings.

#include "vision_search.hpp"

namespace vision {

namespace {

constexpr int grain = 3;         // grey levels that noise seldom has
constexpr double crowded = 0.15; // of the pixels
constexpr double rough = 0.05;      // of the perimeter, what an outline may
                                    // differ from its polygon
constexpr double rough_hull = 0.03;  // the same of its convex hull
constexpr double opened = 1.6;       // times the hull's perimeter
constexpr int shortest_side = 7;    // pixels
constexpr int around = 7;           // pixels: a square around each dark one
constexpr int company = 9;          // has this many, or they are noise
constexpr std::size_t most = 4096;  // candidates: nobody has more robots

bool is_large_enough(const cv::Rect &box) {
  return std::min(box.width, box.height) >= shortest_side;
}

// The quadrilateral that approximates an outline. False if there is none.
bool find_polygon(const std::vector<cv::Point> &outline, double tolerance,
                  std::vector<cv::Point> &polygon) {
  cv::approxPolyDP(outline, polygon,
                   tolerance * cv::arcLength(outline, true), true);
  return polygon.size() == 4 && cv::isContourConvex(polygon);
}

}  // namespace

void find_quads(int darker, int scale, std::vector<Quad> &quads) {
  std::vector<std::vector<cv::Point>> contours;
  static thread_local std::vector<cv::Point> polygon, hull;
  cv::threshold(scratch.darker, scratch.mask, darker - 1, 255,
                cv::THRESH_BINARY);
  // A threshold this low mostly finds noise or grain.
  if (darker < grain &&
      cv::countNonZero(scratch.mask) > crowded * double(scratch.mask.total()))
    cv::threshold(scratch.darker, scratch.mask, grain - 1, 255,
                  cv::THRESH_BINARY);
  // Removes specks, whose outlines would take most of the search. The border
  // of the smallest marker has ten pixels in such a square at its corners.
  cv::blur(scratch.mask, scratch.near, cv::Size(around, around),
           cv::Point(-1, -1), cv::BORDER_REPLICATE);
  cv::threshold(scratch.near, scratch.near,
                255 * company / (around * around) - 1, 255,
                cv::THRESH_BINARY);
  cv::bitwise_and(scratch.mask, scratch.near, scratch.mask);
  cv::findContours(scratch.mask, contours, cv::RETR_LIST,
                   cv::CHAIN_APPROX_SIMPLE);
  for (const std::vector<cv::Point> &contour : contours) {
    if (quads.size() == most)
      break;
    if (contour.size() < 4 || !is_large_enough(cv::boundingRect(contour)))
      continue;
    // Skip inner outlines, which have the opposite orientation
    if (cv::contourArea(contour, true) > 0.0)
      continue;
    if (!find_polygon(contour, rough, polygon)) {
      // Something bright across a side opens a frame: the outline then also
      // follows its inside.
      cv::convexHull(contour, hull);
      if (cv::arcLength(contour, true) < opened * cv::arcLength(hull, true) ||
          !find_polygon(hull, rough_hull, polygon))
        continue;
    }
    // A contour joins pixel centres, half a pixel inside the edge.
    const Point middle = Point(polygon[0] + polygon[1] + polygon[2] +
                               polygon[3]) / 4;
    const double larger =
        1.0 + 1.0 / std::sqrt(std::max(1.0, cv::contourArea(polygon)));
    Quad quad;
    for (int k = 0; k < 4; ++k)
      quad[k] = (middle + (Point(polygon[k]) - middle) * larger +
                 Point(0.5, 0.5)) * scale - Point(0.5, 0.5);
    if (cross(quad[1] - quad[0], quad[2] - quad[1]) < 0.0)
      std::reverse(quad.begin(), quad.end());
    quads.push_back(quad);
  }
}

}  // namespace vision
