// SPDX-License-Identifier: GPL-3.0-or-later
// The search for ArUco markers: quadrilaterals are read, drawn and aligned.

#include "vision_modules.hpp"

namespace vision {

namespace {

// The drawing of a marker that is compared with the image: pixels per module,
// and the width of the quiet zone in pixels.
constexpr int pitch = 8;
constexpr int extent = 8 * pitch;

// Whether a row or column of pixels is compared: half of each module's are,
// symmetrical to its edges, so that it is not shifted.
constexpr bool is_compared(int k) {
  return 0b10100101 >> k % pitch & 1;
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
          const Grid &modules, bool evenly, cv::Mat &shape,
          cv::Mat &used, Grid &contrast) {
  double white = 0.0, black = 0.0;
  int whites = 0, blacks = 0;
  for (int row = 1; row < 7; ++row)
    for (int column = 1; column < 7; ++column) {
      const bool bright = is_white(bits, row, column);
      (bright ? white : black) += modules(row, column);
      ++(bright ? whites : blacks);
    }
  white /= std::max(1, whites);
  black /= blacks;
  const double step = std::max(1.0, white - black);
  const double middle = (white + black) / 2;

  // A bright border module, or a dark module of the quiet zone, is covered or
  // absent.
  Grid seen, pattern;
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column) {
      pattern(row, column) = is_white(bits, row, column);
      seen(row, column) =
          ring_of(row, column) > 1 ||
          (modules(row, column) > middle) == is_white(bits, row, column);
    }

