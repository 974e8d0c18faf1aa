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

// The pixels of shapes of one size that are compared with an image. The
// coordinates of a shape are those in which it is a square, -1 to 1: so the
// parameters of a map have a similar scale.
class Comparison {
public:
  // MAP: from the square to the image; TO_UNIT: from the shape to the square.
  Comparison(const cv::Mat &image, const cv::Mat &used, const Map &map,
             const Map &to_unit)
      : grey(image), scale(1 / to_unit(0, 0)) {
    for (int row = 1; row < used.rows - 1; ++row)
      for (int column = 1; column < used.cols - 1; ++column) {
        const Point at = apply(to_unit, Point(column, row));
        if (used.at<uchar>(row, column) != 0 &&
            in_image(grey, apply(map, at))) {
          x.push_back(float(at.x));
          y.push_back(float(at.y));
          place.emplace_back(column, row);
        }
      }
    x.resize((place.size() + 3) / 4 * 4);
    y.resize(x.size());
    rest.resize(x.size());
  }

  // Moves FIT.map so that SHAPE fits its image best, by least squares
  // (Gauss-Newton); contrast and brightness are fitted too. False with no
  // change if the shape drifts away or FIT.distance would not get less. BLUR:
  // by how much the squared blur of the shape is below that of the image;
  // pixels of the shape.
  //
  // Steps are in the shape's coordinates: there the gradients, and so the
  // normal equations, are the same in each iteration.
  bool align(const cv::Mat &shape, bool perspective, Fit &fit, double &blur) {
    constexpr int rounds = 9;
    constexpr double enough = 5e-3, drift = 6.0;  // pixels of the image
    if (place.size() < 64 || !find_gains(shape, perspective))
      return false;
    Fit now = fit;
    now.offset = now.contrast = 0.0;
    cv::Mat_<float> change = compare(now);
    for (int round = 0; round < rounds; ++round) {
      now.offset += change(0);
      now.contrast += change(1);
      // A shift in the shape is the opposite shift in the image.
      Map step = Map::eye();
      for (int k = 2; k < change.rows; ++k)
        step.val[k - 2] += change(k) / now.contrast;
      if (now.contrast < 1.0 || cv::determinant(step) < 0.1)
        return false;
      const Map before = now.map;
      now.map = before * step.inv();
      if (!keeps_turn(now.map))
        return false;
      change = compare(now);
      if (now.distance > 1.05 * fit.distance)
        return false;
      if (apart(before, now.map) < enough)
        break;
    }
    if (now.distance >= fit.distance || now.contrast <= 8.0 ||
        apart(fit.map, now.map) >= drift)
      return false;
    fit = now;
    fit.rest = cv::Mat::zeros(shape.size(), CV_32F);
    for (std::size_t k = 0; k < place.size(); ++k)
      fit.rest.at<float>(place[k]) = rest[k] / float(fit.contrast);
    // Without the part of the blur that the other parameters can produce
    const cv::Mat_<float> part = gains * bow, same = inverse * part;
    blur = bow.dot(cv::Mat_<float>(gains.cols, 1, rest.data())) /
           (fit.contrast * std::max(1e-6, bow.dot(bow) - part.dot(same)));
    return true;
  }

private:
  const cv::Mat &grey;
  double scale;
  std::vector<float> x, y;       // of each pixel; padded to a multiple of four
  std::vector<cv::Point> place;  // of each in the shape
  std::vector<float> rest;       // what remains of each, grey levels; padded
  cv::Mat_<float> gains;         // derivatives of the pixels with respect to
                                 // brightness, contrast and the map's
                                 // parameters; a row each
  cv::Mat_<float> bow;           // the same for the squared blur; a column
  cv::Mat_<float> inverse;       // of the normal equations

