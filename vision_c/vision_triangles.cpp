// SPDX-License-Identifier: GPL-3.0-or-later
// The search for the platform's white triangles.

#include "vision_search.hpp"

#include <opencv2/imgproc.hpp>

namespace vision {

namespace {

// Turns three corners so that the first is the tip, and puts them clockwise.
// False where no corner stands out.
bool order_triangle(std::array<Point, 3> &corner) {
  if (cross(corner[1] - corner[0], corner[2] - corner[0]) < 0)
    std::swap(corner[1], corner[2]);
  std::array<double, 3> opposite;
  for (int k = 0; k < 3; ++k)
    opposite[k] = length(corner[(k + 1) % 3] - corner[(k + 2) % 3]);
  const int tip = int(std::min_element(opposite.begin(), opposite.end()) -
                      opposite.begin());
  std::rotate(corner.begin(), corner.begin() + tip, corner.end());
  const double base = opposite[tip];
  const double right = opposite[(tip + 1) % 3], left = opposite[(tip + 2) % 3];
  return std::fabs(left - right) < 0.2 * std::max(left, right) &&
         base < 0.9 * std::min(left, right) && base > 0.25 * left;
}

// Whether three corners, the tip first, have the proportions of that triangle
// as a camera sees it that looks down up to 30 degrees aslant: other white
// things have three corners, too.
bool has_proportions(const std::array<Point, 3> &corner) {
  const double base = length(corner[2] - corner[1]);
  const double right = length(corner[1] - corner[0]);
  const double left = length(corner[2] - corner[0]);
  const double side = (left + right) / 2;
  return std::fabs(left - right) < 0.12 * side && base > 0.51 * side &&
         base < 0.7 * side;
}

// A triangle as the platform's robots carry it, drawn; where its corners
// are, and what of the drawing is compared with the image.
struct Triangle {
  static constexpr double width = 40.0, height = 64.0, margin = 12.0;
  cv::Mat shape, used;
  std::array<Point, 3> corner{
      Point(margin + width / 2, margin),
      Point(margin + width, margin + height), Point(margin, margin + height)};

  Triangle() {
    constexpr int fine = 4;
    const cv::Size size(int(width + 2 * margin) + 1,
                        int(height + 2 * margin) + 1);
    cv::Mat large(size * fine, CV_8UC1);
    for (int y = 0; y < large.rows; ++y)
      for (int x = 0; x < large.cols; ++x)
        large.at<uchar>(y, x) =
            depth(Point((x + 0.5) / fine - 0.5, (y + 0.5) / fine - 0.5),
                  corner.data(), 3) > 0.0 ? 255 : 0;
    cv::resize(large, shape, size, 0, 0, cv::INTER_AREA);
    shape.convertTo(shape, CV_32F, 1.0 / 255.0);

    // Only near it: the robot's dark body does not reach far.
    const Point middle = (corner[0] + corner[1] + corner[2]) / 3;
    std::array<Point, 3> wider;
    for (int k = 0; k < 3; ++k)
      wider[k] = middle + (corner[k] - middle) * 1.15;
    used.create(size, CV_8UC1);
    used.setTo(0);
    for (int y = 1; y < used.rows; y += 2)
      for (int x = 1; x < used.cols; x += 2)
        used.at<uchar>(y, x) =
            depth(Point(x, y), wider.data(), 3) > 0.0 ? 255 : 0;
  }

  // Moves the corners of one in the image to where it lies best.
  bool align(std::array<Point, 3> &found) const {
    const Point other = corner[1] + corner[2] - corner[0];
    const Point last = found[1] + found[2] - found[0];
    Fit fit;
    fit.map = map_of({corner[0], corner[1], other, corner[2]},
                     {found[0], found[1], last, found[2]});
    if (!vision::align(scratch.smooth, shape, used, false, 0.15, fit))
      return false;
    for (int k = 0; k < 3; ++k)
      found[k] = apply(fit.map, corner[k]);
    return true;
  }
};

// The corners of a contour which is a triangle but for its roughness: those
// of the largest triangle within. (OpenCV's smallest triangle around it is
// sometimes far from the smallest.)
bool find_corners(const std::vector<cv::Point> &contour,
                  std::array<Point, 3> &corner) {
  std::vector<cv::Point> hull;
  cv::convexHull(contour, hull);
  const std::size_t count = hull.size();
  if (count < 3 || count > 80)
    return false;
  int largest = 0;  // twice the area
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      for (std::size_t k = j + 1; k < count; ++k) {
        const int twice =
            std::abs((hull[j] - hull[i]).cross(hull[k] - hull[i]));
        if (twice > largest) {
          largest = twice;
          corner = {Point(hull[i]), Point(hull[j]), Point(hull[k])};
        }
      }
  return cv::contourArea(hull) < 1.6 * (largest / 2.0);
}

}  // namespace

void find_triangles(const Search &search,
                    std::vector<vision_robot> &robots) {
  static const Triangle drawn;
  // The triangle is 20 cm2, the field 80 cm wide; without an arena the field
  // may be narrower than is assumed.
  const double area = 20.0 / (80.0 * 80.0) * search.width * search.width;
  const double least = std::max(40.0, area * (search.bounded ? 0.4 : 0.08));
  const double most = 2.5 * area;
  const int block = std::min(std::max(cvRound(0.05 * search.width), 7), 400);
  cv::adaptiveThreshold(scratch.smooth, scratch.mask, 255,
                        cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY,
                        2 * block + 1, -12);
  cv::morphologyEx(scratch.mask, scratch.mask, cv::MORPH_OPEN,
                   cv::Mat());  // threads of noise that hang on a triangle
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(scratch.mask, contours, cv::RETR_LIST,
                   cv::CHAIN_APPROX_SIMPLE);
  for (const std::vector<cv::Point> &contour : contours) {
    const double size = cv::contourArea(contour);
    if (size < least || size > most)
      continue;
    std::array<Point, 3> corner;
    if (!find_corners(contour, corner))
      continue;
    if (!order_triangle(corner) ||
        !refine(scratch.smooth, corner.data(), 3, Bright::inside, 4.0, 0.15) ||
        !order_triangle(corner) || !drawn.align(corner) ||
        !has_proportions(corner))
      continue;
    const Point centre = (corner[0] + corner[1] + corner[2]) / 3;
    if (in_field(search, centre))
      robots.push_back(make_robot(0, centre, corner[0], search));
  }
}

}  // namespace vision
