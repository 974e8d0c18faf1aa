// SPDX-License-Identifier: GPL-3.0-or-later
// The search for ArUco markers: quadrilaterals are read and aligned.

#include "vision_search.hpp"

#include <opencv2/imgproc.hpp>

#if CV_VERSION_MAJOR > 4 || (CV_VERSION_MAJOR == 4 && CV_VERSION_MINOR >= 7)
#define VISION_ARUCO_IN_OBJDETECT
#include <opencv2/objdetect/aruco_detector.hpp>
#else
#include <opencv2/aruco.hpp>
#endif

namespace vision {

namespace {

// The meaning of a marker's bits.
class Dictionary {
public:
  Dictionary() {
#ifdef VISION_ARUCO_IN_OBJDETECT
    learn(cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_1000));
#else
    learn(*cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_1000));
#endif
  }

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

  void learn(const cv::aruco::Dictionary &dictionary) {
    for (int id = 0; id < dictionary.bytesList.rows; ++id) {
      const cv::Mat upright = cv::aruco::Dictionary::getBitsFromByteList(
          dictionary.bytesList.rowRange(id, id + 1), 4);
      unsigned bits = 0;
      for (int k = 0; k < 16; ++k)
        bits |= unsigned(upright.at<uchar>(k / 4, k % 4) != 0) << k;
      for (int turns = 0; turns < 4; ++turns) {
        meaning[bits] = 4 * id + turns;
        known.push_back(bits);
        bits = turned(bits);
      }
    }
  }

  // The bits after a clockwise quarter turn.
  static unsigned turned(unsigned bits) {
    unsigned result = 0;
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column)
        result |= (bits >> (4 * (3 - column) + row) & 1u)
                  << (4 * row + column);
    return result;
  }
};

const Dictionary &dictionary() {
  static const Dictionary known;
  return known;
}

// Grey levels, or labels, of a marker's modules: its own 6 x 6, including the
// black border, and those around it.
template <typename Item> using Grid = std::array<std::array<Item, 8>, 8>;

int ring_of(int row, int column) {
  return std::min(std::min(row, column), std::min(7 - row, 7 - column));
}

int bit_of(int row, int column) {
  return 4 * (row - 2) + column - 2;
}

// The marker in module coordinates, from its top left corner.
const Quad six_by_six{Point(0, 0), Point(6, 0), Point(6, 6), Point(0, 6)};

// The modules, each averaged over the centre of its area.
Grid<double> read_modules(const cv::Mat &grey, const Map &map,
                          double module) {
  const int samples = std::min(std::max(cvRound(0.6 * module), 1), 4);
  const cv::Matx33f single = map;
  std::array<float, 4> place;  // in a module
  for (int k = 0; k < samples; ++k)
    place[k] = float(0.6 * ((k + 0.5) / samples - 0.5) - 0.5);
  Grid<double> modules;
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
        modules[row][column + k] = sum[k] / float(samples * samples);
    }
  return modules;
}

// Reverses the optical crosstalk between neighbouring modules: SHARE is the
// share of a neighbour's light in each.
Grid<double> unmix(const Grid<double> &seen, double share) {
  Grid<double> now = seen;
  for (int round = 0; round < 4; ++round) {
    const Grid<double> before = now;
    const auto at = [&](int row, int column) {
      return before[std::min(std::max(row, 0), 7)]
                   [std::min(std::max(column, 0), 7)];
    };
    for (int row = 0; row < 8; ++row)
      for (int column = 0; column < 8; ++column) {
        double mixed = 0.0;
        for (int y = -1; y <= 1; ++y)
          for (int x = -1; x <= 1; ++x)
            mixed += (y == 0 ? 1 - 2 * share : share) *
                     (x == 0 ? 1 - 2 * share : share) *
                     at(row + y, column + x);
        now[row][column] += seen[row][column] - mixed;
      }
  }
  return now;
}

// The modules of the border, in sequence.
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

