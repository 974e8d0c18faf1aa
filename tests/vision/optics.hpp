// SPDX-License-Identifier: GPL-3.0-or-later
/* The camera: where it stands, and what its lens does. The world is in
 * centimetres, x to the right and y down as a camera right above shows it,
 * z into the floor: the floor is z = 0, what stands on it has z < 0. */
#ifndef JUDGE_OPTICS_HPP
#define JUDGE_OPTICS_HPP

#include <opencv2/core.hpp>

#include <vector>

struct Lens {
  enum Model {
    brown,    // Brown and Conrady: distorted = r (1 + k1 r^2 + k2 r^4)
    division  // Fitzgibbon: undistorted = r / (1 + k1 r^2)
  };
  Model model = brown;
  double k1 = 0, k2 = 0;
};

class Camera {
 public:
  Camera() = default;
  Camera(cv::Size size, double focal, cv::Point2d middle, const Lens &lens);

  //  Looks at AIM on the floor from DISTANCE, its axis leaning by TILT
  //  towards AZIMUTH, turned by ROLL about the axis (radians)
  void stand(cv::Point2d aim, double distance, double tilt, double azimuth,
             double roll);

  //  Image of a point of the world
  cv::Point2d project(const cv::Point3d &point) const;

  //  Direction in the world in which a pixel looks
  cv::Vec3d ray(double x, double y) const;

  cv::Size size;
  cv::Vec3d position;
  double focal = 1;
  double distance = 1;

 private:
  void tabulate();

  cv::Point2d middle_;
  Lens lens_;
  cv::Matx33d turn_ = cv::Matx33d::eye();
  //  Undistorted over distorted radius, by the square of the distorted
  std::vector<double> undistort_;
  double table_step_ = 1;
};

//  2 COUNT + 1 points on each side of a rectangle around (0, 0)
std::vector<cv::Point2d> sides(cv::Point2d half, int count);

cv::Rect2d box_around(const std::vector<cv::Point2d> &points);

#endif
