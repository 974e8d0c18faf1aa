// SPDX-License-Identifier: GPL-3.0-or-later
// The search for the arena: edges of a small image vote for lines, four lines
// form an outline, and the best outlines are examined closely.

#include "vision_rims.hpp"

#include <cstdint>
#include <cstring>

#include <opencv2/imgproc.hpp>

namespace vision {

namespace {

constexpr int small_side = 320;  // pixels, of the image searched

// The lens distortions tried: with an error of half a step, a side of a field
// that fills the image bends by two pixels of the small image.
constexpr std::array<double, 5> bends{0.0, -0.05, -0.11, -0.18, -0.26};

// ------------------------------------------------------------------- Edges

// A point of the small image at which it gets brighter along NORMAL.
struct Spot {
  cv::Point2f at, normal;  // from the middle, pixels; of length 1
  float slope;             // grey levels a pixel
};

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
  int votes = 0;
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
  std::vector<Spot> spots, straight, sorted;
  std::vector<int> bin;
  std::array<int, angles + 1> start;
  std::array<std::array<std::uint16_t, distances>, angles> tally;
  std::vector<Rim> rims;
};

// The edges after removal of the lens distortion, sorted by the direction of
// their normals.
void straighten_spots(Votes &votes, double bend, float unit) {
  const float rate = float(bend) / (unit * unit);
  votes.straight.clear();
  votes.bin.clear();
  std::array<int, angles + 1> &start = votes.start;
  start.fill(0);
  for (const Spot &spot : votes.spots) {
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

// The strongest lines of each direction.
void find_rims(Votes &votes) {
  constexpr int sectors = 30, most_in_sector = 8, fewest_votes = 16;
  struct Peak {
    int votes, angle, distance;
  };
  std::array<std::array<Peak, most_in_sector>, sectors> peak;
  std::array<int, sectors> count{};
  const auto height = [&](int angle, int distance) {
    const auto &row = votes.tally[(angle + angles) % angles];
    return 2 * row[distance] + row[distance - 1] + row[distance + 1];
  };
  for (int angle = 0; angle < angles; ++angle) {
    const auto &row = votes.tally[angle];
    const int sector = angle * sectors / angles;
    for (int distance = 2; distance < distances - 2; ++distance) {
      if (row[distance] < fewest_votes / 2)
        continue;
      const int here = height(angle, distance);
      if (here < 2 * fewest_votes)
        continue;
      bool highest = true;
      for (int a = -2; a <= 2 && highest; ++a)
        for (int d = -1; d <= 1 && highest; ++d) {
          if (distance + d < 1 || distance + d >= distances - 1)
            continue;
          const int other = height(angle + a, distance + d);
          highest = a < 0 || (a == 0 && d < 0) ? other < here : other <= here;
        }
      if (!highest)
        continue;
      auto &list = peak[sector];
      int n = count[sector];
      if (n == most_in_sector) {
        if (list[n - 1].votes >= here)
          continue;
        --n;
      } else {
        ++count[sector];
      }
      for (; n > 0 && list[n - 1].votes < here; --n)
        list[n] = list[n - 1];
      list[n] = {here, angle, distance};
    }
  }
  votes.rims.clear();
  for (int sector = 0; sector < sectors; ++sector)
    for (int n = 0; n < count[sector]; ++n) {
      const Peak &here = peak[sector][n];
      const double direction = (here.angle + 0.5) * 2.0 * CV_PI / angles;
      Rim rim;
      rim.normal = cv::Point2f(std::cos(direction), std::sin(direction));
      rim.distance =
          (here.distance + 0.5f - distances / 2) * distance_bin;
      rim.angle = here.angle;
      rim.votes = here.votes;
      fit_rim(votes, rim);
      votes.rims.push_back(rim);
    }
}

// ---------------------------------------------------------------- Outlines

struct Candidate {
  Outline outline;
  double score = 0.0;
};

constexpr int most_candidates = 8;

// The best outlines so far, best first.
struct Candidates {
  std::array<Candidate, most_candidates> candidate;
  int count = 0;

  void add(const Candidate &wanted) {
    constexpr double near = 0.03;  // of the unit
    int place = count;
    for (int n = 0; n < count; ++n) {
      double apart = 0.0;
      for (int k = 0; k < 4; ++k)
        apart = std::max(apart, length(candidate[n].outline.shown(k) -
                                       wanted.outline.shown(k)));
      if (apart < near) {
        if (candidate[n].score >= wanted.score)
          return;
        place = n;
        break;
      }
    }
    if (place == count) {
      if (count == most_candidates) {
        if (candidate[count - 1].score >= wanted.score)
          return;
        place = count - 1;
      } else {
        ++count;
      }
    }
    for (; place > 0 && candidate[place - 1].score < wanted.score; --place)
      candidate[place] = candidate[place - 1];
    candidate[place] = wanted;
  }
};

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
          found.add(candidate);
        }
      }
    }
  }
}

