// SPDX-License-Identifier: GPL-3.0-or-later
// Refinement: moves the sides of an outline onto image edges with sub-pixel
// precision.

#include "vision_search.hpp"

namespace vision {

namespace {

struct Edge {
  double along, across;  // where on its side, and how far outside of it
};

// Finds the edge along the side FROM .. TO, in bands: profiles across the side
// are averaged over a band to reduce noise.
void find_edges(const cv::Mat &grey, const Point &from, const Point &to,
                Bright bright, double reach, double end,
                std::vector<Edge> &edges) {
  constexpr int most = 129;
  constexpr double step = 0.5;     // pixels, across the side
  constexpr int around = 5;        // steps that one edge spreads over
  constexpr double slope = 6.0;    // grey levels a pixel that are an edge
  constexpr int fewest_bands = 7, most_bands = 60;

  edges.clear();
  const double extent = length(to - from);
  const Point along = (to - from) / extent;
  const Point outward(along.y, -along.x);
  const int half = std::min(int(reach / step), most / 2);
  const double sign = bright == Bright::outside ? 1.0 : -1.0;
  const double used = extent * (1 - 2 * end);
  const int bands =
      std::min(std::max(int(used / 4.0), fewest_bands), most_bands);
  const int lines = std::min(std::max(int(used / bands + 0.5), 2), 8);
  std::array<float, most + 3> value;
  std::array<double, most> rise;

  for (int band = 0; band < bands; ++band) {
    const auto place = [&](double line) {
      return extent * end + used * (band + line / lines) / bands;
    };
    const Point first = from + along * place(0.5);
    const Point last = from + along * place(lines - 0.5);
    const Point across = outward * (half * step);
    if (!in_image(grey, first - across) || !in_image(grey, first + across) ||
        !in_image(grey, last - across) || !in_image(grey, last + across))
      continue;
    const Point next = along * (used / bands / lines);
    profile(grey, first - across, outward * step, 2 * half + 1, next, lines,
            value.data());
    int best = 1;
    for (int i = 1; i < 2 * half; ++i) {
      rise[i] = sign * (value[i + 1] - value[i - 1]);
      if (rise[i] > rise[best])
        best = i;
    }
    if (rise[best] < slope)
      continue;
    double weight = 0.0, moment = 0.0;
    for (int i = std::max(1, best - around);
         i <= std::min(2 * half - 1, best + around); ++i) {
      // Squared, to weight the pixels near the edge.
      const double share = std::max(0.0, rise[i]) * std::max(0.0, rise[i]);
      weight += share;
      moment += share * i;
    }
    edges.push_back({place(0.5 * lines), (moment / weight - half) * step});
  }
}

// Fits a line to the edges of one side; the weight of outliers (such as a
// robot) is reduced. False if too few remain.
bool fit_line(const std::vector<Edge> &edges, const Point &from,
              const Point &to, Line &line) {
  constexpr double width = 0.7;  // pixels of distance that halve a weight
  double offset = 0.0, slope = 0.0, total = 0.0;
  if (edges.size() < 4)
    return false;
  for (int round = 0; round < 12; ++round) {
    double w = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const Edge &edge : edges) {
      // At first all edges count, then increasingly the near ones.
      const double scale = round == 0 ? 1e6 : width * (1.0 + 8.0 / round);
      const double away = edge.across - offset - slope * edge.along;
      const double share = 1.0 / (1.0 + away * away / (scale * scale));
      w += share;
      x += share * edge.along;
      y += share * edge.across;
      xx += share * edge.along * edge.along;
      xy += share * edge.along * edge.across;
    }
    const double spread = xx - x * x / w;
    if (spread < 1e-6)
      return false;
    slope = (xy - x * y / w) / spread;
    offset = (y - slope * x) / w;
    total = w;
  }
  if (total < 0.4 * edges.size() || std::fabs(slope) > 0.5)
    return false;
  const Point along = (to - from) / length(to - from);
  const Point outward(along.y, -along.x);
  const Point direction = along + outward * slope;
  line = {from + outward * offset, direction / length(direction)};
  return true;
}

}  // namespace

bool refine(const cv::Mat &grey, Point *corner, int count, Bright bright,
            double reach, double end) {
  constexpr double enough = 0.25;  // pixels: the same edges again
  std::array<Line, 4> line;
  std::vector<Edge> edges;
  for (const double distance :
       {reach, std::max(std::min(reach, 3.0), reach / 2)}) {
    for (int k = 0; k < count; ++k) {
      const Point &from = corner[k], &to = corner[(k + 1) % count];
      if (length(to - from) < 8.0)
        return false;
      find_edges(grey, from, to, bright, distance, end, edges);
      if (!fit_line(edges, from, to, line[k]))
        return false;
    }
    double moved = 0.0;
    for (int k = 0; k < count; ++k) {
      const Point before = corner[k];
      if (!intersect(line[(k + count - 1) % count], line[k], corner[k]))
        return false;
      moved = std::max(moved, length(corner[k] - before));
    }
    if (moved < enough)
      break;
  }
  return true;
}

}  // namespace vision