// Whether the border is black, except for one place that may be covered:
// otherwise it is no marker.
bool is_border(const Grid<bool> &black) {
  constexpr int most_hidden = 4;
  const auto &modules = border_modules();
  const auto is_black = [&](int k) {
    const auto &module = modules[k % 20];
    return black[module[0]][module[1]];
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

constexpr double least_contrast = 10.0;  // grey levels

// A single threshold, which separates the levels best (Otsu 1979).
bool read_evenly(const Grid<double> &modules, unsigned &bits) {
  std::array<double, 36> level;
  for (int k = 0; k < 36; ++k)
    level[k] = modules[1 + k / 6][1 + k % 6];
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
  Grid<bool> black{};
  bits = 0;
  for (int row = 1; row < 7; ++row)
    for (int column = 1; column < 7; ++column) {
      black[row][column] = modules[row][column] <= threshold;
      if (ring_of(row, column) > 1 && !black[row][column])
        bits |= 1u << bit_of(row, column);
    }
  return is_border(black);
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
  bool read(const Grid<double> &modules, unsigned &bits) const {
    constexpr double like = 0.75;   // the cosine between both, at least
    constexpr double apart = 0.75;  // its sine, as a share of the next one's
    cv::Matx<double, 36, 1> seen;
    for (int k = 0; k < 36; ++k)
      seen(k) = modules[1 + k / 6][1 + k % 6];
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

const Differences &differences() {
  static const Differences known;
  return known;
}

// The drawing of a marker that is compared with the image: pixels per module,
// and the width of the quiet zone in pixels.
constexpr int pitch = 8;
constexpr int extent = 8 * pitch;

// The pixels of a module that are compared, in each direction: half of them,
// symmetrical to each edge, so that it is not shifted.
constexpr std::array<int, 4> places{0, 2, 5, 7};
constexpr int points = 8 * int(places.size());
constexpr uchar read_only = 1;  // not to be compared, but looked at

constexpr int point(int k) {
  return k / int(places.size()) * pitch + places[k % places.size()];
}

bool is_white(unsigned bits, int row, int column) {
  const int ring = ring_of(row, column);
  return ring == 0 || (ring > 1 && (bits >> bit_of(row, column) & 1u));
}

// Levels of black and white at each module.
struct Light {
  Grid<double> black{}, white{};
};

// For nearly even illumination: means over a wide neighbourhood of the modules
// that are SEEN.
Light light_far(unsigned bits, const Grid<double> &modules,
                const Grid<bool> &seen, double black, double white) {
  constexpr double spread = 4.0;  // modules
  std::array<double, 8> share;
  for (int k = 0; k < 8; ++k)
    share[k] = std::exp(-0.5 * k * k / (spread * spread));
  Light light;
  for (const bool bright : {false, true}) {
    Grid<double> sum{}, weight{};  // along each row
    for (int y = 1; y < 7; ++y)
      for (int x = 1; x < 7; ++x) {
        if (!seen[y][x] || is_white(bits, y, x) != bright)
          continue;
        for (int column = 0; column < 8; ++column) {
          const double w = share[std::abs(x - column)];
          sum[y][column] += w * modules[y][x];
          weight[y][column] += w;
        }
      }
    for (int row = 0; row < 8; ++row)
      for (int column = 0; column < 8; ++column) {
        double total = 0.02 * (bright ? white : black), part = 0.02;
        for (int y = 1; y < 7; ++y) {
          total += share[std::abs(y - row)] * sum[y][column];
          part += share[std::abs(y - row)] * weight[y][column];
        }
        (bright ? light.white : light.black)[row][column] = total / part;
      }
  }
  return light;
}

// For uneven illumination: black is interpolated from adjacent modules as if
// they were black. The contrast to white varies more slowly.
Light light_near(unsigned bits, const Grid<double> &modules,
                 const Grid<bool> &seen, double black, double white) {
  constexpr double spread = 0.9, spread_of_steps = 2.0;  // modules
  const auto share = [](double x, double y, double reach) {
    return std::exp(-0.5 * (x * x + y * y) / (reach * reach));
  };
  struct Step {
    double row, column, grey;
  };
  std::vector<Step> steps;
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column)
      for (const bool down : {false, true}) {
        const int y = row + down, x = column + !down;
        if (y > 7 || x > 7 || !seen[row][column] || !seen[y][x] ||
            is_white(bits, row, column) == is_white(bits, y, x))
          continue;
        const double grey = modules[y][x] - modules[row][column];
        steps.push_back({(row + y) / 2.0, (column + x) / 2.0,
                         is_white(bits, y, x) ? grey : -grey});
      }
  Light light;
  Grid<double> step;
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column) {
      double sum = 0.02 * (white - black), weight = 0.02;
      for (const Step &one : steps) {
        const double w =
            share(one.column - column, one.row - row, spread_of_steps);
        sum += w * one.grey;
        weight += w;
      }
      step[row][column] = sum / weight;
    }
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column) {
      double sum = 0.001 * black, weight = 0.001;
      for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
          if (!seen[y][x])
            continue;
          const double w = share(x - column, y - row, spread);
          sum += w * (modules[y][x] -
                      (is_white(bits, y, x) ? step[y][x] : 0.0));
          weight += w;
        }
      light.black[row][column] = sum / weight;
      light.white[row][column] = sum / weight + step[row][column];
    }
  return light;
}

