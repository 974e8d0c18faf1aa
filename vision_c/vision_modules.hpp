// SPDX-License-Identifier: GPL-3.0-or-later
// The modules of a marker: their grey levels, and the bits that these mean.

#ifndef VISION_MODULES_HPP
#define VISION_MODULES_HPP

#include "vision_search.hpp"

namespace vision {

// Grey levels of a marker's modules, or a property of theirs, 0 or 1: its own
// 6 x 6, including the black border, and those around it.
using Grid = cv::Matx<double, 8, 8>;

// The meaning of a marker's 16 bits, row by row.
struct Dictionary {
  Dictionary();

  std::vector<int> meaning;  // of all bits: four times the marker's ID, and by
                             // how many quarter turns clockwise it is rotated;
                             // -1: none
  std::vector<unsigned> words;  // those that have one: four of each ID
};

const Dictionary &dictionary();

struct Marker {
  Quad corner;
  int id = 0;
  double blur = 0.0;      // of the image, pixels; 0: not known
  double distance = 0.0;  // of its alignment: Fit.distance
};

// The side of a square with the area of QUAD.
inline double size_of(const Quad &quad) {
  return std::sqrt(std::fabs(cross(quad[2] - quad[0], quad[3] - quad[1])) /
                   2);
}

// The modules, each averaged over the centre of its area. CORNER: of the
// marker in GREY.
Grid read_modules(const cv::Mat &grey, const Quad &corner);

// Quick test with rough positions: a candidate is darker at its border than
// somewhere inside.
bool is_worth_it(const Grid &modules);

// Read the bits. By a single threshold, without the light that modules give
// each other, for even illumination; by the differences between modules
// nearby, for any illumination.
bool read_evenly(const Grid &modules, unsigned &bits);
bool read_unevenly(const Grid &modules, unsigned &bits);

// Aligns the whole pattern of a marker, given its BITS: more edges than the
// outline alone, so less noise and no bias from its inside. SPREAD: within how
// many modules the light hardly changes. False if the reading is uncertain.
bool align_marker(const cv::Mat &grey, unsigned bits, const Grid &modules,
                  bool perspective, double spread, Marker &marker);

}  // namespace vision

#endif
