// SPDX-License-Identifier: GPL-3.0-or-later
// The searches: arena and robots. Each finds its outline roughly, then moves
// the sides onto the edges in the image with sub-pixel precision.

#include "vision_internal.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <opencv2/imgproc.hpp>

#if CV_VERSION_MAJOR > 4 || (CV_VERSION_MAJOR == 4 && CV_VERSION_MINOR >= 7)
#define VISION_ARUCO_IN_OBJDETECT
#include <opencv2/objdetect/aruco_detector.hpp>
#else
#include <opencv2/aruco.hpp>
#endif

namespace vision {

namespace {

using Point = cv::Point2d;

// Images that a search makes on its way; none outlasts it.
struct Scratch {
  cv::Mat grey, smooth, small, gradient, transposed, mask, tiles;
};

thread_local Scratch scratch;

// ---------------------------------------------------------------- Geometry

double cross(const Point &a, const Point &b) {
  return a.x * b.y - a.y * b.x;
}

double length(const Point &a) {
  return std::hypot(a.x, a.y);
}

struct Line {
  Point through, along;  // ALONG has length 1
};

bool intersect(const Line &a, const Line &b, Point &point) {
  const double sine = cross(a.along, b.along);
  if (std::fabs(sine) < 0.05)
    return false;
  point = a.through +
          a.along * (cross(b.through - a.through, b.along) / sine);
  return true;
}

// How far POINT lies inside a convex polygon given clockwise as the image
// shows it; negative outside.
double depth(const Point &point, const Point *corner, int count) {
  double least = 1e9;
  for (int k = 0; k < count; ++k) {
    const Point side = corner[(k + 1) % count] - corner[k];
    least = std::min(least, cross(side, point - corner[k]) /
                                std::max(1e-9, length(side)));
  }
  return least;
}

double sample(const cv::Mat &grey, const Point &at) {
  const int column = std::min(std::max(int(at.x), 0), grey.cols - 2);
  const int row = std::min(std::max(int(at.y), 0), grey.rows - 2);
  const double u = std::min(std::max(at.x - column, 0.0), 1.0);
  const double v = std::min(std::max(at.y - row, 0.0), 1.0);
  const uchar *const above = grey.ptr<uchar>(row) + column;
  const uchar *const below = grey.ptr<uchar>(row + 1) + column;
  return (1 - v) * ((1 - u) * above[0] + u * above[1]) +
         v * ((1 - u) * below[0] + u * below[1]);
}

bool in_image(const cv::Mat &grey, const Point &at) {
  return at.x >= 0 && at.y >= 0 && at.x <= grey.cols - 1 &&
         at.y <= grey.rows - 1;
}

// -------------------------------------------------------------- Refinement

// Which side of an outline is the brighter one.
enum class Bright { outside, inside };

struct Edge {
  double along, across;  // where on its side, and how far outside of it
};

// Where the outline is along the side FROM .. TO, in bands: the profiles
// across the side are averaged over a band, which takes noise off.
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
  std::array<double, most> value, rise;

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
    for (int i = -half; i <= half; ++i) {
      double sum = 0.0;
      for (int line = 0; line < lines; ++line)
        sum += sample(grey, from + along * place(line + 0.5) +
                                outward * (i * step));
      value[i + half] = sum / lines;
    }
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
      // Squared: what is near the edge counts, not what lies beside it.
      const double share = std::max(0.0, rise[i]) * std::max(0.0, rise[i]);
      weight += share;
      moment += share * i;
    }
    edges.push_back({place(0.5 * lines), (moment / weight - half) * step});
  }
}

