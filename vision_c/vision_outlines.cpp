// SPDX-License-Identifier: GPL-3.0-or-later
// Candidates for the arena: edges of a small image vote for lines, and four
// lines form an outline.

#include "vision_rims.hpp"

#include <cstdint>

#include <opencv2/imgproc.hpp>

namespace vision {

namespace {

// The lens distortions tried: with an error of half a step, a side of a field
// that fills the image bends by two pixels of the small image.
constexpr std::array<double, 5> bends{0.0, -0.05, -0.11, -0.18, -0.26};

// ------------------------------------------------------------------- Edges

constexpr int gain = 128;  // of the gradient: a grey level a pixel

// The lower quartile of the gradients: from a plain area, or the smoothest
// part of a rough one, where noise causes them.
double usual_gradient(const cv::Mat &dx, const cv::Mat &dy) {
  std::array<int, 1024> tally{};
  int count = 0;
  for (int row = 1; row < dx.rows - 1; row += 2) {
    const short *const x = dx.ptr<short>(row), *const y = dy.ptr<short>(row);
    for (int column = 1; column < dx.cols - 1; column += 2) {
      const float size = std::sqrt(float(x[column]) * x[column] +
                                   float(y[column]) * y[column]);
      ++tally[std::min(int(size) / 8, 1023)];
      ++count;
    }
  }
  int below = 0, level = 0;
  while (level < 1023 && (below += tally[level]) < count / 4)
    ++level;
  return 8.0 * (level + 0.5);
}

void find_spots(const cv::Mat &small, std::vector<Spot> &spots) {
  cv::Mat &dx = scratch.gradient, &dy = scratch.transposed;
  cv::Sobel(small, dx, CV_16S, 1, 0, 5, 1.0, 0.0, cv::BORDER_REPLICATE);
  cv::Sobel(small, dy, CV_16S, 0, 1, 5, 1.0, 0.0, cv::BORDER_REPLICATE);
  // The lower quartile of the length of two normal deviates is 0.76 sigma.
  const double noise = usual_gradient(dx, dy) / 0.76;
  const double slope = std::max(1.2 * gain, 3.5 * noise);
  const float least = float(slope * slope);
  const cv::Point2f middle((small.cols - 1) / 2.0f, (small.rows - 1) / 2.0f);

  spots.clear();
  const std::ptrdiff_t line = dx.step / sizeof(short);
  for (int row = 1; row < small.rows - 1; ++row) {
    const short *const x = dx.ptr<short>(row), *const y = dy.ptr<short>(row);
    for (int column = 1; column < small.cols - 1; ++column) {
      const float rise = x[column], fall = y[column];
      const float here = rise * rise + fall * fall;
      if (here < least)
        continue;
      const float wide = std::fabs(rise), high = std::fabs(fall);
      int across = 0, down = 0;
      if (5.0f * wide >= 2.0f * high)
        across = rise > 0.0f ? 1 : -1;
      if (5.0f * high >= 2.0f * wide)
        down = fall > 0.0f ? 1 : -1;
      const std::ptrdiff_t ahead = across + down * line;
      // Along the normal: beyond a thin border the gradient is reversed.
      const auto size = [&](std::ptrdiff_t at) {
        return rise * x[at] + fall * y[at];
      };
      const float front = size(column + ahead), back = size(column - ahead);
      if (front > here || back >= here)
        continue;
      const float strength = std::sqrt(here);
      const float bow = 2.0f * here - back - front;
      const float shift = bow > 0.0f ? 0.5f * (front - back) / bow : 0.0f;
      spots.push_back(
          {cv::Point2f(column + shift * across, row + shift * down) - middle,
           cv::Point2f(rise / strength, fall / strength), strength / gain});
    }
  }
}

// ------------------------------------------------------------------- Lines

constexpr int angles = 180;          // bins of the direction of a normal
constexpr int spread = 2;            // bins that an edge votes to either side
constexpr int distances = 256;       // bins of a line's distance
constexpr float distance_bin = 2.0f;  // pixels
constexpr int pieces = 128;          // of a line
constexpr float piece = 4.0f;        // pixels

// A line that is brighter on the side of its normal.
struct Rim {
  cv::Point2f normal;
  float distance = 0.0f;  // from the middle along the normal, pixels
  int angle = 0;          // bin
  std::array<std::uint8_t, pieces + 1> edges;  // pieces with an edge before

  cv::Point2f along() const { return {-normal.y, normal.x}; }

