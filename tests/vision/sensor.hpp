// SPDX-License-Identifier: GPL-3.0-or-later
/* From light to an image in the supervisor's memory: blur of the lens and of
 * the hand, a sensor with a colour mosaic and noise, and the camera's own
 * processing and JPEG. */
#ifndef JUDGE_SENSOR_HPP
#define JUDGE_SENSOR_HPP

#include "random.hpp"

#include <opencv2/core.hpp>

//  Between linear light and grey levels, as the camera's processing has it
class Tone {
 public:
  explicit Tone(double gamma = 2.2, double contrast = 0.2);
  double grey(double light) const;   //  0 .. 255
  double light(double grey) const;

 private:
  double gamma_, contrast_;
};

struct Sensor {
  Tone tone;
  double sharp = 0.45;      //  sigma of the lens at its best, pixels
  double defocus = 0;       //  radius of the disc, pixels
  double shake = 0;         //  length, pixels
  double shake_angle = 0;
  double read_noise = 0.002;
  double shot_noise = 0.006;  //  at full light
  bool mosaic = true;
  double flicker = 0;       //  of the light, over the rows read in turn
  double flicker_rows = 400;
  double sharpening = 0.3;
  int jpeg = 90;
  cv::Vec3f balance = {1, 1, 1};
};

//  LIGHT: 32-bit BGR, linear; it is used up
cv::Mat develop(cv::Mat &light, const Sensor &sensor, Random &random);

#endif