// Fits a line to the edges of one side; those that do not belong to it (a
// robot stands there) lose their weight. False where too few are left.
bool fit_line(const std::vector<Edge> &edges, const Point &from,
              const Point &to, Line &line) {
  constexpr double width = 0.7;  // pixels of distance that halve a weight
  double offset = 0.0, slope = 0.0, total = 0.0;
  if (edges.size() < 4)
    return false;
  for (int round = 0; round < 12; ++round) {
    double w = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const Edge &edge : edges) {
      // At first every edge counts, then more and more the near ones.
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

// Moves the corners of a convex polygon, clockwise as the image shows it,
// so that its sides lie on edges of the image at most REACH pixels away; the
// share END of a side is left out at each end. False where a side has none.
bool refine(const cv::Mat &grey, Point *corner, int count, Bright bright,
            double reach, double end) {
  std::array<Line, 4> line;
  std::vector<Edge> edges;
  for (const double distance : {reach, std::max(3.0, reach / 2)}) {
    for (int k = 0; k < count; ++k) {
      const Point &from = corner[k], &to = corner[(k + 1) % count];
      if (length(to - from) < 8.0)
        return false;
      find_edges(grey, from, to, bright, distance, end, edges);
      if (!fit_line(edges, from, to, line[k]))
        return false;
    }
    for (int k = 0; k < count; ++k)
      if (!intersect(line[(k + count - 1) % count], line[k], corner[k]))
        return false;
  }
  return true;
}

// --------------------------------------------------------------- Alignment

// From the pixels of a drawn shape to those of the image.
using Map = cv::Matx23d;

Point apply(const Map &map, const Point &p) {
  return {map(0, 0) * p.x + map(0, 1) * p.y + map(0, 2),
          map(1, 0) * p.x + map(1, 1) * p.y + map(1, 2)};
}

// The map that takes three points FROM to three points TO.
bool map_of(const Point *from, const Point *to, Map &map) {
  const cv::Matx33d sources(from[0].x, from[1].x, from[2].x,
                            from[0].y, from[1].y, from[2].y, 1, 1, 1);
  const cv::Matx23d images(to[0].x, to[1].x, to[2].x,
                           to[0].y, to[1].y, to[2].y);
  if (std::fabs(cv::determinant(sources)) < 1e-9)
    return false;
  map = images * sources.inv();
  return true;
}

// A pixel of a shape: where it is, how bright, and what brightness gains by a
// change of each parameter of its map to the image, of offset and contrast.
struct Pixel {
  double x, y, value;
  std::array<double, 8> gain;
};

// The pixels of SHAPE (float, 0 .. 1) that USED marks and MAP has in the
// image, every second in each direction.
void choose_pixels(const cv::Mat &grey, const cv::Mat &shape,
                   const cv::Mat &used, const Map &map,
                   std::vector<Pixel> &pixels) {
  constexpr int stride = 2;
  pixels.clear();
  for (int y = 1; y < shape.rows - 1; y += stride)
    for (int x = 1; x < shape.cols - 1; x += stride) {
      if (!used.at<uchar>(y, x) || !in_image(grey, apply(map, Point(x, y))))
        continue;
      const double dx =
          (shape.at<float>(y, x + 1) - shape.at<float>(y, x - 1)) / 2;
      const double dy =
          (shape.at<float>(y + 1, x) - shape.at<float>(y - 1, x)) / 2;
      const double value = shape.at<float>(y, x);
      pixels.push_back({double(x), double(y), value,
                        {dx * x, dx * y, dx, dy * x, dy * y, dy, 1.0, value}});
    }
}

// Moves MAP so that SHAPE (float, 0 .. 1) lies on its image best, by least
// squares (Gauss-Newton) over the pixels that USED marks; contrast and
// brightness are fitted with it. DISTANCE is what remains, grey levels over
// contrast. False where the shape slips away, or where more than MOST remains
// after the first step, which is the largest by far.
//
// The steps are taken in the shape's own coordinates: there the gradients,
// and so the normal equations, are the same in every round.
bool align(const cv::Mat &grey, const cv::Mat &shape, const cv::Mat &used,
           double most, Map &map, double &distance) {
  using Normal = cv::Matx<double, 8, 8>;
  constexpr int rounds = 8;
  constexpr double enough = 1e-4;  // pixels of the image
  static thread_local std::vector<Pixel> pixels;
  const Map start = map;
  const Point extent(shape.cols, shape.rows);
  double offset = 0.0, contrast = 0.0;

  choose_pixels(grey, shape, used, map, pixels);
  if (pixels.size() < 64)
    return false;
  Normal normal = Normal::zeros();
  for (const Pixel &pixel : pixels)
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j <= i; ++j)
        normal(i, j) += pixel.gain[i] * pixel.gain[j];
  for (int i = 0; i < 8; ++i)
    for (int j = i + 1; j < 8; ++j)
      normal(i, j) = normal(j, i);
  bool solved = false;
  const Normal inverse = normal.inv(cv::DECOMP_CHOLESKY, &solved);
  const double number = normal(6, 6), sum = normal(6, 7);
  const double spread = number * normal(7, 7) - sum * sum;
  if (!solved || spread <= 0.0)
    return false;

  for (int round = 0; round < rounds; ++round) {
    std::array<double, 8> right{};
    double squares = 0.0;
    for (const Pixel &pixel : pixels) {
      const double rest =
          sample(grey, apply(map, Point(pixel.x, pixel.y))) - offset -
          contrast * pixel.value;
      for (int i = 0; i < 8; ++i)
        right[i] += pixel.gain[i] * rest;
      squares += rest * rest;
    }
    distance = std::sqrt(squares / number) / std::max(1.0, contrast);
    if (round > 1 && distance > most)
      return false;
    if (round == 0) {
      // Brightness and contrast first: without them there is no gradient.
      offset = (normal(7, 7) * right[6] - sum * right[7]) / spread;
      contrast = (number * right[7] - sum * right[6]) / spread;
      if (contrast < 1.0)
        return false;
      continue;
    }
    std::array<double, 8> change{};
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j < 8; ++j)
        change[i] += inverse(i, j) * right[j];
    // What is to be moved in the shape is to be moved back in the image.
    const Map before = map;
    for (int row = 0; row < 2; ++row)
      for (int column = 0; column < 3; ++column)
        map(row, column) -= (before(row, 0) * change[column] +
                             before(row, 1) * change[3 + column]) /
                            contrast;
    offset += change[6];
    contrast += change[7];
    if (contrast < 1.0 ||
        map(0, 0) * map(1, 1) - map(0, 1) * map(1, 0) < 1e-4)
      return false;
    if (length(apply(map, extent) - apply(before, extent)) < enough &&
        length(apply(map, Point()) - apply(before, Point())) < enough)
      break;
  }

  return contrast > 20.0 &&
         length(apply(map, extent) - apply(start, extent)) < 4.0 &&
         length(apply(map, Point()) - apply(start, Point())) < 4.0;
}

