// SPDX-License-Identifier: GPL-3.0-or-later
/* The sensor: blur, mosaic, noise, tone, sharpening, JPEG. */
#include "sensor.hpp"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

//  Share of each pixel that SHAPE covers, by 16 x 16 points
template <typename Inside>
cv::Mat kernel_of(double reach, Inside inside) {
  const int half = int(std::ceil(reach));
  cv::Mat kernel(2 * half + 1, 2 * half + 1, CV_32F, cv::Scalar(0));
  for (int y = -half; y <= half; ++y)
    for (int x = -half; x <= half; ++x)
      for (int k = 0; k < 256; ++k)
        if (inside(x - 0.5 + (k % 16 + 0.5) / 16,
                   y - 0.5 + (k / 16 + 0.5) / 16))
          kernel.at<float>(y + half, x + half) += 1;
  const double sum = cv::sum(kernel)[0];
  return sum > 0 ? cv::Mat(kernel / sum) : cv::Mat::ones(1, 1, CV_32F);
}

const std::vector<float> &normals() {
  static const std::vector<float> table = [] {
    Random random(4711);
    std::vector<float> made(1 << 16);
    for (float &value : made)
      value = float(random.normal());
    return made;
  }();
  return table;
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
  if (sensor.defocus > 0.05) {
    const double r2 = sensor.defocus * sensor.defocus;
    cv::filter2D(light, light, -1,
                 kernel_of(sensor.defocus, [&](double x, double y) {
                   return x * x + y * y <= r2;
                 }),
                 {-1, -1}, 0, cv::BORDER_REPLICATE);
  }
  if (sensor.shake > 0.05) {
    const double c = std::cos(sensor.shake_angle);
    const double s = std::sin(sensor.shake_angle);
    cv::filter2D(light, light, -1,
                 kernel_of(sensor.shake / 2 + 0.5,
                           [&](double x, double y) {
                             return std::abs(c * x + s * y) <=
                                        sensor.shake / 2 &&
                                    std::abs(c * y - s * x) <= 0.25;
                           }),
                 {-1, -1}, 0, cv::BORDER_REPLICATE);
  }
  cv::GaussianBlur(light, light, {}, sensor.sharp, sensor.sharp,
                   cv::BORDER_REPLICATE);

  const int width = light.cols, height = light.rows;
  const float read = float(sensor.read_noise), shot = float(sensor.shot_noise);
  const double phase = random.in(0, 2 * M_PI);
  const std::vector<float> &normal = normals();
  const auto lit = [&](int y) {
    return float(1 + sensor.flicker *
                         std::sin(phase + 2 * M_PI * y / sensor.flicker_rows));
  };
  const auto noisy = [&](float value, unsigned &at) {
    value = std::max(value, 0.0f);
    at = (at + 1) & 0xFFFF;
    value += normal[at] * std::sqrt(read * read + shot * shot * value);
    return cv::saturate_cast<ushort>(value * 65535.0f);
  };
  cv::Mat raw;
  if (sensor.mosaic) {
    cv::Mat mosaic(height, width, CV_16U);
    for (int y = 0; y < height; ++y) {
      const cv::Vec3f *from = light.ptr<cv::Vec3f>(y);
      ushort *to = mosaic.ptr<ushort>(y);
      unsigned at = unsigned(random.next());
      const float gain = lit(y);
      //  Lines of green and blue, of red and green
      for (int x = 0; x < width; ++x) {
        const int channel = (x + y) % 2 == 0 ? 1 : y % 2 == 0 ? 0 : 2;
        to[x] = noisy(from[x][channel] * gain, at);
      }
    }
    //  OpenCV names a mosaic by its second line's second and third pixel
    cv::cvtColor(mosaic, raw, cv::COLOR_BayerGR2BGR);
  } else {
    raw.create(height, width, CV_16UC3);
    for (int y = 0; y < height; ++y) {
      const cv::Vec3f *from = light.ptr<cv::Vec3f>(y);
      cv::Vec3w *to = raw.ptr<cv::Vec3w>(y);
      unsigned at = unsigned(random.next());
      const float gain = lit(y);
      for (int x = 0; x < width; ++x)
        for (int c = 0; c < 3; ++c)
          to[x][c] = noisy(from[x][c] * gain, at);
    }
  }

  std::vector<uchar> curve[3];
  for (int c = 0; c < 3; ++c) {
    curve[c].resize(4096);
    for (int i = 0; i < 4096; ++i)
      curve[c][std::size_t(i)] = cv::saturate_cast<uchar>(
          sensor.tone.grey((i + 0.5) / 4096 * sensor.balance[c]));
  }
  cv::Mat image(height, width, CV_8UC3);
  for (int y = 0; y < height; ++y) {
    const cv::Vec3w *from = raw.ptr<cv::Vec3w>(y);
    cv::Vec3b *to = image.ptr<cv::Vec3b>(y);
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c)
        to[x][c] = curve[c][std::size_t(from[x][c] >> 4)];
  }
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
