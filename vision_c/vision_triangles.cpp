// SPDX-License-Identifier: GPL-3.0-or-later
// The search for the platform's white triangles.

#include "vision_search.hpp"

namespace vision {

namespace {

// Orders three corners clockwise, the tip first. False if no corner is the
// tip.
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

// A drawing of the triangle on the platform's robots; its corners, and the
// pixels that are compared with the image.
struct Triangle {
  static constexpr double width = 40.0, height = 64.0, margin = 12.0;
  std::array<Point, 3> corner{
      Point(margin + width / 2, margin),
      Point(margin + width, margin + height), Point(margin, margin + height)};
  const cv::Size size{int(width + 2 * margin) + 1,
                      int(height + 2 * margin) + 1};
  cv::Mat_<float> shape = cv::Mat_<float>(size);
  cv::Mat_<uchar> used = cv::Mat_<uchar>(size);

  Triangle() {
    constexpr double near = 2.2;  // the robot's dark body is not much larger
    for (int y = 0; y < shape.rows; ++y)
      for (int x = 0; x < shape.cols; ++x) {
        const double inside = depth(Point(x, y), corner.data(), 3);
        shape(y, x) = float(std::min(std::max(inside + 0.5, 0.0), 1.0));
        used(y, x) = x % 2 == 1 && y % 2 == 1 && inside > -near;
      }
  }

  // Whether a camera tilted by at most 30 degrees can see it so: other white
  // objects have three corners, too. Its image is the drawing stretched; the
  // ratio of the stretches in any two directions is limited.
  bool is_seen_as(const std::array<Point, 3> &found) const {
    const double most = 1.0 / std::cos(CV_PI / 6.0);
    const Point across = (found[1] - found[2]) / width;
    const Point ahead = (found[0] - (found[1] + found[2]) / 2) / height;
    return across.dot(across) + ahead.dot(ahead) <=
           (most + 1.0 / most) * std::fabs(cross(across, ahead));
  }

  // Moves the corners to their best position in the image.
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

// The corners of a contour's triangle. False if it is none. (OpenCV's smallest
// enclosing triangle is sometimes far from the smallest.)
bool find_triangle(const std::vector<cv::Point> &contour,
                   std::array<Point, 3> &corner) {
  constexpr double rough = 0.1;  // of the perimeter
  static const Triangle drawn;
  std::vector<cv::Point> hull, polygon;
  cv::convexHull(contour, hull);
  cv::approxPolyDP(hull, polygon, rough * cv::arcLength(hull, true), true);
  if (polygon.size() != 3)
    return false;
  std::copy(polygon.begin(), polygon.end(), corner.begin());
  return order_triangle(corner) &&
         refine(scratch.smooth, corner.data(), 3, {-1.0, 0.15}, 4.0) &&
         order_triangle(corner) && drawn.align(corner) &&
         drawn.is_seen_as(corner);
}

constexpr int brighter = 12;  // grey levels, than what is around

struct Limits {
  double least, most;  // pixels of a triangle
};

// Adds the triangles among the objects in a mask of a part of the image, and
// those on top of them, such as on a body brighter than the floor. BELOW:
// remaining levels of such nesting.
void find_in(cv::Mat &mask, const cv::Point &origin, int below,
             const Limits &limits,
             std::vector<std::array<Point, 3>> &triangles) {
  constexpr double solid = 0.25;  // of its box: so all boxes together are not
                                  // larger than the part four times
  std::vector<std::vector<cv::Point>> contours, outline;
  std::vector<cv::Vec4i> next;  // next, previous, first hole, around
  cv::morphologyEx(mask, mask, cv::MORPH_OPEN,
                   cv::Mat());  // threads of noise that hang on a triangle
  cv::findContours(mask, contours, next, cv::RETR_CCOMP,
                   cv::CHAIN_APPROX_SIMPLE, origin);
  for (std::size_t k = 0; k < contours.size(); ++k) {
    double size = cv::contourArea(contours[k]);
    if (next[k][3] >= 0 || size < limits.least)
      continue;
    std::array<Point, 3> corner;
    if (size <= limits.most && find_triangle(contours[k], corner)) {
      triangles.push_back(corner);
      continue;
    }
    outline = {contours[k]};
    for (int hole = next[k][2]; hole >= 0; hole = next[hole][0]) {
      outline.push_back(contours[hole]);
      size -= cv::contourArea(contours[hole]);
    }
    const cv::Rect box = cv::boundingRect(contours[k]);
    if (below == 0 || size < 2 * limits.least || size < solid * box.area())
      continue;
    cv::Mat thing = cv::Mat::zeros(box.size(), CV_8UC1), bright;
    cv::fillPoly(thing, outline, 255, cv::LINE_8, 0, -box.tl());
    const cv::Mat part = scratch.smooth(box);
    cv::threshold(part, bright, cv::mean(part, thing)[0] + brighter, 255,
                  cv::THRESH_BINARY);
    cv::bitwise_and(thing, bright, thing);
    find_in(thing, box.tl(), below - 1, limits, triangles);
  }
}

}  // namespace

void find_triangles(const Search &search,
                    std::vector<vision_robot> &robots) {
  // The triangle has 20 cm2, the field is 80 cm wide; without an arena the
  // field may be narrower than assumed.
  const double area = 20.0 / (80.0 * 80.0) * search.width * search.width;
  const Limits limits{
      std::max(40.0, area * (search.bounded ? 0.4 : 0.08)), 2.5 * area};
  const int block = std::min(std::max(cvRound(0.05 * search.width), 7), 400);
  cv::adaptiveThreshold(scratch.smooth, scratch.mask, 255,
                        cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY,
                        2 * block + 1, -brighter);
  std::vector<std::array<Point, 3>> triangles;
  find_in(scratch.mask, cv::Point(), 2, limits, triangles);
  for (const std::array<Point, 3> &corner : triangles) {
    const Point centre = (corner[0] + corner[1] + corner[2]) / 3;
    if (in_field(search, centre))
      robots.push_back(make_robot(0, centre, corner[0], search));
  }
}

}  // namespace vision