// Moves three CORNERs, which REFERENCE are in SHAPE (8-bit, sharp), to where
// the shape lies in the image best. How sharp the image is is tried out, until
// it gets worse: the less sharp shapes behind fit worse still.
bool align(const cv::Mat &grey, const cv::Mat &shape, const cv::Mat &used,
           const Point *reference, Point *corner) {
  constexpr double none = 1e9;
  Map start, best;
  double least = none;
  if (!map_of(reference, corner, start))
    return false;
  const double scale = std::sqrt(std::fabs(
      start(0, 0) * start(1, 1) - start(0, 1) * start(1, 0)));
  if (scale < 1e-3)
    return false;
  cv::Mat blurred;
  for (const double sigma : {0.9, 1.4, 2.2}) {  // pixels of the image
    Map map = start;
    double distance = 0.0;
    shape.convertTo(blurred, CV_32F, 1.0 / 255.0);
    cv::GaussianBlur(blurred, blurred, cv::Size(), sigma / scale, 0.0,
                     cv::BORDER_REPLICATE);
    if (align(grey, blurred, used, 1.5 * least, map, distance) &&
        distance < least) {
      least = distance;
      best = map;
    } else if (least < none) {
      break;
    }
  }
  if (least > 0.15)
    return false;
  for (int k = 0; k < 3; ++k)
    corner[k] = apply(best, reference[k]);
  return true;
}

// ------------------------------------------------------------------- Arena

constexpr int small_side = 320;      // pixels, of the image searched
constexpr double steepest = 20.0;    // degrees that a side may be off
constexpr double border_share = 3.0 / 80.0;  // border over field width

// A side of the arena, nearly horizontal in its image: its height at the
// left and right edge, and how many points of the image say so.
struct Rim {
  double left, right;
  double votes;

  double at(double x, double width) const {
    return left + (right - left) * x / width;
  }
};

// The strongest nearly horizontal edges of an image, given its vertical
// GRADIENT and the SLOPE that makes an edge: those that get brighter upwards
// (UP) or downwards.
std::vector<Rim> find_rims(const cv::Mat &gradient, bool up, double slope,
                           cv::Mat &mask) {
  constexpr std::size_t most = 6;
  cv::compare(gradient, up ? -slope : slope, mask,
              up ? cv::CMP_LT : cv::CMP_GT);
  const double width = mask.cols - 1;
  std::vector<cv::Vec3f> lines;
  cv::HoughLines(mask, lines, 1.0, CV_PI / 180.0, mask.cols / 5, 0, 0,
                 (90.0 - steepest) * CV_PI / 180.0,
                 (90.0 + steepest) * CV_PI / 180.0);
  std::vector<Rim> rims;
  for (const cv::Vec3f &line : lines) {
    const double cosine = std::cos(line[1]), sine = std::sin(line[1]);
    const Rim rim{line[0] / sine, (line[0] - width * cosine) / sine, line[2]};
    const bool known =
        std::any_of(rims.begin(), rims.end(), [&](const Rim &other) {
          return std::fabs(rim.left - other.left) < 8.0 &&
                 std::fabs(rim.right - other.right) < 8.0;
        });
    if (!known)
      rims.push_back(rim);
    if (rims.size() == most)
      break;
  }
  return rims;
}

// Whether four corners can be those of a 4:3 field seen from above.
bool is_field(const cv::Mat &image, const Point *corner) {
  std::array<double, 4> side;
  for (int k = 0; k < 4; ++k) {
    const Point &here = corner[k], &next = corner[(k + 1) % 4];
    const Point after = corner[(k + 2) % 4] - next;
    side[k] = length(next - here);
    if (here.x < -2 || here.y < -2 || here.x > image.cols + 1 ||
        here.y > image.rows + 1 || side[k] < 8.0)
      return false;
    const double sine =
        cross(next - here, after) / (side[k] * std::max(1e-9, length(after)));
    if (sine < 0.96)  // within 16 degrees of a right angle
      return false;
  }
  const double width = (side[0] + side[2]) / 2;
  const double height = (side[1] + side[3]) / 2;
  const double largest = std::max(image.cols, image.rows);
  return width > 0.2 * largest && width / height > 1.17 &&
         width / height < 1.51 && std::fabs(side[0] - side[2]) < 0.2 * width &&
         std::fabs(side[1] - side[3]) < 0.2 * height;
}

// How well a border shows along each side: the share of it that is brighter
// outside than inside. The sum over the sides, 0 where one side has none.
double border_support(const cv::Mat &image, const Point *corner) {
  constexpr int samples = 48;
  const double distance =
      std::max(2.0, 0.6 * border_share * length(corner[1] - corner[0]));
  double sum = 0.0;
  for (int k = 0; k < 4; ++k) {
    const Point side = corner[(k + 1) % 4] - corner[k];
    const Point along = side / length(side);
    const Point outward(along.y, -along.x);
    int seen = 0, bright = 0;
    for (int n = 0; n < samples; ++n) {
      const Point at = corner[k] + side * ((n + 1.5) / (samples + 2));
      if (!in_image(image, at + outward * distance))
        continue;
      ++seen;
      const double inside = sample(image, at - outward * distance);
      const double outside = sample(image, at + outward * distance);
      if (outside > 1.2 * inside + 4.0)
        ++bright;
    }
    // Robots may hide a part of a side, the image may end before another.
    if (seen < samples / 2 || bright < 0.5 * seen)
      return 0.0;
    sum += double(bright) / seen;
  }
  return sum;
}

Line as_line(const Rim &rim, double width, bool transposed) {
  Point from(0.0, rim.left), to(width, rim.right);
  if (transposed) {
    std::swap(from.x, from.y);
    std::swap(to.x, to.y);
  }
  return {from, (to - from) / length(to - from)};
}