  // Sets these three. False if they do not determine a fit.
  bool find_gains(const cv::Mat &shape, bool perspective) {
    const float half = float(scale / 2);
    gains.create(perspective ? 10 : 8, int(place.size()));
    bow.create(gains.cols, 1);
    for (int k = 0; k < gains.cols; ++k) {
      const float *const at = shape.ptr<float>(place[k].y) + place[k].x;
      const float above = at[-shape.cols], below = at[shape.cols];
      const float dx = (at[1] - at[-1]) * half, dy = (below - above) * half;
      const float turn = -(dx * x[k] + dy * y[k]);
      const std::array<float, 10> gain{
          1.0f, at[0], dx * x[k], dx * y[k], dx, dy * x[k], dy * y[k], dy,
          turn * x[k], turn * y[k]};
      for (int i = 0; i < gains.rows; ++i)
        gains(i, k) = gain[i];
      // A blur changes a shape by half of its Laplacian.
      bow(k) = (at[1] + at[-1] + below + above) / 2 - 2 * at[0];
    }
    cv::Mat normal;
    cv::mulTransposed(gains, normal, false, cv::noArray(), 1.0, CV_64F);
    if (cv::invert(normal, normal, cv::DECOMP_CHOLESKY) == 0.0)
      return false;
    normal.convertTo(inverse, CV_32F);
    return true;
  }

  // Sets the rest and FIT.distance. The change of the parameters that reduces
  // the rest.
  cv::Mat_<float> compare(Fit &fit) {
    const cv::Matx33f single = fit.map;
    for (std::size_t k = 0; k < x.size(); k += 4) {
      Four right = load(&x[k]), down = load(&y[k]);
      move(single, right, down);
      store(sample(grey, right, down), &rest[k]);
    }
    cv::Mat_<float> left(gains.cols, 1, rest.data());
    left -= fit.offset + fit.contrast * gains.row(1).t();
    fit.distance = cv::norm(left) / std::sqrt(gains.cols) /
                   std::max(1.0, fit.contrast);
    return inverse * (gains * left);
  }
};

}  // namespace

bool align(const cv::Mat &grey, const cv::Mat &shape, const cv::Mat &used,
           bool perspective, double worst, Fit &fit) {
  constexpr double good = 0.04;  // no other can be much better
  constexpr double sharpest = 0.68, dullest = 2.2;  // pixels of the image
  const double half = 0.5 * std::max(shape.cols, shape.rows);
  const Map to_unit(1 / half, 0, -0.5 * (shape.cols - 1) / half,
                    0, 1 / half, -0.5 * (shape.rows - 1) / half, 0, 0, 1);
  fit.map = fit.map * to_unit.inv();
  fit.map *= 1 / fit.map(2, 2);
  if (!keeps_turn(fit.map))
    return false;
  // image pixels per shape pixel, at its centre
  const double scale = std::sqrt(cv::determinant(fit.map)) / half;
  Comparison comparison(grey, used, fit.map, to_unit);
  cv::Mat blurred;
  double next = fit.spread * scale;  // what seems to fit better
  fit.distance = 1e9;
  const auto try_blur = [&](double sigma) {  // pixels of the image
    const int around = 2 * cvCeil(2.5 * sigma / scale) + 1;
    double left = 0.0;
    cv::GaussianBlur(shape, blurred, cv::Size(around, around), sigma / scale,
                     0.0, cv::BORDER_REPLICATE);
    if (!comparison.align(blurred, perspective, fit, left))
      return false;
    fit.spread = sigma / scale;
    const double square = sigma * sigma + scale * scale * left;
    next = std::min(std::sqrt(std::max(square, sharpest * sharpest)), dullest);
    return true;
  };
  // Most images are about as sharp as the first one.
  bool better = next > 0.0 && try_blur(next);
  for (const double sigma : {0.9, 1.4, 0.6, 2.2})
    better = better || try_blur(sigma);
  for (int round = 0; round < 2 && better && fit.distance > good &&
                      std::fabs(next - fit.spread * scale) > 0.1 * next;
       ++round)
    better = try_blur(next);
  fit.map = fit.map * to_unit;
  return fit.distance <= worst;
}

}  // namespace vision