// Of the quiet zone beside a side: its width, in modules, one at most; the
// grey level beyond it.
struct Margin {
  double width, beyond;
};

// MAP: from the marker's modules to GREY; WHITE: the mean level of its white
// ones. A thin margin's light is measured: blurred, it has no profile.
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

// Draws what is beyond the margins; levels as for draw.
void draw_beyond(const std::array<Margin, 4> &margin, double black,
                 double step, cv::Mat &shape) {
  const auto outer = [&](int side) { return pitch * margin[side].width; };
  for (int y = 0; y < extent; ++y)
    for (int x = 0; x < extent; ++x) {
      if (ring_of(y / pitch, x / pitch) > 0)
        continue;
      const std::array<double, 4> out{
          pitch - outer(0) - y, x + 1 - 7 * pitch - outer(1),
          y + 1 - 7 * pitch - outer(2), pitch - outer(3) - x};
      const auto most = std::max_element(out.begin(), out.end());
      const float share = float(std::min(std::max(*most, 0.0), 1.0));
      const double beyond = margin[most - out.begin()].beyond;
      float &level = shape.at<float>(y, x);
      level += share * (float((beyond - black) / step) - level);
    }
}

// Draws a marker with the illumination of MODULES, 0 for the mean black and 1
// for the mean white; EVENLY: the illumination is nearly even. MAP: from the
// modules to the image. Marks in USED the pixels to be compared. False if a
// side of its border does not show, as what is beside it is as dark.
bool draw(const cv::Mat &grey, const Map &map, unsigned bits,
          const Grid<double> &modules, bool evenly, cv::Mat &shape,
          cv::Mat &used, Grid<double> &contrast) {
  double white = 0.0, black = 0.0;
  int whites = 0, blacks = 0;
  for (int row = 1; row < 7; ++row)
    for (int column = 1; column < 7; ++column) {
      const bool bright = is_white(bits, row, column);
      (bright ? white : black) += modules[row][column];
      ++(bright ? whites : blacks);
    }
  white /= std::max(1, whites);
  black /= blacks;
  const double step = std::max(1.0, white - black);
  const double middle = (white + black) / 2;

  // A bright border module, or a dark module of the quiet zone, is covered or
  // absent.
  Grid<bool> seen;
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column)
      seen[row][column] =
          ring_of(row, column) > 1 ||
          (modules[row][column] > middle) == is_white(bits, row, column);

  const Light light = (evenly ? light_far : light_near)(bits, modules, seen,
                                                        black, white);
  cv::Mat dark(8, 8, CV_32F), bright(8, 8, CV_32F), pattern(8, 8, CV_8U);
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column) {
      const double from = light.black[row][column];
      const double to = light.white[row][column];
      contrast[row][column] = std::max(0.1, (to - from) / step);
      dark.at<float>(row, column) = float((from - black) / step);
      bright.at<float>(row, column) = float((to - black) / step);
      pattern.at<uchar>(row, column) = is_white(bits, row, column) ? 255 : 0;
    }
  const cv::Size size(extent, extent);
  if (evenly) {
    bright.copyTo(dark, pattern);
    cv::resize(dark, shape, size, 0, 0, cv::INTER_NEAREST);
  } else {
    cv::Mat large, mask;
    cv::resize(dark, shape, size, 0, 0, cv::INTER_LINEAR);
    cv::resize(bright, large, size, 0, 0, cv::INTER_LINEAR);
    cv::resize(pattern, mask, size, 0, 0, cv::INTER_NEAREST);
    large.copyTo(shape, mask);
  }

  const auto margin = margins(grey, map, white);
  if (std::any_of(margin.begin(), margin.end(), [&](const Margin &one) {
        return one.width < 0.1 &&
               one.width * step + one.beyond - black < -0.01 * step;
      }))
    return false;
  draw_beyond(margin, black, step, shape);

  // The outer edge of the quiet zone blurs into its surroundings.
  constexpr int rim = int(places.size()) / 2;
  used.create(extent, extent, CV_8UC1);
  used.setTo(0);
  for (int y = rim; y < points - rim; ++y)
    for (int x = rim; x < points - rim; ++x)
      if (seen[point(y) / pitch][point(x) / pitch])
        used.at<uchar>(point(y), point(x)) =
            (x + y) % 2 == 0 ? compared : read_only;
  return true;
}