// The arena in SMALL, to a pixel or two.
bool find_outline(const cv::Mat &small, Point *corner) {
  cv::Mat &gradient = scratch.gradient;

  const auto edges = [&](int dx, std::vector<Rim> &up,
                         std::vector<Rim> &down) {
    cv::Sobel(small, gradient, CV_16S, dx, 1 - dx, 3);
    if (dx == 1) {
      cv::transpose(gradient, scratch.transposed);
      std::swap(gradient, scratch.transposed);
    }
    double least = 0.0, greatest = 0.0;
    cv::minMaxLoc(gradient, &least, &greatest);
    const double slope = std::max(16.0, 0.12 * std::max(-least, greatest));
    up = find_rims(gradient, true, slope, scratch.mask);
    down = find_rims(gradient, false, slope, scratch.mask);
  };

  // A field is darker than its border: its top side is where the image gets
  // brighter upwards, and so on. Sheets and robots have it the other way.
  std::vector<Rim> top, bottom, left, right;
  edges(0, top, bottom);
  edges(1, left, right);

  const double width = small.cols - 1, height = small.rows - 1;
  double best = 0.0;
  for (const Rim &t : top)
    for (const Rim &b : bottom) {
      if (b.at(width / 2, width) < t.at(width / 2, width) + 0.12 * small.cols)
        continue;
      for (const Rim &l : left)
        for (const Rim &r : right) {
          if (r.at(height / 2, height) < l.at(height / 2, height) +
                                             0.2 * small.cols)
            continue;
          const std::array<Line, 4> line{
              as_line(t, width, false), as_line(r, height, true),
              as_line(b, width, false), as_line(l, height, true)};
          std::array<Point, 4> candidate;
          bool whole = true;
          for (int k = 0; k < 4 && whole; ++k)
            whole = intersect(line[(k + 3) % 4], line[k], candidate[k]);
          if (!whole || !is_field(small, candidate.data()))
            continue;
          const double support = border_support(small, candidate.data());
          if (support < 2.6)
            continue;
          const double score =
              support * (t.votes + b.votes + l.votes + r.votes);
          if (score > best) {
            best = score;
            std::copy(candidate.begin(), candidate.end(), corner);
          }
        }
    }
  return best > 0.0;
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
  cv::GaussianBlur(scratch.small, scratch.small, cv::Size(), 1.0);

  std::array<Point, 4> corner;
  if (!find_outline(scratch.small, corner.data()))
    return fail(VISION_NOT_FOUND, "no arena in the image");

  const Point stretch(double(size.width) / scratch.small.cols,
                      double(size.height) / scratch.small.rows);
  for (Point &point : corner)
    point = Point((point.x + 0.5) * stretch.x - 0.5,
                  (point.y + 0.5) * stretch.y - 0.5);
  cv::GaussianBlur(scratch.grey, scratch.smooth, cv::Size(), 1.0);
  const double reach = std::min(3.0 * scale, 30.0);
  if (!refine(scratch.smooth, corner.data(), 4, Bright::outside, reach, 0.03) ||
      !is_field(scratch.smooth, corner.data()) ||
      border_support(scratch.smooth, corner.data()) <= 0.0)
    return fail(VISION_NOT_FOUND, "no arena in the image");
  for (int k = 0; k < 4; ++k)
    arena.corner[k] = {corner[k].x, corner[k].y};
  return VISION_OK;
}

// ------------------------------------------------------------------ Robots

// The part of the image that is searched, and how.
struct Search {
  cv::Rect box;
  double scope = 0.0;          // longest side of what a search everywhere has
  bool bounded = false;        // by the arena
  std::array<Point, 4> field;
  double slack = 0.0;  // pixels that a centre may lie outside the field
  double width = 0.0;  // of the field, pixels
};

bool is_worth_it(const cv::Rect &box) {
  return box.width >= 16 && box.height >= 16;
}

// False where there is too little to search in.
bool limit(const Frame &here, const vision_arena *arena, Search &search) {
  const cv::Rect all(cv::Point(), here.image.size());
  search.box = all;
  search.width = 0.85 * here.image.cols;
  search.scope = std::max(all.width, all.height);
  if (arena == nullptr)
    return is_worth_it(search.box);

  double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
  for (const vision_point &corner : arena->corner) {
    left = std::min(left, corner.x);
    right = std::max(right, corner.x);
    top = std::min(top, corner.y);
    bottom = std::max(bottom, corner.y);
  }
  // A robot whose centre is inside reaches out of the field.
  search.bounded = true;
  search.width = std::max(right - left, (bottom - top) * 4.0 / 3.0);
  search.slack = 0.02 * search.width;
  const double margin = 0.13 * search.width + 4.0;
  search.box = all & cv::Rect(cv::Point(cvFloor(left - margin),
                                        cvFloor(top - margin)),
                              cv::Point(cvCeil(right + margin),
                                        cvCeil(bottom + margin)));
  search.scope = std::max(search.box.width, search.box.height);
  for (int k = 0; k < 4; ++k)
    search.field[k] = Point(arena->corner[k].x, arena->corner[k].y);
  return is_worth_it(search.box);
}

bool in_field(const Search &search, const Point &centre) {
  return !search.bounded || depth(centre + Point(search.box.tl()),
                                  search.field.data(), 4) >= -search.slack;
}

