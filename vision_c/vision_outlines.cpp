// SPDX-License-Identifier: GPL-3.0-or-later
// Candidates for the arena: edges of a small image vote for lines, and four
// lines form an outline.

#include "vision_rims.hpp"

#include <numeric>

namespace vision {

namespace {

// The lens distortions tried: with an error of half a step, a side of a field
// that fills the image bends by two pixels of the small image.
constexpr std::array<double, 5> bends{0.0, -0.05, -0.11, -0.18, -0.26};

// ------------------------------------------------------------------- Edges

constexpr int gain = 128;  // of the gradient: a grey level a pixel
constexpr double noise_gain = 26.5;  // the filter's: sqrt (70 * 10)

// Noise of a pixel, the standard deviation: from the lower quartile of the
// gradients, which is 0.76 sigma of a part of them, in a plain area or the
// smoothest part of a rough one.
double noise_of(const cv::Mat &dx, const cv::Mat &dy) {
  std::vector<float> sizes;
  for (int row = 1; row < dx.rows - 1; row += 2)
    for (int column = 1; column < dx.cols - 1; column += 2)
      sizes.push_back(std::hypot(float(dx.at<short>(row, column)),
                                 float(dy.at<short>(row, column))));
  const auto quarter = sizes.begin() + sizes.size() / 4;
  std::nth_element(sizes.begin(), quarter, sizes.end());
  return *quarter / 0.76 / noise_gain;
}

// A point of the small image at which it gets brighter along NORMAL.
struct Spot {
  cv::Point2f at, normal;  // from the middle, pixels; of length 1
};

// The edge points of the image; returns the noise of a pixel.
double find_spots(const cv::Mat &small, std::vector<Spot> &spots) {
  cv::Mat &dx = scratch.gradient, &dy = scratch.gradient_down;
  cv::Sobel(small, dx, CV_16S, 1, 0, 5, 1.0, 0.0, cv::BORDER_REPLICATE);
  cv::Sobel(small, dy, CV_16S, 0, 1, 5, 1.0, 0.0, cv::BORDER_REPLICATE);
  const double noise = noise_of(dx, dy);
  const double slope = std::max(1.2 * gain, 3.5 * noise_gain * noise);
  const cv::Point2f middle((small.cols - 1) / 2.0f, (small.rows - 1) / 2.0f);
  cv::Canny(dx, dy, scratch.mask, slope, slope, true);
  std::vector<cv::Point> places;
  cv::findNonZero(scratch.mask, places);
  spots.clear();
  for (const cv::Point &at : places) {
    const cv::Point2f rise(dx.at<short>(at), dy.at<short>(at));
    spots.push_back({cv::Point2f(at) - middle, rise / cv::norm(rise)});
  }
  return noise;
}

// ------------------------------------------------------------------- Lines

constexpr int angles = 180;          // bins of the direction of a normal
constexpr int spread = 2;            // bins that an edge votes to either side
constexpr int distances = 256;       // bins of a line's distance
constexpr float distance_bin = 2.0f;  // pixels
constexpr int pieces = 128;          // of a line
constexpr float piece = 4.0f;        // pixels

cv::Point2f normal_of(int angle) {
  const double direction = (angle + 0.5) * 2.0 * CV_PI / angles;
  return cv::Point2f(std::cos(direction), std::sin(direction));
}

// Edge points without the lens distortion, by the direction of their normals.
using Bins = std::array<std::vector<cv::Point2f>, angles>;

// Calls SEE for the points of the bins at most SPREAD beside ANGLE.
template <typename Operation>
void for_each_near(const Bins &bins, int angle, int spread, Operation see) {
  for (int bin = angle - spread; bin <= angle + spread; ++bin)
    for (const cv::Point2f &at : bins[(bin + angles) % angles])
      see(at);
}

void straighten_spots(const std::vector<Spot> &spots, double bend, float unit,
                      Bins &bins) {
  const float rate = float(bend) / (unit * unit);
  for (std::vector<cv::Point2f> &bin : bins)
    bin.clear();
  for (const Spot &spot : spots) {
    const float factor = 1.0f / (1.0f + rate * spot.at.dot(spot.at));
    const cv::Point2f along(-spot.normal.y, spot.normal.x);
    const cv::Point2f turned =
        along - spot.at * (2.0f * rate * factor * spot.at.dot(along));
    const float direction = cv::fastAtan2(-turned.x, turned.y);
    bins[int(direction * (angles / 360.0f)) % angles].push_back(spot.at *
                                                                factor);
  }
}

// A line that is brighter on the side of its normal.
struct Rim {
  cv::Point2f normal;
  float distance = 0.0f;  // from the middle along the normal, pixels
  int angle = 0;          // bin
  std::array<int, pieces + 1> edges;  // pieces with an edge before

