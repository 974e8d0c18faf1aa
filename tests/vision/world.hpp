// SPDX-License-Identifier: GPL-3.0-or-later
/* A world of flat surfaces at several heights, the light on it, the camera,
 * and the ray caster that shows it: a pixel is the mean of rays over its whole
 * area. The world is in centimetres, x to the right and y down as a camera
 * right above shows it, z into the floor: the floor is z = 0, what stands on
 * it has z < 0. */
#ifndef JUDGE_WORLD_HPP
#define JUDGE_WORLD_HPP

#include "print.hpp"

#include <vector>

struct Lens {
  enum Model {
    brown,    // Brown and Conrady: undistorted = r (1 - k1 r^2 - k2 r^4)
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
  cv::Point2d middle_;
  Lens lens_;
  cv::Matx33d turn_ = cv::Matx33d::eye();
};

//  2 COUNT + 1 points on each side of a rectangle around (0, 0)
std::vector<cv::Point2d> sides(cv::Point2d half, int count);

cv::Rect2d box_around(const std::vector<cv::Point2d> &points);

//  OWN after a turn by ANGLE (radians, clockwise as the image shows it)
cv::Point2d turned(cv::Point2d own, double angle);

struct Surface {
  PaintPtr paint;
  cv::Point2d centre;
  cv::Point2d half;      //  half its width and height
  double angle = 0;
  double height = 0;     //  above the floor
  bool endless = false;  //  the floor itself
  bool solid = false;    //  its paint has no holes

  cv::Point3d world(cv::Point2d own) const;
};

struct Shade {
  cv::Point2d through;  //  a point of its edge
  double angle;         //  of the edge
  double width;         //  of the band, 0: all on one side
  double soft;          //  of the edge, centimetres
  float light;          //  what is left
};

struct Lamp {
  cv::Point2d at;
  double height;
  float strength;
};

struct Glare {
  cv::Point2d at;
  double length, width, angle;
  float strength;
};

struct Light {
  cv::Point2d gradient;  //  a centimetre
  cv::Point2d middle;    //  where the light is 1
  std::vector<Lamp> lamps;
  std::vector<Shade> shades;
  std::vector<Glare> glares;
  double vignette = 0;   //  lost in the image's corners

  float on(cv::Point2d point) const;
  float mirrored(cv::Point2d point) const;
};

struct World {
  std::vector<Surface> surfaces;  //  what is in front comes last
  Light light;
};

//  32-bit BGR, linear
cv::Mat show(const World &world, const Camera &camera);

#endif
