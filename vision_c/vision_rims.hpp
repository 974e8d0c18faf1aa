// SPDX-License-Identifier: GPL-3.0-or-later
// The outline of the arena's field with lens distortion: candidates, their
// adjustment to the edges of an image, and the test whether it is an arena.

#ifndef VISION_RIMS_HPP
#define VISION_RIMS_HPP

#include "vision_search.hpp"

namespace vision {

// Undistorted points have their origin in the image centre; their unit is half
// of the longest image side; straight lines remain straight. Division model of
// radial distortion: an undistorted point is its image / (1 + BEND * square of
// its distance from the centre).
inline Point distort(const Point &straight, double bend) {
  const double inner = 1.0 - 4.0 * bend * straight.dot(straight);
  return straight * (2.0 / (1.0 + std::sqrt(std::max(inner, 1e-2))));
}

// Converts between image pixels and points in units of half the longest side.
struct View {
  Point middle;
  double unit;

  explicit View(const cv::Mat &image)
      : middle((image.cols - 1) / 2.0, (image.rows - 1) / 2.0),
        unit(std::max(image.cols, image.rows) / 2.0) {}

  Point pixel(const Point &shown) const { return middle + unit * shown; }
};

// Clockwise in the image, beginning with the top side: the one closest to
// horizontal.
struct Outline {
  std::array<Point, 4> corner;  // undistorted
  double bend = 0.0;

  Point shown(int k) const { return distort(corner[k], bend); }
};

// Beside the border: the level of the field and the contrast of the border,
// grey levels that vary linearly as illumination does; factors of 1, x and y.
using Light = cv::Matx32d;

// Measurements of an image along an outline.
struct Evidence {
  double moved = 0.0;     // pixels that a corner came to lie elsewhere
  double support = 0.0;   // share of what can be seen that has an edge on it
  double weakest = 0.0;   // the same of the side that has the least
  double alike = 0.0;     // share of the edges whose contrast is the usual one
  std::array<Light, 2> light;  // where the border is not clipped, and where it
                               // is; the same unless the sun shines on a part
  double usual = 0.0;     // contrast
};

constexpr int small_side = 320;  // pixels, of the image searched

struct Candidate {
  Outline outline;
  double score = 0.0;
};

using Candidates = std::vector<Candidate>;  // best first

// Adds an outline if it is among the best, and better than one at its place.
void add(Candidates &found, const Candidate &wanted);

// Outlines by lines of the small image, each with the lens distortion that
// suits it best; NOISE: the standard deviation of a pixel.
Candidates find_candidates(const cv::Mat &small, double &noise);

// Sampling density along an outline.
struct Pace {
  int bands;    // of a side, at most: an edge each
  int lines;    // of a band, at most: its profile is their mean
  bool light;  // is measured, too
};

constexpr Pace quick{16, 3, false}, normal{24, 4, false},
    thorough{48, 8, true};

// Moves OUTLINE onto edges that get brighter outwards, at most REACH pixels
// away; NOISE is the standard deviation of a pixel. False if a side has no
// edge.
bool settle(const cv::Mat &grey, Outline &outline, double reach, double noise,
            const Pace &pace, Evidence &evidence);

// The share of the field that is as dark as next to its border, or darker, and
// the share that is neither darker nor brighter.
void look_inside(const cv::Mat &grey, const Outline &outline,
                 const Evidence &evidence, double &dark, double &plain);

// At how many of the eight ends of the sides an edge continues beyond the
// corner, as between tiles or window panes.
int ends_continued(const cv::Mat &small, const Outline &outline,
                   double noise);

// Whether OUTLINE can be the image of a 4:3 rectangle, in either orientation,
// within the tilt of an arena's camera, for any focal length.
bool is_field(const Outline &outline, double tolerance);

}  // namespace vision

#endif
