// SPDX-License-Identifier: GPL-3.0-or-later
// The modules of a marker: the dictionary, what is read, and the light.

#include "vision_modules.hpp"

#if CV_VERSION_MAJOR > 4 || (CV_VERSION_MAJOR == 4 && CV_VERSION_MINOR >= 7)
#define VISION_ARUCO_IN_OBJDETECT
#include <opencv2/objdetect/aruco_detector.hpp>
#else
#include <opencv2/aruco.hpp>
#endif

namespace vision {

namespace {

// Reverses the optical crosstalk between neighbouring modules: SHARE is the
// share of a neighbour's light in each.
Grid unmix(const Grid &seen, double share) {
  Grid mix = (1 - 2 * share) * Grid::eye();  // along a row or column
  for (int k = 0; k < 8; ++k) {
    mix(k, std::max(k - 1, 0)) += share;
    mix(k, std::min(k + 1, 7)) += share;
  }
  Grid now = seen;
  for (int round = 0; round < 4; ++round)
    now += seen - mix * now * mix.t();
  return now;
}

// Compares markers by differences: illumination is nearly equal for adjacent
// modules. Of the 36 modules, each one's difference from the mean around it is
// compared.
class Differences {
public:
  Differences() {
    constexpr double spread = 1.0;  // modules
    cv::Matx<double, 36, 36> left;
    for (int i = 0; i < 36; ++i) {
      double total = 0.0;
      for (int k = 0; k < 36; ++k)
        total += near(i, k, spread);
      for (int k = 0; k < 36; ++k)
        left(i, k) = (i == k) - near(i, k, spread) / total;
    }
    product = left.t() * left;
    for (const unsigned bits : dictionary().words()) {
      double sum = 0.0;
      for (int i = 0; i < 16; ++i)
        for (int k = 0; k < 16; ++k)
          if (bits >> i & bits >> k & 1u)
            sum += product(inner(i), inner(k));
      length_of.push_back(std::sqrt(sum));
    }
  }

  // The marker most similar to MODULES. False if there is none, or another one
  // is nearly as similar.
  bool read(const Grid &modules, unsigned &bits) const {
    constexpr double like = 0.75;   // the cosine between both, at least
    constexpr double apart = 0.75;  // its sine, as a share of the next one's
    cv::Matx<double, 36, 1> seen;
    for (int k = 0; k < 36; ++k)
      seen(k) = modules(1 + k / 6, 1 + k % 6);
    const cv::Matx<double, 36, 1> rest = product * seen;
    const double square = rest.dot(seen);
    if (square < 1.0)
      return false;
    std::array<std::array<double, 256>, 2> part;
    for (int half = 0; half < 2; ++half) {
      part[half][0] = 0.0;
      for (unsigned byte = 1; byte < 256; ++byte) {
        int lowest = 0;
        while (!(byte >> lowest & 1u))
          ++lowest;
        part[half][byte] = part[half][byte & (byte - 1)] +
                           rest(inner(8 * half + lowest));
      }
    }
    double best = 0.0, next = 0.0;
    const std::vector<unsigned> &words = dictionary().words();
    for (std::size_t k = 0; k < words.size(); ++k) {
      const double cosine =
          (part[0][words[k] & 255u] + part[1][words[k] >> 8]) / length_of[k];
      if (cosine > best) {
        next = best;
        best = cosine;
        bits = words[k];
      } else {
        next = std::max(next, cosine);
      }
    }
    return best * best > like * like * square &&
           square - best * best <= apart * apart * (square - next * next);
  }

private:
  cv::Matx<double, 36, 36> product;
  std::vector<double> length_of;

  // The index among the 36 modules of the one with this bit.
  static int inner(int bit) { return 7 + bit / 4 * 6 + bit % 4; }

