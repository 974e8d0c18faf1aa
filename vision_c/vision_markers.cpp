// SPDX-License-Identifier: GPL-3.0-or-later
// The search for ArUco markers: quadrilateral outlines of regions darker than
// their surroundings are read, drawn and aligned.

#include "vision_modules.hpp"

namespace vision {

namespace {

constexpr int grain = 3;         // grey levels that noise seldom has
constexpr double crowded = 0.15; // of the pixels
constexpr double rough = 0.05;      // of the perimeter, what an outline may
                                    // differ from its polygon
constexpr double rough_hull = 0.03;  // the same of its convex hull
constexpr int shortest_side = 7;    // pixels
constexpr int around = 7;           // pixels: a square around each dark one
constexpr int company = 9;          // has this many, or they are noise
constexpr std::size_t most = 4096;  // candidates: nobody has more robots

// The quadrilateral that approximates an outline. False if there is none.
bool find_polygon(const std::vector<cv::Point> &outline, double tolerance,
                  std::vector<cv::Point> &polygon) {
  cv::approxPolyDP(outline, polygon,
                   tolerance * cv::arcLength(outline, true), true);
  return polygon.size() == 4 && cv::isContourConvex(polygon);
}

// Converts QUAD to an image reduced by SCALE, and back.
Quad reduced(const Quad &quad, double scale) {
  const Point half(0.5, 0.5);
  Quad result;
  for (int k = 0; k < 4; ++k)
    result[k] = (quad[k] + half) * (1 / scale) - half;
  return result;
}

// The outlines of quadrilaterals in an image reduced by SCALE, in pixels of
// the original: regions that are at least DARKER grey levels darker than
// their surroundings, by scratch.darker.
std::vector<Quad> find_quads(int darker, int scale) {
  std::vector<Quad> quads;
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
    // Inner outlines have the opposite orientation.
    const cv::Size size = cv::boundingRect(contour).size();
    if (std::min(size.width, size.height) < shortest_side ||
        cv::contourArea(contour, true) > 0.0)
      continue;
    if (!find_polygon(contour, rough, polygon)) {
      // Something bright across a side opens a frame: the outline then also
      // follows its inside.
      cv::convexHull(contour, hull);
      if (!find_polygon(hull, rough_hull, polygon))
        continue;
    }
    // A contour joins pixel centres, half a pixel inside the edge.
    const Point middle = Point(polygon[0] + polygon[1] + polygon[2] +
                               polygon[3]) / 4;
    const double larger =
        1.0 + 1.0 / std::sqrt(std::max(1.0, cv::contourArea(polygon)));
    Quad quad;
    for (int k = 0; k < 4; ++k)
      quad[k] = middle + (Point(polygon[k]) - middle) * larger;
    if (cross(quad[1] - quad[0], quad[2] - quad[1]) < 0.0)
      std::reverse(quad.begin(), quad.end());
    quads.push_back(reduced(quad, 1.0 / scale));
  }
  return quads;
}

Point centre_of(const Quad &quad) {
  return (quad[0] + quad[2]) / 2;
}

// Whether they share more than errors of their position make.
bool overlap(const Quad &one, const Quad &other) {
  constexpr double most = 0.1;  // of the smaller one
  const auto polygon = [](const Quad &quad) {
    return std::vector<cv::Point2f>(quad.begin(), quad.end());
  };
  cv::Mat common;
  const double smaller = std::min(size_of(one), size_of(other));
  return cv::intersectConvexConvex(polygon(one), polygon(other), common) >
         most * smaller * smaller;
}

constexpr Side outline{1.0, 0.12};  // black within white

// Whether it can be a marker's outline.
bool is_sound(const Quad &quad) {
  constexpr double smallest = 7.0;  // pixels
  std::array<double, 4> side;
  for (int k = 0; k < 4; ++k)
    side[k] = length(quad[(k + 1) % 4] - quad[k]);
  const auto [shortest, longest] =
      std::minmax_element(side.begin(), side.end());
  return *shortest >= smallest && *longest < 5.0 * *shortest;
}

// Pixels per side: pictograms in a box of 8 pixels were read as markers.
constexpr double least_size = 9.0;

// Reads the marker with its outline near MARKER.corner, which is set to its
// exact position, its own top left corner first. False if there is none.
bool find_marker(Marker &marker) {
  constexpr double most = 8.0;  // pixels of a module that are enough
  const double module = size_of(marker.corner) / 6;
  int level = 0;
  while (level + 1 < levels && module > most * (1 << level))
    ++level;
  const double scale = 1 << level;
  const cv::Mat &smooth = scratch.level[level];
  const cv::Mat &grey = module > 4.0 ? smooth : scratch.grey;
  const Quad rough = reduced(marker.corner, scale);
  if (!is_worth_it(read_modules(grey, rough)))
    return false;
  // Near edges only: those of something brighter may follow.
  Quad here = rough;
  if (!refine(smooth, here.data(), 4, outline,
              std::max(2.0, 0.45 * module / scale)))
    here = rough;
  const Grid seen = read_modules(grey, here);
  const std::vector<int> &meaning = dictionary().meaning;
  for (const auto bits_of : {read_evenly, read_unevenly}) {
    unsigned bits = 0;
    if (!bits_of(seen, bits) || meaning[bits] < 0)
      continue;
    constexpr double even = 4.0, uneven = 0.9;  // modules: shadows and glare
    Marker read = marker;
    read.corner = here;
    if (!align_marker(grey, bits, seen, module > 2.5, even, read) &&
        (module < 3.5 ||
         !align_marker(grey, bits, seen, true, uneven, read)))
      continue;
    Quad aligned = reduced(read.corner, 1 / scale);
    if (!is_sound(aligned) || size_of(aligned) < least_size)
      continue;
    marker = read;
    Quad &corner = marker.corner = aligned;
    // A cover on part of the outline is not near it now. The outline is more
    // precise in a sharp image; its errors are not those of the bits.
    if (module > 3.5 &&
        refine(scratch.smooth, aligned.data(), 4, outline,
               std::min(std::max(1.5, 0.25 * module), 4.0)))
      for (int n = 0; n < 4; ++n)
        corner[n] =
            read.blur < 1.2 ? aligned[n] : (corner[n] + aligned[n]) / 2;
    marker.id = meaning[bits] / 4;
    // Rotates the corners so that the first is the marker's top left.
    std::rotate(corner.begin(), corner.begin() + meaning[bits] % 4,
                corner.end());
    return true;
  }
  return false;
}

}  // namespace