  const Levels light = (evenly ? light_far : light_near)(
      pattern, modules, seen, black, white);
  for (int k = 0; k < 64; ++k)
    contrast.val[k] =
        std::max(0.1, (light.white.val[k] - light.black.val[k]) / step);
  const auto enlarged = [&](const Grid &level, int interpolation) {
    cv::Mat large;
    cv::resize(cv::Matx<float, 8, 8>(level), large, cv::Size(extent, extent),
               0, 0, interpolation);
    return large;
  };
  shape = enlarged((light.black - Grid::all(black)) * (1 / step),
                   cv::INTER_LINEAR);
  enlarged((light.white - Grid::all(black)) * (1 / step), cv::INTER_LINEAR)
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
      if (is_compared(y) && is_compared(x) &&
          seen(y / pitch, x / pitch) > 0.0)
        used.at<uchar>(y, x) = compared;
  return true;
}

// For each module, the share of its contrast in the drawing that indicates the
// opposite colour: above a half, that fits better.
Grid doubts(unsigned bits, const Grid &contrast, const Fit &fit) {
  // What a module contributes to a row or column of pixels, from a module
  // before it to one after: a blurred square.
  std::array<double, 3 * pitch> part;
  const double width = std::sqrt(2.0) * std::max(0.1, fit.spread);
  double squares = 0.0;
  for (int k = 0; k < 3 * pitch; ++k) {
    const double inside = k + 0.5 - pitch;
    part[k] = 0.5 * (std::erf(inside / width) -
                     std::erf((inside - pitch) / width));
    squares += is_compared(k) * part[k] * part[k];
  }
  const double whole = squares * squares;
  Grid doubt;
  for (const Fit::Rest &rest : fit.rest) {
    const int y = rest.at.y, x = rest.at.x;
    for (int row = y / pitch - 1; row <= y / pitch + 1; ++row)
      for (int column = x / pitch - 1; column <= x / pitch + 1; ++column)
        if (ring_of(row, column) > 0)
          doubt(row, column) += part[y - (row - 1) * pitch] *
                                part[x - (column - 1) * pitch] * rest.share;
  }
  for (int row = 1; row < 7; ++row)
    for (int column = 1; column < 7; ++column)
      doubt(row, column) *= (is_white(bits, row, column) ? -1 : 1) /
                            (whole * contrast(row, column));
  return doubt;
}

// Whether BITS is the only possible reading.
bool is_certain(unsigned bits, const Grid &doubt) {
  constexpr double doubtful = 0.3, wrong = 0.45, most = 0.12;
  double squares = 0.0;
  Grid black;
  std::vector<unsigned> open;
  for (int row = 1; row < 7; ++row)
    for (int column = 1; column < 7; ++column) {
      squares += doubt(row, column) * doubt(row, column);
      if (ring_of(row, column) == 1) {
        black(row, column) = doubt(row, column) <= wrong;
      } else if (doubt(row, column) > wrong) {
        return false;
      } else if (doubt(row, column) > doubtful) {
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

struct Marker {
  Quad corner;
  int id = 0;
  double blur = 0.0;      // of the image, pixels; 0: not known
  double distance = 0.0;  // of its alignment: Fit.distance
};

// The side of a square with the area of QUAD.
double size_of(const Quad &quad) {
  return std::sqrt(std::fabs(cross(quad[2] - quad[0], quad[3] - quad[1])) /
                   2);
}

Point centre_of(const Quad &quad) {
  return (quad[0] + quad[2]) / 2;
}

// Whether they share more than errors of their position make.
bool overlap(const Quad &one, const Quad &other) {
  constexpr double most = 0.1;  // of the smaller one
  const auto polygon = [](const Quad &quad) {
    return std::vector<cv::Point2f>(quad.begin(), quad.end());
  };
  cv::Mat common;
  const double smaller = std::min(size_of(one), size_of(other));
  return cv::intersectConvexConvex(polygon(one), polygon(other), common) >
         most * smaller * smaller;
}

// Converts QUAD to an image reduced by SCALE, and back.
Quad reduced(const Quad &quad, double scale) {
  const Point half(0.5, 0.5);
  Quad result;
  for (int k = 0; k < 4; ++k)
    result[k] = (quad[k] + half) * (1 / scale) - half;
  return result;
}

constexpr Side outline{1.0, 0.12};  // black within white

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

// Aligns the whole pattern of a marker, given its BITS: more edges than the
// outline alone, so less noise and no bias from its inside. False if the
// reading is uncertain.
bool align_marker(const cv::Mat &grey, unsigned bits, const Grid &modules,
                  bool perspective, bool evenly, Marker &marker) {
  static const Quad reference = [] {
    const double near = pitch - 0.5, far = 7 * pitch - 0.5;
    return Quad{Point(near, near), Point(far, near), Point(far, far),
                Point(near, far)};
  }();
  cv::Mat shape, used;
  Grid contrast;
  Quad start = marker.corner;
  if (!draw(grey, map_of(six_by_six, start), bits, modules, evenly, shape,
            used, contrast))
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
      size_of(start) > small && has_spot(modules) ? 0.075 : 0.15;
  // Edges of small markers overshoot; more is no black and white.
  constexpr double brightest = 300.0;
  if (!align(grey, shape, used, perspective, worst, fit) ||
      fit.contrast > brightest ||
      !is_certain(bits, doubts(bits, contrast, fit)))
    return false;
  for (int k = 0; k < 4; ++k)
    marker.corner[k] = apply(fit.map, reference[k]);
  marker.blur = fit.spread / pitch * size_of(marker.corner) / 6;
  marker.distance = fit.distance;
  return true;
}

// Quick test with rough positions: a candidate is darker at its border than
// somewhere inside.
bool is_worth_it(const Grid &modules) {
  double brightest = 0.0;
  std::vector<double> border;
  for (int row = 1; row < 7; ++row)
    for (int column = 1; column < 7; ++column)
      if (ring_of(row, column) == 1)
        border.push_back(modules(row, column));
      else
        brightest = std::max(brightest, modules(row, column));
  std::sort(border.begin(), border.end());
  return brightest > border[0] + 0.8 * least_contrast &&
         border[12] < (brightest + border[0]) / 2;
}

// Pixels per side: pictograms in a box of 8 pixels were read as markers.
constexpr double least_size = 9.0;

// Reads the marker with its outline near MARKER.corner, which is set to its
// exact position, its own top left corner first. False if there is none.
bool find_marker(Marker &marker) {
  constexpr double most = 8.0;  // pixels of a module that are enough
  const double module = size_of(marker.corner) / 6;
  int level = 0;
  while (level + 1 < levels && module > most * (1 << level))
    ++level;
  const double scale = 1 << level;
  const cv::Mat &smooth = scratch.level[level];
  const cv::Mat &grey = module > 4.0 ? smooth : scratch.grey;
  const auto look = [&](const Quad &quad) {
    return read_modules(grey, map_of(six_by_six, quad), module / scale);
  };
  const Quad rough = reduced(marker.corner, scale);
  if (!is_worth_it(look(rough)))
    return false;
  // Near edges first: edges of something brighter may follow. If a corner is
  // covered, the outline is further away.
  for (const double share : {0.45, 0.75}) {
    if (share > 0.5 && module <= 3.0)
      break;
    Quad here = rough;
    if (!refine(smooth, here.data(), 4, outline,
                std::max(2.0, share * module / scale)))
      here = rough;
    const Grid seen = look(here);
    std::vector<unsigned> tried;
    for (const auto bits_of : {read_evenly, read_unmixed, read_unevenly}) {
      unsigned bits = 0;
      if ((bits_of == read_unmixed && module >= 5.0) || !bits_of(seen, bits) ||
          !dictionary().knows(bits) ||
          std::find(tried.begin(), tried.end(), bits) != tried.end())
        continue;
      tried.push_back(bits);
      // Even illumination, or shadows and glare
      Marker read = marker;
      read.corner = here;
      if (!align_marker(grey, bits, seen, module > 2.5, true, read) &&
          (module < 3.5 || !align_marker(grey, bits, seen, true, false, read)))
        continue;
      Quad aligned = reduced(read.corner, 1 / scale);
      if (!is_sound(aligned) || size_of(aligned) < least_size)
        continue;
      marker = read;
      Quad &corner = marker.corner = aligned;
      // A cover on part of the outline is not near it now. The outline is more
      // precise in a sharp image; its errors are not those of the bits.
      if (module > 3.5 &&
          refine(scratch.smooth, aligned.data(), 4, outline,
                 std::min(std::max(1.5, 0.25 * module), 4.0)))
        for (int n = 0; n < 4; ++n)
          corner[n] =
              read.blur < 1.2 ? aligned[n] : (corner[n] + aligned[n]) / 2;
      marker.id = dictionary().id(bits);
      // Rotates the corners so that the first is the marker's top left.
      std::rotate(corner.begin(), corner.begin() + dictionary().turns(bits),
                  corner.end());
      return true;
    }
  }
  return false;
}

}  // namespace

void find_markers(Search &search, std::vector<vision_robot> &robots) {
  constexpr double enough = 14.0;  // pixels of a side that give an outline
  static thread_local std::vector<Quad> quads, small;
  small.clear();

  // A marker has several candidates: outlines, and thresholds.
  std::vector<Marker> found;
  // A marker cut off by the image border is not read.
  const cv::Rect2d whole(-0.5, -0.5, scratch.smooth.cols, scratch.smooth.rows);
  const auto is_cut = [&](const Quad &quad) {
    return !std::all_of(quad.begin(), quad.end(), [&](const Point &corner) {
      return whole.contains(corner);
    });
  };
  const auto is_known = [&](const Quad &quad) {
    return std::any_of(found.begin(), found.end(), [&](const Marker &known) {
      return depth(centre_of(quad), known.corner.data(), 4) > 0.0;
    });
  };
  const auto read = [&](const Quad &corner) {
    Marker marker{corner, 0, search.blur, 0.0};
    if (!is_sound(corner) || is_known(corner) || !find_marker(marker) ||
        is_cut(marker.corner))
      return;
    // Of markers that overlap, only the one that fits best is there.
    const auto first = std::partition(
        found.begin(), found.end(), [&](const Marker &other) {
          return !overlap(other.corner, marker.corner);
        });
    if (std::any_of(first, found.end(), [&](const Marker &other) {
          return other.distance <= marker.distance;
        }))
      return;
    found.erase(first, found.end());
    found.push_back(marker);
  };
  const auto is_in_field = [&](const Marker &marker) {
    return in_field(search, centre_of(marker.corner));
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
  bool is_enough = false;
  for (int pass = coarsest; pass >= -1 && !is_enough; --pass) {
    const int level = std::max(pass, 0);
    const cv::Mat &image = scratch.level[level];
    const int window = level == 0 ? 5 : 7;
    const int darker = pass > 0 ? 4 : pass == 0 ? 2 : 5;  // grey levels
    if (level > 0 && std::min(image.cols, image.rows) < enough + window)
      continue;
    if (pass >= 0) {
      cv::blur(image, scratch.darker, cv::Size(window, window),
               cv::Point(-1, -1), cv::BORDER_REPLICATE);
      cv::subtract(scratch.darker, image, scratch.darker);
    }
    quads.clear();
    find_quads(darker, 1 << level, quads);
    for (Quad &corner : quads)
      if (level == 0 || size_of(corner) >= enough * (1 << level))
        read(corner);
      else
        small.push_back(corner);
    is_enough = search.known > 0 &&
                std::count_if(found.begin(), found.end(), is_in_field) >=
                    search.known;
  }
  if (!is_enough)
    std::for_each(small.begin(), small.end(), read);
  for (const Marker &marker : found) {
    search.found_blur = marker.blur;
    if (is_in_field(marker))
      robots.push_back(make_robot(
          marker.id, centre_of(marker.corner),
          (marker.corner[0] + marker.corner[1]) / 2, search));
  }
}

}  // namespace vision
