// SPDX-License-Identifier: GPL-3.0-or-later
// The modules of a marker: their grey levels, the bits that these mean, and
// the light on them.

#ifndef VISION_MODULES_HPP
#define VISION_MODULES_HPP

#include "vision_search.hpp"

namespace vision {

// Grey levels of a marker's modules, or a property of theirs, 0 or 1: its own
// 6 x 6, including the black border, and those around it.
using Grid = cv::Matx<double, 8, 8>;

inline int ring_of(int row, int column) {
  return std::min(std::min(row, column), std::min(7 - row, 7 - column));
}

inline int bit_of(int row, int column) {
  return 4 * (row - 2) + column - 2;
}

inline bool is_white(unsigned bits, int row, int column) {
  const int ring = ring_of(row, column);
  return ring == 0 || (ring > 1 && (bits >> bit_of(row, column) & 1u));
}

// The marker in module coordinates, from its top left corner.
const Quad six_by_six{Point(0, 0), Point(6, 0), Point(6, 6), Point(0, 6)};

constexpr double least_contrast = 10.0;  // grey levels

// The meaning of a marker's bits.
class Dictionary {
public:
  Dictionary();

  bool knows(unsigned bits) const { return meaning[bits] >= 0; }

  // Decodes 16 bits, row by row: the marker's ID, and by how many quarter
  // turns clockwise it is rotated.
  int id(unsigned bits) const { return meaning[bits] / 4; }
  int turns(unsigned bits) const { return meaning[bits] % 4; }

  // All valid words, in each rotation: four of each ID.
  const std::vector<unsigned> &words() const { return known; }

private:
  std::vector<int> meaning = std::vector<int>(1 << 16, -1);
  std::vector<unsigned> known;
};

const Dictionary &dictionary();

// Whether the border is black, except for one place that may be covered:
// otherwise it is no marker.
bool is_border(const Grid &black);

// The modules, each averaged over the centre of its area. MAP: from the
// marker's modules to GREY; MODULE: the side of one, in pixels.
Grid read_modules(const cv::Mat &grey, const Map &map, double module);

// Read the bits. By a single threshold, for even illumination; the same
// without the light that modules give each other; by the differences between
// modules nearby, for any illumination.
bool read_evenly(const Grid &modules, unsigned &bits);
bool read_unmixed(const Grid &modules, unsigned &bits);
bool read_unevenly(const Grid &modules, unsigned &bits);

// Levels of black and white at each module.
struct Levels {
  Grid black, white;
};

// For nearly even illumination: means over a wide neighbourhood of the modules
// that are SEEN. BRIGHT: those that are white.
Levels light_far(const Grid &bright, const Grid &modules, const Grid &seen,
                 double black, double white);

// For uneven illumination: black is interpolated from adjacent modules as if
// they were black. The contrast to white varies more slowly.
Levels light_near(const Grid &bright, const Grid &modules, const Grid &seen,
                  double black, double white);

// Of the quiet zone beside a side: its width, in modules, one at most; the
// grey level beyond it.
struct Margin {
  double width, beyond;
};

// MAP: from the marker's modules to GREY; WHITE: the mean level of its white
// ones. A thin margin's light is measured: blurred, it has no profile.
std::array<Margin, 4> margins(const cv::Mat &grey, const Map &map,
                              double white);

// Whether a part of the marker is saturated, but its quiet zone is not.
bool has_spot(const Grid &modules);

}  // namespace vision

#endif
