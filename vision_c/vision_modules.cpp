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

bool is_border(const Grid &black) {
  constexpr int most_hidden = 4;
  int run = 0, longest = 0;
  for (int k = 0; k < 40; ++k) {  // twice around
    const int side = k / 5 % 4, from = 1 + k % 5, to = 7 - from;
    const double here = side == 0   ? black(1, from)
                        : side == 1 ? black(from, 6)
                        : side == 2 ? black(6, to)
                                    : black(to, 1);
    run = here > 0.0 ? run + 1 : 0;
    longest = std::max(longest, run);
  }
  return longest >= 20 - most_hidden;
}

// The threshold that separates the levels best (Otsu 1979).
bool read_evenly(const Grid &modules, unsigned &bits) {
  cv::Mat level, white;
  const cv::Mat all(modules);
  all(cv::Rect(1, 1, 6, 6)).convertTo(level, CV_8U);
  cv::threshold(level, white, 0, 255, cv::THRESH_OTSU);
  if (cv::mean(level, white)[0] - cv::mean(level, ~white)[0] < least_contrast)
    return false;
  Grid black;
  bits = 0;
  for (int row = 1; row < 7; ++row)
    for (int column = 1; column < 7; ++column) {
      const bool is_bright = white.at<uchar>(row - 1, column - 1) != 0;
      black(row, column) = !is_bright;
      if (ring_of(row, column) > 1 && is_bright)
        bits |= 1u << bit_of(row, column);
    }
  return is_border(black);
}

bool read_unmixed(const Grid &modules, unsigned &bits) {
  return read_evenly(unmix(modules, 0.15), bits);
}

// Compares by differences: illumination is nearly equal for adjacent modules.
// Of the 36 modules, each one's difference from the mean around it is
// compared. The result is the most similar marker; none, if another one is
// nearly as similar.
bool read_unevenly(const Grid &modules, unsigned &bits) {
  constexpr double like = 0.75;   // the cosine between both, at least
  constexpr double apart = 0.75;  // its sine, as a share of the next one's
  static const std::vector<unsigned> &words = dictionary().words();
  static const Grid near = nearness(1.0), own = [] {
    Grid inside;
    for (int k = 0; k < 36; ++k)
      inside(1 + k / 6, 1 + k % 6) = 1.0;
    return inside;
  }(), total = near * own * near;
  const auto differences = [](const Grid &level) -> Grid {
    return (level - (near * level.mul(own) * near).div(total)).mul(own);
  };
  static const std::vector<double> shares = [&] {  // 1 / length, of each ID
    std::vector<double> all;
    for (std::size_t k = 0; k < words.size(); k += 4) {
      Grid white;
      for (int bit = 0; bit < 16; ++bit)
        white(2 + bit / 4, 2 + bit % 4) = words[k] >> bit & 1u;
      all.push_back(1 / cv::norm(differences(white)));
    }
    return all;
  }();
  const Grid seen = differences(modules);
  const double square = seen.dot(seen);
  if (square < 1.0)
    return false;
  // What a white module adds to the product of both; and those of a byte
  const Grid gain = seen - (near * seen.div(total) * near).mul(own);
  std::array<std::array<double, 256>, 2> part{};
  for (int half = 0; half < 2; ++half)
    for (unsigned byte = 1; byte < 256; ++byte) {
      const int bit = 8 * half + __builtin_ctz(byte);
      part[half][byte] = part[half][byte & (byte - 1)] +
                         gain(2 + bit / 4, 2 + bit % 4);
    }
  double best = 0.0, next = 0.0;
  for (std::size_t k = 0; k < words.size(); ++k) {
    const double cosine =
        (part[0][words[k] & 255u] + part[1][words[k] >> 8]) * shares[k / 4];
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
  for (int side = 0; side < 4; ++side) {
    // The places beside the side, and one module further out.
    const auto beside = [&](double part, double away) {
      const double out = side % 3 == 0 ? -away : 6.0 + away;
      const double place = 6.0 * part;
      return apply(map, side % 2 == 0 ? Point(place, out)
                                      : Point(out, place));
    };
    std::array<float, steps + 4> level;
    const double half = 0.5 / along;
    profile(grey, beside(half, from),
            (beside(0.5, to) - beside(0.5, from)) / steps, steps + 1,
            (beside(1.0, from) - beside(0.0, from)) / along, along,
            level.data());
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
