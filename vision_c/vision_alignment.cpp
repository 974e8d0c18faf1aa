// SPDX-License-Identifier: GPL-3.0-or-later
// Alignment: moves a drawn shape to its best position in the image.

#include "vision_search.hpp"

namespace vision {

namespace {

// Coordinates in which the parameters of a map have similar scale.
struct Frame_Of_Shape {
  double x, y, scale;
  explicit Frame_Of_Shape(const cv::Mat &shape)
      : x(0.5 * (shape.cols - 1)), y(0.5 * (shape.rows - 1)),
        scale(0.5 * std::max(shape.cols, shape.rows)) {}
  Map to_unit() const {
    return {1 / scale, 0, -x / scale, 0, 1 / scale, -y / scale, 0, 0, 1};
  }
};

// Whether MAP keeps the orientation between -1 and 1, away from the horizon.
bool keeps_turn(const Map &map) {
  double nearest = 1e9;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      nearest = std::min(nearest,
                         map(2, 0) * x + map(2, 1) * y + map(2, 2));
  return nearest > 0.2 * map(2, 2) && cv::determinant(map) > 1e-6;
}

// Derivatives of a shape pixel's brightness with respect to offset, contrast
// and each parameter of the map; unused ones stay 0.
constexpr int fours = 3, most_gains = 4 * fours;
using Gains = std::array<Four, fours>;

// The pixels of shapes of one size that are compared with an image, and their
// values.
class Comparison {
public:
  Comparison(const cv::Mat &image, const cv::Mat &used, const Map &map)
      : grey(image), frame(used) {
    for (int row = 1; row < used.rows - 1; ++row)
      for (int column = 1; column < used.cols - 1; ++column) {
        if (used.at<uchar>(row, column) != compared)
          continue;
        const Point at((column - frame.x) / frame.scale,
                       (row - frame.y) / frame.scale);
        if (!in_image(grey, apply(map, at)))
          continue;
        x.push_back(float(at.x));
        y.push_back(float(at.y));
        place.push_back(row * used.cols + column);
      }
    while (x.size() % 4 != 0) {
      x.push_back(x.back());
      y.push_back(y.back());
    }
    look(map);
  }

  // Moves MAP, from unit coordinates of the shape, so that SHAPE (float) fits
  // its image best, by least squares (Gauss-Newton); contrast and brightness
  // are fitted too. FIT.distance is the residual, in grey levels over
  // contrast. Returns false with no change if the shape drifts away or the
  // residual is LEAST or more; not attempted if the initial residual is over
  // LEAST by a twentieth.
  //
  // Steps are in the shape's coordinates: there the gradients, and so the
  // normal equations, are the same in each iteration.
  bool align(const cv::Mat &shape, int parameters, double least, Map &map,
             Fit &fit);

  // By how much the squared blur of SHAPE, after the last alignment, is below
  // that of the image; pixels of the shape.
  double blur_left(const cv::Mat &shape, const Fit &fit) const;

private:
  const cv::Mat &grey;
  const Frame_Of_Shape frame;
  // Position of each pixel, in unit coordinates and in the shape; the values
  // of the image and of the shape there. Positions and samples are padded to a
  // multiple of four.
  std::vector<float> x, y, seen, value;
  std::vector<int> place;
  std::vector<Gains> gains;

  void look(const Map &map);
  bool fit_brightness(Fit &fit) const;
  void find_gains(const cv::Mat &shape, int parameters);
  bool solve(int used);

