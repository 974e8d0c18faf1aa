// SPDX-License-Identifier: GPL-3.0-or-later
/* The sensor: blur, mosaic, noise, tone, sharpening, JPEG. */
#include "sensor.hpp"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

//  Spreads each point of LIGHT over a disc of RADIUS that moves by SHIFT
void spread(cv::Mat &light, double radius, cv::Point2d shift) {
  constexpr int fine = 16;  //  steps to a pixel
  const int half = int(std::ceil(radius + cv::norm(shift) / 2));
  const int count = 2 * half + 1;
  cv::Mat shape(count * fine, count * fine, CV_32F, cv::Scalar(0)), kernel;
  const cv::Point2d middle(count * fine / 2.0, count * fine / 2.0);
  if (shift == cv::Point2d())
    cv::circle(shape, middle, cvRound(radius * fine), 1, cv::FILLED);
  else
    cv::line(shape, middle - shift * (fine / 2.0),
             middle + shift * (fine / 2.0), 1, cvRound(2 * radius * fine));
  cv::resize(shape, kernel, {count, count}, 0, 0, cv::INTER_AREA);
  kernel /= cv::sum(kernel)[0];
  cv::filter2D(light, light, -1, kernel, {-1, -1}, 0, cv::BORDER_REPLICATE);
}

}  // namespace

Tone::Tone(double gamma, double contrast)
    : gamma_(gamma), contrast_(contrast) {}

double Tone::grey(double light) const {
  const double v = std::pow(std::clamp(light, 0.0, 1.0), 1 / gamma_);
  //  A camera's curve: steeper in the middle
  return 255 * ((1 - contrast_) * v + contrast_ * v * v * (3 - 2 * v));
}

double Tone::light(double wanted) const {
  double low = 0, high = 1;
  for (int i = 0; i < 40; ++i) {
    const double middle = (low + high) / 2;
    (grey(middle) < wanted ? low : high) = middle;
  }
  return low;
}

cv::Mat develop(cv::Mat &light, const Sensor &sensor, Random &random) {
  if (sensor.defocus > 0.05)
    spread(light, sensor.defocus, {});
  if (sensor.shake > 0.05)
    spread(light, 0.25, sensor.shake * cv::Point2d(
                                           std::cos(sensor.shake_angle),
                                           std::sin(sensor.shake_angle)));
  cv::GaussianBlur(light, light, {}, sensor.sharp, sensor.sharp,
                   cv::BORDER_REPLICATE);
  const double phase = random.in(0, 2 * M_PI);
  for (int y = 0; y < light.rows; ++y)
    light.row(y) *= 1 + sensor.flicker * std::sin(phase + 2 * M_PI * y /
                                                  sensor.flicker_rows);

  //  Lines of green and blue, of red and green; or all three at each place
  cv::Mat raw = light.reshape(1);
  if (sensor.mosaic) {
    raw.create(light.size(), CV_32F);
    for (int y = 0; y < light.rows; ++y)
      for (int x = 0; x < light.cols; ++x)
        raw.at<float>(y, x) = light.at<cv::Vec3f>(
            y, x)[(x + y) % 2 == 0 ? 1 : y % 2 == 0 ? 0 : 2];
  }
  cv::Mat noise(raw.size(), CV_32F), sigma;
  random.fill(noise, cv::RNG::NORMAL, 0, 1);
  cv::sqrt(sensor.read_noise * sensor.read_noise +
               sensor.shot_noise * sensor.shot_noise * cv::max(raw, 0),
           sigma);
  raw += noise.mul(sigma);
  raw.convertTo(raw, CV_16U, 65535);
  if (sensor.mosaic)
    //  OpenCV names a mosaic by its second line's second and third pixel
    cv::cvtColor(raw, raw, cv::COLOR_BayerGR2BGR);
  else
    raw = raw.reshape(3);

  std::vector<cv::Vec3b> curve(4096);
  for (int i = 0; i < 4096; ++i)
    for (int c = 0; c < 3; ++c)
      curve[std::size_t(i)][c] = cv::saturate_cast<uchar>(
          sensor.tone.grey((i + 0.5) / 4096 * sensor.balance[c]));
  cv::Mat image(light.size(), CV_8UC3);
  for (int y = 0; y < image.rows; ++y)
    for (int x = 0; x < image.cols; ++x)
      for (int c = 0; c < 3; ++c)
        image.at<cv::Vec3b>(y, x)[c] =
            curve[std::size_t(raw.at<cv::Vec3w>(y, x)[c] >> 4)][c];
  if (sensor.sharpening > 0) {
    cv::Mat smooth;
    cv::GaussianBlur(image, smooth, {}, 1.0);
    cv::addWeighted(image, 1 + sensor.sharpening, smooth, -sensor.sharpening,
                    0, image);
  }
  if (sensor.jpeg < 100) {
    std::vector<uchar> bytes;
    cv::imencode(".jpg", image, bytes,
                 {cv::IMWRITE_JPEG_QUALITY, sensor.jpeg});
    image = cv::imdecode(bytes, cv::IMREAD_COLOR);
  }
  return image;
}