  cv::Point2f along() const { return {-normal.y, normal.x}; }

  // The piece of a point on the line.
  int index(const cv::Point2f &point) const {
    const int n = cvFloor(point.dot(along()) / piece) + pieces / 2;
    return std::min(std::max(n, 0), pieces - 1);
  }

  // The share of the segment FROM .. TO, both on the line, that has edges.
  float support(const cv::Point2f &from, const cv::Point2f &to) const {
    const int first = index(from), last = index(to);
    return last > first ? float(edges[last] - edges[first]) / (last - first)
                        : 0.0f;
  }
};

// The line through the edges near the one with that normal and distance, and
// where it has some.
Rim fit_rim(const Bins &bins, int angle, float distance) {
  Rim rim;
  rim.angle = angle;
  rim.normal = normal_of(angle);
  rim.distance = distance;
  std::vector<cv::Point2f> near;
  const auto collect = [&](float width) {
    near.clear();
    for_each_near(bins, angle, spread + 1, [&](const cv::Point2f &at) {
      if (std::fabs(at.dot(rim.normal) - rim.distance) <= width)
        near.push_back(at);
    });
  };
  collect(4.0f);
  cv::Vec4f line;  // its direction, and a point
  cv::fitLine(near, line, cv::DIST_L2, 0, 0.01, 0.01);
  const cv::Point2f normal(-line[1], line[0]);
  rim.normal = normal.dot(rim.normal) > 0.0f ? normal : -normal;
  rim.distance = rim.normal.dot(cv::Point2f(line[2], line[3]));
  collect(2.5f);
  rim.edges.fill(0);
  for (const cv::Point2f &at : near)
    rim.edges[rim.index(at) + 1] = 1;
  std::partial_sum(rim.edges.begin(), rim.edges.end(), rim.edges.begin());
  return rim;
}

// The strongest lines of each direction.
std::vector<Rim> find_rims(const Bins &bins) {
  constexpr int sector = 6;  // bins of a direction
  constexpr std::size_t most_in_sector = 8;
  constexpr float fewest_votes = 8;  // of the bin, and smoothed
  cv::Mat votes = cv::Mat::zeros(angles, distances, CV_32F), smooth, highest;
  for (int angle = 0; angle < angles; ++angle) {
    const cv::Point2f normal = normal_of(angle);
    for_each_near(bins, angle, spread, [&](const cv::Point2f &at) {
      const int bin =
          cvFloor(at.dot(normal) / distance_bin) + distances / 2;
      if (bin >= 0 && bin < distances)
        ++votes.at<float>(angle, bin);
    });
  }
  // A peak has the most votes among the lines nearby.
  cv::copyMakeBorder(votes, smooth, 2, 2, 0, 0, cv::BORDER_WRAP);
  cv::blur(smooth, smooth, cv::Size(2, 1));
  cv::blur(smooth, smooth, cv::Size(2, 1), cv::Point(0, 0));
  cv::dilate(smooth, highest, cv::Mat::ones(5, 3, CV_8U));

  struct Peak {
    float height;
    int angle, bin;
  };
  std::vector<Rim> rims;
  for (int first = 0; first < angles; first += sector) {
    std::vector<Peak> peaks;
    for (int angle = first; angle < first + sector; ++angle)
      for (int bin = 2; bin < distances - 2; ++bin) {
        const float height = smooth.at<float>(angle + 2, bin);
        if (height >= fewest_votes &&
            height >= highest.at<float>(angle + 2, bin) &&
            votes.at<float>(angle, bin) >= fewest_votes)
          peaks.push_back({height, angle, bin});
      }
    std::stable_sort(peaks.begin(), peaks.end(),
                     [](const Peak &one, const Peak &other) {
                       return one.height > other.height;
                     });
    peaks.resize(std::min(peaks.size(), most_in_sector));
    for (const Peak &here : peaks)
      rims.push_back(fit_rim(
          bins, here.angle,
          (here.bin + 0.5f - distances / 2) * distance_bin));
  }
  return rims;
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
  constexpr float least_support = 0.35f, least_sum = 2.3f;  // of four
  constexpr float shortest = 0.16f * small_side;  // pixels, of a side
  constexpr int most_tests = 150000;
  const float unit = float(View(small).unit);
  const Point limit(small.cols / 2.0 + 2.0, small.rows / 2.0 + 2.0);

  // Each line's corners with the lines that can follow it.
  struct Corner {
    int next;
    cv::Point2f at;
  };
  const int count = int(rims.size());
  std::vector<std::vector<Corner>> corners(rims.size());
  for (int k = 0; k < count; ++k)
    for (int next = 0; next < count; ++next) {
      const Rim &one = rims[k], &two = rims[next];
      if (std::abs((two.angle - one.angle + angles) % angles - quarter) >
          slack)
        continue;
      const cv::Point2f at = (one.distance * two.along() -
                              two.distance * one.along()) /
                             -one.normal.cross(two.normal);
      const Point shown = distort(Point(at) / unit, bend) * unit;
      if (std::fabs(shown.x) < limit.x && std::fabs(shown.y) < limit.y)
        corners[k].push_back({next, at});
    }
  int tests = 0;
  const auto support = [&](int k, const cv::Point2f &from,
                           const cv::Point2f &to) {
    ++tests;
    const float share = (to - from).dot(rims[k].along()) < shortest
                            ? 0.0f : rims[k].support(from, to);
    return share >= least_support ? share : 0.0f;
  };

  for (int top = 0; top < count; ++top) {
    if (std::abs(rims[top].angle - 3 * quarter) > quarter / 2 + 2)
      continue;
    for (const Corner &second : corners[top])
      for (const Corner &third : corners[second.next]) {
        const float right = support(second.next, second.at, third.at);
        if (right == 0.0f)
          continue;
        for (const Corner &fourth : corners[third.next]) {
          const float bottom = support(third.next, third.at, fourth.at);
          if (bottom == 0.0f)
            continue;
          for (const Corner &first : corners[fourth.next]) {
            if (first.next != top)
              continue;
            const float left = support(fourth.next, fourth.at, first.at);
            const float upper = support(top, first.at, second.at);
            if (tests > most_tests)
              return;
            const float sum = right + bottom + left + upper;
            Candidate candidate;
            candidate.outline = {{Point(first.at) / unit,
                                  Point(second.at) / unit,
                                  Point(third.at) / unit,
                                  Point(fourth.at) / unit}, bend};
            if (left == 0.0f || upper == 0.0f || sum < least_sum ||
                !is_field(candidate.outline, 0.16))
              continue;
            // For equal fits, prefer the smaller distortion.
            candidate.score = sum - 0.5 * std::fabs(bend);
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
  // Of the plane to the undistorted image.
  const Map map =
      map_of({Point(0, 0), Point(1, 0), Point(1, 1), Point(0, 1)}, c);
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

Candidates find_candidates(const cv::Mat &small, double &noise) {
  constexpr double fits = 3.6;  // of a support of 4
  static thread_local Bins bins;
  std::vector<Spot> spots;
  Candidates found;
  noise = find_spots(small, spots);
  for (const double bend : bends) {
    straighten_spots(spots, bend, float(View(small).unit), bins);
    find_outlines(small, find_rims(bins), bend, found);
    // A distortion larger than a well-fitting one only fits worse.
    if (!found.empty() && found[0].score > fits &&
        found[0].outline.bend != bend)
      break;
  }
  return found;
}

}  // namespace vision