  // Of the normal equations
  cv::Matx<double, most_gains, most_gains> inverse;
};

// Samples the image at each pixel.
void Comparison::look(const Map &map) {
  const cv::Matx33f single = map;
  seen.resize(x.size());
  for (std::size_t k = 0; k < x.size(); k += 4) {
    Four right = load(&x[k]), down = load(&y[k]);
    move(single, right, down);
    store(sample(grey, right, down), &seen[k]);
  }
}

// The best brightness and contrast, and the residual.
bool Comparison::fit_brightness(Fit &fit) const {
  const double number = double(place.size());
  double v = 0.0, vv = 0.0, s = 0.0, sv = 0.0, ss = 0.0;
  for (std::size_t k = 0; k < place.size(); ++k) {
    v += value[k];
    vv += value[k] * value[k];
    s += seen[k];
    sv += seen[k] * value[k];
    ss += seen[k] * seen[k];
  }
  const double spread = number * vv - v * v;
  if (spread <= 0.0)
    return false;
  fit.contrast = (number * sv - v * s) / spread;
  fit.offset = (s - fit.contrast * v) / number;
  const double squares = ss - fit.offset * s - fit.contrast * sv;
  fit.distance = std::sqrt(std::max(0.0, squares) / number) /
                 std::max(1.0, fit.contrast);
  return fit.contrast >= 1.0;
}

void Comparison::find_gains(const cv::Mat &shape, int parameters) {
  const int across = shape.cols;
  const float half = float(frame.scale / 2);
  gains.resize(place.size());
  for (std::size_t k = 0; k < place.size(); ++k) {
    const float *const at = shape.ptr<float>() + place[k];
    const float dx = (at[1] - at[-1]) * half;
    const float dy = (at[across] - at[-across]) * half;
    const float turn =
        parameters > 6 ? -(dx * x[k] + dy * y[k]) : 0.0f;
    gains[k] = {Four{1.0f, value[k], dx * x[k], dx * y[k]},
                Four{dx, dy * x[k], dy * y[k], dy},
                Four{turn * x[k], turn * y[k], 0.0f, 0.0f}};
  }
}

// Inverts the normal equations of the first USED gains.
bool Comparison::solve(int used) {
  std::array<Gains, most_gains> sum{};  // its lower half
  for (const Gains &gain : gains)
#pragma GCC unroll 12
    for (int i = 0; i < most_gains; ++i)
#pragma GCC unroll 3
      for (int j = 0; j <= i / 4; ++j)
        sum[i][j] += gain[i / 4][i % 4] * gain[j];
  cv::Matx<double, most_gains, most_gains> normal;
  for (int i = 0; i < most_gains; ++i)
    for (int j = 0; j <= i; ++j)
      normal(i, j) = normal(j, i) =
          i < used && j < used ? sum[i][j / 4][j % 4] : i == j;
  bool solved = false;
  inverse = normal.inv(cv::DECOMP_CHOLESKY, &solved);
  return solved;
}

bool Comparison::align(const cv::Mat &shape, int parameters, double least,
                       Map &map, Fit &fit) {
  const double most = 1.05 * least;
  constexpr int rounds = 9;
  constexpr double enough = 5e-3;  // pixels of the image
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

  if (place.size() < 64)
    return false;
  value.resize(place.size());
  for (std::size_t k = 0; k < place.size(); ++k)
    value[k] = shape.ptr<float>()[place[k]];
  Fit now;
  if (!fit_brightness(now) || now.distance > most)
    return false;
  find_gains(shape, parameters);
  if (!solve(parameters + 2))
    return false;

  const Map start = map;
  const auto failed = [&] {
    look(start);
    return false;
  };
  Map next = start;
  for (int round = 0; round < rounds; ++round) {
    if (round > 0)
      look(next);
    Gains right{};
    const float offset = float(now.offset), contrast = float(now.contrast);
    float squares = 0.0f;
    for (std::size_t k = 0; k < gains.size(); ++k) {
      const float rest = seen[k] - offset - contrast * value[k];
#pragma GCC unroll 3
      for (int i = 0; i < fours; ++i)
        right[i] += gains[k][i] * rest;
      squares += rest * rest;
    }
    now.distance = std::sqrt(squares / float(gains.size())) /
                   std::max(1.0, now.contrast);
    if (now.distance > most)
      return failed();
    std::array<double, most_gains> change{};
    for (int i = 0; i < parameters + 2; ++i)
      for (int j = 0; j < parameters + 2; ++j)
        change[i] += inverse(i, j) * right[j / 4][j % 4];
    now.offset += change[0];
    now.contrast += change[1];
    // A shift in the shape is the opposite shift in the image.
    const auto part = [&](int k) { return change[2 + k] / now.contrast; };
    const Map step(1 + part(0), part(1), part(2), part(3), 1 + part(4),
                   part(5), part(6), part(7), 1);
    const Map before = next;
    if (now.contrast < 1.0 || cv::determinant(step) < 0.1)
      return failed();
    next = before * step.inv();
    if (!keeps_turn(next))
      return failed();
    if (moved(before, next) < enough)
      break;
  }
  if (now.distance >= least || now.contrast <= 8.0 ||
      moved(start, next) >= 6.0)
    return failed();
  look(next);
  map = next;
  fit.offset = now.offset;
  fit.contrast = now.contrast;
  fit.distance = now.distance;
  return true;
}

// A blur changes a shape by half of its Laplacian; the part that the other
// parameters can produce is excluded.
double Comparison::blur_left(const cv::Mat &shape, const Fit &fit) const {
  const int across = shape.cols;
  Gains sum{};
  double along = 0.0, square = 0.0;
  for (std::size_t k = 0; k < gains.size(); ++k) {
    const float *const at = shape.ptr<float>() + place[k];
    const float gain = 0.5f * (at[1] + at[-1] + at[across] + at[-across] -
                               4.0f * at[0]);
    const float rest =
        seen[k] - float(fit.offset) - float(fit.contrast) * value[k];
    along += gain * rest;
    square += gain * gain;
    for (int i = 0; i < fours; ++i)
      sum[i] += gains[k][i] * gain;
  }
  for (int i = 0; i < most_gains; ++i)
    for (int j = 0; j < most_gains; ++j)
      square -= inverse(i, j) * sum[i / 4][i % 4] * sum[j / 4][j % 4];
  return along / (fit.contrast * std::max(1e-6, square));
}

}  // namespace

bool align(const cv::Mat &grey, const cv::Mat &shape, const cv::Mat &used,
           bool perspective, double worst, Fit &fit) {
  constexpr double none = 1e9;
  constexpr double good = 0.04;  // no other can be much better
  constexpr double sharpest = 0.68, dullest = 2.2;  // pixels of the image
  const Frame_Of_Shape frame(shape);
  const Map to_unit = frame.to_unit();
  Map start = fit.map * to_unit.inv();
  double least = none;
  if (!keeps_turn(start))
    return false;
  // image pixels per shape pixel, at its centre
  const double scale =
      std::sqrt(std::fabs(cross(apply(start, Point(0.5, 0)) -
                                    apply(start, Point(-0.5, 0)),
                                apply(start, Point(0, 0.5)) -
                                    apply(start, Point(0, -0.5))))) /
      frame.scale;
  if (scale < 1e-3)
    return false;
  Comparison comparison(grey, used, start);
  cv::Mat blurred;
  double next = 0.0;  // what seems to fit better
  const auto try_blur = [&](double sigma) {  // pixels of the image
    Map map = start;
    Fit now;
    const int around = 2 * cvCeil(2.5 * sigma / scale) + 1;
    cv::GaussianBlur(shape, blurred, cv::Size(around, around), sigma / scale,
                     0.0, cv::BORDER_REPLICATE);
    if (!comparison.align(blurred, perspective ? 8 : 6, least, map, now))
      return false;
    least = now.distance;
    fit = now;
    start = map;
    fit.spread = sigma / scale;
    const double square = sigma * sigma +
                          scale * scale * comparison.blur_left(blurred, fit);
    next = std::min(std::sqrt(std::max(square, sharpest * sharpest)), dullest);
    std::swap(fit.shape, blurred);
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