// Noise of a pixel: standard deviation, from the difference of each pixel and
// the mean of its two neighbours on a line; the lower quartile is 0.32 of
// that.
double noise_of(const cv::Mat &grey) {
  std::array<int, 256> tally{};
  int count = 0;
  const int rows = std::max(1, grey.rows / 120);
  const int columns = std::max(1, grey.cols / 160);
  for (int row = rows / 2; row < grey.rows; row += rows) {
    const uchar *const line = grey.ptr<uchar>(row);
    for (int column = 1; column < grey.cols - 1; column += columns) {
      ++tally[std::min(
          std::abs(2 * line[column] - line[column - 1] - line[column + 1]),
          255)];
      ++count;
    }
  }
  int below = 0, level = 0;
  while (level < 255 && below + tally[level] < count / 4)
    below += tally[level++];
  const double part =
      tally[level] > 0 ? (count / 4.0 - below) / tally[level] : 0.0;
  return std::max(0.3, (level - 0.5 + part) / (0.32 * std::sqrt(6.0)));
}

// Edge points in the field per pixel.
double busyness(const std::vector<Spot> &spots, const cv::Mat &small,
                const Outline &outline, double contrast) {
  constexpr double part = 0.1;  // of the border's contrast that counts
  constexpr double rim = 4.0;  // pixels beside the border that do not count
  const double unit = View(small).unit;
  std::array<Point, 4> corner;
  for (int k = 0; k < 4; ++k)
    corner[k] = unit * outline.shown(k);
  const double area =
      0.5 * cross(corner[2] - corner[0], corner[3] - corner[1]);
  int within = 0;
  for (const Spot &spot : spots)
    within += spot.slope > part * contrast &&
              depth(Point(spot.at), corner.data(), 4) > rim;
  return within / std::max(1.0, area);
}

double grade(const Evidence &evidence) {
  return evidence.support * evidence.alike * (0.6 + 0.4 * evidence.weakest) *
         std::pow(0.85, 4 - evidence.corners);
}

// Whether ONE lies in OTHER: two edges of one border, of which the inner one
// belongs to the field.
bool inside(const Outline &one, const Outline &other) {
  for (int k = 0; k < 4; ++k)
    if (depth(one.corner[k], other.corner.data(), 4) < -0.01)
      return false;
  return true;
}

// Whether ONE, which shares two corners with OTHER and does not lie in it, is
// OTHER with a wrong line.
bool is_variant(const Outline &one, const Outline &other) {
  constexpr double near = 0.03;
  int shared = 0;
  for (int k = 0; k < 4; ++k)
    shared += length(one.shown(k) - other.shown(k)) < near;
  return shared >= 2 && !inside(one, other);
}

// Whether the sides continue beyond the corners: then it is one of several
// tiles or panes, or part of a frame. Rough ground looks like a weak border.
bool continues(const cv::Mat &small, const Outline &outline, double noise,
               const Evidence &evidence) {
  constexpr double weak = 35.0;  // grey levels
  return ends_continued(small, outline, noise) >
         (evidence.usual > weak ? 1 : 2);
}

