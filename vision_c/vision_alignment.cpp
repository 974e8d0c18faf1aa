// SPDX-License-Identifier: GPL-3.0-or-later
// Alignment: moves a drawn shape to its best position in the image.

#include "vision_search.hpp"

namespace vision {

namespace {

// Whether MAP, from the square of the shape to the image, keeps the
// orientation, away from the horizon, and makes it larger than a pixel.
bool keeps_turn(const Map &map) {
  const double slant = std::fabs(map(2, 0)) + std::fabs(map(2, 1));
  return slant < 0.8 * map(2, 2) && cv::determinant(map) > 1.0;
}

// The largest distance between the corners of the square in both maps; pixels
// of the image.
double apart(const Map &one, const Map &other) {
  double most = 0.0;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      most = std::max(most, length(apply(one, {x, y}) - apply(other, {x, y})));
  return most;
}

// The derivatives of a pixel of a shape with respect to brightness, contrast
// and the parameters of the map; those that are not used are 0.
constexpr int fours = 3, most_gains = 4 * fours;
using Gains = std::array<Four, fours>;

// The pixels of shapes of one size that are compared with an image. The
// coordinates of a shape are those in which it is a square, -1 to 1: so the
// parameters of a map have a similar scale.
class Comparison {
public:
  Comparison(const cv::Mat &image, const cv::Mat &used, const Map &map);

  // Moves MAP so that SHAPE fits its image best, by least squares
  // (Gauss-Newton); contrast and brightness are fitted too. FIT.distance is
  // the residual, in grey levels over contrast. False with no change if the
  // shape drifts away or the residual is LEAST or more.
  //
  // Steps are in the shape's coordinates: there the gradients, and so the
  // normal equations, are the same in each iteration.
  bool align(const cv::Mat &shape, int parameters, double least, Map &map,
             Fit &fit);

  // By how much the squared blur of the shape last aligned is below that of
  // the image; pixels of the shape.
  double blur_left(const cv::Mat &shape, double contrast) const;

  // What remained of each pixel then, for a shape with rows of that LENGTH.
  std::vector<Fit::Rest> rests(int length, double contrast) const;

private:
  const cv::Mat &grey;
  double scale;
  std::vector<float> x, y;   // of each pixel; padded to a multiple of four
  std::vector<int> place;    // of each in the shape
  std::vector<Gains> gains;
  std::vector<float> rest;   // what remains of each, grey levels; padded, too
  cv::Matx<double, most_gains, most_gains> inverse;  // of normal equations

