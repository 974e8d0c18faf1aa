// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by the searches: geometry, interpolated grey levels, refinement of
// outlines, alignment of drawn shapes with the image.

#ifndef VISION_SEARCH_HPP
#define VISION_SEARCH_HPP

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "vision_internal.hpp"

namespace vision {

using Point = cv::Point2d;

// Number of image sizes, each half of the one before, in the search for
// markers.
constexpr int levels = 4;

// Temporary images of a search.
struct Scratch {
  cv::Mat grey, smooth, small, gradient, gradient_down, mask, tiles, darker,
      near;
  std::array<cv::Mat, levels> level;  // the first is smooth itself
};

extern thread_local Scratch scratch;

// ---------------------------------------------------------------- Geometry

inline double cross(const Point &a, const Point &b) {
  return a.x * b.y - a.y * b.x;
}

inline double length(const Point &a) {
  return std::sqrt(a.dot(a));
}

// A projective map between two planes.
using Map = cv::Matx33d;

inline Point apply(const Map &map, const Point &p) {
  double w = map(2, 0) * p.x + map(2, 1) * p.y + map(2, 2);
  if (std::fabs(w) < 1e-9)
    w = 1e-9;  // on the horizon: as good as nowhere
  w = 1.0 / w;
  return {(map(0, 0) * p.x + map(0, 1) * p.y + map(0, 2)) * w,
          (map(1, 0) * p.x + map(1, 1) * p.y + map(1, 2)) * w};
}

using Quad = std::array<Point, 4>;  // clockwise as the image shows it

// The map from the corners FROM to the corners TO.
inline Map map_of(const Quad &from, const Quad &to) {
  std::array<cv::Point2f, 4> first, second;
  std::copy(from.begin(), from.end(), first.begin());
  std::copy(to.begin(), to.end(), second.begin());
  return cv::getPerspectiveTransform(first.data(), second.data());
}

// Distance of POINT inside a convex polygon, which is clockwise in the image;
// negative outside.
inline double depth(const Point &point, const Point *corner, int count) {
  double least = 1e9;
  for (int k = 0; k < count; ++k) {
    const Point side = corner[(k + 1) % count] - corner[k];
    least = std::min(least, cross(side, point - corner[k]) /
                                std::max(1e-9, length(side)));
  }
  return least;
}

// Four at a time: all processors in question have such vectors.
typedef float Four __attribute__((vector_size(16)));
typedef int Four_Places __attribute__((vector_size(16)));

inline Four load(const float *from) {
  Four four;
  std::memcpy(&four, from, sizeof four);
  return four;
}

inline void store(const Four &four, float *to) {
  std::memcpy(to, &four, sizeof four);
}

// AT, limited to 0 .. LAST; NaN, from far behind the camera, becomes 0.
inline Four within(const Four &at, float last) {
  const Four zero{}, most = zero + last;
  const Four low = at > zero ? at : zero;
  return low < most ? low : most;
}

// Interpolates between pixels; outside the image, the nearest border pixel.
inline Four sample(const cv::Mat &grey, const Four &x, const Four &y) {
  const Four right = within(x, float(grey.cols - 1));
  const Four down = within(y, float(grey.rows - 1));
  const Four_Places column = __builtin_convertvector(
      within(right, float(grey.cols - 2)), Four_Places);
  const Four_Places row = __builtin_convertvector(
      within(down, float(grey.rows - 2)), Four_Places);
  const std::size_t step = grey.step.p[0];
  Four_Places a, b, c, d;
  for (int k = 0; k < 4; ++k) {
    const uchar *const above = grey.data + row[k] * step + column[k];
    a[k] = above[0];
    b[k] = above[1];
    c[k] = above[step];
    d[k] = above[step + 1];
  }
  const Four u = right - __builtin_convertvector(column, Four);
  const Four v = down - __builtin_convertvector(row, Four);
  const Four upper = __builtin_convertvector(a, Four) +
                     u * __builtin_convertvector(b - a, Four);
  const Four lower = __builtin_convertvector(c, Four) +
                     u * __builtin_convertvector(d - c, Four);
  return upper + v * (lower - upper);
}

// Applies MAP to four points.
inline void move(const cv::Matx33f &map, Four &x, Four &y) {
  const Four w = 1.0f / (map(2, 0) * x + map(2, 1) * y + map(2, 2));
  const Four right = (map(0, 0) * x + map(0, 1) * y + map(0, 2)) * w;
  y = (map(1, 0) * x + map(1, 1) * y + map(1, 2)) * w;
  x = right;
}

// The grey level at COUNT places, spaced by ACROSS: each the mean of LINES
// samples, spaced by ALONG. VALUE has room for a multiple of four.
inline void profile(const cv::Mat &grey, const Point &first,
                    const Point &across, int count, const Point &along,
                    int lines, float *value) {
  for (int i = 0; i < count; i += 4) {
    const Four place = Four{0, 1, 2, 3} + float(i);
    Four x = float(first.x) + place * float(across.x);
    Four y = float(first.y) + place * float(across.y);
    Four sum{};
    for (int line = 0; line < lines; ++line) {
      sum += sample(grey, x, y);
      x += float(along.x);
      y += float(along.y);
    }
    store(sum / float(lines), value + i);
  }
}

inline bool in_image(const cv::Mat &grey, const Point &at) {
  return at.x >= 0 && at.y >= 0 && at.x <= grey.cols - 1 &&
         at.y <= grey.rows - 1;
}

// ------------------------------------------------- Refinement and alignment

// A side of an outline.
struct Side {
  double rises;  // outwards the image gets brighter (1) or darker (-1)
  double end;    // share of it that is left out at each end
};

// Moves the corners of a convex polygon, clockwise in the image, so that its
// sides lie on image edges at most REACH pixels away. False if a side has no
// edge.
bool refine(const cv::Mat &grey, Point *corner, int count, const Side &side,
            double reach);

// Position of a drawn shape in the image.
struct Fit {
  Map map;                // from the pixels of the shape to those of the image
  double spread = 0.0;    // of the image's blur, pixels of the shape
  double offset = 0.0, contrast = 0.0;  // grey levels of the shape's 0, 0 to 1
  double distance = 0.0;  // what remains, as a share of the contrast
  cv::Mat rest;  // the same of each pixel of the shape, if it was compared
};

// Adjusts FIT.map so that SHAPE (float, sharp; about 0 to 1) fits the image
// best, comparing the pixels that are not 0 in USED, and sets the rest of
// FIT. The image blur is estimated from the residual of a first attempt,
// starting with FIT.spread if known, and refined until the fit is good or no
// longer improves. False if the residual exceeds WORST.
bool align(const cv::Mat &grey, const cv::Mat &shape, const cv::Mat &used,
           bool perspective, double worst, Fit &fit);

// ------------------------------------------------------------------ Robots

// The part of the image to search, and the parameters.
struct Search {
  cv::Rect box;
  bool bounded = false;        // by the arena
  std::array<Point, 4> field;
  double slack = 0.0;  // pixels that a centre may lie outside the field
  double width = 0.0;  // of the field, pixels
  int known = 0;  // robots that are enough; 0: all that are here
  double size = 0.0;  // of their markers' sides, about; pixels
  double blur = 0.0;  // of the image in which a marker was read last, in its
                      // pixels; 0: not known
  double found_blur = 0.0;  // and of those that this search reads
};

bool in_field(const Search &search, const Point &centre);

vision_robot make_robot(int id, const Point &centre, const Point &direction,
                        const Search &search);

// The 16 bits of a marker that stands upright, row by row; 1 is white.
unsigned marker_bits(int id);

// Add what is found in the smoothed image of that part.
void find_markers(Search &search, std::vector<vision_robot> &robots);
void find_triangles(const Search &search, std::vector<vision_robot> &robots);

}  // namespace vision

#endif