vision_status find_arena(Frame &here, vision_arena &arena) {
  const cv::Size size = here.image.size();

  const double scale =
      std::max(1.0, double(std::max(size.width, size.height)) / small_side);
  if (std::min(size.width, size.height) < 16 * scale)
    return fail(VISION_NOT_FOUND, "too small an image for an arena");

  cv::cvtColor(here.image, scratch.grey, cv::COLOR_BGR2GRAY);
  cv::resize(scratch.grey, scratch.small,
             cv::Size(cvRound(size.width / scale),
                      cvRound(size.height / scale)),
             0, 0, cv::INTER_AREA);
  const cv::Mat &grey = scratch.grey, &small = scratch.small;
  const View view(grey);

  static thread_local Votes room;
  Votes &votes = room;
  find_spots(small, votes.spots);
  Candidates found;
  for (const double bend : bends) {
    straighten_spots(votes, bend, float(View(small).unit));
    count_votes(votes);
    find_rims(votes);
    find_outlines(small, votes.rims, bend, found);
    // A distortion larger than a well-fitting one only fits worse.
    const double here = found.count > 0 ? found.candidate[0].score : 0.0;
    if (here > 3.6 && found.candidate[0].outline.bend != bend)
      break;
  }

  const double noise = noise_of(grey);
  const double noise_small = scale > 1.0 ? noise_of(small) : noise;
  // More and more closely, for fewer and fewer candidates.
  Candidates near, nearer;
  for (int n = 0; n < found.count; ++n) {
    Candidate &candidate = found.candidate[n];
    Evidence evidence;
    if (near.count > 0 && near.candidate[0].score > 0.9 &&
        is_variant(candidate.outline, near.candidate[0].outline))
      continue;
    if (!settle(small, candidate.outline, 4.0, noise_small, quick, evidence) ||
        evidence.support < 0.5 || !is_field(candidate.outline, 0.13) ||
        continues(small, candidate.outline, noise_small, evidence))
      continue;
    candidate.score = grade(evidence);
    near.add(candidate);
  }
  for (int n = 0; n < std::min(near.count, 3); ++n) {
    Candidate &candidate = near.candidate[n];
    Evidence evidence;
    if (!settle(small, candidate.outline, 2.5, noise_small, normal,
                evidence) ||
        !is_field(candidate.outline, 0.1))
      continue;
    candidate.score = grade(evidence);
    nearer.add(candidate);
  }
  double best = 0.0;
  Outline chosen;
  for (int n = 0; n < std::min(nearer.count, 2); ++n) {
    Outline &outline = nearer.candidate[n].outline;
    Evidence evidence;
    if (best > 0.9 && is_variant(outline, chosen))
      continue;
    if (!settle(grey, outline, std::max(3.0, 1.8 * scale), noise, normal,
                evidence))
      continue;
    bool settled = false;
    for (int round = 0; round < 3; ++round) {
      settled = settle(grey, outline, std::max(2.5, scale), noise, thorough,
                       evidence);
      if (!settled || evidence.moved < 0.2 * scale)
        break;
    }
    if (!settled)
      continue;
    double dark = 0.0, plain = 0.0;
    look_inside(small, outline, evidence, dark, plain);
    const double busy = busyness(votes.spots, small, outline,
                                 evidence.usual);
    const double score = grade(evidence);
    if (!is_field(outline, 0.06) || score < 0.48 || evidence.alike < 0.7 ||
        evidence.weakest < 0.25 || evidence.usual < 10.0 || dark < 0.85 ||
        plain < 0.35 || busy > 0.085 ||
        continues(small, outline, noise_small, evidence))
      continue;
    if (best > 0.0 &&
        !(inside(outline, chosen) ? score > 0.85 * best
          : inside(chosen, outline) ? 0.85 * score > best : score > best))
      continue;
    best = score;
    chosen = outline;
  }
  if (best <= 0.0)
    return fail(VISION_NOT_FOUND, "no arena in the image");
  // The first side is the top: the one closest to pointing right.
  int first = 0;
  double furthest = 0.0;
  for (int k = 0; k < 4; ++k) {
    const Point way = chosen.corner[(k + 1) % 4] - chosen.corner[k] +
                      chosen.corner[(k + 2) % 4] - chosen.corner[(k + 3) % 4];
    if (way.x / length(way) > furthest) {
      furthest = way.x / length(way);
      first = k;
    }
  }
  for (int k = 0; k < 4; ++k) {
    const Point corner = view.pixel(chosen.shown((first + k) % 4));
    arena.corner[k] = {corner.x, corner.y};
  }
  return VISION_OK;
}

}  // namespace

}  // namespace vision

extern "C" vision_status vision_find_arena(int slot, vision_arena *arena) {
  return vision::on_image(slot, [&](vision::Frame &here) {
    if (arena == nullptr)
      return vision::fail(VISION_BAD_ARGUMENT, "no place for the arena");
    return vision::find_arena(here, *arena);
  });
}