  static double near(int i, int k, double spread) {
    const double x = i % 6 - k % 6, y = i / 6 - k / 6;
    return std::exp(-0.5 * (x * x + y * y) / (spread * spread));
  }
};

// The weights of modules along a row or column, by their distance.
Grid nearness(double spread) {
  Grid weight;
  for (int i = 0; i < 8; ++i)
    for (int k = 0; k < 8; ++k)
      weight(i, k) = std::exp(-0.5 * (i - k) * (i - k) / (spread * spread));
  return weight;
}

// The means around each module of VALUE where USED, by that weight along rows
// and columns; more of LEVEL, the less is used nearby.
Grid means(const Grid &weight, const Grid &value, const Grid &used,
           double little, double level) {
  return (weight * value.mul(used) * weight + Grid::all(little * level))
      .div(weight * used * weight + Grid::all(little));
}

}  // namespace

Dictionary::Dictionary() {
#ifdef VISION_ARUCO_IN_OBJDETECT
  const cv::aruco::Dictionary dictionary =
      cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_1000);
#else
  const cv::aruco::Dictionary dictionary =
      *cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_1000);
#endif
  for (int id = 0; id < dictionary.bytesList.rows; ++id) {
    cv::Mat modules = cv::aruco::Dictionary::getBitsFromByteList(
        dictionary.bytesList.rowRange(id, id + 1), 4);
    for (int turns = 0; turns < 4; ++turns) {
      unsigned bits = 0;
      for (int k = 0; k < 16; ++k)
        bits |= unsigned(modules.at<uchar>(k / 4, k % 4) != 0) << k;
      meaning[bits] = 4 * id + turns;
      known.push_back(bits);
      cv::rotate(modules, modules, cv::ROTATE_90_CLOCKWISE);
    }
  }
}

const Dictionary &dictionary() {
  static const Dictionary known;
  return known;
}

unsigned marker_bits(int id) {
  return dictionary().words()[4 * std::size_t(id)];
}

Grid read_modules(const cv::Mat &grey, const Map &map, double module) {
  const int samples = std::min(std::max(cvRound(0.6 * module), 1), 4);
  const cv::Matx33f single = map;
  std::array<float, 4> place;  // in a module
  for (int k = 0; k < samples; ++k)
    place[k] = float(0.6 * ((k + 0.5) / samples - 0.5) - 0.5);
  Grid modules;
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; column += 4) {
      const Four columns = Four{0, 1, 2, 3} + float(column);
      Four sum{};
      for (int y = 0; y < samples; ++y)
        for (int x = 0; x < samples; ++x) {
          Four right = columns + place[x], down = Four{} + (row + place[y]);
          move(single, right, down);
          sum += sample(grey, right, down);
        }
      for (int k = 0; k < 4; ++k)
        modules(row, column + k) = sum[k] / float(samples * samples);
    }
  return modules;
}

const std::array<std::array<int, 2>, 20> &border_modules() {
  static const auto modules = [] {
    std::array<std::array<int, 2>, 20> all;
    for (int k = 0; k < 5; ++k) {
      all[k] = {1, 1 + k};
      all[5 + k] = {1 + k, 6};
      all[10 + k] = {6, 6 - k};
      all[15 + k] = {6 - k, 1};
    }
    return all;
  }();
  return modules;
}

bool is_border(const Grid &black) {
  constexpr int most_hidden = 4;
  const auto &modules = border_modules();
  const auto is_black = [&](int k) {
    const auto &module = modules[k % 20];
    return black(module[0], module[1]) > 0.0;
  };
  int longest = 0;
  for (int from = 0; from < 20; ++from) {
    int run = 0;
    while (run < 20 && is_black(from + run))
      ++run;
    longest = std::max(longest, run);
  }
  return longest >= 20 - most_hidden;
}

// The threshold that separates the levels best (Otsu 1979).
bool read_evenly(const Grid &modules, unsigned &bits) {
  std::array<double, 36> level;
  for (int k = 0; k < 36; ++k)
    level[k] = modules(1 + k / 6, 1 + k % 6);
  std::sort(level.begin(), level.end());
  double total = 0.0, below = 0.0, best = -1.0, threshold = 0.0;
  for (const double grey : level)
    total += grey;
  for (int k = 1; k < 36; ++k) {
    below += level[k - 1];
    const double apart = (total - below) / (36 - k) - below / k;
    if (k >= 18 && apart * apart * k * (36 - k) > best) {
      best = apart * apart * k * (36 - k);
      threshold = (level[k - 1] + level[k]) / 2;
      if (apart < least_contrast)
        best = -1.0;
    }
  }
  if (best < 0.0)
    return false;
  Grid black;
  bits = 0;
  for (int row = 1; row < 7; ++row)
    for (int column = 1; column < 7; ++column) {
      black(row, column) = modules(row, column) <= threshold;
      if (ring_of(row, column) > 1 && modules(row, column) > threshold)
        bits |= 1u << bit_of(row, column);
    }
  return is_border(black);
}

