// SPDX-License-Identifier: GPL-3.0-or-later
// The outline of the arena's field: moved onto edges with sub-pixel precision,
// all four sides and the lens distortion together.

#include "vision_rims.hpp"

namespace vision {

namespace {

constexpr int unknowns = 9;      // two a corner, and the lens
constexpr int finest = 48;  // bands of a side, one edge each
constexpr double clipped = 250.0;  // grey level, noise aside
constexpr int fewest_clipped = 6;  // edges: the least for a plane of light
constexpr double least_bend = -0.4, most_bend = 0.1;

using Vector = cv::Vec<double, unknowns>;
using Matrix = cv::Matx<double, unknowns, unknowns>;

// An image edge near a side. PULL: the derivatives of its distance with
// respect to the side's two corners (x, y each) and the distortion.
struct Edge {
  int side = 0;
  double part = 0.0;      // of the side before it
  double away = 0.0;      // pixels outside of the outline
  double contrast = 0.0;  // grey levels
  double inside = 0.0;    // grey level of the field
  bool clipped = false;   // the border is as bright as the image gets
  std::array<double, 5> pull;
  std::array<int, 5> unknown;  // of each

  double rest(const Vector &change) const {
    double sum = away;
    for (int n = 0; n < 5; ++n)
      sum -= pull[n] * change[unknown[n]];
    return sum;
  }
};

struct Edges {
  std::array<Edge, 4 * finest> edge;
  std::array<int, 4> seen{}, found{};  // bands of a side in the image, edges
  int count = 0;
};

// A point of a side in the image, and its derivatives.
struct Place {
  Point pixel, along, outward;
  std::array<double, 5> pull;
};

Place place_on(const Outline &outline, const View &view, int side,
               double part) {
  const Point &from = outline.corner[side];
  const Point &to = outline.corner[(side + 1) % 4];
  const Point u = from + part * (to - from);
  const double square = u.dot(u);
  const double root =
      std::sqrt(std::max(1.0 - 4.0 * outline.bend * square, 1e-2));
  const double factor = 2.0 / (1.0 + root);
  const double bending = factor * factor / root;
  // The derivative of the distortion at U, which is symmetric.
  const auto turned = [&](const Point &by) {
    return view.unit *
           (factor * by + 2.0 * outline.bend * bending * u.dot(by) * u);
  };
  Place place;
  place.pixel = view.pixel(factor * u);
  place.along = turned(to - from);
  place.along /= std::max(1e-9, length(place.along));
  place.outward = Point(place.along.y, -place.along.x);
  const Point pull = turned(place.outward);
  place.pull = {(1 - part) * pull.x, (1 - part) * pull.y, part * pull.x,
                part * pull.y,
                view.unit * place.outward.dot(u) * square * bending};
  return place;
}

// Finds the edges along the outline, in bands: profiles across a side are
// averaged over a band to reduce noise. Of several edges it takes the
// innermost one that is not much weaker than the strongest: the ground outside
// the border may be brighter still.
void find_edges(const cv::Mat &grey, const Outline &outline, double reach,
                double noise, double contrast, const Pace &pace,
                Edges &edges) {
  constexpr int most_steps = 14;  // to either side
  constexpr int beside = 6;       // steps beyond them that the profile has
  constexpr double end = 0.02;    // share of a side left out at its ends
  constexpr double weaker = 0.4;
  const View view(grey);
  const double step = std::max(reach / most_steps, 0.5);
  const int half = std::min(int(std::ceil(reach / step)), most_steps);
  const int middle = half + beside;
  std::array<float, 2 * (most_steps + beside) + 4> value, rise;

  edges.count = 0;
  for (int side = 0; side < 4; ++side) {
    const double extent =
        view.unit * length(outline.shown((side + 1) % 4) -
                           outline.shown(side));
    const int bands =
        std::min(std::max(int(extent / 5.0), 12),
                               std::min(pace.bands, finest));
    const double band_length = extent * (1 - 2 * end) / bands;
    const int lines =
        std::min(std::max(int(band_length + 0.5), 1), pace.lines);
    // A gradient is the difference of two sums of this many samples; samples
    // half a pixel apart have correlated noise.
    const int width = std::min(
        std::max(cvRound(2.0 + 12.0 * noise / contrast), 2), beside - 1);
    const float slope = float(
        std::max(2.0 * width, 2.5 * noise * std::sqrt(2.8 * width / lines)));
    edges.seen[side] = edges.found[side] = 0;
    for (int band = 0; band < bands; ++band) {
      Edge &edge = edges.edge[edges.count];
      edge.part = end + (1 - 2 * end) * (band + 0.5) / bands;
      const Place place = place_on(outline, view, side, edge.part);
      if (!in_image(grey, place.pixel - place.outward) ||
          !in_image(grey, place.pixel + place.outward))
        continue;
      ++edges.seen[side];
      const Point next = place.along * (band_length / lines);
      const Point first = place.pixel - next * ((lines - 1) / 2.0);
      profile(grey, first - place.outward * (middle * step),
              place.outward * step, 2 * middle + 1, next, lines,
              value.data());
      float most = 0.0f;
      for (int i = middle - half - 1; i <= middle + half + 1; ++i) {
        rise[i] = 0.0f;
        for (int j = 1; j <= width; ++j)
          rise[i] += value[i + j] - value[i - j];
        most = std::max(most, rise[i]);
      }
      const float least = std::max(slope, float(weaker) * most);
      int best = -1;
      for (int i = middle - half; i <= middle + half && best < 0; ++i)
        if (rise[i] >= least && rise[i] >= rise[i - 1] &&
            rise[i] >= rise[i + 1])
          best = i;
      if (best < 0)
        continue;
      const float bow = 2.0f * rise[best] - rise[best - 1] - rise[best + 1];
      const float shift =
          bow > 0.0f ? 0.5f * (rise[best + 1] - rise[best - 1]) / bow : 0.0f;
      int foot = best, top = best;
      while (foot > best - 6 && value[foot - 1] < value[foot])
        --foot;
      while (top < best + 6 && value[top + 1] > value[top])
        ++top;
      edge.side = side;
      edge.away = (best - middle + shift) * step;
      edge.inside = value[foot];
      edge.contrast = value[top] - value[foot];
      edge.clipped = value[top] >= clipped;
      edge.pull = place.pull;
      edge.unknown = {2 * side, 2 * side + 1, (2 * side + 2) % 8,
                      (2 * side + 3) % 8, 8};
      ++edges.count;
      ++edges.found[side];
    }
  }
}

// Moves the outline onto the edges; the weight of outliers (such as a robot)
// is reduced. WIDTH: the distance in pixels that finally halves a weight.
bool move_onto(const Edges &edges, double width, double unit,
               Outline &outline, Vector &change) {
  constexpr int rounds = 7;
  change = Vector::all(0.0);
  for (int round = 0; round < rounds; ++round) {
    const double scale = width * (1.0 + 16.0 / (1 + round * round));
    Matrix left = Matrix::zeros();
    Vector right = Vector::all(0.0);
    for (int n = 0; n < edges.count; ++n) {
      const Edge &edge = edges.edge[n];
      const double rest = edge.rest(change);
      const double share = 1.0 / (1.0 + rest * rest / (scale * scale));
      for (int i = 0; i < 5; ++i) {
        const double pull = share * edge.pull[i];
        right[edge.unknown[i]] += pull * edge.away;
        for (int j = 0; j < 5; ++j)
          left(edge.unknown[i], edge.unknown[j]) += pull * edge.pull[j];
      }
    }
    // Undetermined parameters stay: the lens, for a small field.
    for (int i = 0; i < 8; ++i)
      left(i, i) += 1e-4 * unit * unit;
    const double stiffness = 100.0;
    left(8, 8) += stiffness;
    right[8] -= stiffness * outline.bend;
    bool solved = false;
    const Matrix inverse = left.inv(cv::DECOMP_CHOLESKY, &solved);
    if (!solved)
      return false;
    change = inverse * right;
    const double bend = std::min(
        std::max(outline.bend + change[8], least_bend), most_bend);
    change[8] = bend - outline.bend;
  }
  outline.bend += change[8];
  for (int k = 0; k < 4; ++k)
    outline.corner[k] += Point(change[2 * k], change[2 * k + 1]);
  return true;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// The planes through the levels of the edges that are IN.
template <typename Condition>
Light light_of(const Outline &outline, const std::vector<Edge> &edges,
               Condition in) {
  cv::Mat places(0, 3, CV_64F), levels(0, 2, CV_64F), planes;
  for (const Edge &edge : edges)
    if (in(edge)) {
      const Point &from = outline.corner[edge.side];
      const Point at =
          from + edge.part * (outline.corner[(edge.side + 1) % 4] - from);
      places.push_back(cv::Mat(cv::Matx13d(1.0, at.x, at.y)));
      levels.push_back(cv::Mat(cv::Matx12d(edge.inside, edge.contrast)));
    }
  cv::solve(places, levels, planes, cv::DECOMP_SVD);
  return planes;
}

}  // namespace

bool settle(const cv::Mat &grey, Outline &outline, double reach, double noise,
            const Pace &pace, Evidence &evidence) {
  static thread_local Edges edges;
  const View view(grey);
  find_edges(grey, outline, reach, noise,
             evidence.usual > 0.0 ? evidence.usual : 1e3, pace, edges);
  for (int side = 0; side < 4; ++side)
    if (edges.seen[side] < 8 || edges.found[side] < 0.3 * edges.seen[side])
      return false;
  Vector change;
  const double width = std::max(0.5, reach / 6.0);
  const Outline before = outline;
  if (!move_onto(edges, width, view.unit, outline, change))
    return false;
  evidence.moved = 0.0;
  for (int k = 0; k < 4; ++k)
    evidence.moved =
        std::max(evidence.moved, view.unit * length(outline.shown(k) -
                                                    before.shown(k)));
  for (int k = 0; k < 4; ++k) {
    const Point &here = outline.corner[k];
    const Point &next = outline.corner[(k + 1) % 4];
    const Point &after = outline.corner[(k + 2) % 4];
    if (!(length(here) < 4.0) || cross(next - here, after - next) < 1e-3)
      return false;
  }

  std::vector<Edge> kept;
  std::copy_if(edges.edge.begin(), edges.edge.begin() + edges.count,
               std::back_inserter(kept), [&](const Edge &edge) {
                 return std::fabs(edge.rest(change)) <= 2.0 * width;
               });
  if (kept.empty())
    return false;
  // Where the sun clips the border, its contrast would be higher: the usual
  // one is that of the rest, at least a quarter.
  const auto relative = [](const Edge &edge) {
    return edge.contrast / (edge.inside + 10.0);
  };
  const int total = int(kept.size());
  std::vector<double> clear, all, contrast;
  for (const Edge &edge : kept) {
    all.push_back(relative(edge));
    contrast.push_back(edge.contrast);
    if (!edge.clipped)
      clear.push_back(all.back());
  }
  const int sunny = total - int(clear.size());
  const bool is_sunny = 4 * sunny <= 3 * total && sunny >= fewest_clipped;
  const double usual = median(is_sunny ? clear : all);
  std::array<int, 4> alike{};
  for (const Edge &edge : kept) {
    const double part = relative(edge) / usual;
    alike[edge.side] +=
        part <= 2.0 && (part >= 0.5 || (is_sunny && edge.clipped));
  }
  int seen = 0, all_alike = 0;
  evidence.weakest = 1.0;
  for (int side = 0; side < 4; ++side) {
    seen += edges.seen[side];
    all_alike += alike[side];
    evidence.weakest =
        std::min(evidence.weakest, double(alike[side]) / edges.seen[side]);
  }
  evidence.support = double(total) / seen;
  evidence.alike = double(all_alike) / total;
  evidence.usual = median(contrast);
  if (pace.light)
    for (const bool clipped : {false, true})
      evidence.light[clipped] = light_of(outline, kept, [&](const Edge &edge) {
        return !is_sunny || edge.clipped == clipped;
      });
  return true;
}

void look_inside(const cv::Mat &grey, const Outline &outline,
                 const Evidence &evidence, double &dark, double &plain) {
  constexpr int columns = 24, rows = 18;
  const View view(grey);
  int darker = 0, alike = 0;
  const std::array<Point, 4> &c = outline.corner;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double x = (column + 1.0) / (columns + 1);
      const double y = (row + 1.0) / (rows + 1);
      const Point u = (1 - y) * ((1 - x) * c[0] + x * c[1]) +
                      y * ((1 - x) * c[3] + x * c[2]);
      const Point at = view.pixel(distort(u, outline.bend));
      const double value =
          sample(grey, Four{} + float(at.x), Four{} + float(at.y))[0];
      bool is_darker = false, is_alike = false;
      for (const Light &light : evidence.light) {
        const cv::Matx12d level = cv::Matx13d(1.0, u.x, u.y) * light;
        const double above = value - level(0);
        const double limit = 0.5 * std::max(0.5 * evidence.usual, level(1));
        is_darker = is_darker || above < limit;
        is_alike = is_alike || std::fabs(above) < limit;
      }
      darker += is_darker;
      alike += is_alike;
    }
  dark = double(darker) / (rows * columns);
  plain = double(alike) / (rows * columns);
}

int ends_continued(const cv::Mat &small, const Outline &outline,
                   double noise) {
  constexpr int places = 7;
  const View view(small);
  // The outward increase of brightness at one pixel inside the side, on it and
  // one pixel outside; false beyond the image.
  using Rises = std::array<float, 3>;
  const auto rises_at = [&](int side, double part, Rises &rises) {
    const Place place = place_on(outline, view, side, part);
    if (!in_image(small, place.pixel - 3.0 * place.outward) ||
        !in_image(small, place.pixel + 3.0 * place.outward))
      return false;
    std::array<float, 8> value;
    profile(small, place.pixel - place.along - 3.0 * place.outward,
            place.outward, 7, place.along, 3, value.data());
    for (int i = 0; i < 3; ++i)
      rises[i] = value[i + 3] + value[i + 4] - value[i + 1] - value[i];
    return true;
  };
  int continued = 0;
  for (int side = 0; side < 4; ++side) {
    std::array<float, places> within;
    int count = 0;
    for (int n = 0; n < places; ++n) {
      Rises rises;
      if (rises_at(side, (n + 1.0) / (places + 1), rises))
        within[count++] = *std::max_element(rises.begin(), rises.end());
    }
    if (count == 0)
      continue;
    std::nth_element(within.begin(), within.begin() + count / 2,
                     within.begin() + count);
    const float least =
        std::max(0.2f * within[count / 2], float(2.0 * noise));
    for (const double end : {0.0, 1.0}) {
      int seen = 0;
      std::array<int, 3> bright{};  // rough ground is so now here, now there
      for (int n = 0; n < places; ++n) {
        const double beyond = 0.06 + 0.04 * n;
        Rises rises;
        if (!rises_at(side, end == 0.0 ? -beyond : 1.0 + beyond, rises))
          break;
        ++seen;
        for (int i = 0; i < 3; ++i)
          bright[i] += rises[i] > least;
      }
      continued += seen >= 3 &&
                   *std::max_element(bright.begin(), bright.end()) >=
                       0.6 * seen;
    }
  }
  return continued;
}

}  // namespace vision