vision_robot make_robot(int id, const Point &centre, const Point &direction,
                        const Search &search) {
  vision_robot robot;
  const Point origin(search.box.tl());
  robot.id = id;
  robot.centre = {centre.x + origin.x, centre.y + origin.y};
  robot.direction = {direction.x + origin.x, direction.y + origin.y};
  robot.angle = std::atan2(centre.y - direction.y, centre.x - direction.x) *
                180.0 / CV_PI;
  if (robot.angle <= -180.0)
    robot.angle = 180.0;
  return robot;
}

using Corners = std::vector<cv::Point2f>;

// ArUco's part: candidates for markers, and the meaning of their bits. What
// it says about a candidate itself is not used: among noise it takes much
// for a marker, and it does not know one that is blurred or small.
class Aruco {
public:
  std::vector<Corners> known, others;  // the candidates of the last image

#ifdef VISION_ARUCO_IN_OBJDETECT
  Aruco() {
    cv::aruco::DetectorParameters parameters;
    tune(parameters);
    detector = cv::aruco::ArucoDetector(
        cv::aruco::getPredefinedDictionary(smallest), parameters);
    learn(cv::aruco::getPredefinedDictionary(which));
  }

  void detect(const cv::Mat &grey, double scope) {
    cv::aruco::DetectorParameters parameters =
        detector.getDetectorParameters();
    limit_sizes(parameters, grey, scope);
    detector.setDetectorParameters(parameters);
    detector.detectMarkers(grey, known, ids, others);
  }
#else
  Aruco()
      : dictionary(cv::aruco::getPredefinedDictionary(smallest)),
        parameters(cv::aruco::DetectorParameters::create()) {
    tune(*parameters);
    learn(*cv::aruco::getPredefinedDictionary(which));
  }

  void detect(const cv::Mat &grey, double scope) {
    limit_sizes(*parameters, grey, scope);
    cv::aruco::detectMarkers(grey, dictionary, known, ids, parameters, others);
  }
#endif

  // Knows 16 bits, row by row, by their marker and by how many quarters of a
  // turn clockwise the marker shows them.
  bool identify(unsigned bits, int &id, int &turns) const {
    if (meaning[bits] < 0)
      return false;
    id = meaning[bits] / 4;
    turns = meaning[bits] % 4;
    return true;
  }

private:
  static constexpr auto which = cv::aruco::DICT_4X4_1000;
  // What OpenCV compares each candidate with, for nothing.
  static constexpr auto smallest = cv::aruco::DICT_4X4_50;
  std::vector<int> ids;
  std::vector<int> meaning = std::vector<int>(1 << 16, -1);
#ifdef VISION_ARUCO_IN_OBJDETECT
  cv::aruco::ArucoDetector detector;
#else
  cv::Ptr<cv::aruco::Dictionary> dictionary;
  cv::Ptr<cv::aruco::DetectorParameters> parameters;
#endif

  static void tune(cv::aruco::DetectorParameters &parameters) {
    parameters.adaptiveThreshWinSizeMin = 11;
    parameters.adaptiveThreshWinSizeMax = 27;
    parameters.adaptiveThreshWinSizeStep = 16;
    parameters.polygonalApproxAccuracyRate = 0.05;
  }

  // A marker is as small or large as it may be in all of SCOPE, whatever
  // part of it is searched.
  static void limit_sizes(cv::aruco::DetectorParameters &parameters,
                          const cv::Mat &grey, double scope) {
    const double share = scope / std::max(grey.cols, grey.rows);
    parameters.minMarkerPerimeterRate = 0.05 * share;
    parameters.maxMarkerPerimeterRate = 4.0 * share;
  }

  void learn(const cv::aruco::Dictionary &dictionary) {
    for (int id = 0; id < dictionary.bytesList.rows; ++id) {
      const cv::Mat upright = cv::aruco::Dictionary::getBitsFromByteList(
          dictionary.bytesList.rowRange(id, id + 1), 4);
      unsigned bits = 0;
      for (int k = 0; k < 16; ++k)
        bits |= unsigned(upright.at<uchar>(k / 4, k % 4) != 0) << k;
      for (int turns = 0; turns < 4; ++turns) {
        meaning[bits] = 4 * id + turns;
        bits = turned(bits);
      }
    }
  }

public:
  // The bits after a quarter of a turn clockwise.
  static unsigned turned(unsigned bits) {
    unsigned result = 0;
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 4; ++column)
        result |= (bits >> (4 * (3 - column) + row) & 1u)
                  << (4 * row + column);
    return result;
  }
};

// The grey levels in the middle of the modules of a marker: 6 x 6 of its
// own, black border included, and the quiet ones around them.
using Modules = std::array<std::array<double, 8>, 8>;

Modules read_modules(const cv::Mat &grey, const std::array<Point, 4> &corner) {
  // Bilinear: a marker is too small for its perspective to show.
  Modules modules;
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column) {
      const double u = (column - 0.5) / 6, v = (row - 0.5) / 6;
      const Point at = (corner[0] * (1 - u) + corner[1] * u) * (1 - v) +
                       (corner[3] * (1 - u) + corner[2] * u) * v;
      modules[row][column] = sample(grey, at);
    }
  return modules;
}

