// SPDX-License-Identifier: GPL-3.0-or-later
/* A world of flat surfaces at several heights, the light on it, and the ray
 * caster that shows it: a pixel is the mean of rays over its whole area. */
#ifndef JUDGE_WORLD_HPP
#define JUDGE_WORLD_HPP

#include "optics.hpp"
#include "print.hpp"

#include <vector>

struct Surface {
  PaintPtr paint;
  cv::Point2d centre;
  cv::Point2d half;      //  half its width and height
  double angle = 0;      //  radians, clockwise as the image shows it
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
