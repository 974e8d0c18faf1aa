// SPDX-License-Identifier: GPL-3.0-or-later
// The modules of a marker: the dictionary, what is read, and the drawing that
// is aligned with the image.

#include "vision_modules.hpp"

#if CV_VERSION_MAJOR > 4 || (CV_VERSION_MAJOR == 4 && CV_VERSION_MINOR >= 7)
#define VISION_ARUCO_IN_OBJDETECT
#include <opencv2/objdetect/aruco_detector.hpp>
#else
#include <opencv2/aruco.hpp>
#endif

namespace vision {

namespace {

constexpr double least_contrast = 10.0;  // grey levels

// How far a module is inside; 0: in the quiet zone.
int ring_of(int row, int column) {
  return std::min(std::min(row, column), std::min(7 - row, 7 - column));
}

// The modules of the marker itself.
const Grid own = [] {
  Grid inside;
  for (int k = 0; k < 36; ++k)
    inside(1 + k / 6, 1 + k % 6) = 1.0;
  return inside;
}();

// Those that are white in the marker with BITS.
Grid pattern_of(unsigned bits) {
  Grid white = Grid::all(1) - own;
  for (int bit = 0; bit < 16; ++bit)
    white(2 + bit / 4, 2 + bit % 4) = bits >> bit & 1u;
  return white;
}

// Those of its black border.
const Grid border = own.mul(Grid::all(1) - pattern_of(0xffff));

// The marker in module coordinates, from its top left corner.
const Quad six_by_six{Point(0, 0), Point(6, 0), Point(6, 6), Point(0, 6)};

// The weights of modules along a row or column, by their distance; SHIFT is
// added to it.
Grid nearness(double spread, double shift = 0.0) {
  Grid weight;
  for (int i = 0; i < 8; ++i)
    for (int k = 0; k < 8; ++k)
      weight(i, k) = std::exp(-0.5 * std::pow((i - k - shift) / spread, 2));
  return weight;
}

// Reverses the optical crosstalk between neighbouring modules.
Grid unmix(const Grid &seen) {
  constexpr double share = 0.15;  // of a neighbour's light in each
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

// Whether the border is dark, except for a few modules that may be covered:
// otherwise it is no marker.
bool is_border(const Grid &bright) {
  constexpr int most_hidden = 4;
  return border.dot(bright) <= most_hidden;
}

// The drawing of a marker that is compared with the image: pixels per module,
// and the width of the quiet zone in pixels.
constexpr int pitch = 8;
constexpr int extent = 8 * pitch;

// Whether a row or column of pixels is compared: half of each module's are,
// symmetrical to its edges, so that it is not shifted.
constexpr bool is_compared(int k) {
  return 0b10100101 >> k % pitch & 1;
}

// Levels of black and white at each module.
struct Levels {
  Grid black, white;
};

// Black is interpolated from the modules within about SPREAD that are SEEN, as
// if they were black; BRIGHT: those that are white. The contrast to white
// varies slowly.
Levels light(double spread, const Grid &bright, const Grid &modules,
             const Grid &seen, double black, double white) {
  static const Grid next = [] {  // moves each module to the one before
    Grid shift;
    for (int k = 0; k < 7; ++k)
      shift(k + 1, k) = 1.0;
    return shift;
  }();
  // Of two adjacent modules of which one is white: the difference.
  const auto steps = [](const Grid &colour, const Grid &level,
                        const Grid &visible, Grid &value, Grid &used) {
    const Grid turn = colour * next - colour;
    const Grid both = turn.mul(visible).mul(visible * next);
    used = turn.mul(both);
    value = (level * next - level).mul(both);
  };
  Grid value, used, value_down, used_down;
  steps(bright, modules, seen, value, used);
  steps(bright.t(), modules.t(), seen.t(), value_down, used_down);
  constexpr double little = 0.02, least = 0.001;  // if nothing else is nearby
  const Grid near = nearness(spread), wide = nearness(2.2 * spread),
             half = nearness(2.2 * spread, 0.5);
  const Grid step =
      (wide * value * half.t() + half * value_down.t() * wide +
       Grid::all(little * (white - black)))
          .div(wide * used * half.t() + half * used_down.t() * wide +
               Grid::all(little));
  const Grid dark = (near * (modules - bright.mul(step)).mul(seen) * near +
                     Grid::all(least * black))
                        .div(near * seen * near + Grid::all(least));
  return {dark, dark + step};
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

// Whether a part of the marker is saturated, but its quiet zone is not.
bool has_spot(const Grid &modules) {
  constexpr double saturated = 245.0;  // grey level, noise aside
  Grid bright;
  for (int k = 0; k < 64; ++k)
    bright.val[k] = modules.val[k] >= saturated;
  return own.dot(bright) > 0 && (Grid::all(1) - own).dot(bright) < 14;
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

// Draws the marker with PATTERN in the light of MODULES, 0 for the mean black
// and 1 for the mean white; SPREAD: as for light. MAP: from the modules to the
// image. Marks in USED the pixels to be compared. False if a side of its
// border does not show, as what is beside it is as dark.
bool draw(const cv::Mat &grey, const Map &map, const Grid &pattern,
          const Grid &modules, double spread, cv::Mat &shape,
          cv::Mat &used) {
  const Grid bright = own.mul(pattern), dark = own - bright;
  const double white = bright.dot(modules) / std::max(1.0, own.dot(bright));
  const double black = dark.dot(modules) / own.dot(dark);
  const double step = std::max(1.0, white - black);

  // A bright border module, or a dark module of the quiet zone, is covered or
  // absent.
  Grid seen;
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column)
      seen(row, column) =
          ring_of(row, column) > 1 ||
          (modules(row, column) > (white + black) / 2) ==
              (pattern(row, column) > 0);

  const Levels level = light(spread, pattern, modules, seen, black, white);
  const auto enlarged = [&](const Grid &one, int interpolation) {
    cv::Mat large;
    cv::resize(cv::Matx<float, 8, 8>(one), large, cv::Size(extent, extent),
               0, 0, interpolation);
    return large;
  };
  shape = enlarged((level.black - Grid::all(black)) * (1 / step),
                   cv::INTER_LINEAR);
  enlarged((level.white - Grid::all(black)) * (1 / step), cv::INTER_LINEAR)
      .copyTo(shape, enlarged(pattern, cv::INTER_NEAREST) > 0.5);

  const auto margin = margins(grey, map, white);
  if (std::any_of(margin.begin(), margin.end(), [&](const Margin &one) {
        return one.width < 0.1 &&
               one.width * step + one.beyond - black < -0.01 * step;
      }))
    return false;
  draw_beyond(margin, black, step, shape);

  // The outer edge of the quiet zone blurs into its surroundings.
  constexpr int rim = 5;
  used = cv::Mat::zeros(extent, extent, CV_8UC1);
  for (int y = rim; y < extent - rim; ++y)
    for (int x = rim; x < extent - rim; ++x)
      used.at<uchar>(y, x) = is_compared(y) && is_compared(x) &&
                             seen(y / pitch, x / pitch) > 0.0;
  return true;
}

// For each module, the share of the contrast that indicates the opposite
// colour: above a half, that fits better.
Grid doubts(const Grid &pattern, const Fit &fit) {
  // What a module adds to a row or column of pixels: a blurred square
  cv::Mat_<float> part(extent, 8);
  const double width = std::sqrt(2.0) * std::max(0.1, fit.spread);
  double squares = 0.0;
  for (int k = 0; k < extent; ++k) {
    for (int module = 0; module < 8; ++module) {
      const double inside = k + 0.5 - pitch * module;
      part(k, module) = float(0.5 * (std::erf(inside / width) -
                                     std::erf((inside - pitch) / width)));
    }
    squares += is_compared(k) * part(k, 3) * part(k, 3);
  }
  const Grid share = cv::Mat(part.t() * fit.rest * part);
  return share.mul(Grid::all(1) - 2 * pattern) * (1 / (squares * squares));
}

// Whether BITS is the only possible reading.
bool is_certain(unsigned bits, const Grid &doubt) {
  constexpr double doubtful = 0.3, wrong = 0.45, most = 0.12;
  Grid bright;
  unsigned open = 0;
  for (int row = 1; row < 7; ++row)
    for (int column = 1; column < 7; ++column)
      if (ring_of(row, column) == 1)
        bright(row, column) = doubt(row, column) > wrong;
      else if (doubt(row, column) > wrong)
        return false;
      else if (doubt(row, column) > doubtful)
        open |= 1u << (4 * (row - 2) + column - 2);
  const std::vector<unsigned> &words = dictionary().words;
  return own.dot(doubt.mul(doubt)) <= 36 * most * most && is_border(bright) &&
         std::none_of(words.begin(), words.end(), [&](unsigned other) {
           return other != bits && ((other ^ bits) & ~open) == 0;
         });
}

}  // namespace

Dictionary::Dictionary() : meaning(1 << 16, -1) {
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
      words.push_back(bits);
      cv::rotate(modules, modules, cv::ROTATE_90_CLOCKWISE);
    }
  }
}

const Dictionary &dictionary() {
  static const Dictionary known;
  return known;
}

unsigned marker_bits(int id) {
  return dictionary().words[4 * std::size_t(id)];
}

Grid read_modules(const cv::Mat &grey, const Quad &corner) {
  const int samples =
      std::min(std::max(cvRound(0.6 * size_of(corner) / 6), 1), 4);
  const cv::Matx33f single = map_of(six_by_six, corner);
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

bool is_worth_it(const Grid &modules) {
  const cv::Mat all(modules);
  double darkest = 0.0, brightest = 0.0;
  cv::minMaxLoc(all(cv::Rect(1, 1, 6, 6)), &darkest);
  cv::minMaxLoc(all(cv::Rect(2, 2, 4, 4)), nullptr, &brightest);
  return brightest > darkest + 0.8 * least_contrast &&
         border.dot(modules) / 20 < (brightest + darkest) / 2;
}

// The threshold that separates the levels best (Otsu 1979).
bool read_evenly(const Grid &modules, unsigned &bits) {
  cv::Mat level, white;
  const cv::Mat all(unmix(modules));
  all(cv::Rect(1, 1, 6, 6)).convertTo(level, CV_8U);
  cv::threshold(level, white, 0, 255, cv::THRESH_OTSU);
  if (cv::mean(level, white)[0] - cv::mean(level, ~white)[0] < least_contrast)
    return false;
  Grid bright;
  bits = 0;
  for (int row = 1; row < 7; ++row)
    for (int column = 1; column < 7; ++column) {
      bright(row, column) = white.at<uchar>(row - 1, column - 1) != 0;
      if (ring_of(row, column) > 1 && bright(row, column) > 0)
        bits |= 1u << (4 * (row - 2) + column - 2);
    }
  return is_border(bright);
}

// Compares by differences: illumination is nearly equal for adjacent modules.
// Of the 36 modules, each one's difference from the mean around it is
// compared. The result is the most similar marker; none, if another one is
// nearly as similar.
bool read_unevenly(const Grid &modules, unsigned &bits) {
  constexpr double like = 0.75;   // the cosine between both, at least
  constexpr double apart = 0.75;  // its sine, as a share of the next one's
  static const std::vector<unsigned> &words = dictionary().words;
  static const Grid near = nearness(1.0), total = near * own * near;
  const auto differences = [](const Grid &level) -> Grid {
    return (level - (near * level.mul(own) * near).div(total)).mul(own);
  };
  static const std::vector<double> shares = [&] {  // 1 / length, of each ID
    std::vector<double> all;
    for (std::size_t k = 0; k < words.size(); k += 4)
      all.push_back(1 / cv::norm(differences(pattern_of(words[k]))));
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

bool align_marker(const cv::Mat &grey, unsigned bits, const Grid &modules,
                  bool perspective, double spread, Marker &marker) {
  static const Quad reference = [] {
    const double near = pitch - 0.5, far = 7 * pitch - 0.5;
    return Quad{Point(near, near), Point(far, near), Point(far, far),
                Point(near, far)};
  }();
  cv::Mat shape, used;
  const Grid pattern = pattern_of(bits);
  Quad start = marker.corner;
  if (!draw(grey, map_of(six_by_six, start), pattern, modules, spread, shape,
            used))
    return false;
  if (!perspective) {
    // the nearest parallelogram
    const Point over = (start[0] - start[1] + start[2] - start[3]) / 4;
    start = {start[0] - over, start[1] + over, start[2] - over,
             start[3] + over};
  }
  Fit fit;
  fit.map = map_of(reference, start);
  fit.spread = marker.blur * pitch * 6 / size_of(start);
  // A spot that makes it another marker has edges of its own; glare has none.
  // Of small markers, sharpening alone saturates modules.
  constexpr double small = 21.0;  // pixels a side
  const double worst =
      size_of(start) > small && has_spot(modules) ? 0.075 : 0.12;
  // Edges of small markers overshoot; more is no black and white.
  constexpr double brightest = 300.0;
  if (!align(grey, shape, used, perspective, worst, fit) ||
      fit.contrast > brightest ||
      !is_certain(bits, doubts(pattern, fit)))
    return false;
  for (int k = 0; k < 4; ++k)
    marker.corner[k] = apply(fit.map, reference[k]);
  marker.blur = fit.spread / pitch * size_of(marker.corner) / 6;
  marker.distance = fit.distance;
  return true;
}

}  // namespace vision