// The bits of a marker; false where what surrounds them is not a black
// border in a white quiet zone, without exception.
bool read_bits(const Modules &modules, unsigned &bits) {
  double white = 0.0, black = 0.0;
  double darkest_white = 255.0, brightest_black = 0.0;
  for (int row = 0; row < 8; ++row)
    for (int column = 0; column < 8; ++column) {
      const double grey = modules[row][column];
      const int ring =
          std::min(std::min(row, column), std::min(7 - row, 7 - column));
      if (ring == 0) {
        white += grey / 28;
        darkest_white = std::min(darkest_white, grey);
      } else if (ring == 1) {
        black += grey / 20;
        brightest_black = std::max(brightest_black, grey);
      }
    }
  const double middle = (white + black) / 2;
  if (white < black + 25.0 || darkest_white < middle ||
      brightest_black > middle)
    return false;
  bits = 0;
  for (int k = 0; k < 16; ++k)
    bits |= unsigned(modules[k / 4 + 2][k % 4 + 2] > middle) << k;
  return true;
}

// Aligns the whole pattern of a marker, given its BITS: more edges than its
// outline has, so less noise, and none that its inside draws away. It is too
// small for its perspective to show.
bool align_marker(const cv::Mat &grey, unsigned bits,
                  std::array<Point, 4> &corner) {
  constexpr int pitch = 8;  // pixels of the drawing for a module
  cv::Mat modules(8, 8, CV_8UC1, cv::Scalar(255)), shape;
  modules(cv::Rect(1, 1, 6, 6)).setTo(0);
  for (int k = 0; k < 16; ++k)
    if (bits >> k & 1u)
      modules.at<uchar>(k / 4 + 2, k % 4 + 2) = 255;
  cv::resize(modules, shape, cv::Size(), pitch, pitch, cv::INTER_NEAREST);

  // The rim of the quiet zone is blurred into what is around it.
  constexpr int rim = pitch / 2;
  cv::Mat used(shape.size(), CV_8UC1, cv::Scalar(0));
  used(cv::Rect(rim, rim, shape.cols - 2 * rim, shape.rows - 2 * rim))
      .setTo(255);
  const double near = pitch - 0.5, far = 7 * pitch - 0.5;
  const Point reference[3] = {{near, near}, {far, near}, {far, far}};
  if (!align(grey, shape, used, reference, corner.data()))
    return false;
  corner[3] = corner[0] + corner[2] - corner[1];
  return true;
}

void find_markers(const Search &search, std::vector<vision_robot> &robots) {
  static thread_local Aruco aruco;
  // A marker is a candidate more than once: its outlines, and thresholds.
  const auto is_known = [&](int id, const std::array<Point, 4> &corner) {
    const Point centre =
        (corner[0] + corner[2]) / 2 + Point(search.box.tl());
    return std::any_of(
        robots.begin(), robots.end(), [&](const vision_robot &robot) {
          return robot.id == id &&
                 std::hypot(robot.centre.x - centre.x,
                            robot.centre.y - centre.y) < 4.0;
        });
  };
  aruco.detect(scratch.smooth, search.scope);
  for (const std::vector<Corners> *list : {&aruco.known, &aruco.others})
    for (const Corners &candidate : *list) {
      std::array<Point, 4> corner;
      std::copy(candidate.begin(), candidate.end(), corner.begin());
      if (cross(corner[1] - corner[0], corner[2] - corner[0]) < 0)
        std::swap(corner[1], corner[3]);
      const double area = std::fabs(cross(corner[2] - corner[0],
                                          corner[3] - corner[1])) / 2;
      const double reach = std::max(2.5, 0.75 * std::sqrt(area) / 6);
      unsigned bits = 0;
      int id = 0, turns = 0;
      if (!refine(scratch.smooth, corner.data(), 4, Bright::outside, reach,
                  0.12) ||
          !read_bits(read_modules(scratch.smooth, corner), bits) ||
          !aruco.identify(bits, id, turns) || is_known(id, corner) ||
          !align_marker(scratch.smooth, bits, corner))
        continue;
      // Turned so often, its top left corner is where that one is.
      std::rotate(corner.begin(), corner.begin() + turns, corner.end());
      const Point centre = (corner[0] + corner[2]) / 2;
      const Point direction = (corner[0] + corner[1]) / 2;
      if (in_field(search, centre))
        robots.push_back(make_robot(id, centre, direction, search));
    }
}

// Turns three corners so that the first is the tip, and puts them clockwise.
// False where no corner stands out.
bool order_triangle(std::array<Point, 3> &corner) {
  if (cross(corner[1] - corner[0], corner[2] - corner[0]) < 0)
    std::swap(corner[1], corner[2]);
  std::array<double, 3> opposite;
  for (int k = 0; k < 3; ++k)
    opposite[k] = length(corner[(k + 1) % 3] - corner[(k + 2) % 3]);
  const int tip = int(std::min_element(opposite.begin(), opposite.end()) -
                      opposite.begin());
  std::rotate(corner.begin(), corner.begin() + tip, corner.end());
  const double base = opposite[tip];
  const double right = opposite[(tip + 1) % 3], left = opposite[(tip + 2) % 3];
  return std::fabs(left - right) < 0.2 * std::max(left, right) &&
         base < 0.9 * std::min(left, right) && base > 0.25 * left;
}

// A triangle as the platform's robots carry it, drawn; where its corners
// are, and what of the drawing is compared with the image.
struct Triangle {
  static constexpr double width = 40.0, height = 64.0, margin = 12.0;
  cv::Mat shape, used;
  std::array<Point, 3> corner{
      Point(margin + width / 2, margin),
      Point(margin + width, margin + height), Point(margin, margin + height)};

