// SPDX-License-Identifier: GPL-3.0-or-later
/* Textures: pictures that are repeated over a surface, with smaller copies
 * (mip maps) for the distance, made by value noise or from photographs. */
#ifndef JUDGE_TEXTURE_HPP
#define JUDGE_TEXTURE_HPP

#include "random.hpp"

#include <opencv2/core.hpp>

#include <memory>
#include <vector>

class Texture {
 public:
  //  PICTURE: 32-bit BGR, linear; REPEATED as tiles, or mirrored
  explicit Texture(const cv::Mat &picture, bool repeated = true);

  //  At (U, V), 0 .. 1 across one tile, averaged over FOOTPRINT of it
  cv::Vec3f at(double u, double v, double footprint) const;

  double aspect() const;  //  height over width

 private:
  std::vector<cv::Mat> levels_;
  bool repeated_;
};

using TexturePtr = std::shared_ptr<const Texture>;

//  How a floor looks: the texture's mean is about 1 in each channel
struct Floor {
  TexturePtr texture;
  double size;  //  of one tile, centimetres
};

//  A floor or a table top, from a stock that is made once
Floor pick_floor(Random &random);

//  Faint unevenness of paper, paint and felt
Floor pick_grain(Random &random);

#endif
