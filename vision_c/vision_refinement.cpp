// SPDX-License-Identifier: GPL-3.0-or-later
// Refinement: moves the sides of an outline onto image edges with sub-pixel
// precision.

#include "vision_search.hpp"

namespace vision {

namespace {

// A line in the image: the places at which line.dot (x, y, 1) is 0; the first
// two form a vector of length 1, which points outwards.
using Line = cv::Point3d;

// Finds the edge along a side of EXTENT pixels, in bands: profiles across the
// side are averaged over a band to reduce noise. An edge: x along the side, y
// outwards.
std::vector<Point> find_edges(const cv::Mat &grey, const Point &from,
                              const Point &along, const Point &outward,
                              double extent, const Side &side, double reach) {
  constexpr double step = 0.5;   // pixels, across the side
  constexpr int most = 64;       // steps to either side
  constexpr int around = 5;      // steps that one edge spreads over
  constexpr double slope = 6.0;  // grey levels a pixel that are an edge
  const double used = extent * (1 - 2 * side.end);
  const int half = std::min(int(reach / step), most);
  const int bands = std::min(std::max(int(used / 4.0), 7), 60);
  const int lines = std::min(std::max(int(used / bands + 0.5), 2), 8);
  const Point next = along * (used / bands / lines);
  std::array<float, 2 * most + 4> value;
  std::array<double, 2 * most + 1> rise{};
  std::vector<Point> edges;
  for (int band = 0; band < bands; ++band) {
    const double middle = extent * side.end + used * (band + 0.5) / bands;
    const Point first = from + along * middle - next * ((lines - 1) / 2.0);
    const Point last = first + next * (lines - 1);
    const Point across = outward * (half * step);
    if (!in_image(grey, first - across) || !in_image(grey, first + across) ||
        !in_image(grey, last - across) || !in_image(grey, last + across))
      continue;
    profile(grey, first - across, outward * step, 2 * half + 1, next, lines,
            value.data());
    for (int i = 1; i < 2 * half; ++i)
      rise[i] = side.rises * (value[i + 1] - value[i - 1]);
    const int best = int(std::max_element(rise.begin() + 1,
                                          rise.begin() + 2 * half) -
                         rise.begin());
    if (rise[best] < slope)
      continue;
    double weight = 0.0, moment = 0.0;
    for (int i = std::max(1, best - around);
         i <= std::min(2 * half - 1, best + around); ++i) {
      // Squared, to weight the pixels near the edge.
      const double share = rise[i] > 0.0 ? rise[i] * rise[i] : 0.0;
      weight += share;
      moment += share * i;
    }
    edges.push_back({middle, (moment / weight - half) * step});
  }
  return edges;
}

// Fits a line to the edges of the side FROM .. TO; the weight of outliers
// (such as a robot) is reduced. False if too few remain.
bool find_line(const cv::Mat &grey, const Point &from, const Point &to,
               const Side &side, double reach, Line &line) {
  constexpr double width = 0.7;  // pixels of distance that halve a weight
  const double extent = length(to - from);
  if (extent < 8.0)
    return false;
  const Point along = (to - from) / extent, outward(along.y, -along.x);
  const std::vector<Point> edges =
      find_edges(grey, from, along, outward, extent, side, reach);
  double offset = 0.0, slope = 0.0, total = 0.0;
  for (int round = 0; round < 12; ++round) {
    // At first all edges count, then increasingly the near ones.
    const double scale = round == 0 ? 1e6 : width * (1.0 + 8.0 / round);
    double w = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const Point &edge : edges) {
      const double away = edge.y - offset - slope * edge.x;
      const double share = 1.0 / (1.0 + away * away / (scale * scale));
      w += share;
      x += share * edge.x;
      y += share * edge.y;
      xx += share * edge.x * edge.x;
      xy += share * edge.x * edge.y;
    }
    const double spread = w * xx - x * x;
    if (edges.size() < 4 || spread < 1e-6 * w)
      return false;
    slope = (w * xy - x * y) / spread;
    offset = (y - slope * x) / w;
    total = w;
  }
  const Point normal = (outward - along * slope) / std::hypot(1.0, slope);
  line = {normal.x, normal.y, -normal.dot(from + outward * offset)};
  return total >= 0.4 * edges.size() && std::fabs(slope) <= 0.5;
}

}  // namespace

bool refine(const cv::Mat &grey, Point *corner, int count, const Side &side,
            double reach) {
  constexpr double enough = 0.25;  // pixels: the same edges again
  std::array<Line, 4> line;
  for (const double distance :
       {reach, std::max(std::min(reach, 3.0), reach / 2)}) {
    for (int k = 0; k < count; ++k)
      if (!find_line(grey, corner[k], corner[(k + 1) % count], side, distance,
                     line[k]))
        return false;
    double moved = 0.0;
    for (int k = 0; k < count; ++k) {
      const Line meet = line[(k + count - 1) % count].cross(line[k]);
      if (std::fabs(meet.z) < 0.05)  // the sine of their angle
        return false;
      const Point before = corner[k];
      corner[k] = Point(meet.x, meet.y) / meet.z;
      moved = std::max(moved, length(corner[k] - before));
    }
    if (moved < enough)
      break;
  }
  return true;
}

}  // namespace vision