  Triangle() {
    constexpr int fine = 4;
    const cv::Size size(int(width + 2 * margin) + 1,
                        int(height + 2 * margin) + 1);
    cv::Mat large(size * fine, CV_8UC1);
    for (int y = 0; y < large.rows; ++y)
      for (int x = 0; x < large.cols; ++x)
        large.at<uchar>(y, x) =
            depth(Point((x + 0.5) / fine - 0.5, (y + 0.5) / fine - 0.5),
                  corner.data(), 3) > 0.0 ? 255 : 0;
    cv::resize(large, shape, size, 0, 0, cv::INTER_AREA);

    // Only near it: the robot's dark body does not reach far.
    const Point middle = (corner[0] + corner[1] + corner[2]) / 3;
    std::array<Point, 3> wider;
    for (int k = 0; k < 3; ++k)
      wider[k] = middle + (corner[k] - middle) * 1.15;
    used.create(size, CV_8UC1);
    for (int y = 0; y < used.rows; ++y)
      for (int x = 0; x < used.cols; ++x)
        used.at<uchar>(y, x) =
            depth(Point(x, y), wider.data(), 3) > 0.0 ? 255 : 0;
  }
};

// The corners of a contour which is a triangle but for its roughness: those
// of the largest triangle within. (OpenCV's smallest triangle around it is
// sometimes far from the smallest.)
bool find_corners(const std::vector<cv::Point> &contour,
                  std::array<Point, 3> &corner) {
  std::vector<cv::Point> hull;
  cv::convexHull(contour, hull);
  const std::size_t count = hull.size();
  if (count < 3 || count > 80)
    return false;
  int largest = 0;  // twice the area
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      for (std::size_t k = j + 1; k < count; ++k) {
        const int twice =
            std::abs((hull[j] - hull[i]).cross(hull[k] - hull[i]));
        if (twice > largest) {
          largest = twice;
          corner = {Point(hull[i]), Point(hull[j]), Point(hull[k])};
        }
      }
  return cv::contourArea(hull) < 1.6 * (largest / 2.0);
}

void find_triangles(const Search &search,
                    std::vector<vision_robot> &robots) {
  static const Triangle drawn;
  // The triangle is 20 cm2, the field 80 cm wide; without an arena the field
  // may be narrower than is assumed.
  const double area = 20.0 / (80.0 * 80.0) * search.width * search.width;
  const double least = std::max(40.0, area * (search.bounded ? 0.4 : 0.08));
  const double most = 2.5 * area;
  const int block = std::min(std::max(cvRound(0.05 * search.width), 7), 400);
  cv::adaptiveThreshold(scratch.smooth, scratch.mask, 255,
                        cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY,
                        2 * block + 1, -12);
  cv::morphologyEx(scratch.mask, scratch.mask, cv::MORPH_OPEN,
                   cv::Mat());  // threads of noise that hang on a triangle
  std::vector<std::vector<cv::Point>> contours;
  cv::findContours(scratch.mask, contours, cv::RETR_LIST,
                   cv::CHAIN_APPROX_SIMPLE);
  for (const std::vector<cv::Point> &contour : contours) {
    const double size = cv::contourArea(contour);
    if (size < least || size > most)
      continue;
    std::array<Point, 3> corner;
    if (!find_corners(contour, corner))
      continue;
    if (!order_triangle(corner) ||
        !refine(scratch.smooth, corner.data(), 3, Bright::inside, 4.0, 0.15) ||
        !order_triangle(corner) ||
        !align(scratch.smooth, drawn.shape, drawn.used, drawn.corner.data(),
               corner.data()))
      continue;
    const Point centre = (corner[0] + corner[1] + corner[2]) / 3;
    if (in_field(search, centre))
      robots.push_back(make_robot(0, centre, corner[0], search));
  }
}

// ---------------------------------------------------------------- Following

// What each tile of the image looked like when it was searched last. As long
// as one that is not searched looks the same, nothing has come there.
struct Watch {
  static constexpr int across = 80;   // tiles, along the longer side
  static constexpr int samples = 4;   // of a tile, in each direction: green
  static constexpr int change = 24;   // grey levels that are one: four times
                                      // what a noise of 15 amounts to
  cv::Mat seen;  // CV_16SC1, a tile a pixel: the sum of its samples

  void look(const cv::Mat &image, cv::Mat &now, int &side) const;
};

void Watch::look(const cv::Mat &image, cv::Mat &now, int &side) const {
  side = std::max(samples, (std::max(image.cols, image.rows) + across - 1) /
                               across);
  now.create(image.rows / side, image.cols / side, CV_16SC1);
  std::array<int, samples> place;
  for (int x = 0; x < samples; ++x)
    place[x] = 3 * (x * side / samples) + 1;
  for (int row = 0; row < now.rows; ++row) {
    short *const sums = now.ptr<short>(row);
    std::fill(sums, sums + now.cols, short(0));
    for (int y = 0; y < samples; ++y) {
      const uchar *next = image.ptr<uchar>(row * side + y * side / samples);
      for (int column = 0; column < now.cols; ++column, next += 3 * side)
        sums[column] =
            short(sums[column] + next[place[0]] + next[place[1]] +
                  next[place[2]] + next[place[3]]);
    }
  }
}

thread_local Watch watch;