void find_markers(Search &search, std::vector<vision_robot> &robots) {
  constexpr double enough = 14.0;  // pixels of a side that give an outline
  // A marker has several candidates: outlines, and thresholds.
  std::vector<Marker> found;
  // A marker cut off by the image border is not read.
  const cv::Rect2d whole(-0.5, -0.5, scratch.smooth.cols, scratch.smooth.rows);
  const auto is_cut = [&](const Quad &quad) {
    return !std::all_of(quad.begin(), quad.end(), [&](const Point &corner) {
      return whole.contains(corner);
    });
  };
  const auto is_known = [&](const Quad &quad) {
    return std::any_of(found.begin(), found.end(), [&](const Marker &known) {
      return depth(centre_of(quad), known.corner.data(), 4) > 0.0;
    });
  };
  const auto read = [&](const Quad &corner) {
    Marker marker{corner, 0, search.blur, 0.0};
    if (!is_sound(corner) || is_known(corner) || !find_marker(marker) ||
        is_cut(marker.corner))
      return;
    // Of markers that overlap, only the one that fits best is there.
    const auto first = std::partition(
        found.begin(), found.end(), [&](const Marker &other) {
          return !overlap(other.corner, marker.corner);
        });
    if (std::any_of(first, found.end(), [&](const Marker &other) {
          return other.distance <= marker.distance;
        }))
      return;
    found.erase(first, found.end());
    found.push_back(marker);
  };
  const auto is_in_field = [&](const Marker &marker) {
    return in_field(search, centre_of(marker.corner));
  };

  scratch.level[0] = scratch.smooth;
  for (int level = 1; level < levels; ++level) {
    const cv::Mat &finer = scratch.level[level - 1];
    const cv::Size half(finer.cols / 2, finer.rows / 2);
    cv::resize(finer(cv::Rect(cv::Point(), half * 2)), scratch.level[level],
               half, 0, 0, cv::INTER_AREA);
  }
  // A reduced image has less noise and needs less time, if the markers are
  // large enough in it.
  int coarsest = levels - 1;
  while (search.size > 0.0 && coarsest > 0 &&
         1.25 * search.size < enough * (1 << coarsest))
    --coarsest;
  // At the threshold for faint markers a border joins a dark field beyond a
  // thin margin: hence the last pass.
  bool is_enough = false;
  for (int pass = coarsest; pass >= -1 && !is_enough; --pass) {
    const int level = std::max(pass, 0);
    const cv::Mat &image = scratch.level[level];
    const int window = level == 0 ? 5 : 7;
    const int darker = pass > 0 ? 4 : pass == 0 ? 2 : 5;  // grey levels
    if (level > 0 && std::min(image.cols, image.rows) < enough + window)
      continue;
    if (pass >= 0) {
      cv::blur(image, scratch.darker, cv::Size(window, window),
               cv::Point(-1, -1), cv::BORDER_REPLICATE);
      cv::subtract(scratch.darker, image, scratch.darker);
    }
    for (const Quad &corner : find_quads(darker, 1 << level))
      if (level == 0 || size_of(corner) >= enough * (1 << level))
        read(corner);
    is_enough = search.known > 0 &&
                std::count_if(found.begin(), found.end(), is_in_field) >=
                    search.known;
  }
  for (const Marker &marker : found) {
    search.found_blur = marker.blur;
    if (is_in_field(marker))
      robots.push_back(make_robot(
          marker.id, centre_of(marker.corner),
          (marker.corner[0] + marker.corner[1]) / 2, search));
  }
}

}  // namespace vision