// For each module, the share of its contrast in the drawing that indicates the
// opposite colour: above a half, that fits better.
Grid<double> doubts(const cv::Mat &grey, unsigned bits, const cv::Mat &used,
                    const Grid<double> &contrast, const Fit &fit) {
  // The residual, and the contribution of a module to the pixels near it.
  std::array<std::array<double, points>, points> rest{};
  const cv::Matx33f map = fit.map;
  for (int y = 0; y < points; ++y)
    for (int x = 0; x < points; x += 4) {
      Four right{float(point(x)), float(point(x + 1)), float(point(x + 2)),
                 float(point(x + 3))};
      Four down = Four{} + float(point(y));
      move(map, right, down);
      const Four seen = sample(grey, right, down);
      for (int k = 0; k < 4; ++k)
        if (used.at<uchar>(point(y), point(x + k)) &&
            in_image(grey, Point(right[k], down[k])))
          rest[y][x + k] = (seen[k] - fit.offset) / fit.contrast -
                           fit.shape.at<float>(point(y), point(x + k));
    }
  constexpr int per_module = int(places.size());
  constexpr int around = 3 * per_module;
  std::array<double, around> profile;
  const double width = std::sqrt(2.0) * std::max(0.1, fit.spread);
  double square = 0.0;  // of what a module gives
  for (int k = 0; k < around; ++k) {
    const double from = point(k) + 0.5 - pitch;  // the edge before it
    profile[k] = 0.5 * (std::erf(from / width) -
                        std::erf((from - pitch) / width));
    square += profile[k] * profile[k];
  }
  square *= square;
  Grid<double> doubt{};
  for (int column = 1; column < 7; ++column) {
    std::array<double, points> across{};
    for (int y = 0; y < points; ++y)
      for (int k = 0; k < around; ++k)
        across[y] += profile[k] * rest[y][(column - 1) * per_module + k];
    for (int row = 1; row < 7; ++row) {
      double along = 0.0;
      for (int k = 0; k < around; ++k)
        along += profile[k] * across[(row - 1) * per_module + k];
      doubt[row][column] = (is_white(bits, row, column) ? -1 : 1) * along /
                           (square * contrast[row][column]);
    }
  }
  return doubt;
}

// Whether BITS is the only possible reading.
bool is_certain(unsigned bits, const Grid<double> &doubt) {
  constexpr double doubtful = 0.3, wrong = 0.45, most = 0.12;
  double squares = 0.0;
  Grid<bool> black{};
  std::vector<unsigned> open;
  for (int row = 1; row < 7; ++row)
    for (int column = 1; column < 7; ++column) {
      squares += doubt[row][column] * doubt[row][column];
      if (ring_of(row, column) == 1) {
        black[row][column] = doubt[row][column] <= wrong;
      } else if (doubt[row][column] > wrong) {
        return false;
      } else if (doubt[row][column] > doubtful) {
        open.push_back(1u << bit_of(row, column));
      }
    }
  if (squares > 36 * most * most || !is_border(black) || open.size() > 3)
    return false;
  for (unsigned choice = 1; choice < 1u << open.size(); ++choice) {
    unsigned other = bits;
    for (std::size_t k = 0; k < open.size(); ++k)
      if (choice >> k & 1u)
        other ^= open[k];
    if (dictionary().knows(other))
      return false;
  }
  return true;
}

// The side of a square with the area of QUAD.
double size_of(const Quad &quad) {
  return std::sqrt(std::fabs(cross(quad[2] - quad[0], quad[3] - quad[1])) /
                   2);
}

// Converts QUAD to an image reduced by SCALE, and back.
Quad reduced(const Quad &quad, double scale) {
  const Point half(0.5, 0.5);
  Quad result;
  for (int k = 0; k < 4; ++k)
    result[k] = (quad[k] + half) * (1 / scale) - half;
  return result;
}

// Whether it can be a marker's outline.
bool is_sound(const Quad &quad) {
  double shortest = 1e9, longest = 0.0;
  for (int k = 0; k < 4; ++k) {
    const double side = length(quad[(k + 1) % 4] - quad[k]);
    shortest = std::min(shortest, side);
    longest = std::max(longest, side);
  }
  constexpr double smallest = 7.0;  // pixels
  return shortest >= smallest && longest < 5.0 * shortest;
}