// The tiles that a part of the image touches.
cv::Rect tiles_of(const cv::Rect &part, int side, const cv::Mat &tiles) {
  const cv::Point first(part.x / side, part.y / side);
  const cv::Point last((part.x + part.width + side - 1) / side,
                       (part.y + part.height + side - 1) / side);
  return cv::Rect(first, last) & cv::Rect(cv::Point(), tiles.size());
}

// Everything has been searched.
void note_all(Frame &here) {
  int side = 0;
  watch.look(here.image, watch.seen, side);
}

// Whether something in WHOLE but not in PARTS has changed since it has been
// searched. The parts count as searched then.
bool has_changed(Frame &here, const cv::Rect &whole,
                 const std::vector<cv::Rect> &parts) {
  int side = 0;
  watch.look(here.image, scratch.tiles, side);
  if (scratch.tiles.size() != watch.seen.size())
    return true;
  for (const cv::Rect &part : parts) {
    const cv::Rect tiles = tiles_of(part, side, scratch.tiles);
    scratch.tiles(tiles).copyTo(watch.seen(tiles));
  }
  const cv::Rect tiles = tiles_of(whole, side, scratch.tiles);
  return cv::norm(scratch.tiles(tiles), watch.seen(tiles), cv::NORM_INF) >
         Watch::change * Watch::samples * Watch::samples;
}

// Of robots found twice at one place, one is enough.
void drop_doubles(std::vector<vision_robot> &robots) {
  std::stable_sort(robots.begin(), robots.end(),
                   [](const vision_robot &a, const vision_robot &b) {
                     return a.id < b.id;
                   });
  const auto same = [](const vision_robot &a, const vision_robot &b) {
    return a.id == b.id && std::hypot(a.centre.x - b.centre.x,
                                      a.centre.y - b.centre.y) < 8.0;
  };
  robots.erase(std::unique(robots.begin(), robots.end(), same), robots.end());
}

bool are_sound(const vision_area *areas, int count) {
  if (areas == nullptr || count < 1)
    return false;
  return std::all_of(areas, areas + count, [](const vision_area &area) {
    return sound(area.centre) && area.reach >= 0.0 && area.reach <= 1e6;
  });
}

// Finds the robots in the parts of the image that CHOOSE names; nothing
// where it says no.
template <typename Choice>
vision_status find_robots(int slot, vision_marker marker,
                          const vision_arena *arena, vision_robot *robots,
                          int capacity, int *count, Choice choose) {
  if (count != nullptr)
    *count = 0;
  return on_image(slot, [&](Frame &here) {
    if (robots == nullptr || count == nullptr || capacity < 1 ||
        (marker != VISION_MARKER_ARUCO && marker != VISION_MARKER_TRIANGLE) ||
        (arena != nullptr && !sound(*arena)))
      return fail(VISION_BAD_ARGUMENT, "cannot search for robots so");

    std::vector<vision_robot> found;
    std::vector<cv::Rect> parts;
    Search search;
    if (limit(here, arena, search) && choose(here, search.box, parts))
      for (const cv::Rect &part : parts) {
        search.box = part;
        cv::cvtColor(here.image(part), scratch.grey, cv::COLOR_BGR2GRAY);
        cv::GaussianBlur(scratch.grey, scratch.smooth, cv::Size(), 0.8);
        if (marker == VISION_MARKER_ARUCO)
          find_markers(search, found);
        else
          find_triangles(search, found);
      }
    drop_doubles(found);
    if (found.empty())
      return fail(VISION_NOT_FOUND, "no robot in the image");
    *count = std::min(capacity, int(found.size()));
    std::copy(found.begin(), found.begin() + *count, robots);
    return VISION_OK;
  });
}

}  // namespace

}  // namespace vision

using vision::fail;
using vision::Frame;
using vision::on_image;

extern "C" {

vision_status vision_find_arena(int slot, vision_arena *arena) {
  return on_image(slot, [&](Frame &here) {
    if (arena == nullptr)
      return fail(VISION_BAD_ARGUMENT, "no place for the arena");
    return vision::find_arena(here, *arena);
  });
}

vision_status vision_find_robots(int slot, vision_marker marker,
                                 const vision_arena *arena,
                                 vision_robot *robots, int capacity,
                                 int *count) {
  return vision::find_robots(
      slot, marker, arena, robots, capacity, count,
      [](Frame &here, const cv::Rect &whole, std::vector<cv::Rect> &parts) {
        parts.push_back(whole);
        vision::note_all(here);
        return true;
      });
}

vision_status vision_follow_robots(int slot, vision_marker marker,
                                   const vision_arena *arena,
                                   const vision_area *areas, int area_count,
                                   vision_robot *robots, int capacity,
                                   int *count) {
  if (count != nullptr)
    *count = 0;
  if (!vision::are_sound(areas, area_count))
    return fail(VISION_BAD_ARGUMENT, "no areas to search in");
  return vision::find_robots(
      slot, marker, arena, robots, capacity, count,
      [&](Frame &here, const cv::Rect &whole, std::vector<cv::Rect> &parts) {
        for (int k = 0; k < area_count; ++k) {
          const vision_area &area = areas[k];
          const cv::Rect part =
              whole & cv::Rect(cv::Point(cvFloor(area.centre.x - area.reach),
                                         cvFloor(area.centre.y - area.reach)),
                               cv::Point(cvCeil(area.centre.x + area.reach),
                                         cvCeil(area.centre.y + area.reach)));
          if (vision::is_worth_it(part))
            parts.push_back(part);
        }
        return !vision::has_changed(here, whole, parts);
      });
}

}  // extern "C"