  bool find_gains(const cv::Mat &shape, int used);
  Gains compare(const Map &map, Fit &fit);
};

Comparison::Comparison(const cv::Mat &image, const cv::Mat &used,
                       const Map &map)
    : grey(image), scale(0.5 * std::max(used.cols, used.rows)) {
  for (int row = 1; row < used.rows - 1; ++row)
    for (int column = 1; column < used.cols - 1; ++column) {
      const Point at((column - 0.5 * (used.cols - 1)) / scale,
                     (row - 0.5 * (used.rows - 1)) / scale);
      if (used.at<uchar>(row, column) != compared ||
          !in_image(grey, apply(map, at)))
        continue;
      x.push_back(float(at.x));
      y.push_back(float(at.y));
      place.push_back(row * used.cols + column);
    }
  x.resize((place.size() + 3) / 4 * 4);
  y.resize(x.size());
  rest.resize(x.size());
}

// The first USED gains of each pixel; false if they do not determine a fit.
bool Comparison::find_gains(const cv::Mat &shape, int used) {
  const int across = shape.cols;
  const float half = float(scale / 2), slant = used > 8 ? 1.0f : 0.0f;
  std::array<Gains, most_gains> sum{};  // its lower half
  gains.clear();
  for (std::size_t k = 0; k < place.size(); ++k) {
    const float *const at = shape.ptr<float>() + place[k];
    const float dx = (at[1] - at[-1]) * half;
    const float dy = (at[across] - at[-across]) * half;
    const float turn = -slant * (dx * x[k] + dy * y[k]);
    const Gains gain{Four{1.0f, at[0], dx * x[k], dx * y[k]},
                     Four{dx, dy * x[k], dy * y[k], dy},
                     Four{turn * x[k], turn * y[k], 0.0f, 0.0f}};
    gains.push_back(gain);
#pragma GCC unroll 12
    for (int i = 0; i < most_gains; ++i)
#pragma GCC unroll 3
      for (int j = 0; j <= i / 4; ++j)
        sum[i][j] += gain[i / 4][i % 4] * gain[j];
  }
  cv::Matx<double, most_gains, most_gains> normal;
  for (int i = 0; i < most_gains; ++i)
    for (int j = 0; j <= i; ++j)
      normal(i, j) = normal(j, i) = i < used ? sum[i][j / 4][j % 4] : i == j;
  bool solved = false;
  inverse = normal.inv(cv::DECOMP_CHOLESKY, &solved);
  return solved;
}

// Sets the rest and FIT.distance; the sums of the rest times each gain.
Gains Comparison::compare(const Map &map, Fit &fit) {
  const cv::Matx33f single = map;
  for (std::size_t k = 0; k < x.size(); k += 4) {
    Four right = load(&x[k]), down = load(&y[k]);
    move(single, right, down);
    store(sample(grey, right, down), &rest[k]);
  }
  const float offset = float(fit.offset), contrast = float(fit.contrast);
  Gains sum{};
  float squares = 0.0f;
  for (std::size_t k = 0; k < gains.size(); ++k) {
    rest[k] -= offset + contrast * gains[k][0][1];
#pragma GCC unroll 3
    for (int i = 0; i < fours; ++i)
      sum[i] += gains[k][i] * rest[k];
    squares += rest[k] * rest[k];
  }
  fit.distance = std::sqrt(squares / float(gains.size())) /
                 std::max(1.0, fit.contrast);
  return sum;
}

bool Comparison::align(const cv::Mat &shape, int parameters, double least,
                       Map &map, Fit &fit) {
  constexpr int rounds = 9;
  constexpr double enough = 5e-3, drift = 6.0;  // pixels of the image
  if (place.size() < 64 || !find_gains(shape, 2 + parameters))
    return false;
  Map next = map;
  Fit now;
  Gains sum = compare(next, now);
  for (int round = 0; round < rounds; ++round) {
    std::array<double, most_gains> change{};
    for (int i = 0; i < most_gains; ++i)
      for (int j = 0; j < most_gains; ++j)
        change[i] += inverse(i, j) * sum[j / 4][j % 4];
    now.offset += change[0];
    now.contrast += change[1];
    // A shift in the shape is the opposite shift in the image.
    const auto part = [&](int k) { return change[2 + k] / now.contrast; };
    const Map step(1 + part(0), part(1), part(2), part(3), 1 + part(4),
                   part(5), part(6), part(7), 1);
    if (now.contrast < 1.0 || cv::determinant(step) < 0.1)
      return false;
    const Map before = next;
    next = before * step.inv();
    if (!keeps_turn(next))
      return false;
    sum = compare(next, now);
    if (now.distance > 1.05 * least)
      return false;
    if (apart(before, next) < enough)
      break;
  }
  if (now.distance >= least || now.contrast <= 8.0 ||
      apart(map, next) >= drift)
    return false;
  map = next;
  fit.offset = now.offset;
  fit.contrast = now.contrast;
  fit.distance = now.distance;
  return true;
}

// A blur changes a shape by half of its Laplacian; the part that the other
// parameters can produce is excluded.
double Comparison::blur_left(const cv::Mat &shape, double contrast) const {
  Gains sum{};
  double along = 0.0, square = 0.0;
  for (std::size_t k = 0; k < gains.size(); ++k) {
    const float *const at = shape.ptr<float>() + place[k];
    const float bow = 0.5f * (at[1] + at[-1] + at[shape.cols] +
                              at[-shape.cols] - 4.0f * at[0]);
    along += bow * rest[k];
    square += bow * bow;
    for (int i = 0; i < fours; ++i)
      sum[i] += gains[k][i] * bow;
  }
  for (int i = 0; i < most_gains; ++i)
    for (int j = 0; j < most_gains; ++j)
      square -= inverse(i, j) * sum[i / 4][i % 4] * sum[j / 4][j % 4];
  return along / (contrast * std::max(1e-6, square));
}

std::vector<Fit::Rest> Comparison::rests(int length, double contrast) const {
  std::vector<Fit::Rest> all;
  for (std::size_t k = 0; k < place.size(); ++k)
    all.push_back({{place[k] % length, place[k] / length},
                   rest[k] / contrast});
  return all;
}

}  // namespace

bool align(const cv::Mat &grey, const cv::Mat &shape, const cv::Mat &used,
           bool perspective, double worst, Fit &fit) {
  constexpr double good = 0.04;  // no other can be much better
  constexpr double sharpest = 0.68, dullest = 2.2;  // pixels of the image
  const double half = 0.5 * std::max(shape.cols, shape.rows);
  const Map to_unit(1 / half, 0, -0.5 * (shape.cols - 1) / half,
                    0, 1 / half, -0.5 * (shape.rows - 1) / half, 0, 0, 1);
  Map start = fit.map * to_unit.inv();
  start *= 1 / start(2, 2);
  if (!keeps_turn(start))
    return false;
  // image pixels per shape pixel, at its centre
  const double scale = std::sqrt(cv::determinant(start)) / half;
  Comparison comparison(grey, used, start);
  cv::Mat blurred;
  double least = 1e9;
  double next = 0.0;  // what seems to fit better
  const auto try_blur = [&](double sigma) {  // pixels of the image
    const int around = 2 * cvCeil(2.5 * sigma / scale) + 1;
    cv::GaussianBlur(shape, blurred, cv::Size(around, around), sigma / scale,
                     0.0, cv::BORDER_REPLICATE);
    if (!comparison.align(blurred, perspective ? 8 : 6, least, start, fit))
      return false;
    least = fit.distance;
    fit.spread = sigma / scale;
    const double square =
        sigma * sigma +
        scale * scale * comparison.blur_left(blurred, fit.contrast);
    next = std::min(std::sqrt(std::max(square, sharpest * sharpest)), dullest);
    fit.rest = comparison.rests(shape.cols, fit.contrast);
    return true;
  };
  // Most images are about as sharp as the first one.
  const double known = fit.spread * scale;
  bool better = known > 0.0 && try_blur(known);
  for (const double sigma : {0.9, 1.4, 0.6, 2.2})
    if (better || (better = try_blur(sigma)))
      break;
  for (int round = 0; round < 2 && better && least > good &&
                      std::fabs(next - fit.spread * scale) > 0.1 * next;
       ++round)
    better = try_blur(next);
  fit.map = start * to_unit;
  return least <= worst;
}

}  // namespace vision
