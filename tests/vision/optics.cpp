// SPDX-License-Identifier: GPL-3.0-or-later
/* The camera: projection, and its inverse by a table. */
#include "optics.hpp"

#include <algorithm>
#include <cmath>

namespace {

constexpr int table_size = 4096;

cv::Matx33d about_axis(double x, double y, double z, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), t = 1 - c;
  return {t * x * x + c,     t * x * y - s * z, t * x * z + s * y,
          t * x * y + s * z, t * y * y + c,     t * y * z - s * x,
          t * x * z - s * y, t * y * z + s * x, t * z * z + c};
}

//  Distorted over undistorted radius, by the undistorted
double distortion(const Lens &lens, double r) {
  const double r2 = r * r;
  if (lens.model == Lens::brown) {
    //  Brown's polynomial turns back at some radius: it stops there
    const double most = lens.k1 < 0 ? std::sqrt(1 / (3 * -lens.k1)) : 1e9;
    const double s = std::min(r, most);
    return (1 + s * s * (lens.k1 + s * s * lens.k2)) * (r > 0 ? s / r : 1);
  }
  //  r = d / (1 + k d^2) solved for d
  if (std::abs(lens.k1) * r2 < 1e-9)
    return 1;
  return (1 - std::sqrt(std::max(0.0, 1 - 4 * lens.k1 * r2))) /
         (2 * lens.k1 * r2);
}

}  // namespace

Camera::Camera(cv::Size image, double focal_length, cv::Point2d middle,
               const Lens &lens)
    : size(image), focal(focal_length), middle_(middle), lens_(lens) {
  tabulate();
}

void Camera::tabulate() {
  const double half = 0.5 * std::hypot(size.width, size.height) + 40;
  const double most = std::pow(half / focal, 2);
  table_step_ = most / (table_size - 2);
  undistort_.resize(table_size);
  for (int i = 0; i < table_size; ++i) {
    const double d = std::sqrt(i * table_step_);
    double low = 0, high = 4 * d + 1e-6;  //  the radius that d is made from
    for (int step = 0; step < 60; ++step) {
      const double r = (low + high) / 2;
      (r * distortion(lens_, r) < d ? low : high) = r;
    }
    undistort_[i] = d > 0 ? low / d : 1;
  }
  undistort_[0] = 1;
}

void Camera::stand(cv::Point2d aim, double away, double tilt, double azimuth,
                   double roll) {
  turn_ = about_axis(0, 0, 1, roll) *
          about_axis(-std::sin(azimuth), std::cos(azimuth), 0, -tilt);
  distance = away;
  const cv::Vec3d axis = turn_.t() * cv::Vec3d(0, 0, 1);
  position = cv::Vec3d(aim.x, aim.y, 0) - away * axis;
}

cv::Point2d Camera::project(const cv::Point3d &point) const {
  const cv::Vec3d seen =
      turn_ * (cv::Vec3d(point.x, point.y, point.z) - position);
  if (seen[2] < 1e-3)
    return {1e6, 1e6};
  const double x = seen[0] / seen[2], y = seen[1] / seen[2];
  const double scale = focal * distortion(lens_, std::hypot(x, y));
  return {middle_.x + x * scale, middle_.y + y * scale};
}

cv::Vec3d Camera::ray(double px, double py) const {
  const double x = (px - middle_.x) / focal, y = (py - middle_.y) / focal;
  const double at =
      std::min((x * x + y * y) / table_step_, double(table_size - 2));
  const int i = int(at);
  const double scale =
      undistort_[i] + (at - i) * (undistort_[i + 1] - undistort_[i]);
  return turn_.t() * cv::Vec3d(x * scale, y * scale, 1);
}

std::vector<cv::Point2d> sides(cv::Point2d half, int count) {
  std::vector<cv::Point2d> points;
  for (int i = -count; i <= count; ++i)
    for (const double end : {-1.0, 1.0}) {
      const double part = double(i) / count;
      points.emplace_back(part * half.x, end * half.y);
      points.emplace_back(end * half.x, part * half.y);
    }
  return points;
}

cv::Rect2d box_around(const std::vector<cv::Point2d> &points) {
  double left = 1e9, top = 1e9, right = -1e9, bottom = -1e9;
  for (const cv::Point2d &point : points) {
    left = std::min(left, point.x);
    right = std::max(right, point.x);
    top = std::min(top, point.y);
    bottom = std::max(bottom, point.y);
  }
  return {left, top, right - left, bottom - top};
}