  // The share of the segment FROM .. TO, both on the line, that has edges.
  float support(const cv::Point2f &from, const cv::Point2f &to) const {
    const auto index = [&](const cv::Point2f &point) {
      const int n = cvRound(point.dot(along()) / piece) + pieces / 2;
      return std::min(std::max(n, 0), pieces);
    };
    const int first = index(from), last = index(to);
    return last > first ? float(edges[last] - edges[first]) / (last - first)
                        : 0.0f;
  }
};

struct Votes {
  std::vector<Spot> straight, sorted;
  std::vector<int> bin;
  std::array<int, angles + 1> start;
  std::array<std::array<std::uint16_t, distances>, angles> tally;
  std::vector<Rim> rims;
};

// The edges after removal of the lens distortion, sorted by the direction of
// their normals.
void straighten_spots(const std::vector<Spot> &spots, double bend, float unit,
                      Votes &votes) {
  const float rate = float(bend) / (unit * unit);
  votes.straight.clear();
  votes.bin.clear();
  std::array<int, angles + 1> &start = votes.start;
  start.fill(0);
  for (const Spot &spot : spots) {
    const float factor = 1.0f / (1.0f + rate * spot.at.dot(spot.at));
    const cv::Point2f at = spot.at * factor;
    const cv::Point2f along(-spot.normal.y, spot.normal.x);
    const cv::Point2f turned =
        along - spot.at * (2.0f * rate * factor * spot.at.dot(along));
    const cv::Point2f normal =
        cv::Point2f(turned.y, -turned.x) / std::sqrt(turned.dot(turned));
    votes.straight.push_back({at, normal, spot.slope});
    const int bin =
        int(cv::fastAtan2(normal.y, normal.x) * (angles / 360.0f)) % angles;
    votes.bin.push_back(bin);
    ++start[bin + 1];
  }
  for (int n = 0; n < angles; ++n)
    start[n + 1] += start[n];
  std::array<int, angles> next;
  std::copy(start.begin(), start.end() - 1, next.begin());
  votes.sorted.resize(votes.straight.size());
  for (std::size_t n = 0; n < votes.straight.size(); ++n)
    votes.sorted[next[votes.bin[n]]++] = votes.straight[n];
}

void count_votes(Votes &votes) {
  for (auto &row : votes.tally)
    row.fill(0);
  for (int angle = 0; angle < angles; ++angle) {
    const double direction = (angle + 0.5) * 2.0 * CV_PI / angles;
    const cv::Point2f normal(std::cos(direction), std::sin(direction));
    std::array<std::uint16_t, distances> &row = votes.tally[angle];
    for (int near = -spread; near <= spread; ++near) {
      const int from = (angle + near + angles) % angles;
      for (int n = votes.start[from]; n < votes.start[from + 1]; ++n) {
        const float place =
            votes.sorted[n].at.dot(normal) / distance_bin + distances / 2;
        if (place >= 0.0f && place < distances)
          ++row[int(place)];
      }
    }
  }
}

// Fits the line to the edges near it, and records where it has some.
void fit_rim(const Votes &votes, Rim &rim) {
  std::array<bool, pieces> filled;
  for (int round = 0; round < 2; ++round) {
    const float width = round == 0 ? 4.0f : 2.5f;
    const cv::Point2f along = rim.along();
    double w = 0, x = 0, y = 0, xx = 0, xy = 0;
    filled.fill(false);
    for (int near = -spread - 1; near <= spread + 1; ++near) {
      const int from = (rim.angle + near + angles) % angles;
      for (int n = votes.start[from]; n < votes.start[from + 1]; ++n) {
        const cv::Point2f &at = votes.sorted[n].at;
        const float away = at.dot(rim.normal) - rim.distance;
        if (std::fabs(away) > width)
          continue;
        const float place = at.dot(along);
        w += 1;
        x += place;
        y += away;
        xx += place * place;
        xy += place * away;
        const int index = int(std::floor(place / piece)) + pieces / 2;
        if (index >= 0 && index < pieces)
          filled[index] = true;
      }
    }
    if (round == 1 || w < 2)
      break;
    const double spread_out = xx - x * x / w;
    if (spread_out < 1.0)
      break;
    const double slope = std::min(
        std::max((xy - x * y / w) / spread_out, -0.1), 0.1);
    const double offset = (y - slope * x) / w;
    const cv::Point2f turned = rim.normal - along * float(slope);
    const float size = std::sqrt(turned.dot(turned));
    rim.normal = turned / size;
    rim.distance = (rim.distance + float(offset)) / size;
  }
  rim.edges[0] = 0;
  for (int n = 0; n < pieces; ++n)
    rim.edges[n + 1] = std::uint8_t(rim.edges[n] + filled[n]);
}

// The votes for a line and for its neighbours, weighted 1, 2, 1.
int height(const Votes &votes, int angle, int distance) {
  const auto &row = votes.tally[(angle + angles) % angles];
  return 2 * row[distance] + row[distance - 1] + row[distance + 1];
}

// Whether no line nearby has more votes; of equal ones the first is a peak.
bool is_peak(const Votes &votes, int angle, int distance) {
  constexpr int fewest_votes = 16;
  const int here = height(votes, angle, distance);
  if (votes.tally[angle][distance] < fewest_votes / 2 ||
      here < 2 * fewest_votes)
    return false;
  for (int a = -2; a <= 2; ++a)
    for (int d = -1; d <= 1; ++d) {
      if (distance + d < 1 || distance + d >= distances - 1)
        continue;
      const int other = height(votes, angle + a, distance + d);
      if (other > here || (other == here && (a < 0 || (a == 0 && d < 0))))
        return false;
    }
  return true;
}

// The strongest lines of each direction.
void find_rims(Votes &votes) {
  constexpr int sector = 6;  // bins of a direction
  constexpr std::size_t most_in_sector = 8;
  struct Peak {
    int height, angle, distance;
  };
  votes.rims.clear();
  for (int first = 0; first < angles; first += sector) {
    std::vector<Peak> peaks;
    for (int angle = first; angle < first + sector; ++angle)
      for (int distance = 2; distance < distances - 2; ++distance)
        if (is_peak(votes, angle, distance))
          peaks.push_back({height(votes, angle, distance), angle, distance});
    std::stable_sort(peaks.begin(), peaks.end(),
                     [](const Peak &one, const Peak &other) {
                       return one.height > other.height;
                     });
    peaks.resize(std::min(peaks.size(), most_in_sector));
    for (const Peak &here : peaks) {
      const double direction = (here.angle + 0.5) * 2.0 * CV_PI / angles;
      Rim rim;
      rim.normal = cv::Point2f(std::cos(direction), std::sin(direction));
      rim.distance = (here.distance + 0.5f - distances / 2) * distance_bin;
      rim.angle = here.angle;
      fit_rim(votes, rim);
      votes.rims.push_back(rim);
    }
  }
}

// ---------------------------------------------------------------- Outlines

// The largest distance between two corners.
double apart(const Outline &one, const Outline &other) {
  double most = 0.0;
  for (int k = 0; k < 4; ++k)
    most = std::max(most, length(one.shown(k) - other.shown(k)));
  return most;
}

// Four lines, each a quarter turn clockwise from the previous one, with edges
// between their corners.
void find_outlines(const cv::Mat &small, const std::vector<Rim> &rims,
                   double bend, Candidates &found) {
  constexpr int quarter = angles / 4, slack = 9;  // 18 degrees
  constexpr float least_support = 0.35f;
  constexpr float shortest = 0.16f * small_side;  // pixels, of a side
  constexpr int most_tests = 150000;
  const int count = int(rims.size());
  const float unit = std::max(small.cols, small.rows) / 2.0f;
  const cv::Point2f rim_of_image(small.cols / 2.0f + 2.0f,
                                 small.rows / 2.0f + 2.0f);
  int tests = 0;

  const auto follows = [&](const Rim &one, const Rim &next) {
    const int turn = (next.angle - one.angle + angles) % angles;
    return std::abs(turn - quarter) <= slack;
  };
  const auto meet = [&](const Rim &one, const Rim &next, cv::Point2f &point) {
    const float sine = one.normal.x * next.normal.y -
                       one.normal.y * next.normal.x;
    point = cv::Point2f(one.distance * next.normal.y -
                            next.distance * one.normal.y,
                        next.distance * one.normal.x -
                            one.distance * next.normal.x) /
            sine;
    const Point shown =
        distort(Point(point.x / unit, point.y / unit), bend) * unit;
    return std::fabs(shown.x) < rim_of_image.x &&
           std::fabs(shown.y) < rim_of_image.y;
  };
  const auto good = [&](const Rim &rim, const cv::Point2f &from,
                        const cv::Point2f &to, float &support) {
    ++tests;
    if ((to - from).dot(rim.along()) < shortest)
      return false;
    support = rim.support(from, to);
    return support >= least_support;
  };

  for (int t = 0; t < count; ++t) {
    const Rim &top = rims[t];
    if (std::abs(top.angle - 3 * quarter) > quarter / 2 + 2)
      continue;
    for (int r = 0; r < count; ++r) {
      cv::Point2f second;
      if (!follows(top, rims[r]) || !meet(top, rims[r], second))
        continue;
      for (int b = 0; b < count; ++b) {
        cv::Point2f third;
        float right_support = 0.0f;
        if (!follows(rims[r], rims[b]) || !meet(rims[r], rims[b], third) ||
            !good(rims[r], second, third, right_support))
          continue;
        for (int l = 0; l < count; ++l) {
          cv::Point2f fourth, first;
          float bottom = 0.0f, left = 0.0f, upper = 0.0f;
          if (!follows(rims[b], rims[l]) || !follows(rims[l], top) ||
              !meet(rims[b], rims[l], fourth) ||
              !good(rims[b], third, fourth, bottom) ||
              !meet(rims[l], top, first) ||
              !good(rims[l], fourth, first, left) ||
              !good(top, first, second, upper))
            continue;
          if (tests > most_tests)
            return;
          Candidate candidate;
          candidate.outline.bend = bend;
          candidate.outline.corner = {
              Point(first) / unit, Point(second) / unit, Point(third) / unit,
              Point(fourth) / unit};
          const double support = right_support + bottom + left + upper;
          if (support < 2.3 || !is_field(candidate.outline, 0.16))
            continue;
          // For equal fits, prefer the smaller distortion.
          candidate.score = support - 0.5 * std::fabs(bend);
          add(found, candidate);
        }
      }
    }
  }
}

}  // namespace

void add(Candidates &found, const Candidate &wanted) {
  constexpr std::size_t most = 8;
  constexpr double near = 0.03;  // of the unit
  const auto same = std::find_if(
      found.begin(), found.end(), [&](const Candidate &other) {
        return apart(other.outline, wanted.outline) < near;
      });
  if (same != found.end()) {
    if (same->score >= wanted.score)
      return;
    found.erase(same);
  }
  found.insert(std::find_if(found.begin(), found.end(),
                            [&](const Candidate &other) {
                              return other.score < wanted.score;
                            }),
               wanted);
  found.resize(std::min(found.size(), most));
}

bool is_field(const Outline &outline, double tolerance) {
  constexpr double narrowest = 3.6, widest = 1.1;  // focal lengths, in units
  constexpr int steps = 8;
  constexpr double greatest_tilt = 30.0;  // degrees
  const std::array<Point, 4> &c = outline.corner;
  if (std::fabs(cross(c[1] - c[2], c[3] - c[2])) < 1e-6)
    return false;
  const Map map = map_of_square(c);  // of the plane to the undistorted image
  double best = 1e9;
  for (int n = 0; n < steps; ++n) {
    const double focal =
        widest * std::pow(narrowest / widest, double(n) / (steps - 1));
    // The sides in space, in an arbitrary unit.
    const cv::Vec3d right(map(0, 0) / focal, map(1, 0) / focal, map(2, 0));
    const cv::Vec3d down(map(0, 1) / focal, map(1, 1) / focal, map(2, 1));
    const double width = cv::norm(right), height = cv::norm(down);
    if (width < 1e-9 || height < 1e-9)
      continue;
    const cv::Vec3d normal = right.cross(down);
    const double upright = std::fabs(normal[2]) / cv::norm(normal);
    if (upright < std::cos(greatest_tilt * CV_PI / 180.0))
      continue;
    const double ratio = std::max(width, height) / std::min(width, height);
    best = std::min(
        best, std::hypot(std::log(ratio * 0.75),
                         right.dot(down) / (width * height)));
  }
  return best < tolerance;
}

Candidates find_candidates(const cv::Mat &small, std::vector<Spot> &spots) {
  constexpr double fits = 3.6;  // of a support of 4
  static thread_local Votes votes;
  Candidates found;
  find_spots(small, spots);
  for (const double bend : bends) {
    straighten_spots(spots, bend, float(View(small).unit), votes);
    count_votes(votes);
    find_rims(votes);
    find_outlines(small, votes.rims, bend, found);
    // A distortion larger than a well-fitting one only fits worse.
    if (!found.empty() && found[0].score > fits &&
        found[0].outline.bend != bend)
      break;
  }
  return found;
}

}  // namespace vision
