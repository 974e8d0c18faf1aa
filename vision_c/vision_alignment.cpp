// SPDX-License-Identifier: GPL-3.0-or-later
// Alignment: moves a drawn shape to where it lies in the image best.

#include "vision_search.hpp"

#include <opencv2/imgproc.hpp>

namespace vision {

namespace {

// The coordinates in which the parameters of a map are of one size.
struct Frame_Of_Shape {
  double x, y, scale;
  explicit Frame_Of_Shape(const cv::Mat &shape)
      : x(0.5 * (shape.cols - 1)), y(0.5 * (shape.rows - 1)),
        scale(0.5 * std::max(shape.cols, shape.rows)) {}
  Map to_unit() const {
    return {1 / scale, 0, -x / scale, 0, 1 / scale, -y / scale, 0, 0, 1};
  }
};

// The map that takes the unit square to QUAD (Heckbert 1989).
Map map_of_square(const Quad &quad) {
  const Point a = quad[1] - quad[2], b = quad[3] - quad[2];
  const Point rest = quad[0] - quad[1] + quad[2] - quad[3];
  const double area = cross(a, b);
  const double g = area == 0.0 ? 0.0 : cross(rest, b) / area;
  const double h = area == 0.0 ? 0.0 : cross(a, rest) / area;
  const Point x = quad[1] - quad[0] + g * quad[1];
  const Point y = quad[3] - quad[0] + h * quad[3];
  return {x.x, y.x, quad[0].x, x.y, y.y, quad[0].y, g, h, 1};
}

// Whether MAP turns nothing over between -1 and 1, nor takes it near the
// horizon.
bool keeps_turn(const Map &map) {
  double nearest = 1e9;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      nearest = std::min(nearest,
                         map(2, 0) * x + map(2, 1) * y + map(2, 2));
  return nearest > 0.2 * map(2, 2) && cv::determinant(map) > 1e-6;
}

// A pixel of a shape: where it is, how bright, and what brightness gains by a
// change of each parameter of its map to the image, of offset and contrast.
constexpr int most_gains = 10;

struct Pixel {
  double x, y, value;
  std::array<double, most_gains> gain;
};

// The pixels of SHAPE (float) that USED marks and MAP has in the image.
void choose_pixels(const cv::Mat &grey, const cv::Mat &shape,
                   const cv::Mat &used, const Map &map, int parameters,
                   std::vector<Pixel> &pixels) {
  const Frame_Of_Shape frame(shape);
  pixels.clear();
  for (int row = 1; row < shape.rows - 1; ++row)
    for (int column = 1; column < shape.cols - 1; ++column) {
      if (!used.at<uchar>(row, column))
        continue;
      const double x = (column - frame.x) / frame.scale;
      const double y = (row - frame.y) / frame.scale;
      if (!in_image(grey, apply(map, Point(x, y))))
        continue;
      const double value = shape.at<float>(row, column);
      const double dx = (shape.at<float>(row, column + 1) -
                         shape.at<float>(row, column - 1)) *
                        frame.scale / 2;
      const double dy = (shape.at<float>(row + 1, column) -
                         shape.at<float>(row - 1, column)) *
                        frame.scale / 2;
      Pixel pixel{x, y, value, {}};
      pixel.gain = {1.0, value, dx * x, dx * y, dx, dy * x, dy * y, dy};
      if (parameters > 6) {
        pixel.gain[8] = -(dx * x + dy * y) * x;
        pixel.gain[9] = -(dx * x + dy * y) * y;
      }
      pixels.push_back(pixel);
    }
}

// Moves MAP, from unit coordinates of the shape, so that SHAPE (float) lies
// on its image best, by least squares (Gauss-Newton) over the pixels that
// USED marks; contrast and brightness are fitted with it. FIT.distance is
// what remains, grey levels over contrast. False where the shape slips away,
// or where more than MOST remains with the right brightness and contrast.
//
// The steps are taken in the shape's own coordinates: there the gradients,
// and so the normal equations, are the same in every round.
bool align(const cv::Mat &grey, const cv::Mat &shape, const cv::Mat &used,
           int parameters, double most, Map &map, Fit &fit) {
  constexpr int rounds = 10;
  constexpr double enough = 5e-3;  // pixels of the image
  static thread_local std::vector<Pixel> pixels;
  const int gains = parameters + 2;
  const Map start = map;
  constexpr std::array<std::array<double, 2>, 4> ends{
      {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  const auto moved = [&](const Map &from, const Map &to) {
    double largest = 0.0;
    for (const std::array<double, 2> &end : ends) {
      const Point at(end[0], end[1]);
      largest = std::max(largest, length(apply(to, at) - apply(from, at)));
    }
    return largest;
  };

  choose_pixels(grey, shape, used, map, parameters, pixels);
  if (pixels.size() < 64)
    return false;
  cv::Matx<double, most_gains, most_gains> normal;
  for (const Pixel &pixel : pixels)
    for (int i = 0; i < gains; ++i)
      for (int j = 0; j <= i; ++j)
        normal(i, j) += pixel.gain[i] * pixel.gain[j];
  for (int i = 0; i < gains; ++i)
    for (int j = i + 1; j < gains; ++j)
      normal(i, j) = normal(j, i);
  for (int i = gains; i < most_gains; ++i)
    normal(i, i) = 1.0;
  bool solved = false;
  const auto inverse = normal.inv(cv::DECOMP_CHOLESKY, &solved);
  const double number = normal(0, 0), sum = normal(0, 1);
  const double spread = number * normal(1, 1) - sum * sum;
  if (!solved || spread <= 0.0)
    return false;

  fit.offset = fit.contrast = 0.0;
  for (int round = 0; round < rounds; ++round) {
    std::array<double, most_gains> right{};
    double squares = 0.0;
    for (const Pixel &pixel : pixels) {
      const double rest = sample(grey, apply(map, Point(pixel.x, pixel.y))) -
                          fit.offset - fit.contrast * pixel.value;
      for (int i = 0; i < gains; ++i)
        right[i] += pixel.gain[i] * rest;
      squares += rest * rest;
    }
    fit.distance = std::sqrt(squares / number) / std::max(1.0, fit.contrast);
    if (round > 0 && fit.distance > most)
      return false;
    if (round == 0) {
      // Brightness and contrast first: without them there is no gradient.
      fit.offset = (normal(1, 1) * right[0] - sum * right[1]) / spread;
      fit.contrast = (number * right[1] - sum * right[0]) / spread;
      if (fit.contrast < 1.0)
        return false;
      continue;
    }
    std::array<double, most_gains> change{};
    for (int i = 0; i < gains; ++i)
      for (int j = 0; j < gains; ++j)
        change[i] += inverse(i, j) * right[j];
    fit.offset += change[0];
    fit.contrast += change[1];
    // What is to be moved in the shape is to be moved back in the image.
    const auto part = [&](int k) { return change[2 + k] / fit.contrast; };
    const Map step(1 + part(0), part(1), part(2), part(3), 1 + part(4),
                   part(5), part(6), part(7), 1);
    const Map before = map;
    if (fit.contrast < 1.0 || cv::determinant(step) < 0.1)
      return false;
    map = before * step.inv();
    if (!keeps_turn(map))
      return false;
    if (moved(before, map) < enough)
      break;
  }
  return fit.contrast > 8.0 && moved(start, map) < 6.0;
}

}  // namespace

Map map_of(const Quad &from, const Quad &to) {
  const Map sources = map_of_square(from);
  bool solved = false;
  const Map map = map_of_square(to) * sources.inv(cv::DECOMP_LU, &solved);
  return solved ? map : Map::zeros();
}

bool align(const cv::Mat &grey, const cv::Mat &shape, const cv::Mat &used,
           bool perspective, double worst, Fit &fit) {
  constexpr double none = 1e9;
  const Frame_Of_Shape frame(shape);
  const Map to_unit = frame.to_unit();
  Map start = fit.map * to_unit.inv();
  double least = none;
  if (!keeps_turn(start))
    return false;
  // pixels of the image for one of the shape, about its middle
  const double scale =
      std::sqrt(std::fabs(cross(apply(start, Point(0.5, 0)) -
                                    apply(start, Point(-0.5, 0)),
                                apply(start, Point(0, 0.5)) -
                                    apply(start, Point(0, -0.5))))) /
      frame.scale;
  if (scale < 1e-3)
    return false;
  cv::Mat blurred;
  const auto try_blur = [&](double sigma) {  // pixels of the image
    Map map = start;
    Fit now;
    cv::GaussianBlur(shape, blurred, cv::Size(), sigma / scale, 0.0,
                     cv::BORDER_REPLICATE);
    if (!align(grey, blurred, used, perspective ? 8 : 6, 1.05 * least, map,
               now) ||
        now.distance >= least)
      return false;
    least = now.distance;
    fit = now;
    start = map;
    fit.spread = sigma / scale;
    std::swap(fit.shape, blurred);
    return true;
  };
  // Most images are as sharp as the first.
  try_blur(0.9);
  if (try_blur(1.4) || (!try_blur(0.6) && least == none))
    try_blur(2.2);
  fit.map = start * to_unit;
  return least <= worst;
}

}  // namespace vision