// Whether a part of the marker is saturated, but its quiet zone is not.
bool has_spot(const Grid<double> &modules) {
  constexpr double saturated = 245.0;  // grey level, noise aside
  int within = 0, around = 0;          // of 28
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column)
      (ring_of(row, column) == 0 ? around : within) +=
          modules[row][column] >= saturated;
  return within > 0 && around < 14;
}

// Aligns the whole pattern of a marker, given its BITS: more edges than the
// outline alone, so less noise and no bias from its inside. BLUR, in pixels:
// the image's if known, on return the measured one. False if the reading is
// uncertain.
bool align_marker(const cv::Mat &grey, unsigned bits,
                  const Grid<double> &modules, bool perspective,
                  bool evenly, Quad &corner, double &blur) {
  static const Quad reference = [] {
    const double near = pitch - 0.5, far = 7 * pitch - 0.5;
    return Quad{Point(near, near), Point(far, near), Point(far, far),
                Point(near, far)};
  }();
  cv::Mat shape, used;
  Grid<double> contrast;
  if (!draw(grey, map_of(six_by_six, corner), bits, modules, evenly, shape,
            used, contrast))
    return false;
  Quad start = corner;
  if (!perspective) {
    // the nearest parallelogram
    const Point over = (start[0] - start[1] + start[2] - start[3]) / 4;
    start = {start[0] - over, start[1] + over, start[2] - over,
             start[3] + over};
  }
  Fit fit;
  fit.map = map_of(reference, start);
  fit.spread = blur * pitch * 6 / size_of(start);
  // A spot that makes it another marker has edges of its own; glare has none.
  // Of small markers, sharpening alone saturates modules.
  constexpr double small = 21.0;  // pixels a side
  const double worst =
      size_of(start) > small && has_spot(modules) ? 0.075 : 0.15;
  if (!align(grey, shape, used, perspective, worst, fit) ||
      !is_certain(bits, doubts(grey, bits, used, contrast, fit)))
    return false;
  for (int k = 0; k < 4; ++k)
    corner[k] = apply(fit.map, reference[k]);
  blur = fit.spread / pitch * size_of(corner) / 6;
  return true;
}

// Quick test with rough positions: a candidate is darker at its border than
// somewhere inside.
bool is_worth_it(const Grid<double> &modules) {
  double brightest = 0.0, darkest = 255.0;
  for (int row = 1; row < 7; ++row)
    for (int column = 1; column < 7; ++column) {
      if (ring_of(row, column) == 1)
        darkest = std::min(darkest, modules[row][column]);
      else
        brightest = std::max(brightest, modules[row][column]);
    }
  const double middle = (brightest + darkest) / 2;
  int dark = 0;
  for (const auto &module : border_modules())
    dark += modules[module[0]][module[1]] < middle;
  return brightest > darkest + 0.8 * least_contrast && dark >= 13;
}

// Pixels per side: pictograms in a box of 8 pixels were read as markers.
constexpr double least_size = 9.0;

// Reads the marker with its outline near HERE in an image reduced by SCALE:
// GREY, and SMOOTH for its edges, at most SHARE of a module away. CORNERS are
// in pixels of the original image.
bool read_marker(const cv::Mat &grey, const cv::Mat &smooth, double scale,
                 double module, double share, Quad here, double &blur,
                 Quad &corner, int &id) {
  Quad refined = here;
  if (refine(smooth, refined.data(), 4, Bright::outside,
             std::max(2.0, share * module / scale), 0.12))
    here = refined;
  const Grid<double> seen =
      read_modules(grey, map_of(six_by_six, here), module / scale);
  std::array<unsigned, 3> tried;
  int tries = 0;
  for (int k = 0; k < 3; ++k) {
    unsigned bits = 0;
    const bool done =
        k == 0   ? read_evenly(seen, bits)
        : k == 1 ? module < 5.0 && read_evenly(unmix(seen, 0.15), bits)
                 : differences().read(seen, bits);
    if (!done || !dictionary().knows(bits) ||
        std::find(tried.begin(), tried.begin() + tries, bits) !=
            tried.begin() + tries)
      continue;
    tried[tries++] = bits;
    // Even illumination, or shadows and glare
    Quad aligned = here;
    if (!align_marker(grey, bits, seen, module > 2.5, true, aligned, blur) &&
        (module < 3.5 ||
         !align_marker(grey, bits, seen, true, false, aligned, blur)))
      continue;
    aligned = reduced(aligned, 1 / scale);
    if (!is_sound(aligned) || size_of(aligned) < least_size)
      continue;
    corner = aligned;
    // A cover on part of the outline is not near it now. The outline is more
    // precise in a sharp image; its errors are not those of the bits.
    if (module > 3.5 &&
        refine(scratch.smooth, aligned.data(), 4, Bright::outside,
               std::min(std::max(1.5, 0.25 * module), 4.0), 0.12))
      for (int n = 0; n < 4; ++n)
        corner[n] = blur < 1.2 ? aligned[n] : (corner[n] + aligned[n]) / 2;
    id = dictionary().id(bits);
    // Rotates the corners so that the first is the marker's top left.
    std::rotate(corner.begin(), corner.begin() + dictionary().turns(bits),
                corner.end());
    return true;
  }
  return false;
}