bool read_unmixed(const Grid &modules, unsigned &bits) {
  return read_evenly(unmix(modules, 0.15), bits);
}

bool read_unevenly(const Grid &modules, unsigned &bits) {
  static const Differences differences;
  return differences.read(modules, bits);
}

Levels light_far(const Grid &bright, const Grid &modules, const Grid &seen,
                 double black, double white) {
  static const Grid near = nearness(4.0);
  Grid inner;
  for (int row = 1; row < 7; ++row)
    for (int column = 1; column < 7; ++column)
      inner(row, column) = seen(row, column);
  return {means(near, modules, inner - inner.mul(bright), 0.02, black),
          means(near, modules, inner.mul(bright), 0.02, white)};
}

Levels light_near(const Grid &bright, const Grid &modules, const Grid &seen,
                  double black, double white) {
  static const Grid near = nearness(0.9), wide = nearness(2.0);
  using Between = cv::Matx<double, 8, 7>;
  static const Between half = [] {  // as wide, from between two modules
    Between weight;
    for (int i = 0; i < 8; ++i)
      for (int k = 0; k < 7; ++k)
        weight(i, k) =
            std::exp(-0.5 * (i - k - 0.5) * (i - k - 0.5) / (2.0 * 2.0));
    return weight;
  }();
  // Of two adjacent modules of which one is white: the difference.
  const auto steps = [](const Grid &colour, const Grid &level,
                        const Grid &visible, Between &value, Between &used) {
    for (int row = 0; row < 8; ++row)
      for (int k = 0; k < 7; ++k) {
        const double turn = colour(row, k + 1) - colour(row, k);
        used(row, k) =
            std::fabs(turn) * visible(row, k) * visible(row, k + 1);
        value(row, k) =
            used(row, k) * turn * (level(row, k + 1) - level(row, k));
      }
  };
  Between value, used, value_down, used_down;
  steps(bright, modules, seen, value, used);
  steps(bright.t(), modules.t(), seen.t(), value_down, used_down);
  const Grid step =
      (wide * value * half.t() + half * value_down.t() * wide +
       Grid::all(0.02 * (white - black)))
          .div(wide * used * half.t() + half * used_down.t() * wide +
               Grid::all(0.02));
  const Grid dark =
      means(near, modules - bright.mul(step), seen, 0.001, black);
  return {dark, dark + step};
}

std::array<Margin, 4> margins(const cv::Mat &grey, const Map &map,
                              double white) {
  constexpr int steps = 16, along = 12;
  constexpr double from = -0.5, to = 1.5, step = (to - from) / steps;
  std::array<Margin, 4> margin;
  const cv::Matx33f single = map;
  for (int side = 0; side < 4; ++side) {
    std::array<double, steps + 1> level;
    for (int k = 0; k <= steps; ++k) {
      const double away = from + k * step;
      Four sum{};
      for (int n = 0; n < along; n += 4) {
        Four x = (Four{0, 1, 2, 3} + (float(n) + 0.5f)) * (6.0f / along);
        Four y = Four{} + float(side % 3 == 0 ? -away : 6.0 + away);
        if (side % 2 == 1)
          std::swap(x, y);
        move(single, x, y);
        sum += sample(grey, x, y);
      }
      level[k] = (sum[0] + sum[1] + sum[2] + sum[3]) / along;
    }
    const double beyond = (level[steps] + level[steps - 1]) / 2;
    const double bright = white - beyond;
    double light = -from * (beyond - level[0]);  // over that beyond
    for (int k = 0; k < steps; ++k)
      light += step * ((level[k] + level[k + 1]) / 2 - beyond);
    margin[side] = {bright > least_contrast && light < bright
                        ? std::max(light, 0.0) / bright : 1.0,
                    beyond};
  }
  return margin;
}

bool has_spot(const Grid &modules) {
  constexpr double saturated = 245.0;  // grey level, noise aside
  int within = 0, around = 0;          // of 28
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column)
      (ring_of(row, column) == 0 ? around : within) +=
          modules(row, column) >= saturated;
  return within > 0 && around < 14;
}

}  // namespace vision