// Reads the marker with its outline near CORNER, which is set to its exact
// position, its own top left corner first; BLUR as for the alignment. False if
// there is none.
bool find_marker(Quad &corner, int &id, double &blur) {
  constexpr double most = 8.0;  // pixels of a module that are enough
  const double module = size_of(corner) / 6;
  int level = 0;
  while (level + 1 < levels && module > most * (1 << level))
    ++level;
  const double scale = 1 << level;
  const cv::Mat &smooth = scratch.level[level];
  const cv::Mat &grey = module > 4.0 ? smooth : scratch.grey;

  Quad here = reduced(corner, scale);
  if (!is_worth_it(read_modules(grey, map_of(six_by_six, here),
                                module / scale)))
    return false;
  // Near edges first: edges of something brighter may follow. If a corner is
  // covered, the outline is further away.
  return read_marker(grey, smooth, scale, module, 0.45, here, blur, corner,
                     id) ||
         (module > 3.0 && read_marker(grey, smooth, scale, module, 0.75, here,
                                      blur, corner, id));
}

}  // namespace

unsigned marker_bits(int id) {
  return dictionary().words()[4 * std::size_t(id)];
}

void find_markers(Search &search, std::vector<vision_robot> &robots) {
  constexpr double enough = 14.0;  // pixels of a side that give an outline
  static thread_local std::vector<Quad> quads, small;
  const std::size_t before = robots.size();
  small.clear();

  // A marker has several candidates: outlines, and thresholds.
  std::vector<Quad> found;
  // A marker cut off by the image border is not read.
  const cv::Rect2d whole(-0.5, -0.5, scratch.smooth.cols, scratch.smooth.rows);
  const auto is_cut = [&](const Quad &quad) {
    return !std::all_of(quad.begin(), quad.end(), [&](const Point &corner) {
      return whole.contains(corner);
    });
  };
  const auto is_known = [&](const Quad &quad) {
    const Point centre = (quad[0] + quad[2]) / 2;
    return std::any_of(found.begin(), found.end(), [&](const Quad &known) {
      return depth(centre, known.data(), 4) > 0.0;
    });
  };
  const auto read = [&](Quad &corner) {
    int id = 0;
    double blur = search.blur;
    if (!is_sound(corner) || is_known(corner) ||
        !find_marker(corner, id, blur) || is_known(corner) || is_cut(corner))
      return;
    search.found_blur = blur;
    found.push_back(corner);
    const Point centre = (corner[0] + corner[2]) / 2;
    const Point direction = (corner[0] + corner[1]) / 2;
    if (in_field(search, centre))
      robots.push_back(make_robot(id, centre, direction, search));
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
  for (int pass = coarsest; pass >= -1; --pass) {
    const int level = std::max(pass, 0);
    const cv::Mat &image = scratch.level[level];
    const int window = level == 0 ? 5 : 7;
    const int darker = pass > 0 ? 4 : pass == 0 ? 2 : 5;  // grey levels
    if (level > 0 && std::min(image.cols, image.rows) < enough + window)
      continue;
    quads.clear();
    find_quads(image, window, darker, 1 << level, quads);
    for (Quad &corner : quads)
      if (level == 0 || size_of(corner) >= enough * (1 << level))
        read(corner);
      else
        small.push_back(corner);
    if (search.known > 0 && int(robots.size() - before) >= search.known)
      return;
  }
  for (Quad &corner : small)
    read(corner);
}

}  // namespace vision
